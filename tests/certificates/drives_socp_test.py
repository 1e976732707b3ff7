# SPDX-License-Identifier: MIT
"""Servo axes against a second-order cone program: drives_socp_test.py CAMOPT [--count 15] [--seed 34].

Random drives (load, friction, limits on torque, its root mean square, speed, torque-speed curve) are solved by camopt and, without
any of its code, by CVXOPT. The splines are those of bounds_lp_test.py; root mean squares are sums by Gauss and Legendre; rows are
added at the exact maxima of each polynomial piece. Objectives must agree to 1e-7, verdicts must be the same.
"""
import math
import sys

import numpy
from cvxopt import matrix, solvers

from bounds_lp_test import Splines, compared

EXCEEDED = 1e-10  # a rule exceeded by more than this part of its size becomes a row
SOLVED = 2e-9     # relative gap and residuals at which CVXOPT's result is taken although it was asked for more
TRIES = (1e-11, 1e-10, 1e-9)
ROUNDS = 40
PLACES, WEIGHTS = numpy.polynomial.legendre.leggauss(8)  # exact for polynomials to degree 15
FIXED = 1e-10     # rows shorter than this are of places that the conditions fix
JERK = 60.0       # the unit of the jerk's peak and its rows


class Rule:
    """constant + weights . (y, y', y'', y''') - size * variable <= 0 on a stroke, divided by scale."""

    def __init__(self, stroke, weights, constant, scale, variable=None, size=0.0):
        self.stroke, self.weights, self.constant = stroke, numpy.array(weights, float) / scale, constant / scale
        self.variable, self.size = variable, size / scale


class Program:
    """min weights . (variables): variables after the splines of the strokes are the terms of the objective."""

    def __init__(self, drive):
        self.drive = drive
        self.splines = [Splines(drive.degree, points) for points, _, _, _ in drive.strokes]
        self.offsets = numpy.cumsum([0] + [s.size for s in self.splines])
        self.design = int(self.offsets[-1])
        self.terms = list(drive.weights)
        self.rows, self.sides, self.places = [], [], set()
        self.rules = self.rules_of()
        self.norm, self.rest = self.norm_of()

    def rules_of(self):
        """Of every stroke: torque, speed and curve of the motor, its range and direction, peaks."""
        drive, rules = self.drive, []
        for k, (_, start, to, way) in enumerate(drive.strokes):
            const = drive.constant + way * drive.friction
            for sign in (1.0, -1.0):
                torque = [0.0, sign * drive.velocity, sign * drive.acceleration, 0.0]
                side = drive.torque["max" if sign > 0 else "min"] if drive.torque else None
                if side is not None:
                    rules.append(Rule(k, torque, sign * const - sign * side, drive.acceleration))
                if drive.speed_limit:
                    rules.append(Rule(k, [0.0, sign * drive.speed, 0.0, 0.0], -drive.speed_limit, drive.speed_limit))
                if "motor_torque" in drive.weights:
                    rules.append(Rule(k, torque, sign * const, drive.acceleration, "motor_torque", drive.references["motor_torque"]))
                if "jerk" in drive.weights:
                    scale = drive.jerk_scale(k)
                    rules.append(Rule(k, [0.0, 0.0, 0.0, sign], 0.0, JERK, "jerk", drive.references["jerk"] * scale))
                for (n, most), (further, less) in zip(drive.curve, drive.curve[1:]):
                    fall = (most - less) / (further - n)
                    for way_of in (1.0, -1.0):
                        own = [0.0, torque[1] + way_of * fall * drive.speed, torque[2], 0.0]
                        rules.append(Rule(k, own, sign * const - most - fall * n, drive.acceleration))
                if drive.curve:
                    rules.append(Rule(k, [0.0, sign * drive.speed, 0.0, 0.0], -drive.curve[-1][0], drive.curve[-1][0]))
            rules += [Rule(k, [1.0, 0.0, 0.0, 0.0], -1.0, 1.0), Rule(k, [-1.0, 0.0, 0.0, 0.0], 0.0, 1.0)]
            if drive.monotone:
                rules.append(Rule(k, [0.0, -1.0 if to > start else 1.0, 0.0, 0.0], 0.0, 1.0))
        return rules

    def norm_of(self):
        """The root mean square is |norm . design + rest|: one row a place of quadrature, then a triangle."""
        drive, rows, rest = self.drive, [], []
        for k, (points, _, _, way) in enumerate(drive.strokes):
            for i, (a, b) in enumerate(zip(points, points[1:])):
                for place, weight in zip(PLACES, WEIGHTS):
                    x, root = (a + b + (b - a) * place) / 2, math.sqrt(weight * (b - a) / 2 / drive.cycle)
                    row = numpy.zeros(self.design)
                    own = self.splines[k]
                    row[self.offsets[k]:self.offsets[k + 1]] = root * (drive.velocity * own.row_on(i, x, 1) +
                                                                       drive.acceleration * own.row_on(i, x, 2))
                    rows.append(row)
                    rest.append(root * (drive.constant + way * drive.friction))
        still = drive.cycle - sum(points[-1] - points[0] for points, _, _, _ in drive.strokes)
        rows.append(numpy.zeros(self.design))
        rest.append(drive.constant * math.sqrt(max(0.0, still) / drive.cycle))
        triangle = numpy.linalg.qr(numpy.hstack([rows, numpy.array(rest)[:, None]]), "r")
        return triangle[:, :-1], triangle[:, -1]

    def conditions(self):
        rows, values = [], []
        for k, (points, start, to, _) in enumerate(self.drive.strokes):
            for x, left, y in ((points[0], False, start), (points[-1], True, to)):
                if self.drive.kind == "RR" and x == 1.0:  # the two strokes join: y(1) = 1, y'(1) = 0, y'' and more go on
                    orders = (0, 1)
                else:
                    orders = (0, 1, 2)
                for order in orders:
                    row = numpy.zeros(self.design)
                    row[self.offsets[k]:self.offsets[k + 1]] = self.splines[k].row(x, order, left)
                    rows.append(row)
                    values.append(y if order == 0 else 0.0)
        for order in range(2, self.drive.degree) if self.drive.kind == "RR" else ():
            row = numpy.zeros(self.design)
            row[:self.offsets[1]] = self.splines[0].row(1.0, order, True) / 60.0**max(0, order - 2)
            row[self.offsets[1]:] = -self.splines[1].row(1.0, order) / 60.0**max(0, order - 2)
            rows.append(row)
            values.append(0.0)
        return numpy.hstack([numpy.array(rows), numpy.zeros((len(rows), len(self.terms)))]), numpy.array(values)

    def solve(self):
        """The objective, or None where there is no such motion."""
        self.start, self.basis = self.freedom(*self.conditions())
        for rule in self.rules:
            for i, (a, b) in enumerate(zip(self.points(rule), self.points(rule)[1:])):
                for x in (a, (a + b) / 2, b):
                    self.add(rule, i, x)
        for _ in range(ROUNDS):
            found = self.cone_program()
            if found is None:
                return None
            if not sum(self.exchange(number, rule, found) for number, rule in enumerate(self.rules)):
                return sum(self.drive.weights[name] * found[self.design + i] for i, name in enumerate(self.terms))
        raise AssertionError("the exchange does not end")

    def points(self, rule):
        return self.drive.strokes[rule.stroke][0]

    def add(self, rule, i, x):
        row = numpy.zeros(self.design + len(self.terms))
        own = slice(self.offsets[rule.stroke], self.offsets[rule.stroke + 1])
        for order, weight in enumerate(rule.weights):
            if weight:
                row[own] += weight * self.splines[rule.stroke].row_on(i, x, order)
        if rule.variable:
            row[self.design + self.terms.index(rule.variable)] = -rule.size
        if numpy.linalg.norm(row @ self.basis) > FIXED:  # what the conditions alone fix has no inside
            self.rows.append(row)
            self.sides.append(-rule.constant)

    def exchange(self, number, rule, found):
        """Rows at the maxima of a rule on every piece: its ends and the roots of its slope."""
        own = found[self.offsets[rule.stroke]:self.offsets[rule.stroke + 1]]
        room = -rule.constant + (rule.size * found[self.design + self.terms.index(rule.variable)] if rule.variable else 0.0)
        added, points = 0, self.points(rule)
        for i, (a, b) in enumerate(zip(points, points[1:])):
            y = numpy.poly1d(numpy.tensordot(own, self.splines[rule.stroke].values[:, i, :], 1))
            value = sum((weight * (numpy.polyder(y, order) if order else y) for order, weight in enumerate(rule.weights) if weight),
                        numpy.poly1d([0.0]))
            roots = [t.real for t in numpy.roots(numpy.polyder(value)) if abs(t.imag) < 1e-9 and 0.0 < t.real < b - a]
            for t in [0.0, b - a] + roots:
                place = number, i, round(t / (b - a), 5)
                if value(t) > room + EXCEEDED and place not in self.places:
                    self.places.add(place)
                    self.add(rule, i, a + t)
                    added += 1
        return added

    def cone_program(self):
        """The optimum over the rows so far; None: there is none."""
        drive, size = self.drive, self.design + len(self.terms)
        cost = numpy.concatenate([numpy.zeros(self.design), [drive.weights[name] for name in self.terms]])
        blocks, sides, cones = [numpy.array(self.rows)], [numpy.array(self.sides)], []
        heads = []
        if "motor_torque_rms" in drive.weights:
            head = numpy.zeros(size)
            head[self.design + self.terms.index("motor_torque_rms")] = -drive.references["motor_torque_rms"]
            heads.append((head, 0.0))
        if drive.rms_limit:
            heads.append((numpy.zeros(size), drive.rms_limit))
        for head, side in heads:
            body = numpy.hstack([-self.norm, numpy.zeros((len(self.norm), len(self.terms)))])
            blocks.append(numpy.vstack([head, body]))
            sides.append(numpy.concatenate([[side], self.rest]))
            cones.append(len(self.norm) + 1)
        dims = {"l": len(self.rows), "q": cones, "s": []}
        start, basis, block = self.start, self.basis, numpy.vstack(blocks)
        arguments = [matrix(basis.T @ cost), matrix(block @ basis), matrix(numpy.concatenate(sides) - block @ start), dims]
        for tolerance in TRIES:
            options = {"show_progress": False, "abstol": tolerance, "reltol": tolerance, "feastol": tolerance, "refinement": 2}
            try:
                found = solvers.conelp(*arguments, options=options)
            except (ValueError, ArithmeticError):  # a step past the last digits
                continue
            if found["status"] == "primal infeasible":
                return None
            if found["status"] == "optimal" or max(found["primal infeasibility"] or 1.0, found["dual infeasibility"] or 1.0,
                                                   found["relative gap"] or 1.0) < SOLVED:
                return start + basis @ numpy.array(found["x"]).ravel()
        raise AssertionError("CVXOPT gives up")

    @staticmethod
    def freedom(equal, values):
        """(start, basis): all that meets the conditions is start + basis u."""
        _, sizes, rows = numpy.linalg.svd(equal)
        rank = int(numpy.sum(sizes > 1e-12 * sizes[0]))
        return numpy.linalg.lstsq(equal, values, None)[0], rows[rank:].T


class RandomDrive:
    """A scene as text, and the same as numbers: torque = acceleration y'' + velocity y' + constant ± friction, speed y'."""

    def __init__(self, numbers, index):
        self.numbers, self.index = numbers, index
        self.kind, self.degree = ("DRD", "program", "DRD", "RR", "program")[index % 5], (3, 5)[index // 2 % 2]
        self.segments = 2 * numbers.randint(4, 8)
        self.lift, self.rise = numbers.choice((60, 100, 250)), numbers.choice((80, 110, 130))
        self.back = self.rise if self.kind == "RR" else round(self.rise * numbers.uniform(0.7, 1.25))
        self.speed_rpm = round(numbers.uniform(60, 220))
        self.monotone = index % 3 == 1
        self.turns = index % 4 == 3
        self.choose_drive()
        self.choose_strokes()
        self.choose_objective()
        self.choose_limits()
        self.text = self.written()

    def choose_drive(self):
        n = self.numbers
        time = self.rise / (6.0 * self.speed_rpm)
        lift = math.radians(self.lift) if self.turns else self.lift / 1000
        travel = n.choice((36, 60)) if self.turns else n.choice((40, 60, 90))
        mass = round(n.uniform(0.02, 0.4), 3) if self.turns else round(n.uniform(1, 12), 2)
        inertia = n.choice((0.0, 1e-4, 4e-4))
        per_radian = (math.radians(travel) if self.turns else travel / 1000) / (2 * math.pi)
        scale = lift / time**2  # m/s^2 of y'' = 1
        viscous = round(n.choice((0.0, 0.05, 0.3)) * mass * 4 / time, 4)
        force = round(n.uniform(-1.0, 1.5) * mass * scale, 4)
        friction = round(n.uniform(0.3, 1.0) * mass * scale, 4) if self.monotone else 0.0
        self.acceleration = (mass * per_radian + inertia / per_radian) * scale
        self.velocity, self.constant, self.friction = viscous * per_radian * lift / time, force * per_radian, friction * per_radian
        self.speed = lift / time / per_radian
        names = (("load_inertia_kg_m2", "transmission_deg_per_rev", "viscous_nm_s_rad", "moment_nm", "friction_nm") if self.turns else
                 ("load_mass_kg", "transmission_mm_per_rev", "viscous_n_s_m", "force_n", "friction_n"))
        self.drive = f"motor_inertia_kg_m2 = {inertia}\n" + "".join(
            f"{name} = {value!r}\n" for name, value in zip(names, (mass, travel, viscous, force, friction)))

    def choose_strokes(self):
        """(points, y at both ends, direction)."""
        ratio, half = self.back / self.rise, self.segments // 2
        rise = [i / self.segments for i in range(self.segments + 1)]
        if self.kind == "DRD":
            self.strokes = [(rise, 0.0, 1.0, 1)]
        elif self.kind == "RR":
            self.strokes = [([i / half for i in range(half + 1)], 0.0, 1.0, 1), ([1 + i / half for i in range(half + 1)], 1.0, 0.0, -1)]
        else:
            self.dwells = self.numbers.randint(20, 50), 0
            begin = 1.0 + self.dwells[0] / self.rise
            self.strokes = [(rise, 0.0, 1.0, 1), ([begin + ratio * x for x in rise], 1.0, 0.0, -1)]
        self.cycle = 360.0 / self.rise
        self.cycle_text = ""
        if self.kind != "program" and self.numbers.random() < 0.5:
            degrees = self.rise * (2 if self.kind == "RR" else 1) + self.numbers.randint(0, 60)
            self.cycle, self.cycle_text = degrees / self.rise, f"cycle_deg = {degrees}\n"

    def jerk_scale(self, k):
        """y''' of one in the unit of J: a stroke of a program has its own unit."""
        points = self.strokes[k][0]
        return 1.0 if self.kind != "program" else 1.0 / (points[-1] - points[0])**3

    def law_figures(self):
        """Peak and root mean square of the torque along the cycloidal law in the place of the strokes."""
        peak, square, still = abs(self.constant), 0.0, self.cycle
        if self.cycle - sum(points[-1] - points[0] for points, _, _, _ in self.strokes) < 1e-12:
            peak = 0.0
        if self.kind != "program":
            peak = 0.0
        for points, _, _, way in self.strokes:
            length = points[-1] - points[0]
            v, a, c = way * self.velocity / length, way * self.acceleration * 2 * math.pi / length**2, self.constant + way * self.friction
            for sign in (1, -1):  # v (1 - cos) + a sin + c
                peak = max(peak, sign * (v + c) + math.hypot(v, a))
            square += length * (1.5 * v * v + a * a / 2 + c * c + 2 * v * c)
            still -= length
        return peak, math.sqrt((square + max(0.0, still) * self.constant**2) / self.cycle)

    def choose_objective(self):
        n = self.numbers
        peak, rms = self.law_figures()
        self.typical, self.typical_rms = peak, rms
        self.weights = {"motor_torque_rms": 1.0} if self.index % 4 < 2 else {"jerk": round(n.uniform(0.2, 1.0), 3)}
        if self.index % 4 in (1, 3):
            self.weights["jerk"] = 0.1
        if self.index % 3 == 2:
            self.weights["motor_torque"] = round(n.uniform(0.2, 1.0), 3)
        if self.index % 2:
            self.references = {name: round(value, 3) for name, value in (("motor_torque", peak), ("motor_torque_rms", rms), ("jerk", 50))}
            self.reference = "{ " + ", ".join(f"{name} = {value}" for name, value in self.references.items()) + " }"
        else:
            self.references = {"motor_torque": peak, "motor_torque_rms": rms, "jerk": 4 * math.pi**2}
            self.reference = '"cycloidal"'

    def choose_limits(self):
        n, lines = self.numbers, []
        self.torque, self.speed_limit, self.curve, self.rms_limit = None, None, [], None
        if self.index % 9 == 8:
            self.typical *= 0.7
        if self.index % 5 in (0, 1, 4) or self.index % 9 == 8:
            most = round(n.uniform(0.92, 1.12) * self.typical, 4)
            if n.random() < 0.5:
                self.torque = {"min": -most, "max": most}
                lines.append(f"motor_torque_nm = {most}")
            else:
                self.torque = {"min": None, "max": most}
                lines.append(f"motor_torque_nm = {{ max = {most} }}")
        top = self.speed * 2.0  # of a cycloidal stroke of length 1
        if self.index % 4 == 2:
            rpm = round(n.uniform(0.92, 1.2) * top * 30 / math.pi, 2)
            self.speed_limit = rpm * math.pi / 30
            lines.append(f"motor_speed_rpm = {rpm}")
        if self.index % 5 in (2, 3):
            full, corner = round(n.uniform(0.95, 1.2) * self.typical, 4), round(n.uniform(0.5, 0.7) * top * 30 / math.pi)
            last, low = round(n.uniform(1.2, 1.5) * top * 30 / math.pi), round(0.3 * full, 4)
            self.curve = [(0.0, full), (corner * math.pi / 30, full), (last * math.pi / 30, low)]
            lines.append(f"motor_curve = [[0, {full}], [{corner}, {full}], [{last}, {low}]]")
        if "motor_torque_rms" not in self.weights:
            if self.index % 8 == 7:  # mostly less than any motion needs
                self.typical_rms *= 0.8
            self.rms_limit = round(n.uniform(0.95, 1.04) * self.typical_rms, 4)
            lines.append(f"motor_torque_rms_nm = {self.rms_limit}")
        self.limits = "".join(line + "\n" for line in lines)

    def written(self):
        lift = f"lift_{'deg' if self.turns else 'mm'} = {self.lift}\nspeed_rpm = {self.speed_rpm}\n"
        motion = f'[motion]\ntype = "{self.kind}"\n{lift}monotone = {str(self.monotone).lower()}\n'
        if self.kind == "program":
            rest = 360 - self.rise - self.back - self.dwells[0]
            for kind, angle, to in (("spline", self.rise, 1), ("dwell", self.dwells[0], None), ("spline", self.back, 0),
                                    ("dwell", rest, None)):
                motion += f'[[motion.segments]]\nkind = "{kind}"\nangle_deg = {angle}\n' + (f"to = {to}\n" if to is not None else "")
        else:
            motion += f"rise_deg = {self.rise}\n"
        weights = "".join(f"{name} = {weight}\n" for name, weight in self.weights.items())
        return (f"{motion}[spline]\ndegree = {self.degree}\nsegments = {self.segments}\n[drive]\n{self.drive}{self.cycle_text}"
                f"[objective]\n{weights}reference = {self.reference}\n[limits]\n{self.limits}")


def main():
    return compared(__doc__, 15, 34, RandomDrive, Program, lambda drive: ", " + ", ".join(drive.weights),
                    lambda met, count: met["optimal"] >= count // 2 and met["infeasible"])


if __name__ == "__main__":
    sys.exit(main())
