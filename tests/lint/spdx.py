# SPDX-License-Identifier: MIT
"""spdx.py ROOT: every source, script and build file names its licence in its first three lines."""

import pathlib
import sys

import source_tree

LINE = "SPDX-License-Identifier: MIT"
SUFFIXES = {".cpp", ".hpp", ".c", ".h", ".py", ".sh", ".cmake", ".m", ".js"}


def wants_line(root, path):
    if path.suffix in SUFFIXES or path.name == "CMakeLists.txt" or path.name.endswith(".cmake.in"):
        return True
    with (root / path).open("rb") as file:
        return file.read(2) == b"#!"


def main():
    root = pathlib.Path(sys.argv[1])
    paths = [path for path in source_tree.files(root) if wants_line(root, path)]
    faults = []
    for path in paths:
        if LINE not in "\n".join((root / path).read_text().splitlines()[:3]):
            faults.append(f"{path}:1: no line '{LINE}'")
    source_tree.report("spdx", faults, len(paths))


main()
