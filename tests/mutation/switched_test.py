#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""switched_test.py: the extents that switched.py finds, and the text it writes and takes back."""
import sys
import tempfile
from pathlib import Path

sys.dont_write_bytecode = True
import mutate  # noqa: E402
from switched import Expressions, Switched  # noqa: E402

# Code with the changed operator between « and »; what its expression is, and its statement.
CASES = [
    ("double f() { return a« + »b * c; }", "a + b * c", "return a + b * c;"),
    ("const double x = -g(a, b«[0] * »c, 1.0);", "b[0] * c", None),
    ("if (a« < »b && c) return d;", "a < b && c", None),
    ("{\n    if (a) x« += »y;\n    z = 1;\n}", "x += y", "x += y;"),
    ("{\n    for (int i = 0; i« < »n; ++i) sum += i;\n}", "i < n", None),
    ("return a ? b« - »c : d;", "b - c", None),
    ("f({.first = true, .second = v« - »w});", "v - w", None),
    ("{\n    sum(g(a« - »b), c)[0].set(d);\n}", "a - b", "sum(g(a - b), c)[0].set(d);"),
    ("auto best = «std::max(»a, f(b)) + c::d;", "std::max(a, f(b)) + c::d", None),
    ("if (!done) {\n    stop();\n}\nvalue« == »1 ? a() : b();", "value == 1", None),
    ("x = s.at(static_cast<int>(k))«.y * »T{1, 2}.z;", "s.at(static_cast<int>(k)).y * T{1, 2}.z", None),
    ("const auto less = [&](int i) { return v[i]« < »w; };", "v[i] < w", "return v[i] < w;"),
]


def check(condition, *what):
    if not condition:
        sys.exit("switched_test: " + " ".join(map(str, what)))


def check_extents():
    for text, expression, statement in CASES:
        begin, end = text.index("«"), text.index("»") - 1
        code = text.replace("«", "").replace("»", "")
        known = Expressions(mutate.blanked(code))
        found = known.expression(begin, end)
        check(found and code[slice(*found)] == expression, repr(code), "gives", found and repr(code[slice(*found)]))
        if statement:
            found = known.statement(begin, end)
            check(found and code[slice(*found)] == statement, repr(code), "gives", found and code[slice(*found)])


def check_writing():
    with tempfile.TemporaryDirectory() as folder:
        copy = Path(folder) / "source"
        copy.mkdir()
        text = "int f(int a, int b) {\n    const bool c = a < b;\n    return -a + b;\n}\n"
        path = Path("f.cpp")
        (copy / path).write_text(text)
        sites = [(path, text.index(old), old, new)
                 for old, new in ((" < ", " <= "), ("return -", "return "), (" + ", " - "))]
        switched = Switched(copy, dict(enumerate(sites, 1)), mutate.blanked)
        switched.write()
        written = (copy / path).read_text()
        check("const bool c = (camopt_mutant == 1 ? (a <= b) : (a < b));" in written, written)
        check("return (camopt_mutant == 2 ? (a + b) : (-a + b));" in written, written)
        check(switched.way[3] == "alone", "two mutants of one expression stand together")
        check(switched.blamed("source/f.cpp:3:20: error: no match") == [1], "the line of mutant 1 is not known")
        switched.restore()
        check((copy / path).read_text() == text, "the copy keeps mutants")


check_extents()
check_writing()
