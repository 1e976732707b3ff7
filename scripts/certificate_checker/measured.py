# SPDX-License-Identifier: MIT
"""The distance of a motion from the rows of a measured table, as terms of the objective: the largest, and the root mean square.

Theorem. y less the displacement of a row is affine in the motion. So the largest distance is at least +-(y - row) of each row, and the root mean
square, a norm, is at or above its tangent at any motion z: rms(y) >= <y, z> / |z|.
"""
import math

from .enclosures import ends_of
from .exact import SAME_PLACE, Refuted, STATED, Unverified, add_to, number, root
from .prescribed import state_at
from .rational import Fraction
from .runs import Peak, Row
from .units import RADIAN, angle_of, in_unit

DEFAULT_REFERENCE = Fraction(1, 1000)  # lifts
KINDS = ("deviation", "deviation_rms")
SAME_ANGLE = STATED * RADIAN           # deg


def deviation_terms(problem):
    """measured.use = "nearest" is a weight of 1 where the objective gives none."""
    weights = {kind: number(problem.objective.get(kind, 0)) for kind in KINDS}
    given = problem.scene.get("measured", {})
    if given.get("use") == "nearest" and not any(weights.values()):
        weights["deviation_rms" if given.get("norm") == "rms" else "deviation"] = Fraction(1)
    asked = problem.objective.get("reference")
    asked = asked if isinstance(asked, dict) else {}
    return [Peak(kind, 0, weight, number(asked.get(kind, DEFAULT_REFERENCE))) for kind, weight in weights.items() if weight]


class MeasuredTable:
    """The rows on the motion. Of each: (run, a function of its control points, (low, high) of what is added to it): y less the row's
    displacement, in lifts."""

    def __init__(self, problem):
        given = problem.scene.get("measured", {})
        if given.get("outliers", "keep") != "keep" or "table" in given:
            raise Unverified("a measured table of which rows are left out, or that is another file")
        if problem.copies > 1 and problem.stretches[-1].to:
            raise Unverified("a measured table of a motion that goes on from copy to copy")
        self.problem, end = problem, problem.stretches[-1].end * problem.copies
        key, lifts = problem.lifts_of(given, "s")
        if key is None:
            raise Unverified("a measured table without displacements")
        angles, degree = self.angles(given, len(given[key])), in_unit((Fraction(1), "deg"), problem.unit_angle[1]) / problem.unit_angle[0]
        self.rows = [self.deviation(min(max(x, Fraction(0)), end), number(s) * lifts)
                     for x, s in self.arranged([(angle * degree, s) for angle, s in zip(angles, given[key], strict=True)], end, degree)
                     if -STATED <= x <= end + STATED]
        if not self.rows:
            raise Refuted("no row of the measured table is on the motion")

    def angles(self, given, count):
        """deg from the start of the motion."""
        key = next((key for key in given if key.startswith(("theta_", "step_"))), "theta_")
        name, unit = key.split("_", 1)
        values = [i * number(given[key]) for i in range(count)] if name == "step" else [number(value) for value in given[key]]
        if given.get("angles", "cam") == "crank" and unit != "crank_deg":
            values = [value / 2 for value in values]
        zero = given.get("zero", "start")
        if zero == "nose" and self.problem.type == "program":
            raise Unverified("a measured table from the nose of a program")
        first = Fraction(0) if zero == "start" else in_unit(self.problem.unit_angle, "deg") if zero == "nose" else number(zero["deg"])
        return [first + in_unit(angle_of({f"angle_{unit}": value}, "angle"), "deg") for value in values]

    def arranged(self, rows, end, degree):
        """(x, displacement) with ascending x; those beyond a motion of one revolution at most are moved by whole ones onto it."""
        if rows[0][0] > rows[-1][0]:
            rows = rows[::-1]
        turn, room = 360 * degree, SAME_ANGLE * degree
        if max(end, rows[-1][0] - rows[0][0]) > turn + room or self.problem.motion.get("closed") == "relative":
            return rows
        moved = [(x if -room <= x <= end + room else x - math.floor((x - end / 2) / turn + Fraction(1, 2)) * turn, s) for x, s in rows]
        if moved == rows:
            return rows
        kept = []
        for x, s in sorted(moved, key=lambda row: row[0]):
            if not kept or x - kept[-1][0] > room:
                kept.append((x, s))
        return kept

    def deviation(self, x, displacement):
        side = "left" if x > self.problem.stretches[-1].end * self.problem.copies - SAME_PLACE else "right"
        stretch = self.problem.stretch_at(self.problem.folded(x, side), side)
        for k, run in enumerate(self.problem.runs):
            if stretch in run.stretches:
                at = self.problem.folded(x, side) + run.begin_of(stretch) - stretch.begin
                return k, run.space.functional(at, 0, side), (-run.level(stretch) - displacement,) * 2
        return None, {}, tuple(end - displacement for end in ends_of(state_at(self.problem, x, side)[0][0]))

    def values(self, curve):
        """(low, high) of each row."""
        for k, function, ends in self.rows:
            of_run = sum((w * curve.control[k][j] for j, w in function.items()), Fraction(0))
            yield tuple(of_run + end for end in ends)

    def figure(self, curve, kind):
        """(low, high) around the largest distance, or the root mean square, lifts."""
        sizes = [(Fraction(0) if low < 0 < high else min(abs(low), abs(high)), max(abs(low), abs(high))) for low, high in self.values(curve)]
        if kind == "deviation":
            return max(low for low, _ in sizes), max(high for _, high in sizes)
        means = [sum(size[i]**2 for size in sizes) / len(sizes) for i in (0, 1)]
        return root(means[0])[0], root(means[1])[1]

    def row(self, origin):
        """That of a row of the table in a proof: ± the distance is at most the largest one."""
        row, sign = origin.which["row"], origin.which["side"]
        place = next((i for i, term in enumerate(self.problem.terms) if term.kind == "deviation"), None)
        if place is None or sign not in (1, -1) or not 0 <= row < len(self.rows):
            raise Refuted(f"{origin}: the scene has no such rule")
        sign, (k, function, ends) = int(sign), self.rows[int(row)]
        reference = self.problem.terms[place].reference
        return Row(str(origin), k or 0, {j: sign * w / reference for j, w in function.items()},
                   -min(sign * end for end in ends) / reference, place)

    def tangent(self, curve, place):
        """The root mean square lies above its tangent at the delivered motion z: rms(y) >= <y, z> / |z|. None: z is on every row."""
        found = [low for low, _ in self.values(curve)]
        size = root(sum(z * z for z in found) / len(found))[1] * len(found) * self.problem.terms[place].reference
        if not any(found):
            return None
        functions, constant = [{} for _ in self.problem.runs] or [{}], Fraction(0)
        for z, (k, function, ends) in zip(found, self.rows):
            constant += min(z * end for end in ends)
            if function:
                add_to(functions[k], function, z)
        return Row.over_runs("tangent of the root mean square of the deviations", functions, constant, size, Fraction(0), place)
