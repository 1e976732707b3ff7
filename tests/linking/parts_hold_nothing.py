#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""parts_hold_nothing.py NM READELF FOLDER PROGRAM …: a part exports its entry alone and has no variables of camopt but the turn of
Ipopt's solves, so nothing of camopt's state exists twice; and no PROGRAM begins with the libraries that stand behind the parts."""

import pathlib
import re
import subprocess
import sys

NM, READELF = sys.argv[1:3]
BEHIND = {"ipopt": r"libipopt\b", "pdf": r"libcairo\b", "http": r"libcpp-httplib\b", "step": r"libTK\w+"}
ONLY_VARIABLE = re.compile(r"camopt::.*turn_of_process\(\)::mutex")
CONSTANT = re.compile(r"(typeinfo|vtable|VTT) .*|camopt::.*::\w+_table")


def output(*words):
    return subprocess.run([str(word) for word in words], capture_output=True, text=True, check=True).stdout


def variables(part):
    """Names in .data and .bss, and those that all modules of a process share, without tables that are relocated once."""
    lines = [line.split(maxsplit=2) for line in output(NM, "-C", "--defined-only", part).splitlines()]
    return [name for _, kind, name in lines if kind in "bBdDu" and "camopt" in name and not CONSTANT.fullmatch(name)]


def faults_of(part):
    name = part.stem.removeprefix("camopt_part_")
    exported = [line.split()[-1] for line in output(NM, "-D", "--defined-only", part).splitlines()]
    if exported != [part.stem]:
        yield f"{part.name} exports {exported}"
    for variable in variables(part):
        if not ONLY_VARIABLE.fullmatch(variable):
            yield f"{part.name} has the variable {variable}"
    if not re.search(BEHIND[name], output(READELF, "-d", part)):
        yield f"{part.name} is not linked to {BEHIND[name]}"


def main():
    parts, programs = sorted(pathlib.Path(sys.argv[3]).glob("*.so")), sys.argv[4:]
    faults = [fault for part in parts for fault in faults_of(part)]
    for program in programs:
        needed = output("ldd", program)
        faults += [f"{program} begins with {found[0]}" for behind in BEHIND.values() if (found := re.search(behind, needed))]
    print(f"{len(parts)} parts, {len(programs)} programs")
    if faults or not parts or not programs:
        sys.exit("\n".join(faults) or "nothing was looked at")


main()
