# SPDX-License-Identifier: MIT
"""Tolerances: every limit holds for all cams within them.

Theorem. A made cam moves its follower by y + e_0 with slopes y' + e_1, y'' + e_2, |e_r| <= E_r in lifts by x^r, and its numbers are within half a
width of those of the scene. A row at any cam within the tolerances is a row of the scene, since the scene demands all of them; the delivered
motion is judged at every choice of ends. Cams between the ends are not judged along it: camopt encloses those (between_ends.hpp).
"""
import itertools
import re

from .dimensions import largest_of
from .exact import Refuted, Unverified, number
from .rational import Fraction
from .units import LENGTHS, angle_of, dimension_of, in_unit

NAMES = "profile", "slope", "acceleration"
MARKS = "s", "s'", "s''"
SMALL = {"um": Fraction(1, 10**6), "mdeg": Fraction(1, 1000)}


TABLES = "cam", "linkage"


class Corner:
    """One choice of ends, or of what lies between them. motion: errors of y, y', y''; numbers: {name: error in m, rad, N, N/m}."""

    def __init__(self, motion, numbers):
        self.motion, self.numbers = motion, numbers


def place_of(scene, name):
    """(table, key) under which a number of the cam is written; None: it is not."""
    return next(((table, f"{name}_{unit}") for table in TABLES for unit in (*LENGTHS, "deg", "rad")
                 if f"{name}_{unit}" in scene.get(table, {})), None)


class Tolerances:
    def __init__(self, problem, scene):
        table = scene.get("tolerance", {})
        self.given = bool(table)
        self.motion = [self.error(problem, table, order) for order in range(3)] if table else [Fraction(0)] * 3
        self.numbers = {}
        forces = scene.get("forces", {})
        for key in table:
            if key.startswith(NAMES):
                continue
            name = key.removesuffix("_percent") if key.endswith("_percent") else re.sub(r"_(mm|in|m|deg|rad|n|n_m)$", "", key)
            if name in ("preload", "spring_rate"):
                own, size = self.of_spring(name, key, table, forces)
            else:
                angle = angle_of(table, name)
                own, size = name, in_unit(angle, "rad") if angle else dimension_of(table, name)
                if name != "offset" and place_of(scene, name) is None:
                    raise Unverified(f"tolerance.{key} of a number at its default")
            self.numbers[own] = size

    @staticmethod
    def of_spring(name, key, table, forces):
        unit = {"preload": "n", "spring_rate": "n_m"}[name]
        given = forces.get(f"{name}_{unit}")
        if given is None or not (key.endswith("_percent") or key == f"{name}_{unit}"):
            raise Unverified(f"tolerance.{key}")
        most = largest_of((number(given["min"]), number(given["max"]))) if isinstance(given, dict) else abs(number(given))
        return "forces." + name, number(table[key]) * (most / 100 if key.endswith("_percent") else 1)

    @staticmethod
    def error(problem, table, order):
        """In lifts by x^order."""
        key = next((key for key in table if key.startswith(NAMES[order] + "_")), None)
        if key is None:
            return Fraction(0)
        first, *angle = key.removeprefix(NAMES[order] + "_").split("_")
        value = number(table[key])
        if first in LENGTHS or first == "um":
            value *= SMALL.get(first) or LENGTHS[first]
        else:
            value = in_unit((value * SMALL.get(first, 1), "deg" if first == "mdeg" else first), problem.lift[1])
        if order:
            value *= in_unit(problem.unit_angle, angle[0].rstrip("23"))**order
        return value / problem.lift[0]

    def searched_under_other_names(self, scene, searched):
        """A number with a tolerance that is a range, and that the rules do not know by its name; None: there is none."""
        places = {name: place_of(scene, name) for name in self.numbers}
        return next((name for name, place in places.items()
                     if place and isinstance(scene[place[0]][place[1]], dict) and name not in searched), None)

    @staticmethod
    def scene_of(scene, corner):
        """The scene of that cam; numbers that are searched are left as they are."""
        tables = {name: dict(scene[name]) for name in (*TABLES, "forces") if name in scene}
        for name, error in corner.numbers.items():
            if name.startswith("forces."):
                table, key = "forces", name.removeprefix("forces.") + {"forces.preload": "_n", "forces.spring_rate": "_n_m"}[name]
            elif (place := place_of(scene, name)) is not None:
                table, key = place
                unit = key.removeprefix(name + "_")
                error = error / LENGTHS[unit] if unit in LENGTHS else in_unit((error, "rad"), unit)
            else:
                table, key = "cam", name + "_m"  # an offset that is not written is 0
            value = tables[table].get(key, 0)
            if not isinstance(value, dict):
                tables[table][key] = number(value) + error
        return scene | tables

    def corners(self):
        """Every choice of ends."""
        signs = [(1, -1) if error else (1,) for error in self.motion] + [(1, -1)] * len(self.numbers)
        for ends in itertools.product(*signs):
            yield Corner([sign * error for sign, error in zip(ends, self.motion)],
                         {name: sign * size for sign, (name, size) in zip(ends[3:], self.numbers.items())})

    def made(self, parts):
        """The cam at these parts of the tolerances, from -1 to 1 by their names."""
        if any(not -1 <= part <= 1 for part in parts.values()):
            raise Refuted("a cam outside of its tolerances")
        motion, numbers = [number(parts.get(mark, 0)) * error for mark, error in zip(MARKS, self.motion)], {}
        for name in parts.keys() - set(MARKS):
            own = name if name in self.numbers else "forces." + name
            numbers[own] = number(parts[name]) * self.numbers[own]
        return Corner(motion, numbers)


class MadeRules:
    """The rules of a cam at one choice of ends. `rules`: of the cam with its fixed numbers moved; those that are searched move here."""

    def __init__(self, rules, corner, searched):
        self.rules, self.corner = rules, corner
        self.searched_errors = [corner.numbers.get(name, Fraction(0)) / largest_of(ends) for name, ends in searched.items()]

    def __getattr__(self, name):
        return getattr(self.rules, name)

    def moved(self, formula):
        errors = self.corner.motion + [Fraction(0)] + self.searched_errors

        def rule(numbers, *more):
            return formula([n if not e else n + e for n, e in
                            itertools.zip_longest(numbers, errors[:len(numbers)], fillvalue=Fraction(0))], *more)
        return rule

    def formulas(self, *words):
        return [self.moved(f) for f in self.rules.formulas(*words)]

    def pressures(self, limit, sign):
        return [self.moved(f) for f in self.rules.pressures(limit, sign)]

    def kept(self, key):
        formulas, more = self.rules.kept(key)
        return [self.moved(f) for f in formulas], more

    def bear(self, load):
        self.rules.load = load

    load = property(None, bear)
