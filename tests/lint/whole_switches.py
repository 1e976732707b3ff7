# SPDX-License-Identifier: MIT
"""whole_switches.py ROOT: a switch of profiles/, objectives/ or scene/ names every kind, form and follower: it has no
default, so that a new one does not compile (-Werror=switch) until each switch says what it does with it."""

import pathlib
import re
import sys

import source_tree

FOLDERS = {"profiles", "objectives", "scene"}
DEFAULT = re.compile(r"^\s*default\s*:", re.MULTILINE)


def faults_of(path, text):
    for match in DEFAULT.finditer(text):
        line = text.count("\n", 0, match.end()) + 1
        yield f"{path}:{line}: a switch with a default: name every case, and end in an error"


def main(root):
    paths = [path for path in source_tree.code(root) if path.parts[0] in FOLDERS]
    faults = [fault for path in paths for fault in faults_of(path, (pathlib.Path(root) / path).read_text())]
    source_tree.report("whole_switches", faults, len(paths))


main(sys.argv[1])
