# SPDX-License-Identifier: MIT
"""How a cell is cut into pieces (notebooks_cpp/kernel/cell_pieces.py)."""

import pathlib
import sys
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "notebooks_cpp" / "kernel"))

import cell_pieces  # noqa: E402


def statements(text):
    return [text[begin:end] for begin, _, end in cell_pieces.statements(text)]


class CellPieces(unittest.TestCase):
    def test_statements(self):
        for text in ("int a = 1;", "for (int i = 0; i < 3; ++i) { f(i); }", "if (a) { b(); } else { c(); }",
                     "struct S { int a; };", "do { f(); } while (g());", "try { f(); } catch (...) { g(); }",
                     'std::string s = R"x(a; "b" }; )x";', "std::vector<int> v = {1, 2, 3};", "auto f = [] { return 1; };",
                     "int f(int a) { return a; }", "char c = ';';", "double d = 1'000.5e-3;", "f(); // one; two {",
                     "auto g = S{1}.value;", "using A = int;", "namespace n { int a; }"):
            with self.subTest(text):
                self.assertEqual(statements(f"{text}\nint next = 2;"), [text.split(" //")[0], "int next = 2;"])

    def test_brackets(self):
        for text in ("int a[3] = {f(1), 2};", "// (", "/* { */", 'g("(");', "char c = '{';", 'h(R"({[)");', "#define A {\nint b;"):
            with self.subTest(text):
                self.assertIsNone(cell_pieces.bracket_fault(text))
        self.assertEqual(cell_pieces.bracket_fault("int a;\nvoid f() {\n"), (2, "'{' is never closed"))
        self.assertEqual(cell_pieces.bracket_fault("int a;\n}"), (2, "'}' closes nothing"))
        self.assertEqual(cell_pieces.bracket_fault("f(1];"), (1, "']' closes nothing"))
        self.assertEqual(cell_pieces.bracket_fault('s = "abc'), (1, "a text that does not end"))
        self.assertIsNotNone(cell_pieces.bracket_fault('s = R"(abc'))

    def test_directives_are_no_statements(self):
        self.assertEqual(statements("#include <map>\n#define A { \\\n  (\nint a;"), ["int a;"])

    def test_constants_begin_a_piece(self):
        pieces = cell_pieces.pieces("a = 1;\nconst int b = a;\na = 2;")
        self.assertEqual([piece.strip().splitlines()[-1].strip() for piece in pieces], ["a = 1;", "const int b = a;", "a = 2;"])
        self.assertIn("#line 2\nconst", pieces[1])

    def test_constant_inside_a_function_does_not(self):
        self.assertEqual(len(cell_pieces.pieces("void f() {\n    const int b = 1;\n}\nf();")), 1)

    def test_lambda_in_a_statement_goes_into_a_function(self):
        piece, = cell_pieces.pieces("  sort(a, [](int x) { return x; });\nint b;", "cell")
        self.assertIn("void cell_2() {\n#line 1\n  sort(a, [](int x) { return x; });\n}\ncell_2();\n#line 1\n", piece)

    def test_lambda_in_a_declaration_stays(self):
        for text in ("auto f = [](int x) { return x; };", "std::vector<double> y = each(x, [](double a) { return a; });",
                     "void f() { g([] { return 1; }); }", "notebook::Plot p(each([] { return 1; }));"):
            with self.subTest(text):
                self.assertEqual(cell_pieces.pieces(text), [text])

    def test_empty(self):
        self.assertEqual(cell_pieces.pieces(""), [""])


if __name__ == "__main__":
    unittest.main()
