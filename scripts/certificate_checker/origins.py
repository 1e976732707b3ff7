# SPDX-License-Identifier: MIT
"""What rows of proofs say of themselves: the fields of certificate.json (docs/results.md), never its words.

No theorem: a row is built from the scene by the rule and the place that its fields name. A field that is wrong names another true row.
"""
import json

from .exact import Unverified, number
from .units import known_limit

FORMAT = 2  # of certificate.json: rows and cases have fields beside their words


def read_certificate(path):
    certificate = json.loads(path.read_text())
    if certificate.get("format") != FORMAT:
        raise Unverified(f"{path.name} of format {certificate.get('format', 1)}: this checker reads format {FORMAT}, which camopt writes when "
                         "it solves the scene again")
    return certificate


class Origin:
    """The rule and the place of a row. `key`: of the scene, of a peak its name; `part`: what a limit needs beside itself; `at`: x, None of
    rows without a place; `which`: numbers that tell rows of one rule apart, None: all of them are meant; `made`: parts of tolerances."""

    def __init__(self, key, order=None, sign=0, part="", which=None):
        self.key, self.order, self.sign, self.part, self.which = key, order, sign, part, which
        self.axis, self.at, self.side, self.limit, self.made = "", None, None, True, {}

    @staticmethod
    def of(fields):
        own = Origin(known_limit(fields.get("key", "")), fields.get("order"), fields.get("sign", 0), fields.get("part", ""),
                     fields.get("which", {}))
        own.axis, own.limit, own.side, own.made = fields.get("axis", ""), fields["limit"], fields.get("side"), fields.get("made", {})
        own.at = number(fields["at"]) if "at" in fields else None
        return own

    def __str__(self):
        place = "" if self.at is None else f" at x = {float(self.at)}"
        return self.key + (f" ({self.part})" if self.part else "") + place

    def chosen(self, name, options, usual=None):
        """The one of the options that the row counts, from 0; all of them where it does not say which, and `usual` gives none."""
        place = None if self.which is None else self.which.get(name, usual)
        return options if place is None else options[int(place):int(place) + 1]

    def signs(self, name):
        """Those of a figure with two signs that the row means."""
        return [sign for sign in (1, -1) if self.which is None or self.which.get(name, sign) == sign]


def rows_of(key, part=""):
    """All rows of a limit or of a part of it: those of a pressure angle to either side."""
    signs = (1, -1) if key.endswith("pressure_angle_deg") else (0,)
    return [Origin("limits." + key, 1 if sign else None, sign, part) for sign in signs]
