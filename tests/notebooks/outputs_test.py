# SPDX-License-Identifier: MIT
"""What counts as a difference between stored and computed outputs, and which numbers a text may state."""

import pathlib
import sys
import types
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "notebooks_cpp" / "check"))

import outputs  # noqa: E402


def output(text, mime=None):
    if mime is None:
        return {"output_type": "stream", "name": "stdout", "text": text}
    return {"output_type": "display_data", "data": {mime: text}}


def cell(kind, source, *found):
    return types.SimpleNamespace(cell_type=kind, source=source, outputs=list(found))


def text_faults(text, *found, code="int n = 12;"):
    return list(outputs.text_faults(types.SimpleNamespace(cells=[cell("code", code, *found), cell("markdown", text)])))


class Outputs(unittest.TestCase):
    def test_same(self):
        for stored, now in (("a 1.5", "a 1.5"), ("0.9404892771", "0.9404892773"), ("0.940", "0.941"), ("took 1.2 s", "took 9 s"),
                            ("gap 3e-16", "gap 0"), ("1234567.8", "1234568.1"), ("V=1.71429e+00", "V=1.71428e+00")):
            self.assertEqual(outputs.difference(stored, now), "", (stored, now))

    def test_different(self):
        for stored, now in (("a 1.5", "b 1.5"), ("0.940489", "0.940499"), ("0.940", "0.942"), ("17 rows", "18 rows"), ("1 2", "1"),
                            ("-1.5", "1.5"), ("optimal", "local"), ("1e-3", "1e-4")):
            self.assertNotEqual(outputs.difference(stored, now), "", (stored, now))

    def test_pictures_by_the_pixel(self):
        old, near, far = ({"outputs": [output(f'<path d="M 10 {y}"/>', "image/svg+xml")]} for y in (20, 20.04, 20.2))
        self.assertEqual(list(outputs.compare_cell(old, near)), [])
        self.assertEqual(len(list(outputs.compare_cell(old, far))), 1)

    def test_kinds_of_outputs(self):
        self.assertEqual(len(list(outputs.compare_cell({"outputs": [output("a")]}, {"outputs": []}))), 1)

    def test_text_states_what_is_computed(self):
        self.assertEqual(text_faults("0.94 of 12 segments, −7.0 %", output("0.940489 -6.98\n")), [])
        self.assertEqual(text_faults("0.94", output("<td>0.9405</td>", "text/html")), [])

    def test_text_states_what_nothing_computes(self):
        for text in ("0.95", "0.9406", "13 segments", "It was 1994."):
            self.assertEqual(len(text_faults(text, output("0.940489"))), 1, text)
        self.assertEqual(len(text_faults("0.94", output("0.940489", "image/svg+xml"))), 1)  # a picture is no witness

    def test_what_is_not_read(self):
        self.assertEqual(text_faults("# 4. Head\n`x = 5.5` [a](3_b.ipynb) C2 y3 <b width=9>\n1. first"), [])


if __name__ == "__main__":
    unittest.main()
