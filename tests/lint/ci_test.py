# SPDX-License-Identifier: MIT
"""ci_test.py ROOT: .ci/run in a tree whose scripts are stand-ins: it ends with the summary of the tests, tells what failed,
and ends in time where a step hangs."""

import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import time

SUMMARY = "100% tests passed, 0 tests failed out of 7"
SCRIPTS = ("setup", "lint", "test", "tidy", "nightly")


def tree(root, folder, replaced):
    (folder / ".ci").mkdir()
    (folder / "scripts").mkdir()
    (folder / "tests/lint").mkdir(parents=True)
    (folder / "tests/lint/tiers.py").write_text("")
    shutil.copy(root / ".ci/run", folder / ".ci/run")
    for name in SCRIPTS:
        body = replaced.get(name, f"echo '{SUMMARY}'" if name == "test" else "true")
        (folder / "scripts" / name).write_text(f"#!/bin/sh\n{body}\n")
        (folder / "scripts" / name).chmod(0o755)
    for words in (["init", "-q"], ["-c", "user.name=n", "-c", "user.email=e", "commit", "-q", "--allow-empty", "-m", "c"]):
        subprocess.run(["git", *words], cwd=folder, check=True)


def run(root, seconds, replaced):
    """(exit status, lines, seconds)."""
    with tempfile.TemporaryDirectory() as place:
        folder = pathlib.Path(place)
        tree(root, folder, replaced)
        begin = time.monotonic()
        done = subprocess.run([folder / ".ci/run"], capture_output=True, text=True, check=False, timeout=60,
                              env=os.environ | {"CAMOPT_CI_SECONDS": str(seconds)})
        return done.returncode, done.stdout.splitlines(), time.monotonic() - begin


def main():
    root, faults = pathlib.Path(sys.argv[1]).resolve(), []

    def demand(what, holds):
        if not holds:
            faults.append(what)

    status, lines, _ = run(root, 600, {})
    demand("where all pass the status is 0", status == 0)
    demand("the last line is ctest's summary", lines[-1] == SUMMARY)
    demand("the table has a line a step", sum("passed" in line and line.startswith(".ci/run:") for line in lines) == 10)

    status, lines, _ = run(root, 600, {"tidy": "echo 'finding: planted'; exit 78"})
    demand("findings in code that works do not fail the run", status == 0)
    demand("they are printed at the end", "finding: planted" in lines[-16:] and any("OPEN" in line for line in lines[-16:]))

    status, lines, _ = run(root, 600, {"lint": "echo 'error: planted'; exit 1", "nightly": "exit 77"})
    demand("a failed step makes the status 1", status == 1)
    demand("its cause is told at the end", "error: planted" in lines[-14:])
    demand("the steps after it run", any("SKIPPED" in line and "nightly" in line for line in lines))
    demand("the summary is last after a failure, too", lines[-1] == SUMMARY)

    status, lines, seconds = run(root, 2, {"test": f"echo '{SUMMARY}'; sleep 50"})
    demand("a step that hangs is ended", seconds < 10)
    demand("it is called out of time", any("OUT OF TIME" in line for line in lines))
    demand("what is left out is named", any(line.startswith(".ci/run:     Python package") for line in lines))
    demand("the status is 1", status == 1)
    demand("the summary of what ran is last", lines[-1] == SUMMARY)
    print("\n".join(faults + [f"ci_test: {len(faults)} faults"]))
    return 1 if faults else 0


sys.exit(main())
