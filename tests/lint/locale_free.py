# SPDX-License-Identifier: MIT
"""locale_free.py ROOT: no number is read or written by a function that obeys the locale of the process (1.5 would
be 1, or written 1,5). core/text/parsing.hpp reads, fmt writes. Not in tests/, benchmarks/
and examples: programs that set no locale."""

import pathlib
import re
import sys

import source_tree

# Reading: all of these. Writing: printf and its kin where a %e, %f or %g stands in the format.
READING = re.compile(r"\b(?:sto(?:d|f|ld|i|l|ll|ul|ull)|strto(?:d|f|ld|l|ll|ul|ull)|ato(?:f|i|l|ll)|v?f?s?scanf)\s*\(")
WRITING = re.compile(r"\bv?(?:f|s|sn)?printf\s*\([^;]*%[-+ #0-9.*]*[aefgAEFG]")
LOCALISED = re.compile(r"\{:[^{}]*L\}")


def faults_of(path, text):
    code = re.sub(r"//[^\n]*", "", text)
    for what, words in ((READING, "reads a number by the locale: use core/text/parsing.hpp"),
                        (WRITING, "writes a number by the locale: use fmt"),
                        (LOCALISED, "writes a number by the locale: no 'L' in a format")):
        for match in what.finditer(code):
            yield f"{path}:{code.count(chr(10), 0, match.start()) + 1}: {words}"


def main(root):
    paths = [path for path in source_tree.code(root) if path.parts[0] not in ("tests", "benchmarks") and "examples" not in path.parts]
    faults = [fault for path in paths for fault in faults_of(path, (pathlib.Path(root) / path).read_text())]
    source_tree.report("locale_free", faults, len(paths))


main(sys.argv[1])
