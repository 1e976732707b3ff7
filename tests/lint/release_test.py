# SPDX-License-Identifier: MIT
"""release_test.py ROOT: scripts that name the same things agree: artefacts of scripts/release with their builds, checks and
licences, marks of scripts/packages.txt with scripts/setup, steps of scripts/nightly with the table of docs/verification.md."""

import hashlib
import importlib.machinery
import importlib.util
import os
import pathlib
import re
import signal
import subprocess
import sys
import tempfile

sys.dont_write_bytecode = True


def module(path):
    loader = importlib.machinery.SourceFileLoader(path.stem, str(path))
    found = importlib.util.module_from_spec(importlib.util.spec_from_loader(path.stem, loader))
    loader.exec_module(found)
    return found


def faults_of_release(root):
    release, texts = module(root / "scripts/release"), module(root / "scripts/license_texts")
    sys.path.insert(0, str(root / "tests/artefacts"))
    checks = module(root / "tests/artefacts/checks.py")
    nightly = module(root / "scripts/nightly")
    if [command.split()[1] for command in nightly.STEPS["release"][2]] != list(release.ARTEFACTS):
        yield "scripts/nightly: the step release does not make each artefact in turn"
    for name in release.ARTEFACTS:
        if not hasattr(release.Release, f"build_{name}"):
            yield f"scripts/release: no build_{name}"
        if not hasattr(checks, f"check_{name}"):
            yield f"tests/artefacts/checks.py: no check_{name}"
    for file, parts in texts.CONTENTS.items():
        for part in parts:
            if part not in texts.PARTS:
                yield f"scripts/license_texts: {file}: no {part}"


# `ninja -t deps` of three objects, of which one is out of date.
DEPS = """apps/main.o: #deps 2, deps mtime 1 (VALID)
    ../../core/a.hpp
    /usr/include/CLI/CLI.hpp
bindings/b.o: #deps 1, deps mtime 1 (VALID)
    /usr/include/pybind11/pybind11.h
old.o: #deps 1, deps mtime 1 (STALE)
    /usr/include/fmt/format.h
"""


def faults_of_licenses(root):
    """The check of finished files (tests/artefacts/licenses.py) finds what it must."""
    sys.path.insert(0, str(root / "tests/artefacts"))
    licenses = module(root / "tests/artefacts/licenses.py")
    found = {path.as_posix() for path in licenses.headers_in(DEPS, root, ["bindings/"])}
    found |= {path.as_posix() for path in licenses.headers_in(DEPS, root, only=["apps/"])}
    if found != {"/usr/include/CLI/CLI.hpp"}:
        yield f"tests/artefacts/licenses.py: headers_in finds {found}"
    text = (root / "LICENSE").read_text() + "".join(map(licenses.license_texts().text_of, ["uplot", "three.js"]))
    for what, given, packages, words in (("nothing", text, {"libc6-dev": "h"}, None), ("a part", text, {"libfmt-dev": "h"}, "contains fmt"),
                                         ("an unknown part", text, {"other-dev": "h"}, "contains other-dev"),
                                         ("camopt's text", text[100:], {}, "the licence of camopt"),
                                         ("the last text", text[:-100], {}, "the licence of three.js")):
        faults = list(licenses.faults("source", given, packages))
        if (faults and not words) or (words and not any(words in fault for fault in faults)):
            yield f"tests/artefacts/licenses.py: where {what} is missing it finds {faults}"


def faults_of_agreement(root):
    """Which results of two platforms agree (tests/artefacts/agreement.py)."""
    judged = module(root / "tests/artefacts/agreement.py").judged

    def result(verdict, objective, lower, solver="structured", reason="converged"):
        bound = None if lower is None else {"lower": lower, "gap": (objective or 0.0) - lower}
        return {"verdict": verdict, "objective": objective, "bound": bound, "reason": reason, "solver": {"name": solver}, "plan": {"convex": True}}

    proved = result("optimal", 1.0912, 1.0911, "ipopt")
    for what, here, there, agree in (
            ("the same", result("optimal", 1.0, 1.0), result("optimal", 1.0, 1.0), True),
            ("another optimum", result("optimal", 1.0, 1.0), result("optimal", 1.00001, 1.0), False),
            ("another verdict", result("local", 1.0912, 0.96), proved, False),
            ("out of time", result("local", 1.0912, 0.96, reason="time_limit"), proved, True),
            ("out of time, worse bound than possible", result("local", 1.2, 1.1, reason="time_limit"), proved, False),
            ("the program out of time", result("optimal", 1.0912, 1.0911), result("local", 1.0912, 0.96, "ipopt", "time_limit"), True),
            ("infeasible in one", result("infeasible", None, None), proved, False)):
        if judged(here, there)[2].startswith("FAILED") == agree:
            yield f"tests/artefacts/agreement.py: {what}: {judged(here, there)}"


BEGIN_A_CHILD = """
import importlib.machinery, importlib.util, signal, subprocess, sys
sys.dont_write_bytecode = True
loader = importlib.machinery.SourceFileLoader("release", sys.argv[1])
release = importlib.util.module_from_spec(importlib.util.spec_from_loader("release", loader))
loader.exec_module(release)
signal.signal(signal.SIGTERM, release.end_with_children)
subprocess.run(["bash", "-c", "sleep 100 & echo $!; wait"])
"""


def faults_of_signals(root):
    process = subprocess.Popen([sys.executable, "-c", BEGIN_A_CHILD, str(root / "scripts/release")], stdout=subprocess.PIPE, text=True)
    grandchild = int(process.stdout.readline())
    process.terminate()
    if process.wait(30) != 128 + signal.SIGTERM:
        yield f"scripts/release: SIGTERM ends it with {process.returncode}"
    if module(root / "scripts/release").is_running(grandchild):
        os.kill(grandchild, signal.SIGKILL)
        yield "scripts/release: SIGTERM leaves what its builds began"


def faults_of_table(root):
    """scripts/release --table: what it enters between the marks of docs/install.md, and that it can be entered again."""
    release = module(root / "scripts/release")
    page = (root / "docs/install.md").read_text()
    with tempfile.TemporaryDirectory() as folder:
        file = pathlib.Path(folder) / "camopt-1.2.3.html"
        file.write_bytes(b"a" * 1_234_567)
        table = release.artefact_table([file], "0123456789abcdef")
    row = f"| `camopt-1.2.3.html` | 1.23 MB | `{hashlib.sha256(b'a' * 1_234_567).hexdigest()}` |"
    if row not in table or "`0123456789ab`" not in table:
        yield f"scripts/release: artefact_table made {table!r}"
    once = release.with_table(page, table)
    if row not in once or release.with_table(once, table) != once or once.count(release.TABLE_BEGIN) != 1:
        yield "scripts/release: with_table does not replace the table of docs/install.md"
    if [once.split(release.TABLE_BEGIN)[0], once.split(release.TABLE_END)[1]] != \
            [page.split(release.TABLE_BEGIN)[0], page.split(release.TABLE_END)[1]]:
        yield "scripts/release: with_table changes what is outside of the table"


def faults_of_packages(root):
    marks = set(re.findall(r"optional_marks='([^']*)'", (root / "scripts/setup").read_text()))
    known = "".join(re.escape(mark) for mark in set("".join(marks)))
    for number, line in enumerate((root / "scripts/packages.txt").read_text().splitlines(), 1):
        if not line.startswith("#") and not re.fullmatch(rf"[{known}]*[a-z0-9][a-z0-9+.-]*", line):
            yield f"scripts/packages.txt:{number}: '{line}': no package that scripts/setup installs"


def faults_of_steps(root):
    nightly = module(root / "scripts/nightly")
    found = list(nightly.rows_of_page())
    if found != list(nightly.STEPS):
        yield f"docs/verification.md: its steps are not those of scripts/nightly: {sorted(set(found) ^ set(nightly.STEPS))}"
    setup = (root / "scripts/setup").read_text()
    for name, (_, option, _) in nightly.STEPS.items():
        if option and f"\n{option})" not in setup:
            yield f"scripts/nightly: {name}: scripts/setup has no {option}"


def main(root):
    faults = [fault for part in (faults_of_release, faults_of_licenses, faults_of_agreement, faults_of_signals, faults_of_table, faults_of_packages,
                                      faults_of_steps)
              for fault in part(root)]
    for fault in faults:
        print(fault)
    print(f"release_test: {len(faults)} faults")
    sys.exit(1 if faults else 0)


main(pathlib.Path(sys.argv[1]).resolve())
