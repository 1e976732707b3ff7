#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""links_nothing_else.py MAP LIBRARY …: of the libraries of mechanisms, the map holds objects of those named and no other."""

import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "benchmarks" / "embedding"))
from linker_map import linked_objects  # noqa: E402

MECHANISMS = {"profiles_remote", "profiles_inverse", "profiles_linear", "profiles_spatial", "profiles_factory"}


def main():
    objects = linked_objects(pathlib.Path(sys.argv[1]))
    print("; ".join(f"{library} {count}" for library, count in sorted(objects.items())))
    if "studies_solve" not in objects:
        sys.exit("the map names no object of studies_solve: nothing was looked at")
    found, wanted = MECHANISMS & set(objects), set(sys.argv[2:])
    if found != wanted:
        sys.exit(f"linked: {sorted(found)}; wanted: {sorted(wanted)}")


main()
