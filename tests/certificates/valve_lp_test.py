# SPDX-License-Identifier: MIT
"""Valve lobes against linear programs: valve_lp_test.py CAMOPT [--count 10] [--seed 35].

Random lobes of most area are solved by camopt and, without any of its code, by HiGHS (bounds_lp_test.py). The lost areas must agree to 1e-7, verdicts must be the same. Durations and areas
of the report are recomputed from the exported lobe table.
"""
import argparse
import csv
import json
import math
import random
import subprocess
import sys
import tempfile
from pathlib import Path
from types import SimpleNamespace

import numpy

from bounds_lp_test import Program

SAME = 1e-7
SEGMENTS = 16


class Part(Program):
    """The most area under a spline on `points` that meets `conditions`: (x, order, value)."""

    def __init__(self, points, wanted, bounds):
        super().__init__(SimpleNamespace(degree=3, points=points, bounds=bounds, weights={"area": 1.0},
                                         references={"area": 1.0}, length=points[-1]))
        self.wanted = wanted

    def conditions(self):
        rows = [self.splines.row(x, order, x == self.scene.length) for x, order, _ in self.wanted]
        return numpy.array(rows), [value for _, _, value in self.wanted]


def uniform(begin, end):
    return [begin + (end - begin) * i / SEGMENTS for i in range(SEGMENTS + 1)]


class Lobe:
    def __init__(self, numbers):
        pick = lambda low, high, digits: round(numbers.uniform(low, high), digits)
        self.lift, self.lash, self.ratio = pick(8, 12, 2), pick(0, 0.3, 2), numbers.choice((1.0, 1.0, 1.5))
        self.duration, self.check = pick(220, 290, 1), numbers.choice((0.15, 0.5, 1.27))
        self.opening = round(self.duration * pick(0.46, 0.54, 3), 1)
        self.ramps = [(pick(0.15, 0.4, 2), pick(0.006, 0.02, 4)) for _ in range(2)]
        self.up, self.down = pick(0.012, 0.03, 4), pick(0.006, 0.012, 4)
        self.jerk = pick(0.002, 0.008, 4) if numbers.random() < 0.7 else None
        self.nose = (self.lift + self.lash) / self.ratio
        self.checked = (self.check + self.lash) / self.ratio
        self.sound = all(self.checked > height / 3 for height, _ in self.ramps)

    def text(self):
        (h, v), (k, w) = self.ramps
        jerk = f"jerk_mm_deg3 = {self.jerk}\n" if self.jerk else ""
        return (f'[motion]\ntype = "valve"\nlift_mm = {self.lift}\nlash_mm = {self.lash}\nrocker_ratio = {self.ratio}\n'
                f"duration_crank_deg = {self.duration}\nopening_crank_deg = {self.opening}\nchecking_height_mm = {self.check}\n"
                f"opening_ramp = {{ height_mm = {h}, velocity_mm_deg = {v} }}\n"
                f"closing_ramp = {{ height_mm = {k}, velocity_mm_deg = {w} }}\n"
                f"[spline]\nsegments = {SEGMENTS}\n[objective]\narea = 1\n"
                f"[limits]\nacceleration_mm_deg2 = {{ min = {-self.down}, max = {self.up} }}\n{jerk}")

    def bounds(self, unit, begin, end, least, most):
        """Of a part in units of `unit` degrees, in lifts."""
        all_ = [(0, 1, most, begin, end), (0, -1, -least, begin, end)]
        return all_ + [(2, 1, self.up * unit**2 / self.nose, begin, end), (2, -1, self.down * unit**2 / self.nose, begin, end)] + \
            [(3, sign, self.jerk * unit**3 / self.nose, begin, end) for sign in (1, -1) if self.jerk]

    def typical_angle(self, way, velocity, angle):
        jerk, bend = 60 * self.nose / angle**3, 4 * self.nose / angle**2
        low, high = 0.0, way / velocity
        for _ in range(100):
            t = (low + high) / 2
            first = min(t, bend / jerk)
            rest = t - first
            moved = velocity * t + jerk * first**2 * (first / 6 + rest / 2) + bend * rest**2 / 2
            low, high = (t, high) if moved <= way else (low, t)
        return low

    def lost_area(self):
        """1 - the mean displacement in lifts; None: there is no such lobe."""
        area, flanks = 0.0, []
        for (height, velocity), angle in zip(self.ramps, (self.opening / 2, (self.duration - self.opening) / 2)):
            constant = 2 * height / (3 * velocity)
            area += constant * (2 * height / 3) / self.nose
            area += constant * 0.3 * (height / 3) / self.nose  # ∫ 2u³ − u⁴ = 0.3
            way = self.checked - height
            flanks.append((angle, angle + (self.typical_angle(way, velocity, angle) if way > 0 else way / velocity), way > 0, height, velocity))
        (up_angle, up, up_point, h, v), (down_angle, down, down_point, k, w) = flanks
        end = 1 + down / up
        y = lambda s: s / self.nose
        wanted = [(0, 0, y(h)), (0, 1, y(v * up)), (0, 2, 0), (1, 0, 1), (1, 1, 0), (end, 0, y(k)), (end, 1, y(-w * up)),
                  (end, 2, 0)]
        if up_point:
            wanted.append((1 - up_angle / up, 0, y(self.checked)))
        if down_point:
            wanted.append((1 + down_angle / up, 0, y(self.checked)))
        points = uniform(0.0, 1.0) + uniform(1.0, end)[1:]
        monotone = [(1, -1, 0.0, 0.0, 1.0), (1, 1, 0.0, 1.0, end)]
        found = Part(points, wanted, self.bounds(up, 0.0, 1.0, y(h), 1.0) + self.bounds(up, 1.0, end, y(k), 1.0) + monotone).solve()
        return None if found is None else 1 - (area + (up + down) * (1 - found)) / 360


def hermite(a, b, t):
    """Displacement and its integral on a step from row a to row b: the quintic with their derivatives."""
    step = b[0] - a[0]
    rows = [[math.perm(m, r) * x**(m - r) if m >= r else 0.0 for m in range(6)] for x in (0.0, 1.0) for r in range(3)]
    sides = [a[1], a[2] * step, a[3] * step**2, b[1], b[2] * step, b[3] * step**2]
    p = numpy.polynomial.Polynomial(numpy.linalg.solve(rows, sides))
    return p(t), p.integ()(t) * step


def recomputed(path, lobe, height):
    """Duration and area in crank degrees from the table alone."""
    with open(path, newline="", encoding="utf-8") as file:
        rows = [tuple(float(row[name]) for name in ("theta_deg", "s_mm", "v_mm_deg", "a_mm_deg2")) for row in csv.DictReader(file)]
    level = (height + lobe.lash) / lobe.ratio
    nose = max(range(len(rows)), key=lambda i: rows[i][1])
    places, area = [], 0.0
    for sense in (-1, 1):
        i = nose
        while rows[i + sense][1] > level:
            pair = (rows[min(i, i + sense)], rows[max(i, i + sense)])
            area += hermite(*pair, 1.0)[1]
            i += sense
        a, b = rows[min(i, i + sense)], rows[max(i, i + sense)]
        low, high = 0.0, 1.0
        for _ in range(60):
            middle = (low + high) / 2
            rising = (hermite(a, b, middle)[0] > level) == (sense < 0)
            low, high = (low, middle) if rising else (middle, high)
        places.append(a[0] + low * (b[0] - a[0]))
        part = hermite(a, b, low)[1]
        area += hermite(a, b, 1.0)[1] - part if sense < 0 else part
    span = places[1] - places[0]
    return 2 * span, 2 * (lobe.ratio * area - lobe.lash * span)


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("camopt")
    parser.add_argument("--count", type=int, default=10)
    parser.add_argument("--seed", type=int, default=35)
    arguments = parser.parse_args()
    numbers, faults, met = random.Random(arguments.seed), [], {"optimal": 0, "infeasible": 0}
    with tempfile.TemporaryDirectory() as place:
        while sum(met.values()) + len(faults) < arguments.count:
            lobe = Lobe(numbers)
            if not lobe.sound:
                continue
            expected = lobe.lost_area()
            scene = Path(place) / "lobe.toml"
            scene.write_text(lobe.text())
            out = Path(place) / "lobe"
            subprocess.run([arguments.camopt, "solve", scene, "--out", out, "--set", "solver.explain_seconds=0"],
                           capture_output=True, timeout=300)
            result = json.loads((out / "result.json").read_text())
            verdict = result["verdict"]
            if verdict != ("infeasible" if expected is None else "optimal"):
                faults.append(f"{verdict}, expected {expected}:\n{lobe.text()}")
                continue
            if expected is not None:
                found = result["own_terms"][0]["value"]
                if abs(found - expected) > SAME * abs(expected):
                    faults.append(f"lost area {found}, expected {expected}:\n{lobe.text()}")
                    continue
                table = Path(place) / "table"
                subprocess.run([arguments.camopt, "export", out, "--out", table, "--lobe", "mm", "--step-deg", "0.05"], check=True,
                               capture_output=True, timeout=300)
                for event in result["valve"]["events"]:
                    span, area = recomputed(table / "lobe.csv", lobe, event["height_mm"])
                    if abs(span - event["duration_crank_deg"]) > 1e-6 or \
                            abs(area / event["area_mm_crank_deg"] - 1) > 1e-6:
                        faults.append(f"{event}, from the table {span}, {area}")
            met[verdict] += 1
    print(f"{met['optimal']} optimal and {met['infeasible']} infeasible lobes agree")
    for fault in faults:
        print(fault, file=sys.stderr)
    if faults or min(met.values()) == 0:
        sys.exit(1)


if __name__ == "__main__":
    main()
