# SPDX-License-Identifier: MIT
"""public_headers.py INCLUDE: the headers of an installed camopt (INCLUDE/camopt) stand alone. They include the standard library,
Eigen and one another, hold no conditional compilation, and name no type of another library."""

import pathlib
import re
import sys

import source_tree

INCLUDE = re.compile(r'^\s*#\s*include\s*(["<])([^">]+)[">]')
CONDITIONAL = re.compile(r"^\s*#\s*(if|ifdef|ifndef|elif|else)\b")
STANDARD_OR_EIGEN = re.compile(r"^([a-z_0-9]+|(unsupported/)?Eigen/\w+)$")
FOREIGN = re.compile(r"\b(nlopt::|nlopt_(opt|result|algorithm|func|mfunc)\b|Ipopt::|TNLP\b|SuiteSparseQR|"
                     r"cholmod_(common|sparse|dense|factor|triplet)\b|toml::|nlohmann::|CLI::|fmt::)")


def faults_of(root, path):
    text = (root / path).read_text()
    if "#pragma once" not in text:
        yield f"{path}: no '#pragma once'"
    for number, line in enumerate(text.splitlines(), 1):
        where = f"{path}:{number}"
        include = INCLUDE.match(line)
        if include and "needs C++20" in include.group(2) and path.name == "language.hpp":
            continue
        if include and include.group(1) == "<" and not STANDARD_OR_EIGEN.match(include.group(2)):
            yield f"{where}: a public header must not include <{include.group(2)}>"
        if include and include.group(1) == '"' and not (root / include.group(2)).is_file():
            yield f"{where}: includes \"{include.group(2)}\", which is not installed"
        if path.name == "language.hpp":
            continue  # the one line about too old a compiler
        if CONDITIONAL.match(line):
            yield f"{where}: features select files, never parts of a header: {line.strip()}"
        foreign = FOREIGN.search(line.split("//")[0])
        if foreign:
            yield f"{where}: names another library: {foreign.group(0)}"


def main():
    root = pathlib.Path(sys.argv[1])
    headers = [path for path in source_tree.files(root) if path.suffix == ".hpp"]
    promised = [path for path in headers if path.parent.as_posix() == "camopt"]
    faults = [fault for path in headers for fault in faults_of(root, path)]
    if promised:
        faults += [f"{path}: stands outside of camopt/" for path in headers if path.parts[0] != "camopt"]
        if len(promised) > 60:
            faults.append(f"camopt/: {len(promised)} headers are promised to embedders; about 40 are meant")
    source_tree.report("public_headers", faults, len(headers))


main()
