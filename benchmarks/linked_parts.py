#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""linked_parts.py BUILD …: what an embedding program pulls in, in every built folder given. CSV on the standard output.

Shared libraries are those the program names itself (readelf -d); objects are counted in the linker's map, by folder of
camopt; ldd counts what the loader brings in all. Bytes are those of code and data (size).
"""

import collections
import pathlib
import re
import subprocess
import sys

PROGRAMS = {"embed_laws": "motions", "embed_profile": "motions, profiles", "embed_solve": "studies and what it needs"}
MEMBER = re.compile(r"^\S*libcamopt_(\w+)\.a\((\S+)\)")


def output(*command):
    return subprocess.run(command, stdout=subprocess.PIPE, text=True, check=True).stdout


def linked_objects(path):
    """How many object files of each camopt library the linker took."""
    members = set()
    for line in path.read_text(errors="replace").splitlines():
        found = MEMBER.match(line)
        if found:
            members.add(found.groups())
        if line.startswith("Memory Configuration"):
            break
    return collections.Counter(library for library, _ in sorted(members))


def row(build, name, targets):
    program = build / "benchmarks" / name
    needed = re.findall(r"\(NEEDED\).*\[(.*)\]", output("readelf", "-d", program))
    loaded = len(output("ldd", program).splitlines())
    text, data, bss = output("size", program).splitlines()[1].split()[:3]
    objects = linked_objects(program.with_name(name + ".map"))
    counts = "; ".join(f"{library} {count}" for library, count in sorted(objects.items()))
    return [build.name, name, targets, " ".join(needed), loaded, counts, sum(objects.values()),
            int(text) + int(data) + int(bss)]


def main():
    print("build,program,links,shared_libraries_named,shared_libraries_loaded,objects_by_folder,objects,bytes")
    for build in map(pathlib.Path, sys.argv[1:]):
        for name, targets in PROGRAMS.items():
            if (build / "benchmarks" / name).exists():
                print(",".join(f'"{cell}"' if isinstance(cell, str) else str(cell) for cell in row(build, name, targets)))


main()
