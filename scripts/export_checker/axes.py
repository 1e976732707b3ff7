# SPDX-License-Identifier: MIT
"""The axes of a program as its header states them: "X = x in mm, Y = -y + 5 in mm, ..., A = -rotary + 180 in deg".

A printed number is  sign * value + offset  after the axis's letter. x, y, z are the tip's place in the machine, `rotary` turns the
cam, `tilt` leans it.
"""
import re

from certificate_checker.exact import Unverified
from certificate_checker.rational import Fraction, parsed

KEYS = ("x", "y", "z", "rotary", "tilt")
LINE = re.compile(r"^[(;]([A-Z] = -?x\b[^()\n]*)\)?$", re.MULTILINE)
TERM = re.compile(r"([A-Z]) = (-?)([a-z]+)(?: ([+-]) (\d+(?:\.\d+)?(?:e[+-]?\d+)?))? in (mm|inch|deg)")
UNITS = {"mm": Fraction(1), "inch": Fraction(254, 10), "deg": Fraction(1)}
LETTERS = set("ABCEUVWXYZ")  # the others of the alphabet are no axes


class Axes:
    """`letters`: in the order of KEYS. `mirrored`: the plane of X and Y shows the cam's mirror image, so that G2 and G3, G41 and G42
    change places."""

    def __init__(self, text):
        lines = LINE.findall(text)
        terms = [TERM.fullmatch(term) for term in lines[0].split(", ")] if len(lines) == 1 else []
        if not terms or None in terms or tuple(term[3] for term in terms) != KEYS[:len(terms)] or len(terms) < 3:
            raise Unverified("a program that does not state how its axes follow from those of the cam")
        if any((term[6] == "deg") != (k >= 3) for k, term in enumerate(terms)):
            raise Unverified("an axis in another unit")
        self.letters = [term[1] for term in terms]
        if len(set(self.letters) & LETTERS) < len(terms):
            raise Unverified("the letters of the axes " + " ".join(self.letters))
        self.signs = [-1 if term[2] else 1 for term in terms]
        self.offsets = [parsed((term[4] or "") + (term[5] or "0")) * UNITS[term[6]] for term in terms]
        self.mirrored = self.signs[0] != self.signs[1]

    def value(self, k, printed):
        """Of an axis; mm, degrees."""
        return self.signs[k] * (printed - self.offsets[k])
