# SPDX-License-Identifier: MIT
"""What the comparison of golden files takes for equal, and what it finds: words, units, signs, numbers."""

import unittest

from differences import differences
from views import cleaned, lines_of, thinned


def found(one, other):
    return list(differences(one.split("\n"), other.split("\n")))


class Comparison(unittest.TestCase):
    def equal(self, one, other):
        self.assertEqual(found(one, other), [])

    def unequal(self, one, other):
        self.assertNotEqual(found(one, other), [])

    def test_round_off_is_equal(self):
        self.equal("gap 3.5e-10", "gap 1.2e-9")
        self.equal("0.940489277213864", "0.940489277213999")
        self.equal("x −0", "x 0")
        self.equal("1,100.5,3e-5\n2,200.5,4e-5", "1,100.5,3e-5\n2,200.50001,4e-5")
        self.equal("[#9] 0.0 1e-5 100", "[#9] 0.0 2e-5 100")
        self.equal("velocity 12.3456", "velocity 12.3457")

    def test_changes_are_found(self):
        self.unequal("velocity 12.3456 mm", "velocity 12.3456 in")
        self.unequal("velocity 12.3456 mm", "velocity −12.3456 mm")
        self.unequal("velocity 12.3456 mm", "velocity 12.35 mm")
        self.unequal("velocity 0.52 mm", "velocity 0.53 mm")
        self.unequal("12 segments", "13 segments")
        self.unequal("1,100.5,3e-5\n2,200.5,4e-5", "1,100.5,3e-5\n2,200.5,5e-5")
        self.unequal("a\nb\nc", "a\nc")
        self.unequal("a\nc", "a\nb\nc")
        self.unequal("3 mm/s", "3 mm/s²")

    def test_place_is_that_of_the_line(self):
        self.assertEqual(found("a\nb 1.5\nc", "a\nb 2.5\nc"), [(1, "b 1.5", "b 2.5")])
        self.assertEqual(found("a\nb\nc", "a\nb\nd\nc"), [(2, None, "d")])


class Views(unittest.TestCase):
    def test_what_differs_between_runs_is_left_out(self):
        self.assertEqual(cleaned("  solver: structured, iterations 27, exchange rounds 7, 1.68 s"),
                         "  solver: structured, iterations <n>, exchange rounds <n>, <seconds> s")
        self.assertEqual(cleaned("camopt " + "0.2.0"), "camopt <version>")
        self.assertEqual(cleaned("704.4 s at the given feed"), "704.4 s at the given feed")
        self.assertEqual(cleaned("0.30000000000000004"), "0.3")

    def test_alike_lines_are_thinned_and_new_words_kept(self):
        lines = [f"{i},{i * i}" for i in range(100)] + ["units: mm"]
        kept = thinned(lines)
        self.assertEqual(kept, ["0,0", "33,1089", "66,4356", "99,9801", "units: mm", "… 100 alike: #,#"])
        self.assertEqual(thinned(lines, sums=True)[-1], "… 100 alike, sum 333300: #,#")

    def test_kinds_of_files(self):
        self.assertEqual(lines_of("a.json", b'{"a": [1, 2], "b": {"c": "mm"}}'), ['{"a": [1, 2], "b": {"c": "mm"}}'])
        self.assertEqual(lines_of("a.csv", b"row,iterations,v_mm_s\n0,17,1.5\n"), ["row,iterations,v_mm_s", "0,<n>,1.5"])
        self.assertEqual(lines_of("a.svg", b'<svg xmlns="x"><text x="1">V</text></svg>'), ["<svg>", ' <text x="1"> V'])
        self.assertEqual(lines_of("a.html", b"<style>x</style><h1>A &amp; B</h1>"), ["A & B"])
        self.assertEqual(lines_of("a.dxf", b"0\nLINE\n5\nF\n8\nCAM\n"), ["0=LINE 8=CAM"])


if __name__ == "__main__":
    unittest.main()
