# SPDX-License-Identifier: MIT
"""assertions.py ROOT: every test case asserts something, itself or through a function of the tests that it calls, and every
skip is accepted by name: the file that skips stands in tests/skips.txt. A case is a TEST, TEST_F, TEST_P or TYPED_TEST of
GoogleTest, or a method or function test_… of Python. What a case asserts when it runs is counted by
tests/support/counted_assertions.hpp."""

import ast
import pathlib
import re
import sys

import skips
import source_tree

CASE = re.compile(r"^[ \t]*(?:TYPED_)?TEST(?:_[FP])?\s*\(\s*(\w+)\s*,\s*(\w+)\s*\)\s*\{", re.M)
ASSERTION = re.compile(r"\b(?:EXPECT|ASSERT)_\w+\s*\(|\b(?:ADD_FAILURE|ADD_FAILURE_AT|FAIL|static_assert)\s*\(")
SKIP = re.compile(r"\bGTEST_SKIP\s*\(|skipTest\s*\(|unittest\.skip\w*\s*\(|\b(?:exit|return|sys\.exit\()\s*\(?77\b|^SKIPPED\b.* = 77\b", re.M)
NAME = re.compile(r"\b([A-Za-z_]\w*)\s*(?=[(<])")
# A function or a named lambda with a body.
FUNCTION = re.compile(r"\b([A-Za-z_]\w*)\s*(?:=\s*\[[^\]]*\]\s*)?\(")
NO_FUNCTION = {"if", "for", "while", "switch", "catch", "return", "sizeof", "TEST", "TEST_F", "TEST_P", "TYPED_TEST", "decltype"}
LEFT_OUT = ("tests/lint/", "tests/mutation/")  # these plant faults, and are run as a whole


def without_text(text):
    """C++ without comments, and with nothing between quotes; of the same length."""
    blank = lambda match: re.sub(r"[^\n\"']", " ", match[0]) if match[0][0] in "\"'R" else re.sub(r"[^\n]", " ", match[0])
    return re.sub(r'//[^\n]*|/\*.*?\*/|R"(\w*)\(.*?\)\1"|"(?:\\.|[^"\\\n])*"|(?<![0-9a-fA-F])\'(?:\\.|[^\'\\\n])+\'', blank, text, flags=re.S)


def closing(text, begin):
    """The end of what opens at begin: a bracket of any kind."""
    depth = 0
    for match in re.compile(r"[({\[\])}]").finditer(text, begin):
        depth += 1 if match[0] in "({[" else -1
        if depth == 0:
            return match.end()
    return len(text)


def functions(code):
    """(name, body) of each function that the code defines."""
    for match in FUNCTION.finditer(code):
        if match[1] in NO_FUNCTION:
            continue
        end = closing(code, match.end() - 1)
        body = re.compile(r"\s*(?:(?:const|noexcept|override|final|mutable)\b\s*)*(?:->\s*[\w:<>&*, ]+?)?\s*(?::[^;{]*(?:\{[^}]*\}[^;{]*)*)?\{").match(code, end)
        if body:
            yield match[1], code[body.end() - 1:closing(code, body.end() - 1)]


class Sources:
    """The C++ of the tests, and which functions of which file assert."""

    def __init__(self, root, paths):
        self.root = root
        self.code = {path.as_posix(): without_text((root / path).read_text()) for path in paths}
        self.own = {name: list(functions(code)) for name, code in self.code.items()}

    def visible(self, name):
        """The file, what it includes of the tests, and the sources of that."""
        seen, open_ = set(), [name]
        while open_:
            one = open_.pop()
            if one in seen or one not in self.code:
                continue
            seen.add(one)
            open_ += re.findall(r'#include "([^"]+)"', (self.root / one).read_text())
            if one.endswith(".hpp"):
                open_.append(one[:-4] + ".cpp")
        return seen

    def asserting(self, name):
        """Names of functions that the file can call and that assert."""
        bodies = [pair for one in self.visible(name) for pair in self.own[one]]
        found = {function for function, body in bodies if ASSERTION.search(body)}
        while True:
            more = {function for function, body in bodies
                    if function not in found and any(call in found for call in NAME.findall(body))}
            if not more:
                return found
            found |= more

    def faults(self, name):
        code, helpers = self.code[name], None
        for match in CASE.finditer(code):
            body = code[match.end() - 1:closing(code, match.end() - 1)]
            if ASSERTION.search(body):
                continue
            helpers = self.asserting(name) if helpers is None else helpers
            if helpers.isdisjoint(re.findall(r"\w+", body)):  # called, or given to what calls it
                line = code.count("\n", 0, match.start()) + 1
                yield f"{name}:{line}: {match[1]}.{match[2]} asserts nothing"


def asserts(node):
    """Whether Python code asserts something itself."""
    for one in ast.walk(node):
        if isinstance(one, ast.Assert):
            return True
        if isinstance(one, ast.Call):
            name = getattr(one.func, "attr", getattr(one.func, "id", ""))
            if name.startswith("assert") or name in ("fail", "check_call", "check_output"):
                return True
            if any(word.arg == "check" and getattr(word.value, "value", False) is True for word in one.keywords):
                return True
    return False


def python_faults(root, paths):
    trees = {path: ast.parse((root / path).read_text()) for path in paths}
    bodies = [(node.name, node) for tree in trees.values() for node in ast.walk(tree) if isinstance(node, ast.FunctionDef)]
    calls = lambda node: {getattr(one.func, "attr", getattr(one.func, "id", "")) for one in ast.walk(node)
                          if isinstance(one, ast.Call)}
    helpers = {name for name, node in bodies if asserts(node)}
    while True:
        more = {name for name, node in bodies if name not in helpers and calls(node) & helpers}
        if not more:
            break
        helpers |= more
    for path, tree in trees.items():
        for node in ast.walk(tree):
            if isinstance(node, ast.FunctionDef) and node.name.startswith("test_") and node.name not in helpers:
                yield f"{path}:{node.lineno}: {node.name} asserts nothing"


def skip_faults(root, paths):
    accepted = {entry.file for entry in skips.accepted(root)}
    skipping = set()
    for path in paths:
        text = (root / path).read_text()
        for match in SKIP.finditer(text):
            skipping.add(path.as_posix())
            if path.as_posix() not in accepted:
                yield f"{path}:{text.count(chr(10), 0, match.start()) + 1}: skips, and {skips.LIST} has no line with this file"
    for file in sorted(accepted - skipping):
        yield f"{skips.LIST}: {file} skips nothing"


def main(root):
    root = pathlib.Path(root)
    paths = [path for path in source_tree.files(root)
             if path.parts[0] == "tests" and not path.as_posix().startswith(LEFT_OUT)]
    code = [path for path in paths if path.suffix in source_tree.CODE]
    python = [path for path in paths if path.suffix == ".py"]
    sources = Sources(root, code)
    faults = [fault for path in code for fault in sources.faults(path.as_posix())]
    faults += python_faults(root, python)
    faults += skip_faults(root, [path for path in paths if path.suffix in source_tree.CODE | {".py", ".sh"}])
    source_tree.report("assertions", faults, len(code) + len(python))


if __name__ == "__main__":
    main(sys.argv[1])
