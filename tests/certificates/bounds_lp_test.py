# SPDX-License-Identifier: MIT
"""Sided limits, corridors and lost area against a linear program: bounds_lp_test.py CAMOPT [--count 20] [--seed 32].

Random scenes are solved by camopt and, without any of its code, by HiGHS. The spline here is y(0), y'(0), y''(0) and the
B-spline coefficients of y''', integrated three times; rows are added where a bound is exceeded most, at the exact extremes of
each polynomial piece. Objectives must agree to 1e-7, verdicts must be the same. Where the program finds less, by rows that its
tolerance exceeds next to the ends of a stroke, scripts/verify-certificate decides; at most one scene in ten.
"""
import argparse
import json
import random
import subprocess
import sys
import tempfile
from pathlib import Path

import numpy
from scipy.optimize import linprog

import checker

SAME = 1e-7       # of objectives, relative
EXCEEDED = 1e-12  # a bound exceeded by more than this part of its size becomes a row
GRID = 6          # places of the first grid in a piece
ROUNDS = 60
JUDGED = "below which HiGHS comes, and no motion, proved exactly"
TRIES = (("highs-ds", 1e-10, True), ("highs-ds", 1e-10, False), ("highs-ds", 1e-9, True), ("highs-ds", 1e-9, False))
TYPICAL = (1.0, 2.0, 6.0, 60.0)  # of y, y', y'', y''': rows are divided by these
PER_SECOND = 1500.0  # degrees, at 250 rpm
NAMES = ("displacement", "velocity", "acceleration", "jerk")


def bspline_pieces(degree, points):
    """The B-splines of a degree on clamped simple knots, by Cox and de Boor: [function][piece] polynomials of t = x - left end."""
    knots = [points[0]] * degree + list(points) + [points[-1]] * degree
    pieces = len(points) - 1
    functions = [[numpy.poly1d([1.0 if i == k - degree else 0.0]) for i in range(pieces)] for k in range(len(knots) - 1)]
    for d in range(1, degree + 1):
        raised = []
        for k in range(len(functions) - 1):
            own = []
            for i in range(pieces):
                total = numpy.poly1d([0.0])
                if knots[k + d] > knots[k]:
                    total += numpy.poly1d([1.0, points[i] - knots[k]]) / (knots[k + d] - knots[k]) * functions[k][i]
                if knots[k + d + 1] > knots[k + 1]:
                    total += numpy.poly1d([-1.0, knots[k + d + 1] - points[i]]) / (knots[k + d + 1] - knots[k + 1]) * \
                        functions[k + 1][i]
                own.append(total)
            raised.append(own)
        functions = raised
    return functions


class Splines:
    """All splines of a degree with continuous derivatives to degree - 1: values[j, i] is function j on piece i, highest power
    first."""

    def __init__(self, degree, points):
        self.points, self.degree = numpy.array(points), degree
        widths, functions = numpy.diff(self.points), []
        for start in range(3):
            functions.append(self.integrated([numpy.poly1d([0.0])] * len(widths), widths, start))
        for jerk in bspline_pieces(degree - 3, points):
            functions.append(self.integrated([60.0 * p for p in jerk], widths, None))
        self.size = len(functions)
        self.values = numpy.zeros((self.size, len(widths), degree + 1))
        for j, function in enumerate(functions):
            for i, p in enumerate(function):
                self.values[j, i, degree + 1 - len(p.coeffs):] = p.coeffs

    @staticmethod
    def integrated(jerk, widths, start):
        pieces = list(jerk)
        for order in (2, 1, 0):
            value = 1.0 if order == start else 0.0
            for i, width in enumerate(widths):
                pieces[i] = numpy.polyint(pieces[i], k=value)
                value = pieces[i](width)
        return pieces

    def piece_of(self, x, left=False):
        i = numpy.searchsorted(self.points, x, side="left" if left else "right") - 1
        return min(max(int(i), 0), len(self.points) - 2)

    def row(self, x, order, left=False):
        i = self.piece_of(x, left)
        return numpy.array([numpy.polyval(numpy.polyder(self.values[j, i], order) if order else self.values[j, i],
                                          x - self.points[i]) for j in range(self.size)])

    def row_on(self, i, x, order):
        """The same on piece i, which may end at x."""
        powers = numpy.zeros(self.degree + 1)
        t = x - self.points[i]
        for m in range(order, self.degree + 1):
            powers[self.degree - m] = numpy.prod(numpy.arange(m, m - order, -1.0)) * t**(m - order)
        return self.values[:, i, :] @ powers

    def mean(self):
        widths = numpy.diff(self.points)
        return numpy.array([sum(numpy.polyval(numpy.polyint(self.values[j, i]), w) for i, w in enumerate(widths))
                            for j in range(self.size)]) / (self.points[-1] - self.points[0])

    def extremes(self, design, order, begin, end):
        """[(piece, x)] where the derivative can be largest or least on a stretch: its ends, breakpoints, roots of the next."""
        found = []
        for i, (a, b) in enumerate(zip(self.points, self.points[1:])):
            low, high = max(a, begin), min(b, end)
            if low > high or (low == high and begin < end):
                continue
            found += [(i, low), (i, high)]
            slope = numpy.polyder(numpy.tensordot(design, self.values[:, i, :], 1), order + 1)
            for t in numpy.roots(slope) if numpy.any(slope) else ():
                if abs(t.imag) < 1e-9 and low < a + t.real < high:
                    found.append((i, a + t.real))
        return found


class Program:
    """min cost . (design, peaks): rows sign y^(order)(x) - peak <= bound at the places found so far."""

    def __init__(self, scene):
        self.scene = scene
        self.splines = Splines(scene.degree, scene.points)
        self.rules = list(scene.bounds)  # (order, sign, bound, begin, end)
        self.peaks = [name for name in ("velocity", "acceleration", "jerk") if scene.weights.get(name)]
        self.rows, self.sides, self.places = [], [], set()

    def solve(self):
        """(objective, or None where there is no such motion)."""
        length, splines = self.scene.length, self.splines
        peaks = [(NAMES.index(name), sign, k, 0.0, length) for k, name in enumerate(self.peaks) for sign in (1, -1)]
        for order, sign, k, begin, end in peaks:
            self.grid(order, sign, 0.0, begin, end, k)
        for order, sign, bound, begin, end in self.rules:
            self.grid(order, sign, bound, begin, end, None)
        cost, constant = self.cost()
        equal, values = self.conditions()
        for _ in range(ROUNDS):
            found = self.linear_program(cost, equal, values)
            if found is None:
                return None
            design, own = found.x[:splines.size], found.x[splines.size:]
            added = 0
            for order, sign, k, begin, end in peaks:
                added += self.exchange(design, order, sign, own[k] * TYPICAL[order], begin, end, k)
            for order, sign, bound, begin, end in self.rules:
                added += self.exchange(design, order, sign, bound, begin, end, None)
            if not added:
                return found.fun + constant
        raise AssertionError("the exchange does not end")

    def linear_program(self, cost, equal, values):
        """The optimum over the rows so far; None: there is none. HiGHS may give up with one tolerance and not with another."""
        for method, tolerance, presolve in TRIES:
            found = linprog(cost, numpy.array(self.rows), numpy.array(self.sides), equal, values, (None, None), method,
                            options={"primal_feasibility_tolerance": tolerance, "dual_feasibility_tolerance": tolerance,
                                     "presolve": presolve})
            if found.status in (0, 2):
                return found if found.status == 0 else None
        raise AssertionError(f"HiGHS: {found.message}")

    def cost(self):
        cost, constant, scene = numpy.zeros(self.splines.size + len(self.peaks)), 0.0, self.scene
        for k, name in enumerate(self.peaks):
            cost[self.splines.size + k] = scene.weights[name] / scene.references[name] * TYPICAL[NAMES.index(name)]
        if scene.weights.get("area"):
            factor = scene.weights["area"] / scene.references["area"]
            cost[:self.splines.size] -= factor * self.splines.mean()
            constant = factor
        return cost, constant

    def conditions(self):
        rows, values, end = [], [], self.scene.length
        for order in range(1 + getattr(self.scene, "rest", 2)):
            for row in self.splines.row(0.0, order), self.splines.row(end, order, True):
                rows.append(row if order < 3 else row / numpy.abs(row).max())
            values += [0.0, 1.0 if order == 0 and self.scene.kind == "DRD" else 0.0]
        if self.scene.kind == "RR":
            rows += [self.splines.row(1.0, 0), self.splines.row(1.0, 1)]
            values += [1.0, 0.0]
        return numpy.hstack([numpy.array(rows), numpy.zeros((len(rows), len(self.peaks)))]), values

    def add(self, i, x, order, sign, bound, peak):
        row = numpy.zeros(self.splines.size + len(self.peaks))
        row[:self.splines.size] = sign * self.splines.row_on(i, x, order) / TYPICAL[order]
        if peak is not None:
            row[self.splines.size + peak] = -1.0
        self.rows.append(row)
        self.sides.append(bound / TYPICAL[order])

    def grid(self, order, sign, bound, begin, end, peak):
        points = self.splines.points
        for i, (a, b) in enumerate(zip(points, points[1:])):
            low, high = max(a, begin), min(b, end)
            if low < high:
                for x in numpy.linspace(low, high, GRID):
                    self.add(i, x, order, sign, bound, peak)

    def exchange(self, design, order, sign, bound, begin, end, peak):
        size, added = max(abs(bound), TYPICAL[order]), 0
        for i, x in self.splines.extremes(design, order, begin, end):
            if sign * self.splines.row_on(i, x, order) @ design > bound + EXCEEDED * size:
                place = (i, round(x, 13), order, sign, bound if peak is None else peak)
                if place not in self.places:  # a row that is there is exceeded by the tolerance of HiGHS
                    self.places.add(place)
                    self.add(i, x, order, sign, 0.0 if peak is not None else bound, peak)
                    added += 1
        return added


class RandomScene:
    """A scene as text, and the same as numbers in lifts by x."""

    def __init__(self, numbers, index):
        self.numbers = numbers
        self.kind, self.degree = ("DRD", "RR")[index % 2], (3, 5, 7)[index // 2 % 3]
        self.rest = 2 + index // 6 % (self.degree - 2)
        self.lift, self.rise = numbers.choice((8, 12.5, 40)), numbers.choice((60, 90, 120))
        self.back = self.rise if numbers.random() < 0.5 else round(self.rise * numbers.uniform(0.8, 1.5))
        self.length = 1.0 if self.kind == "DRD" else 1.0 + self.back / self.rise
        self.segments = numbers.randint(10 if self.degree == 3 else 8, 24)
        self.points = [self.length * i / self.segments for i in range(self.segments + 1)]
        self.within = index // 4 % 2 == 0
        self.bounds = []
        self.choose_weights(index)
        limits = self.choose_limits()
        corridors = "".join(self.choose_corridor() for _ in range(numbers.randint(1, 3)))
        self.text = self.written(limits, corridors)
        if self.within:
            for begin, end in [(0.0, 1.0)] + ([(1.0, self.length)] if self.kind == "RR" else []):
                self.bounds += [(0, 1, 1.0, begin, end), (0, -1, 0.0, begin, end)]

    def choose_weights(self, index):
        self.references = {"acceleration": 5.53, "jerk": 69.0, "area": 0.5, "velocity": 1.76}
        self.weights = {"area": round(self.numbers.uniform(0.05, 0.5), 3),
                        "acceleration": round(self.numbers.uniform(0.1, 0.6), 3),
                        "jerk": round(self.numbers.uniform(0.1, 0.6), 3)}
        if index % 5 == 0:
            del self.weights["acceleration"]
        if index % 7 == 3:
            self.weights["velocity"] = 0.2
        if index % 10 == 9:  # so small that camopt scales the objective
            self.weights = {name: round(0.05 * weight, 5) for name, weight in self.weights.items()}

    def choose_limits(self):
        text = ""
        room = 1.5 if self.degree == 7 else 1.0  # what rests to a higher order needs larger peaks
        for name, order, least in (("acceleration", 2, 5.6 * room), ("jerk", 3, 60.0 * room)):
            sides = {"min": -round(self.numbers.uniform(least, 2 * least), 2),
                     "max": round(self.numbers.uniform(least, 2 * least), 2)}
            if self.numbers.random() < 0.2:
                del sides[self.numbers.choice(("min", "max"))]
            in_time = self.numbers.random() < 0.4
            unit = self.lift * (PER_SECOND / self.rise)**order if in_time else 1.0  # mm/s^order of one
            if in_time:
                sides = {side: round(value * unit) for side, value in sides.items()}
            text += f"{name}{('_mm_s%d' % order) if in_time else ''} = {self.pair(sides)}\n"
            self.take(order, sides, unit, 0.0, self.length)
        return text

    def choose_corridor(self):
        begin = round(self.numbers.uniform(0.0, 0.8 * self.length) * self.rise, 2)
        end = min(round(begin + self.numbers.uniform(0.05, 0.3) * self.length * self.rise, 2), self.length * self.rise)
        a, b = begin / self.rise, min(end / self.rise, self.length)
        order = self.numbers.choice((0, 0, 1, 2))
        stated, unit = NAMES[order], 1.0
        if self.numbers.random() < 0.5:
            stated += ("_mm", "_mm_s", "_mm_s2")[order]
            unit = self.lift * (PER_SECOND / self.rise)**order
        middle, slope = self.typical((a + b) / 2), self.typical_slope((a + b) / 2)
        sides = {}
        if order == 0:
            sides = {"max": middle + 0.5 * abs(slope) * (b - a) + self.numbers.uniform(-0.05, 0.1),
                     "min": middle - 0.5 * abs(slope) * (b - a) - self.numbers.uniform(-0.05, 0.1)}
        elif order == 1:
            sides = {"max": slope + self.numbers.uniform(0.1, 0.8), "min": slope - self.numbers.uniform(0.1, 0.8)}
        else:
            sides = {"max": self.numbers.uniform(1.0, 5.0), "min": -self.numbers.uniform(1.0, 5.0)}
        if self.numbers.random() < 0.6:
            del sides[self.numbers.choice(("min", "max"))]
        if len(sides) == 2 and sides["min"] >= sides["max"]:
            del sides["min"]
        sides = {side: float(f"{value * unit:.6g}") for side, value in sides.items()}
        self.take(order, sides, unit, a, b)
        return f"[[motion.corridor]]\nfrom_deg = {begin}\nto_deg = {end}\n{stated} = {self.pair(sides)}\n"

    def typical(self, x):
        """The 3-4-5 polynomial, which the corridors are placed around."""
        u = x if x <= 1.0 else (self.length - x) / (self.length - 1.0)
        return u**3 * (10 - 15 * u + 6 * u * u)

    def typical_slope(self, x):
        u, step = (x, 1.0) if x <= 1.0 else ((self.length - x) / (self.length - 1.0), -1.0 / (self.length - 1.0))
        return 30 * u * u * (1 - u)**2 * step

    def take(self, order, sides, unit, begin, end):
        for side, value in sides.items():
            sign = 1 if side == "max" else -1
            self.bounds.append((order, sign, sign * value / unit, begin, end))

    @staticmethod
    def pair(sides):
        return "{ " + ", ".join(f"{side} = {sides[side]!r}" for side in ("min", "max") if side in sides) + " }"

    def written(self, limits, corridors):
        back = f"return_deg = {self.back}\n" if self.kind == "RR" else ""
        weights = "".join(f"{name} = {weight}\n" for name, weight in self.weights.items())
        references = ", ".join(f"{name} = {value}" for name, value in self.references.items())
        return (f'[motion]\ntype = "{self.kind}"\nlift_mm = {self.lift}\nrise_deg = {self.rise}\n{back}speed_rpm = 250\n'
                f"within_lift = {str(self.within).lower()}\n{corridors}"
                f"[spline]\ndegree = {self.degree}\nsegments = {self.segments}\nrest = {self.rest}\n"
                f"[objective]\n{weights}reference = {{ {references} }}\n[limits]\n{limits}")


def solved(camopt, text, place, index):
    scene = Path(place) / f"scene_{index}.toml"
    scene.write_text(text)
    run = subprocess.run([camopt, "solve", str(scene), "--json"], capture_output=True, text=True, timeout=300)
    if run.returncode not in (0, 3):
        raise AssertionError(f"camopt ended with {run.returncode}: {run.stderr}\n{text}")
    result = json.loads(run.stdout)
    return result["verdict"], result["objective"]


def proved_exactly(camopt, text, folder):
    """Whether no motion is below what camopt says, in exact arithmetic; and what it delivers satisfies the scene."""
    checker.solve(camopt, text, folder)
    code, why = checker.outcome(checker.load(), folder)
    print(f"  {code}: {why}")
    return code == "confirmed"


def compared(description, count, seed, draw, program, words_of, enough):
    """Random scenes through camopt and the program that is independent of it; the exit code. enough(met, count): the verdicts met."""
    parser = argparse.ArgumentParser(description=description)
    parser.add_argument("camopt")
    parser.add_argument("--count", type=int, default=count)
    parser.add_argument("--seed", type=int, default=seed)
    arguments = parser.parse_args()
    numbers, faults, met = random.Random(arguments.seed), [], {"optimal": 0, "infeasible": 0}
    with tempfile.TemporaryDirectory() as place:
        for index in range(arguments.count):
            scene = draw(numbers, index)
            words = f"{index}: {scene.kind}, degree {scene.degree}, {scene.segments} segments{words_of(scene)}: "
            try:
                expected = program(scene).solve()
                verdict, objective = solved(arguments.camopt, scene.text, place, index)
            except AssertionError as fault:
                faults.append(f"{words}{fault}\n{scene.text}")
                continue
            words += f"camopt {verdict} {objective}, expected {expected}"
            print(words, flush=True)
            met[verdict] = met.get(verdict, 0) + 1
            same = verdict == ("infeasible" if expected is None else "optimal")
            if same and expected is not None and expected < objective * (1 - SAME) and \
                    proved_exactly(arguments.camopt, scene.text, Path(place) / f"judged_{index}"):
                met[JUDGED] = met.get(JUDGED, 0) + 1
                if 10 * met[JUDGED] <= arguments.count:
                    continue
            if not same or (expected is not None and abs(objective - expected) > SAME * abs(expected)):
                faults.append(words + "\n" + scene.text)
    print(met)
    if not enough(met, arguments.count):
        faults.append("too few optima, or too few scenes without a motion")
    return checker.end(faults)


def main():
    return compared(__doc__, 20, 32, RandomScene, Program, lambda scene: "",
                    lambda met, count: min(met["optimal"], met["infeasible"]) >= count // 10)


if __name__ == "__main__":
    sys.exit(main())
