# SPDX-License-Identifier: MIT
"""checked_output.py ROOT: what is written is checked. Files go through core/text/text_file.hpp, standard output through
apps/terminal.hpp; both report a full disk. No other source opens a file to write or prints. Not in tests/, benchmarks/,
notebooks_cpp/ (their kernel's line) and examples."""

import pathlib
import re
import sys

import source_tree

WRITING = re.compile(r"\b(?:std::)?(?:ofstream|fstream|cout|freopen|fwrite|fputs|fputc|puts|putchar|f?printf|fmt::print)\b"
                     r"(?=\s*[({<&;]|\s+\w)|\bfopen\s*\([^;]*\"[wa]")
CHECKED = {"core/text/text_file.cpp", "apps/terminal.cpp"}  # the last: stderr too, while a user waits
SEAM = "core/platform/"  # opens what text_file.cpp writes
LEFT_OUT = {"tests", "benchmarks", "notebooks_cpp"}


def faults_of(path, text):
    code = re.sub(r"//[^\n]*|/\*.*?\*/|^#include[^\n]*", lambda found: "\n" * found[0].count("\n"), text, flags=re.DOTALL | re.MULTILINE)
    code = re.sub(r'"(?:[^"\\\n]|\\.)*"', lambda found: found[0] if found[0] in ('"w"', '"wb"', '"a"', '"ab"') else '""', code)
    for match in WRITING.finditer(code):
        yield (f"{path}:{code.count(chr(10), 0, match.start()) + 1}: writes unchecked ({match[0].strip()}): use "
               "write_text_file (core/text/text_file.hpp) or print (apps/terminal.hpp)")


def main(root):
    paths = [path for path in source_tree.code(root)
             if path.parts[0] not in LEFT_OUT and "examples" not in path.parts and path.as_posix() not in CHECKED and not path.as_posix().startswith(SEAM)]
    faults = [fault for path in paths for fault in faults_of(path, (pathlib.Path(root) / path).read_text())]
    source_tree.report("checked_output", faults, len(paths))


main(sys.argv[1])
