# SPDX-License-Identifier: MIT
"""Linear (plate) cams against linear programs: linear_lp_test.py CAMOPT [--count 40] [--seed 20].

Random scenes are solved by camopt and, without any of its code, by HiGHS on the splines of bounds_lp_test.py. On a plate that slides by
c for every radian a pushed follower, inclined by d against the normal of the travel, has tan(pressure angle) = (s'/c + sin d)/cos d (of
the opposite sign where c < 0): rows on y'. An arm of length l at the angle p has (l p' + c sin p)/(|c| cos p): where its angle stays below
the limit that is convex in (p, p'), and tangents are added where the motion passes it. Verdicts must be the same, objectives agree to
1e-7, and scripts/verify-certificate must confirm every result.
"""
import math
import sys

import numpy

import checker
import program_trials
from bounds_lp_test import SAME, Program

FOLLOWERS = ("translating_roller", "translating_knife", "oscillating_roller")
PASSED = 1e-9      # of a pressure angle's excess, in parts of c
PLACES = 24        # of each piece that a pressure angle is looked at
MOST_CUTS = 200
MOST_UNDECIDED = 0.15  # of the scenes


class Scene:
    """A plate, its motion, and what bounds_lp_test.Program asks for."""

    def __init__(self, numbers, index):
        self.numbers, self.follower = numbers, FOLLOWERS[index % 3]
        self.kind, self.degree = ("DRD", "RR")[index // 3 % 2], (3, 3, 5)[index % 3]
        self.swings = self.follower == "oscillating_roller"
        self.rise = numbers.choice((70, 90, 120))
        self.back = self.rise if numbers.random() < 0.5 else round(self.rise * numbers.uniform(0.8, 1.4))
        self.length = 1.0 if self.kind == "DRD" else 1.0 + self.back / self.rise
        self.segments = numbers.randint(8, 20)
        self.points = [self.length * i / self.segments for i in range(self.segments + 1)]
        self.references = {"velocity": 1.76, "acceleration": 5.53, "jerk": 69.0}
        self.weights = {name: round(numbers.uniform(0.1, 0.6), 3) for name in self.references if name != "velocity" or index % 2}
        self.way = numbers.choice((1, -1))
        # y' of about 1.2 to 2.2 at the pressure angle's limit; below 1 there is no rise.
        self.steep = numbers.uniform(0.95, 2.2)
        self.limits = [round(numbers.uniform(22, 40), 1)] * 2
        if numbers.random() < 0.4:
            self.limits[1] = round(numbers.uniform(22, 40), 1)
        (self.choose_arm if self.swings else self.choose_pushed)()
        self.bounds = [(0, sign, 1.0 if sign > 0 else 0.0, begin, end) for sign in (1, -1)
                       for begin, end in [(0.0, 1.0)] + ([(1.0, self.length)] if self.kind == "RR" else [])]
        if not self.swings:
            self.bound_slopes()

    def choose_pushed(self):
        self.lift, self.lean = self.numbers.choice((8, 12.5, 30)), 0.0
        if self.numbers.random() < 0.7:
            self.lean = round(self.numbers.uniform(-0.6, 0.6) * min(self.limits), 1)
        room = math.tan(math.radians(self.limits[0])) * math.cos(self.lean_angle()) - math.sin(self.lean_angle()) * self.way
        self.set_travel(self.steep * self.lift / (math.radians(self.rise) * max(room, 0.1)))
        self.keys = f"inclination_deg = {self.lean}\n" + ("roller_radius_mm = 6\n" if self.follower == "translating_roller" else "")

    def choose_arm(self):
        most = min(self.limits)
        self.lift = self.numbers.choice((8, 14, 20))
        self.arm, self.roller, self.base = self.numbers.choice((40, 60, 90)), 8, 30
        low, high = -0.9 * most, 0.95 * most - self.lift  # so that the limit is convex on the whole swing
        self.start = math.radians(self.numbers.uniform(low, max(high, low)))
        self.pivot = round(self.base + self.roller - self.arm * math.sin(self.start), 3)
        self.start = math.asin((self.base + self.roller - self.pivot) / self.arm)
        room = math.tan(math.radians(most)) - 0.5 * abs(math.sin(self.start))
        self.set_travel(self.steep * self.arm * math.radians(self.lift) / (math.radians(self.rise) * max(room, 0.1)))
        self.keys = f"roller_radius_mm = {self.roller}\narm_length_mm = {self.arm}\npivot_height_mm = {self.pivot}\n"

    def set_travel(self, slide):
        self.travel = self.way * round(2 * math.pi * abs(slide), 2)

    def lean_angle(self):
        return math.radians(self.lean)

    def slide(self):
        return self.travel / (2 * math.pi)

    def bound_slopes(self):
        """|s' + c sin d| <= |c| cos d tan(limit) on either side."""
        c, d, unit = self.slide(), self.lean_angle(), self.lift / math.radians(self.rise)
        for sign, limit in zip((1, -1), self.limits):
            most = (abs(c) * math.cos(d) * math.tan(math.radians(limit)) - sign * c * math.sin(d)) / unit
            self.bounds.append((1, sign, most, 0.0, self.length))

    def text(self):
        back = f"return_deg = {self.back}\n" if self.kind == "RR" else ""
        rise, fall = self.limits
        limits = f"pressure_angle_deg = {rise}\n" if rise == fall else \
            f"rise_pressure_angle_deg = {rise}\nreturn_pressure_angle_deg = {fall}\n"
        return (f'[motion]\ntype = "{self.kind}"\nlift_{"deg" if self.swings else "mm"} = {self.lift}\nrise_deg = {self.rise}\n{back}'
                f"[spline]\ndegree = {self.degree}\nsegments = {self.segments}\n[objective]\n" +
                "".join(f"{name} = {weight}\n" for name, weight in self.weights.items()) +
                "reference = { " + ", ".join(f"{name} = {size}" for name, size in self.references.items()) + " }\n"
                f'[cam]\ntype = "linear"\nfollower = "{self.follower}"\ntravel_mm = {self.travel}\nbase_height_mm = 30\n{self.keys}'
                f"[limits]\n{limits}")


class PlateProgram(Program):
    """With tangents of an arm's pressure angle."""

    def solve(self):
        for _ in range(MOST_CUTS if self.scene.swings else 1):
            found = super().solve()
            if found is None or not self.scene.swings or not self.cut():
                return found
        raise AssertionError("the cuts do not end")

    def linear_program(self, cost, equal, values):
        found = super().linear_program(cost, equal, values)
        self.design = None if found is None else found.x[:self.splines.size]
        return found

    def excess(self, sign, limit, y, slope):
        """(sign N cos - D sin)/|c| and its partials by y and y'."""
        own, lift = self.scene, math.radians(self.scene.lift)
        c, unit, angle = own.slide(), lift / math.radians(own.rise), own.start + lift * y
        cosine, sine = math.cos(math.radians(limit)), math.sin(math.radians(limit))
        value = sign * cosine * (own.arm * unit * slope + c * math.sin(angle)) - abs(c) * math.cos(angle) * sine
        by_y = lift * (sign * cosine * c * math.cos(angle) + abs(c) * math.sin(angle) * sine)
        return value / abs(c), by_y / abs(c), sign * cosine * own.arm * unit / abs(c)

    def cut(self):
        """Tangents where the motion passes a limit most; how many."""
        added, splines = 0, self.splines
        for sign, limit in zip((1, -1), self.scene.limits):
            for i, (a, b) in enumerate(zip(splines.points, splines.points[1:])):
                own = numpy.tensordot(self.design, splines.values[:, i, :], 1)
                ways = numpy.linspace(0, b - a, PLACES + 1)
                y, slope = numpy.polyval(own, ways), numpy.polyval(numpy.polyder(own), ways)
                found = [self.excess(sign, limit, *pair)[0] for pair in zip(y, slope)]
                k = int(numpy.argmax(found))
                t = self.highest(sign, limit, own, ways[max(k - 1, 0)], ways[min(k + 1, PLACES)])
                y, slope = numpy.polyval(own, t), numpy.polyval(numpy.polyder(own), t)
                value, by_y, by_slope = self.excess(sign, limit, y, slope)
                if value > PASSED:
                    row = by_y * splines.row_on(i, a + t, 0) + by_slope * splines.row_on(i, a + t, 1)
                    self.rows.append(numpy.append(row, numpy.zeros(len(self.peaks))))
                    self.sides.append(by_y * y + by_slope * slope - value)
                    added += 1
        return added

    def highest(self, sign, limit, own, low, high):
        def at(t):
            return self.excess(sign, limit, numpy.polyval(own, t), numpy.polyval(numpy.polyder(own), t))[0]
        golden = (math.sqrt(5) - 1) / 2
        for _ in range(60):
            left, right = high - golden * (high - low), low + golden * (high - low)
            low, high = (left, high) if at(left) < at(right) else (low, right)
        return max((low, high), key=at)


def judged(module, camopt, folder, scene):
    """What is wrong with a scene; None: nothing."""
    verdict, expected = checker.solve(camopt, scene.text(), folder), program_trials.optimum_of(PlateProgram(scene))
    if expected == program_trials.SKIPPED:
        return expected
    if scene.swings and expected is None and verdict == "failed":  # of arms not every infeasible scene is proved
        return program_trials.UNDECIDED
    if fault := program_trials.difference(verdict, folder, expected, SAME):
        return fault
    outcome = checker.outcome(module, folder)
    if scene.swings and expected is None and outcome[0] == "not verified":
        return program_trials.UNDECIDED
    return None if outcome[0] == "confirmed" else f"{outcome}"


if __name__ == "__main__":
    sys.exit(program_trials.run("plates", 20, Scene, judged, MOST_UNDECIDED))
