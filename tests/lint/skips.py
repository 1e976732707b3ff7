# SPDX-License-Identifier: MIT
"""tests/skips.txt, the skips that are accepted by name. skips.py ROOT BUILD: every test that the last run (BUILD/tests.xml, written
by scripts/test) skipped is one of them."""

import collections
import fnmatch
import pathlib
import sys
import xml.etree.ElementTree

import source_tree

LIST = "tests/skips.txt"
Skip = collections.namedtuple("Skip", "file pattern reason")


def accepted(root):
    """Throws SystemExit for a line that is none."""
    path = pathlib.Path(root) / LIST
    if not path.is_file():
        return []
    found = []
    for number, line in enumerate(path.read_text().splitlines(), 1):
        if not line or line.startswith("#"):
            continue
        parts = line.split(maxsplit=2)
        if len(parts) < 3:
            sys.exit(f"{LIST}:{number}: found '{line}'; allowed: the file that skips, the pattern of its tests, the reason")
        found.append(Skip(*parts))
    return found


def skipped(results):
    """The tests of a JUnit file of ctest that did not run for a reason of their own."""
    for case in xml.etree.ElementTree.parse(results).getroot().iter("testcase"):
        if case.find("skipped") is not None:
            yield case.get("name")


def faults(root, results):
    patterns = [entry.pattern for entry in accepted(root)]
    for name in skipped(results):
        if not any(fnmatch.fnmatchcase(name, pattern) for pattern in patterns):
            yield f"{name} was skipped, and {LIST} has no line for it"


if __name__ == "__main__":
    RESULTS = pathlib.Path(sys.argv[-1]) / "tests.xml"
    SEEN = RESULTS.is_file()
    source_tree.report("skips", list(faults(sys.argv[1], RESULTS)) if SEEN else [], int(SEEN))
