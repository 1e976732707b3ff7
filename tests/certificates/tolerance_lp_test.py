# SPDX-License-Identifier: MIT
"""Tolerances against linear programs: tolerance_lp_test.py CAMOPT [--count 40] [--seed 18].

Random scenes with tolerances are solved by camopt and, without any of its code, by HiGHS on the splines of bounds_lp_test.py. Each limit
is a row a y + b y' + c y'' <= d for every choice of the ends of the numbers, whose right side loses |a| e0 + |b| e1 + |c| e2 by the errors
of the motion: pressure angle s' - e <= tan(limit) (sqrt(R^2 - e^2) + s) of a roller or an edge, radius of a flat face, contact force,
velocity and acceleration. Verdicts must be the same, objectives agree to 1e-8, the price is not negative,
and scripts/verify-certificate must confirm every result.
"""
import itertools
import json
import math
import sys

import numpy

import checker
import program_trials
from bounds_lp_test import TYPICAL, Program

SAME = 1e-8
EXCEEDED = 1e-12   # of a row, relative
MOST_CUTS = 60
SPEED = 200.0       # rpm
FOLLOWERS = ("translating_roller", "translating_knife", "translating_flat")


class Scene:
    """The scene as text, and what bounds_lp_test.Program asks for; `lines`: (a, b, c, d) in mm and rad of cam angle."""

    def __init__(self, numbers, index):
        self.numbers, self.follower = numbers, FOLLOWERS[index % 3]
        self.kind, self.degree = ("DRD", "RR")[index // 3 % 2], (3, 3, 5)[index // 2 % 3]
        self.lift, self.rise = numbers.choice((8.0, 12.5, 20.0)), numbers.choice((60, 80, 110))
        self.back = self.rise if numbers.random() < 0.5 else round(self.rise * numbers.uniform(0.9, 1.4))
        self.length = 1.0 if self.kind == "DRD" else 1.0 + self.back / self.rise
        self.segments = numbers.randint(8, 18)
        self.points = [self.length * i / self.segments for i in range(self.segments + 1)]
        self.references = {"velocity": 1.76, "acceleration": 5.53, "jerk": 69.0}
        self.weights = {name: round(numbers.uniform(0.1, 0.6), 3) for name in self.references if name != "velocity" or index % 2}
        self.bounds = [(0, sign, 1.0 if sign > 0 else 0.0, begin, end) for sign in (1, -1)
                       for begin, end in [(0.0, 1.0)] + ([(1.0, self.length)] if self.kind == "RR" else [])]
        self.lines, self.limits, self.cam, self.forces, self.tolerance = [], "", "", "", ""
        self.beta = math.radians(self.rise)
        self.choose_errors()
        self.choose_cam()
        if numbers.random() < 0.4:
            self.choose_peak()
        if numbers.random() < 0.5:
            self.choose_forces()

    def choose_errors(self):
        """Of s, s', s'' in mm and rad."""
        profile, slope, bend = (self.numbers.choice((0, round(self.numbers.uniform(*ends), 4))) for ends in ((5, 60), (1, 10), (0.1, 2)))
        self.errors = [profile / 1000, slope / 1000 * 180 / math.pi, bend / 1000 * (180 / math.pi)**2]
        for name, size in (("profile_um", profile), ("slope_um_deg", slope), ("acceleration_um_deg2", bend)):
            self.tolerance += f"{name} = {size}\n" if size else ""

    def ends(self, name, value, most):
        """The ends of a number that may have a tolerance."""
        half = self.numbers.choice((0, round(self.numbers.uniform(0.1, 1) * most, 4)))
        if half:
            self.tolerance += f"{name} = {half}\n"
        return {value - half, value + half}

    def line(self, a, b, c, d):
        """a s + b s' + c s'' <= d, with the errors of the motion."""
        self.lines.append((a, b, c, d - sum(abs(w) * e for w, e in zip((a, b, c), self.errors))))

    def choose_cam(self):
        if self.follower == "translating_flat":
            base = round(self.lift * self.numbers.uniform(1.2, 3.0), 2)
            least = round(base * self.numbers.uniform(0.1, 0.5), 2)
            self.cam, self.limits = f"base_radius_mm = {base}\n", f"cam_radius_min_mm = {least}\n"
            for own in self.ends("base_radius_mm", base, 0.2):
                self.line(-1, 0, -1, own - least)
            return
        limit = round(self.numbers.uniform(22, 38), 1)
        steep = math.tan(math.radians(limit))
        prime = round(self.lift * self.numbers.uniform(0.8, 1.6) * 1.76 / self.beta / steep, 2)
        offset = self.numbers.choice((0, round(0.3 * prime * self.numbers.uniform(-1, 1), 2)))
        roller = round(0.3 * prime, 2) if self.follower == "translating_roller" else 0
        self.cam = f"base_radius_mm = {prime - roller}\noffset_mm = {offset}\n" + (f"roller_radius_mm = {roller}\n" if roller else "")
        self.limits = f"pressure_angle_deg = {limit}\n"
        rollers = self.ends("roller_radius_mm", roller, 0.02) if roller else {0}
        sizes = itertools.product(self.ends("base_radius_mm", prime - roller, 0.1), rollers, self.ends("offset_mm", offset, 0.1))
        for base, own, eccentric in sizes:
            start = math.sqrt((base + own)**2 - eccentric**2)
            for sign in (1, -1):
                self.line(-steep, sign, 0, steep * start + sign * eccentric)

    def choose_peak(self):
        order = self.numbers.choice((1, 2))
        name, most = ("velocity", "acceleration")[order - 1], round(self.numbers.uniform(1.0, 1.4) * (1.7, 6.2)[order - 1], 3)
        self.limits += f"{name} = {most}\n"
        for sign in (1, -1):
            weights = [0.0, 0.0, 0.0]
            weights[order] = sign
            self.line(*weights, most * self.lift / self.beta**order)

    def choose_forces(self):
        """mass w^2 s'' + rate s + preload >= least, in N and m."""
        mass, rate = round(self.numbers.uniform(0.2, 2), 2), round(self.numbers.uniform(1, 15), 2)
        swing = mass * (SPEED * math.pi / 30)**2
        preload = round(swing * 7 * self.lift / 1000 / self.beta**2 * self.numbers.uniform(0.7, 1.5), 1)
        least = round(0.05 * preload, 1)
        self.forces = f"[forces]\nmass_kg = {mass}\nspring_rate_n_mm = {rate}\npreload_n = {preload}\n"
        self.limits += f"contact_force_min_n = {least}\n"
        share = self.numbers.choice((0, round(self.numbers.uniform(1, 10), 1)))
        self.tolerance += f"spring_rate_percent = {share}\n" if share else ""
        for stiff, own in itertools.product({rate * (1 - share / 100), rate * (1 + share / 100)},
                                            self.ends("preload_n", preload, 0.05 * preload)):
            self.line(-stiff, 0, -swing / 1000, own - least)

    def text(self):
        back = f"return_deg = {self.back}\n" if self.kind == "RR" else ""
        return (f'[motion]\ntype = "{self.kind}"\nlift_mm = {self.lift}\nrise_deg = {self.rise}\n{back}speed_rpm = {SPEED}\n'
                f"[spline]\ndegree = {self.degree}\nsegments = {self.segments}\n[objective]\n" +
                "".join(f"{name} = {weight}\n" for name, weight in self.weights.items()) +
                "reference = { " + ", ".join(f"{name} = {size}" for name, size in self.references.items()) + " }\n"
                f'[cam]\ntype = "disk"\nfollower = "{self.follower}"\n{self.cam}[limits]\n{self.limits}{self.forces}[tolerance]\n{self.tolerance}'
                "[solver]\ntolerance = 1e-11\n")


class LineProgram(Program):
    """With rows on a sum of y, y', y''."""

    def __init__(self, scene):
        super().__init__(scene)
        sizes = [scene.lift / scene.beta**order for order in range(3)]
        self.lines = [([w * size for w, size in zip(line[:3], sizes)], line[3]) for line in scene.lines]
        for weights, most in self.lines:
            for i, (a, b) in enumerate(zip(self.splines.points, self.splines.points[1:])):
                for x in numpy.linspace(a, b, 5):
                    self.add_line(i, x, weights, most)

    def add_line(self, i, x, weights, most):
        scale = max(abs(w) * typical for w, typical in zip(weights, TYPICAL))
        row = sum(w * self.splines.row_on(i, x, order) for order, w in enumerate(weights)) / scale
        self.rows.append(numpy.append(row, numpy.zeros(len(self.peaks))))
        self.sides.append(most / scale)

    def linear_program(self, cost, equal, values):
        found = super().linear_program(cost, equal, values)
        self.design = None if found is None else found.x[:self.splines.size]
        return found

    def solve(self):
        for _ in range(MOST_CUTS):
            found = super().solve()
            if found is None or not self.cut():
                return found
        raise AssertionError("the cuts do not end")

    def cut(self):
        added, splines = 0, self.splines
        for number, (weights, most) in enumerate(self.lines):
            scale = max(abs(w) * typical for w, typical in zip(weights, TYPICAL))
            for i, (a, b) in enumerate(zip(splines.points, splines.points[1:])):
                own = numpy.tensordot(self.design, splines.values[:, i, :], 1)
                line = sum((w * numpy.poly1d(numpy.polyder(own, order)) for order, w in enumerate(weights)), numpy.poly1d([0.0]))
                ways = [0.0, b - a] + [t.real for t in line.deriv().roots if abs(t.imag) < 1e-9 and 0 < t.real < b - a]
                for t in ways:
                    place = (i, round(t, 12), number)
                    if line(t) > most + EXCEEDED * scale and place not in self.places:
                        self.places.add(place)
                        self.add_line(i, a + t, weights, most)
                        added += 1
        return added


def judged(module, camopt, folder, scene):
    """What is wrong with a scene; None: nothing."""
    verdict, expected = checker.solve(camopt, scene.text(), folder), program_trials.optimum_of(LineProgram(scene))
    if expected == program_trials.SKIPPED:
        return expected
    if fault := program_trials.difference(verdict, folder, expected, SAME):
        return fault
    if expected is not None:
        price = json.loads((folder / "result.json").read_text())["tolerance"]["price"]
        if price is None or price < -SAME:
            return f"the price is {price}"
    outcome = checker.outcome(module, folder)
    return None if outcome[0] == "confirmed" else f"{outcome}"


if __name__ == "__main__":
    sys.exit(program_trials.run("cams", 18, Scene, judged))
