# SPDX-License-Identifier: MIT
"""release_test.py ROOT: scripts that name the same things agree: artefacts of scripts/release with their builds, checks and
licences, marks of scripts/packages.txt with scripts/setup, steps of scripts/nightly with the table of docs/verification.md."""

import hashlib
import importlib.machinery
import importlib.util
import pathlib
import re
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
    for name in release.ARTEFACTS:
        if not hasattr(release.Release, f"build_{name}"):
            yield f"scripts/release: no build_{name}"
        if not hasattr(checks, f"check_{name}"):
            yield f"tests/artefacts/checks.py: no check_{name}"
        for part in texts.OF_ARTEFACT.get(name, ["OF_ARTEFACT"]):
            if part not in texts.PARTS:
                yield f"scripts/license_texts: {name}: no {part}"


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
    for name in nightly.NO_TURN:
        if name not in nightly.STEPS:
            yield f"scripts/nightly: NO_TURN: no step {name}"


def main(root):
    faults = [*faults_of_release(root), *faults_of_table(root), *faults_of_packages(root), *faults_of_steps(root)]
    for fault in faults:
        print(fault)
    print(f"release_test: {len(faults)} faults")
    sys.exit(1 if faults else 0)


main(pathlib.Path(sys.argv[1]).resolve())
