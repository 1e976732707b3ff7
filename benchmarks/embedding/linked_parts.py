#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""linked_parts.py BUILD …: what an embedding program pulls in, in every built folder given. CSV on the standard output.

Shared libraries are those the program names itself (readelf -d); objects are counted in the linker's map, by folder of
camopt; ldd counts what the loader brings in all. Bytes are those of code and data (size).
"""

import pathlib
import re
import subprocess
import sys

from linker_map import linked_objects

PROGRAMS = {"benchmarks/embed_laws": "motions", "benchmarks/embed_profile": "motions, profiles",
            "benchmarks/embed_solve": "studies and what it needs",
            "tests/linking/solve_disk": "studies, input", "tests/linking/solve_remote": "the same, profiles_remote",
            "tests/linking/solve_inverse": "the same, profiles_inverse",
            "tests/linking/solve_spatial": "the same, profiles_spatial"}


def output(*command):
    return subprocess.run(command, stdout=subprocess.PIPE, text=True, check=True).stdout


def row(build, name, targets):
    program = build / name
    needed = re.findall(r"\(NEEDED\).*\[(.*)\]", output("readelf", "-d", program))
    loaded = len(output("ldd", program).splitlines())
    text, data, bss = output("size", program).splitlines()[1].split()[:3]
    objects = linked_objects(program.with_suffix(".map"))
    counts = "; ".join(f"{library} {count}" for library, count in sorted(objects.items()))
    return [build.name, program.name, targets, " ".join(needed), loaded, counts, sum(objects.values()),
            int(text) + int(data) + int(bss)]


def main():
    print("build,program,links,shared_libraries_named,shared_libraries_loaded,objects_by_folder,objects,bytes")
    for build in map(pathlib.Path, sys.argv[1:]):
        for name, targets in PROGRAMS.items():
            if (build / name).exists():
                print(",".join(f'"{cell}"' if isinstance(cell, str) else str(cell) for cell in row(build, name, targets)))


main()
