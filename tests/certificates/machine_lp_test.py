# SPDX-License-Identifier: MIT
"""The largest speed of random machines against linear programs and bisection: machine_lp_test.py CAMOPT [--count 3] [--seed 34].

Machines of 2 to 4 axes are solved by camopt and, without any of its code, by HiGHS: splines are B-spline coefficients by Cox and
de Boor, rows are added at the exact extremes of each polynomial piece, of clearances between merged breakpoints. The speed of
HiGHS must lie in camopt's bracket, which must be confirmed by scripts/verify-certificate, and the delivered motions must keep
limits and clearances at 10,000 angles.
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

GAP = 1e-3
EXCEEDED = 1e-6  # relative: what is exceeded by more becomes a row; far less than the gap
IMPOSSIBLE = 1e-5
DEGREE, SEGMENTS = 5, 8


def basis(degree, knots, x, order):
    """(first, values of the degree + 1 functions): derivatives of B-splines by the recurrence of their coefficients."""
    span = min(max(int(numpy.searchsorted(knots, x, side="right")) - 1, degree), len(knots) - degree - 2)
    values = []
    for j in range(span - degree, span + 1):
        c = numpy.zeros(len(knots) - degree - 1)
        c[j] = 1.0
        values.append(spline_value(degree, knots, c, x, order, span))
    return span - degree, numpy.array(values)


def spline_value(degree, knots, c, x, order, span):
    """de Boor's triangle of the derivative."""
    d = c[span - degree:span + 1].copy()
    t = knots
    for r in range(order):
        for j in range(degree - r):
            i = span - degree + r + 1 + j
            d[j] = (degree - r) * (d[j + 1] - d[j]) / (t[i + degree - r] - t[i])
        d = d[:degree - r]
    p = degree - order
    for r in range(1, p + 1):
        for j in range(p, r - 1, -1):
            i = span - p + j
            a = (x - t[i]) / (t[i + p - r + 1] - t[i])
            d[j] = (1 - a) * d[j - 1] + a * d[j]
    return d[p]


class Axis:
    """Rise, dwell, return, dwell: two splines from rest to rest, degrees for angles and seconds from the speed."""

    def __init__(self, rng, index):
        self.name, self.lift = f"axis{index}", rng.choice([30.0, 60.0, 90.0])
        first = rng.choice([100, 120, 135])
        angles = [first, rng.choice([15, 25, 40]), rng.choice([100, 125])]
        self.angles = angles + [360 - sum(angles)]
        self.phase = rng.choice([0, 10, 25, 330])
        self.velocity, self.acceleration = rng.choice([1.5, 2.5]), rng.choice([30.0, 50.0, 70.0])
        self.strokes = []  # (begin, angle, from, to)
        self.strokes.append((0.0, float(angles[0]), 0.0, 1.0))
        self.strokes.append((float(angles[0] + angles[1]), float(angles[2]), 1.0, 0.0))
        self.knots = numpy.concatenate([numpy.zeros(DEGREE), numpy.linspace(0.0, 1.0, SEGMENTS + 1), numpy.ones(DEGREE)])
        self.size = SEGMENTS + DEGREE

    def scene(self):
        lines = [f'[motion]\ntype = "program"\nlift_mm = {self.lift}\n']
        for k, angle in enumerate(self.angles):
            kind = "spline" if k % 2 == 0 else "dwell"
            to = f"to_mm = {self.lift if k == 0 else 0}\n" if k % 2 == 0 else ""
            lines.append(f'[[motion.segments]]\nkind = "{kind}"\nangle_deg = {angle}\n{to}')
        lines.append(f"[spline]\ndegree = {DEGREE}\nsegments = {SEGMENTS}\n[objective]\nacceleration = 1.0\n"
                     f"[limits]\nvelocity_m_s = {self.velocity}\nacceleration_m_s2 = {self.acceleration}\n")
        return "\n".join(lines)

    def at(self, angle):
        """(stroke, u) at a master angle, or the constant displacement."""
        own = (angle - self.phase) % 360.0
        for k, (begin, width, _, _) in enumerate(self.strokes):
            if begin <= own <= begin + width:
                return k, (own - begin) / width
        return None, self.strokes[0][3] if own < self.strokes[1][0] else self.strokes[1][3]

    def breaks(self):
        return [(self.phase + begin + width * i / SEGMENTS) % 360.0 for begin, width, _, _ in self.strokes
                for i in range(SEGMENTS + 1)]


class Program:
    """Least t: every limit exceeded by t of itself, clearances by t of the strokes in it."""

    def __init__(self, axes, clearances):
        self.axes, self.clearances = axes, clearances
        self.offset, total = {}, 0
        for a, axis in enumerate(axes):
            for s in range(2):
                self.offset[a, s] = total
                total += axis.size
        self.size = total + 1
        self.places = {}  # (a, s, order) or clearance: angles or u of rows
        for a in range(len(axes)):
            for s in range(2):
                for order in (0, 1, 2):
                    self.places[a, s, order] = list(numpy.linspace(0.0, 1.0, 2 * SEGMENTS + 1))
        for k in range(len(clearances)):
            self.places[k] = list(numpy.linspace(0.0, 360.0, 48, endpoint=False))

    def row(self, a, s, u, order):
        first, values = basis(DEGREE, self.axes[a].knots, u, order)
        row = numpy.zeros(self.size)
        row[self.offset[a, s] + first:self.offset[a, s] + first + DEGREE + 1] = values
        return row

    def clearance_row(self, k, angle):
        """(row, constant) of at_least - sum of factor lift y, over the sum of the strokes."""
        used, factors, least = self.clearances[k]
        row, constant = numpy.zeros(self.size), least
        scale = sum(abs(f) * self.axes[a].lift for a, f in zip(used, factors))
        for a, f in zip(used, factors):
            s, u = self.axes[a].at(angle)
            if s is None:
                constant -= f * self.axes[a].lift * u
            else:
                row -= f * self.axes[a].lift * self.row(a, s, u, 0)
        return row / scale, constant / scale

    def caps(self, a, s, speed):
        """Largest |y'| and |y''| by u of a stroke."""
        axis = self.axes[a]
        seconds = axis.strokes[s][1] / (6.0 * speed)
        return axis.velocity * 1e3 / axis.lift * seconds, axis.acceleration * 1e3 / axis.lift * seconds**2

    def least(self, speed, rounds=40):
        """A lower bound of it, from the rows of `rounds` rounds: above 0 there is no motion."""
        t = numpy.zeros(self.size)
        t[-1] = 1.0
        equal, value = [], []
        for (a, s) in self.offset:
            _, _, start, end = self.axes[a].strokes[s]
            for u, y in ((0.0, start), (1.0, end)):
                equal += [self.row(a, s, u, order) for order in range(3)]
                value += [y, 0.0, 0.0]
        for _ in range(rounds):
            rows, most = [], []
            for key, places in self.places.items():
                for place in places:
                    if not isinstance(key, tuple):
                        row, constant = self.clearance_row(key, place)
                        rows.append(row - t)
                        most.append(-constant)
                        continue
                    a, s, order = key
                    row = self.row(a, s, place, order)
                    if order == 0:  # the stroke stays between its ends
                        rows += [row, -row]
                        most += [1.0, 0.0]
                    else:
                        cap = self.caps(a, s, speed)[order - 1]
                        rows += [row / cap - t, -row / cap - t]
                        most += [1.0, 1.0]
            bounds = [(None, None)] * (self.size - 1) + [(-0.9, None)]
            found = linprog(t, A_ub=numpy.array(rows), b_ub=most, A_eq=numpy.array(equal), b_eq=value, bounds=bounds,
                            method="highs")
            assert found.status == 0, found.message
            if found.x[-1] > IMPOSSIBLE or not self.add(found.x, speed):  # rows so far are a relaxation
                break
        return found.x[-1]

    def add(self, x, speed):
        """Rows at the extremes that the rows so far miss."""
        added = False
        for key, places in list(self.places.items()):
            if isinstance(key, tuple):
                a, s, order = key
                cap = 1.0 if order == 0 else self.caps(a, s, speed)[order - 1]
                pieces = [(lambda u, a=a, s=s: self.row(a, s, u, order) @ x / cap, i / SEGMENTS, (i + 1) / SEGMENTS)
                          for i in range(SEGMENTS)]
                limits = (0.0, 1.0) if order == 0 else (-1.0 - x[-1], 1.0 + x[-1])
            else:
                used, _, _ = self.clearances[key]
                points = sorted({0.0, 360.0} | {b for a in used for b in self.axes[a].breaks()})
                pieces = [(lambda angle, k=key: sum((lambda rc: (rc[0] @ x, rc[1]))(self.clearance_row(k, angle))), p, q)
                          for p, q in zip(points, points[1:]) if q - p > 1e-9]
                limits = (-numpy.inf, x[-1])
            for function, begin, end in pieces:
                nodes = 0.5 * (begin + end) + 0.5 * (end - begin) * numpy.cos(numpy.pi * (numpy.arange(6) + 0.5) / 6)
                fit = numpy.polyfit((nodes - begin) / (end - begin), [function(p) for p in nodes], 5)
                for root in numpy.roots(numpy.polyder(fit)):
                    u = root.real
                    if abs(root.imag) > 1e-9 or not 0.0 < u < 1.0:
                        continue
                    value = numpy.polyval(fit, u)
                    if value > limits[1] + EXCEEDED or value < limits[0] - EXCEEDED:
                        place = begin + u * (end - begin)
                        if min(abs(place - p) for p in places) > 1e-9:
                            places.append(place)
                            added = True
        return added


def machine(rng):
    axes = [Axis(rng, i) for i in range(rng.randint(2, 4))]
    clearances = []
    for _ in range(rng.randint(1, 3)):
        used = rng.sample(range(len(axes)), 2)
        factors = rng.choice([(1.0, -1.0), (-1.0, -1.0), (1.0, -0.5)])
        rest = min(sum(f * axes[a].lift * u for a, f, u in zip(used, factors, state)) for state in resting(axes, used))
        clearances.append((used, factors, round(rest - rng.choice([2.0, 5.0, 15.0]), 3)))
    return axes, clearances


def resting(axes, used):
    """Displacements at angles where both axes rest, and at the middle of each stroke: what clearances must allow."""
    found = []
    for angle in range(360):
        states = [axes[a].at(float(angle)) for a in used]
        if all(s is None for s, _ in states):
            found.append([u for _, u in states])
    return found or [[0.0] * len(used)]


def written(axes, clearances, folder):
    text = "[machine]\nspeed_rpm = { min = 5, max = 2000 }\n"
    for axis in axes:
        (folder / f"{axis.name}.toml").write_text(axis.scene())
        text += f'[[axis]]\nname = "{axis.name}"\nscene = "{axis.name}.toml"\nphase_deg = {axis.phase}\n'
    for used, factors, least in clearances:
        names = ", ".join(f'"{axes[a].name}"' for a in used)
        text += f"[[clearance]]\nbetween = [{names}]\nfactors = [{factors[0]}, {factors[1]}]\nat_least_mm = {least}\n"
    (folder / "machine.toml").write_text(text)


def curve_of(axis, result):
    """y, y', y'' of a result by master angle, mm and degrees."""
    curves = [(numpy.array(c["breakpoints"]), [[numpy.polyder(numpy.poly1d(p[::-1]), r) for r in range(3)] for p in c["pieces"]])
              for c in result["motion"]["curves"]]
    unit = axis.strokes[0][1]

    def state(angle):
        s, u = axis.at(angle)
        if s is None:
            return axis.lift * u, 0.0, 0.0
        begin, width, _, _ = axis.strokes[s]
        points, pieces = curves[s]
        x = points[0] + u * width / unit
        i = min(max(int(numpy.searchsorted(points, x, side="right")) - 1, 0), len(pieces) - 1)
        return tuple(axis.lift * p(x - points[i]) / unit**r for r, p in enumerate(pieces[i]))
    return state


def check(camopt, rng, verify, number):
    axes, clearances = machine(rng)
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        written(axes, clearances, folder)
        run = subprocess.run([camopt, "machine", str(folder / "machine.toml"), "--out", str(folder / "out")], capture_output=True,
                             text=True, timeout=120)
        result = json.loads((folder / "out" / "machine.json").read_text())
        outcome, why = checker.outcome(verify, folder / "out")
        assert outcome == "confirmed", f"machine {number}: {why}"
        program = Program(axes, clearances)
        if result["verdict"] == "infeasible":
            assert run.returncode == 3 and program.least(5.0) > 0.0, f"machine {number}: HiGHS finds motions at 5 rpm"
            return f"machine {number}: infeasible, at standstill: {result['at_standstill']}"
        assert result["verdict"] == "optimal", f"machine {number}: {result['verdict']}: {run.stdout}{run.stderr}"
        low, high = result["speed_rpm"], result["impossible_above_rpm"]
        assert low < high <= low * (1 + GAP) * (1 + 1e-9), f"machine {number}: {low} to {high}"
        margins = program.least(low, 1), program.least(high)
        assert margins[0] <= 1e-6 and margins[1] > 0.0, f"machine {number}: HiGHS misses by {margins} at {low} and {high} rpm"
        values = [curve_of(axis, result["axes"][axis.name]) for axis in axes]
        for angle in numpy.linspace(0.0, 360.0, 10000):
            states = [value(angle) for value in values]
            for axis, (y, velocity, acceleration) in zip(axes, states):
                assert -1e-6 <= y <= axis.lift + 1e-6 and abs(velocity) * 6e-3 * low <= axis.velocity * (1 + 1e-8) and \
                    abs(acceleration) * 36e-3 * low**2 <= axis.acceleration * (1 + 1e-8), f"machine {number}: {axis.name} at {angle} deg"
            for used, factors, least in clearances:
                kept = sum(f * states[a][0] for a, f in zip(used, factors))
                assert kept >= least - 1e-6, f"machine {number}: {kept} below {least} at {angle}"
        claim = folder / "out" / "machine.json"
        claim.write_text(claim.read_text().replace(f'"impossible_above_rpm": {high}', f'"impossible_above_rpm": {low * (1 + 1e-7)}'))
        outcome, why = checker.outcome(verify, folder / "out")
        assert outcome == "refuted", f"machine {number}: a speed that is possible is {outcome} as impossible: {why}"
        return f"machine {number}: {len(axes)} axes, {len(clearances)} clearances, {low} rpm, limited by " + \
            ", ".join(f"{one['key']} {one['share']:.2f}" for one in result["limited_by"][:2])


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("camopt")
    parser.add_argument("--count", type=int, default=3)
    parser.add_argument("--seed", type=int, default=34)
    asked = parser.parse_args()
    rng, verify = random.Random(asked.seed), checker.load()
    for number in range(asked.count):
        print(check(asked.camopt, rng, verify, number), flush=True)


if __name__ == "__main__":
    sys.exit(main())
