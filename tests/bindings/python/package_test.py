# SPDX-License-Identifier: MIT
"""The package itself: every public name is documented, and the stubs are those of the module."""

import ast
import inspect
import os
import pathlib
import re
import unittest

import camopt
import program
from camopt import _camopt

STUB = pathlib.Path(camopt.__file__).with_name("_camopt.pyi")
EXPLAINED = {"__call__", "_repr_svg_", "_repr_html_"}
OPERATORS = "add radd sub rsub mul rmul truediv rtruediv pow rpow neg pos abs lt le gt ge bool len float init"
SPOKEN = EXPLAINED | {f"__{name}__" for name in OPERATORS.split()}


def is_public(name):
    return not name.startswith("_") or name in SPOKEN


def members(cls):
    return {name: value for name, value in vars(cls).items() if is_public(name)}


def words_of(thing):
    """The docstring less the line of the signature that the extension writes into it."""
    text = inspect.getdoc(thing) or ""
    text = re.sub(r"\A\w+\(\*args, \*\*kwargs\)\nOverloaded function\.\n|^(\d+\. )?\w+\(.*\) -> .*\n?", "", text, flags=re.M)
    return text.strip()


def documented(text):
    """The stub with the docstrings of the module: what editors show."""
    lines = text.split("\n")
    described = []  # (line of the end of a signature, indent, docstring), of a class or a function
    for node in ast.parse(text).body:
        if not isinstance(node, (ast.ClassDef, ast.FunctionDef)):
            continue
        thing = getattr(_camopt, node.name)
        described.append((node, thing))
        if isinstance(node, ast.ClassDef):
            described += [(one, vars(thing).get(one.name)) for one in node.body if isinstance(one, ast.FunctionDef)]
    for node, thing in sorted(described, key=lambda pair: -pair[0].lineno):
        operator = node.name.startswith("__") and node.name not in EXPLAINED
        words = "" if operator or thing is None else words_of(thing)
        first = node.body[0]
        value = first.value if isinstance(first, ast.Expr) else None
        end = first.lineno - 1 - len(getattr(first, "decorator_list", []))  # of the signature, where it has its own line
        if isinstance(value, ast.Constant) and value.value is ... or isinstance(value, ast.Constant) and end == node.lineno - 1:
            lines[end] = lines[end][:value.col_offset].rstrip()  # "...", or words that stand behind it
        elif isinstance(value, ast.Constant):
            del lines[first.lineno - 1:first.end_lineno]
            end -= 1
        else:
            end -= 1
        if not words:
            lines[end] += " ..." if isinstance(value, ast.Constant) else ""
        elif isinstance(node, ast.FunctionDef) and "\n" not in words and len(lines[end]) + len(words) + 7 <= 120:
            lines[end] += f' """{words}"""'
        else:
            indent = " " * (node.col_offset + 4)
            lines[end + 1:end + 1] = [(indent + line).rstrip() for line in f'"""{words}"""'.split("\n")]
    return "\n".join(lines)


class Docstrings(unittest.TestCase):
    def test_every_public_name_has_one(self):
        self.assertTrue(words_of(camopt))
        for name in camopt.__all__:
            thing = getattr(camopt, name)
            self.assertTrue(words_of(thing), name)
            if not inspect.isclass(thing) or issubclass(thing, Exception):
                continue
            for member, value in members(thing).items():
                if member in EXPLAINED or not member.startswith("_"):
                    if member == "solution" or not (callable(value) or isinstance(value, (property, classmethod))):
                        continue
                    value = value.__func__ if isinstance(value, classmethod) else value
                    self.assertTrue(words_of(value), f"{name}.{member}")

    def test_namespace_holds_what_is_meant_for_users_alone(self):
        self.assertEqual({name for name in dir(camopt) if not name.startswith("_")}, set(camopt.__all__))


class Stubs(unittest.TestCase):
    def setUp(self):
        self.tree = ast.parse(STUB.read_text())

    def test_names_are_those_of_the_module(self):
        stubbed = {node.name: node for node in self.tree.body if isinstance(node, (ast.ClassDef, ast.FunctionDef))}
        built = {name: value for name, value in vars(_camopt).items() if not name.startswith("_")}
        self.assertEqual(set(stubbed), set(built))
        for name, node in stubbed.items():
            if isinstance(node, ast.FunctionDef):
                self.assert_same_parameters(node, built[name], name)
            elif not issubclass(built[name], Exception):
                self.assert_same_members(node, built[name])

    def test_docstrings_are_those_of_the_module(self):
        wanted = documented(STUB.read_text())
        if os.environ.get("CAMOPT_WRITE_DOCS"):
            (program.ROOT / "bindings/python/camopt" / STUB.name).write_text(wanted)
        self.assertEqual(STUB.read_text(), wanted, "CAMOPT_WRITE_DOCS=1 writes them")

    def assert_same_members(self, node, cls):
        functions = [one for one in node.body if isinstance(one, ast.FunctionDef)]
        named = {one.name for one in functions}
        # The extension gives every class an __init__; that of what cannot be made by hand only says so.
        self.assertEqual(named - {"__init__"}, set(members(cls)) - {"__init__"}, node.name)
        for one in functions:
            decorators = {ast.unparse(decorator) for decorator in one.decorator_list}
            where = f"{node.name}.{one.name}"
            self.assertEqual("property" in decorators, isinstance(vars(cls)[one.name], property), where)
            if "property" not in decorators and one.name != "__init__":
                self.assert_same_parameters(one, vars(cls)[one.name], where)

    def assert_same_parameters(self, node, function, where):
        if where.startswith("Number."):
            return  # operators and what is like them: for a number and for a Number
        signature = re.match(r"\w+\((.*)\) -> ", function.__doc__ or "")
        self.assertIsNotNone(signature, where)
        depth, built, start = 0, [], 0
        text = signature[1] + ","
        for index, letter in enumerate(text):
            depth += (letter in "[({") - (letter in "])}")
            if letter == "," and depth == 0:
                built.append(text[start:index].strip())
                start = index + 1
        built = [one for one in built if one and not one.startswith(("self", "arg0", "**"))]
        arguments = [one for one in node.args.args if one.arg != "self"]
        self.assertEqual([one.arg for one in arguments], [one.split(":")[0] for one in built], where)
        self.assertEqual(len(node.args.defaults), sum(" = " in one for one in built), where)

    def test_the_package_says_that_it_has_types(self):
        self.assertTrue(STUB.with_name("py.typed").exists())


if __name__ == "__main__":
    unittest.main(verbosity=2)
