# SPDX-License-Identifier: MIT
"""Cams for a prescribed output against linear programs: output_lp_test.py CAMOPT [--count 30] [--seed 19].

Random scenes are solved by camopt and, without any of its code, by HiGHS on the splines of bounds_lp_test.py, at rest to the fourth
derivative at both ends. The cam of an output y is s = (1 + k_r/k) y + c_g/(k T) y' + m/(k T^2) y'', T the seconds of a rise: limits on s', s'', on the
pressure angle and the force on a disk cam are rows on y ... y''''. Verdicts must be the same, objectives agree to 1e-7, and
scripts/verify-certificate must confirm every result.
"""
import math
import sys

import numpy

import checker
import program_trials
from bounds_lp_test import Program
from tolerance_lp_test import LineProgram

SAME = 1e-7


class Scene:
    """The scene as text, and what the program asks for; `lines`: (weights of y ... y'''', most), normalised."""

    def __init__(self, numbers, index):
        self.numbers, self.kind, self.degree = numbers, ("DRD", "RR")[index % 2], (5, 5, 7)[index % 3]
        self.lift, self.rise = numbers.choice((8.0, 12.5, 20.0)), numbers.choice((60, 80, 110))
        self.length = 1.0 if self.kind == "DRD" else 2.0
        self.segments = numbers.randint(10, 14) * (1 if self.kind == "DRD" else 2)
        self.points = [self.length * i / self.segments for i in range(self.segments + 1)]
        self.references = {"velocity": 1.76, "acceleration": 5.53, "jerk": 69.0}
        self.weights = {name: round(numbers.uniform(0.1, 0.6), 3) for name in self.references}
        self.bounds = [(0, sign, 1.0 if sign > 0 else 0.0, begin, end) for sign in (1, -1)
                       for begin, end in [(0.0, 1.0)] + ([(1.0, self.length)] if self.kind == "RR" else [])]
        self.lines, self.limits, self.cam = [], "", ""
        self.choose_train()
        self.choose_limits(index % 10 == 6)
        if numbers.random() < 0.6:
            self.choose_cam()

    def choose_train(self):
        """lambda natural periods in a rise."""
        self.ratio, self.mass = round(self.numbers.uniform(1.2, 5.0), 3), round(self.numbers.uniform(0.5, 4), 2)
        self.speed = 150
        seconds = self.rise / (6 * self.speed)
        self.frequency = self.ratio / seconds
        total = self.mass * (2 * math.pi * self.frequency)**2
        self.back = round(total * self.numbers.choice((0.0, 0.02, 0.06)) / 1000, 3)  # N/mm
        spring = total - 1000 * self.back
        self.damper = round(2 * math.sqrt(total * self.mass) * self.numbers.choice((0.0, 0.05, 0.2)), 2)  # to ground, N s/m
        self.share, self.drag, self.bend = 1 + 1000 * self.back / spring, self.damper / spring / seconds, self.mass / spring / seconds**2

    def line(self, weights, most):
        """weights . (s, s', s'') <= most as a row on y ... y''''."""
        row = numpy.zeros(5)
        for order, weight in enumerate(weights):
            row[order] += weight * self.share
            row[order + 1] += weight * self.drag
            row[order + 2] += weight * self.bend
        self.lines.append((list(row), most))

    def choose_limits(self, impossible):
        """`impossible`: of a rise (even numbers), the cam's velocity stays below its mean."""
        for order, name, good in ((1, "velocity", 1.9), (2, "acceleration", 6.2)):
            slow = impossible and name == "velocity"
            if self.numbers.random() < 0.6 or slow:
                most = round(0.97 * self.share, 3) if slow else round(good * self.share * (1 + 6 / self.ratio**2) * self.numbers.uniform(0.85, 1.3), 3)
                self.limits += f"cam_{name} = {most}\n"
                for sign in (1, -1):
                    weights = [0.0, 0.0, 0.0]
                    weights[order] = sign
                    self.line(weights, most)

    def choose_cam(self):
        limit = round(self.numbers.uniform(24, 36), 1)
        steep, beta = math.tan(math.radians(limit)), math.radians(self.rise)
        prime = round(self.lift * self.numbers.uniform(0.55, 1.5) * 1.9 / beta / steep, 2)
        self.cam = f'[cam]\ntype = "disk"\nfollower = "translating_roller"\nbase_radius_mm = {round(0.7 * prime, 2)}\n' \
                   f"roller_radius_mm = {round(0.3 * prime, 2)}\n"
        prime = round(0.7 * prime, 2) + round(0.3 * prime, 2)
        self.limits += f"pressure_angle_deg = {limit}\n"
        for sign in (1, -1):
            self.line([-steep * self.lift, sign * self.lift / beta, 0.0], steep * prime)

    def text(self):
        return (f'[motion]\ntype = "{self.kind}"\nlift_mm = {self.lift}\nrise_deg = {self.rise}\nspeed_rpm = {self.speed}\n'
                f"[spline]\ndegree = {self.degree}\nsegments = {self.segments}\n[objective]\n" +
                "".join(f"{name} = {weight}\n" for name, weight in self.weights.items()) +
                "reference = { " + ", ".join(f"{name} = {size}" for name, size in self.references.items()) + " }\n"
                f'[dynamics]\nmass_kg = {self.mass}\nnatural_frequency_hz = {self.frequency}\nreturn_spring_n_mm = {self.back}\n'
                f'ground_damping_n_s_m = {self.damper}\nprescribe = "output"\n{self.cam}[limits]\n{self.limits}[solver]\ntolerance = 1e-10\n')


class OutputProgram(LineProgram):
    """At rest to the fourth derivative."""

    def __init__(self, scene):
        Program.__init__(self, scene)
        self.lines = scene.lines
        for weights, most in self.lines:
            for i, (a, b) in enumerate(zip(self.splines.points, self.splines.points[1:])):
                for x in numpy.linspace(a, b, 5):
                    self.add_line(i, x, weights, most)

    def conditions(self):
        equal, values = super().conditions()
        rows = [self.splines.row(x, order, left) / 1000 for order in (3, 4) for x, left in ((0.0, False), (self.scene.length, True))]
        return numpy.vstack([equal, numpy.hstack([numpy.array(rows), numpy.zeros((4, len(self.peaks)))])]), values + [0.0] * 4


def judged(module, camopt, folder, scene):
    """What is wrong with a scene; None: nothing."""
    verdict, expected = checker.solve(camopt, scene.text(), folder), program_trials.optimum_of(OutputProgram(scene))
    if expected == program_trials.SKIPPED:
        return expected
    if fault := program_trials.difference(verdict, folder, expected, SAME):
        return fault
    outcome = checker.outcome(module, folder)
    return None if outcome[0] == "confirmed" else f"{outcome}"


if __name__ == "__main__":
    sys.exit(program_trials.run("cams", 19, Scene, judged))
