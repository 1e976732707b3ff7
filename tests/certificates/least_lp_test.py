# SPDX-License-Identifier: MIT
"""Numbers that are sought (objective.least, objective.largest) against linear programs: least_lp_test.py CAMOPT [--count 60] [--seed 21].

Random scenes are solved by camopt and, without any of its code, by HiGHS on the splines of bounds_lp_test.py. A number that the limits
are linear in is a variable of the program. Of others (pressure angle, Hertz pressure, spring rate, angle of a stroke, speed) the least common
violation t is the optimum; its zero is bracketed by two programs whose t is beyond the tolerance of HiGHS. `value` and `impossible` must
enclose the number within `least_gap`, and scripts/verify-certificate must confirm both. Then claims are spoiled: none of them may be
confirmed. The speed of machines is that of machine_lp_test.py.
"""
import argparse
import copy
import json
import math
import random
import shutil
import sys
import tempfile
from pathlib import Path

import numpy

import checker
from bounds_lp_test import GRID, TYPICAL, Program, Splines
from motion_scenes import DWELL, SPLINE

EXCEEDED = 1e-10      # a row that is exceeded by more than this part of its size is added: the tolerance of HiGHS
NO_NUMBER = 1e-6      # an optimum of 0
LINEAR_ERROR = 1e-8   # of the optimum of a linear program, relative
ROUNDS, PATIENCE = 75, 25  # after so many the rows may be exceeded by ten times as much
CERTAIN = 2e-9        # a least common violation beyond this is not the tolerance of HiGHS
BRACKETS = (1e-8, 1e-7, 1e-6, 1e-5, 1e-4)  # relative distances of the two programs that enclose a zero
ENCLOSED = 1e-9       # relative: where the search for the zero ends
UNITS = (("", 0), ("mm_s", 1), ("mm_rad", 1), ("mm_deg", 1), ("in_s", 1), ("m_s", 1))
POWERS = {"velocity": "", "acceleration": "2", "jerk": "3"}


class NoTest(Exception):
    """A scene without a motion, or one whose number HiGHS cannot say."""


class Stroke:
    """y(x) from x = 0 on; displacement = lift (start + way y), cam angle = angle x (rad)."""

    def __init__(self, degree, segments, length, angle, lift, start=0.0, way=1.0, top=False):
        self.splines = Splines(degree, [length * i / segments for i in range(segments + 1)])
        self.length, self.angle, self.lift, self.start, self.way, self.top = length, angle, lift, start, way, top
        self.within = [([1, 0, 0, 0], -1.0), ([-1, 0, 0, 0], 0.0)]  # a . (y, y', y'', y''') + c <= 0

    def of(self, order):
        """(a, c): the derivative of the displacement by the cam angle."""
        a = [0.0] * 4
        a[order] = self.way * self.lift / self.angle**order
        return numpy.array(a), self.lift * self.start if order == 0 else 0.0

    def sum(self, *parts):
        """Of (factor, order) and plain numbers."""
        a, c = numpy.zeros(4), 0.0
        for part in parts:
            if isinstance(part, tuple):
                of, constant = self.of(part[1])
                a, c = a + part[0] * of, c + part[0] * constant
            else:
                c += part
        return a, c

    def conditions(self):
        rows, values = [], []
        for order in range(3):
            rows += [self.splines.row(0.0, order), self.splines.row(self.length, order, True)]
            values += [0.0, 1.0 if order == 0 and not self.top else 0.0]
        if self.top:
            rows += [self.splines.row(1.0, 0), self.splines.row(1.0, 1)]
            values += [1.0, 0.0]
        return numpy.array(rows), values


class LeastOf(Program):
    """min u: a . (y, y', y'', y''') + c + h p <= 0 of every row in `caps`, <= u size of every row in `sought`, all along a stroke;
    p, within `chosen`, is a number that is chosen with the motion, and rows without it have no h."""

    def __init__(self, stroke, caps, sought, places, enough=math.inf, chosen=None):
        self.chosen = chosen
        self.enough = enough  # above this the optimum over some rows, which bounds it from below, is all that is asked for
        self.stroke, self.splines, self.found_places = stroke, stroke.splines, places
        self.rules = [(row, 0.0) for row in list(caps) + stroke.within] + [(row, size) for row, size in sought]
        self.rows, self.sides = [], []

    def add_at(self, i, x, rule):
        (a, c, *h), factor = self.rules[rule]
        size = factor or float(numpy.abs(a) @ TYPICAL)
        row = sum(a[order] * self.splines.row_on(i, x, order) for order in range(4) if a[order])
        own = [(h[0] if h else 0.0) / size] if self.chosen else []
        self.rows.append(numpy.concatenate([row / size, own, [-1.0 if factor else 0.0]]))
        self.sides.append(-c / size)

    def solve(self):
        points = self.splines.points
        for rule in range(len(self.rules)):
            for i, (a, b) in enumerate(zip(points, points[1:])):
                for x in numpy.linspace(a, b, GRID):
                    self.add_at(i, x, rule)
        known = set(self.found_places)
        for i, x, rule in known:
            self.add_at(i, x, rule)
        equal, values = self.stroke.conditions()
        more = 2 if self.chosen else 1
        for sign, end in zip((-1.0, 1.0), self.chosen or ()):
            self.rows.append(numpy.concatenate([numpy.zeros(self.splines.size), [sign, 0.0]]))
            self.sides.append(sign * end)
        equal, cost = numpy.hstack([equal, numpy.zeros((len(values), more))]), numpy.append(numpy.zeros(self.splines.size + more - 1), 1.0)
        for k in range(ROUNDS):
            found = self.linear_program(cost, equal, values)
            if found is None:
                raise NoTest("no motion")
            self.tolerance = EXCEEDED * 10**(k // PATIENCE)
            added = [place for place in self.exceeded(found.x[:-1], found.x[-1]) if place not in known]
            if not added or found.fun > self.enough:
                self.found_places |= known
                return found.fun
            for place in added:
                known.add(place)
                self.add_at(*place)
        raise NoTest("a vertex wanders in a wide optimal face")

    def exceeded(self, numbers, u):
        design, p = numbers[:self.splines.size], numbers[-1] if self.chosen else 0.0
        for rule, ((a, c, *h), factor) in enumerate(self.rules):
            c = c + (h[0] if h else 0.0) * p
            allowed = u * factor + self.tolerance * (factor or float(numpy.abs(a) @ TYPICAL))
            for i, (low, high) in enumerate(zip(self.splines.points, self.splines.points[1:])):
                own = numpy.tensordot(design, self.splines.values[:, i, :], 1)
                total = numpy.poly1d([c])
                for order in range(4):
                    if a[order]:
                        total += a[order] * numpy.poly1d(numpy.polyder(own, order) if order else own)
                ends = [0.0, high - low]
                inner = [t.real for t in numpy.roots(numpy.polyder(total).coeffs) if abs(t.imag) < 1e-9 and 0 < t.real < high - low]
                for t in ends + inner:
                    if total(t) > allowed:
                        yield i, round(low + t, 13), rule


class Scene:
    """Text, the number that it seeks, and the rows of its strokes."""

    def __init__(self, numbers, index):
        self.numbers, self.family = numbers, FAMILIES[index % len(FAMILIES)]
        kinds = ("DRD", "RR", "program")
        self.kind, self.degree = kinds[index % 3], numbers.choice((3, 3, 5))
        self.segments, self.lift = numbers.randint(8, 20), numbers.choice((8, 12.5, 20))
        self.rise, self.back = numbers.choice((60, 75, 90, 120)), numbers.choice((60, 80, 100))
        self.rpm, self.gap = numbers.choice((90, 250, 400)), numbers.choice((1e-3, 1e-4, 1e-5))
        self.speed = self.rpm * math.pi / 30
        self.tables, self.limits, self.caps, self.largest = "", "", [], False
        self.make_strokes()
        self.add_caps()
        getattr(self, self.family)()

    def make_strokes(self):
        one = math.radians(self.rise)
        if self.kind == "program":
            self.strokes = [Stroke(self.degree, self.segments, 1.0, one, self.lift),
                            Stroke(self.degree, self.segments, 1.0, math.radians(self.back), self.lift, 1.0, -1.0)]
        else:
            length = 1.0 if self.kind == "DRD" else 1.0 + self.back / self.rise
            self.strokes = [Stroke(self.degree, self.segments, length, one, self.lift, top=self.kind == "RR")]

    def pick(self, low, high, digits=3):
        return round(self.numbers.uniform(low, high), digits)

    def cap(self, order, most, sign=1.0):
        """A row of every stroke: sign y^(order) <= most, of the normalised motion."""
        self.caps.append(lambda stroke: (numpy.eye(4)[order] * sign, -most))

    def add_caps(self):
        """Of any motion but for those that the number is sought of."""
        for name, order, least in (("acceleration", 2, 6.0), ("jerk", 3, 70.0)):
            if self.numbers.random() < 0.4:
                continue
            most = self.pick(least, 3 * least, 1)
            self.limits += f"{name} = {most}\n"
            for sign in (1.0, -1.0):
                self.cap(order, most, sign)

    def text(self):
        back = f"return_deg = {self.back}\n" if self.kind == "RR" else ""
        if self.kind == "program":
            rest = 360 - self.rise - self.back
            motion = (f'type = "program"\nlift_mm = {self.lift}\nspeed_rpm = {self.rpm}\n' + SPLINE + f"angle_deg = {self.rise}\nto = 1\n" +
                      DWELL + f"angle_deg = {rest / 2}\n" + SPLINE + f"angle_deg = {self.back}\nto = 0\n" + DWELL +
                      f"angle_deg = {rest / 2}\n")
        else:
            motion = f'type = "{self.kind}"\nlift_mm = {self.lift}\nrise_deg = {self.rise}\n{back}speed_rpm = {self.rpm}\n'
        word = "largest" if self.largest else "least"
        return (f"[motion]\n{motion}[spline]\ndegree = {self.degree}\nsegments = {self.segments}\n[objective]\nacceleration = 0.5\n"
                f'jerk = 0.2\n{word} = "{self.key}"\nleast_gap = {self.gap!r}\n{self.tables}[limits]\n{self.limits}')

    def expected(self):
        """(the number, its error)."""
        found = [self.of_stroke(stroke, [cap(stroke) for cap in self.caps]) for stroke in self.strokes]
        value, error = (min if self.largest else max)(found, key=lambda pair: pair[0])
        if value <= 0 and not self.signed:
            raise NoTest("the end of its range")
        return value, error

    signed, chosen, verdict = False, None, "optimal"

    def of_stroke(self, stroke, caps):
        """Of a number that the rows are linear in: a . (…) + c <= u for the rows in sought."""
        rows = self.sought(stroke)
        size = max(float(numpy.abs(a) @ TYPICAL) for a, *_ in rows)
        program = LeastOf(stroke, caps, [(row, size) for row in rows], set(), chosen=self.chosen)
        least = program.solve()
        if abs(least) < NO_NUMBER:
            raise NoTest("an optimum of 0, to which nothing is relative")
        value = self.number_of(least * size)
        return value, max(LINEAR_ERROR, 10 * program.tolerance) * max(abs(value), size)

    def number_of(self, least):
        return -least if self.largest else least

    # Families: the key, its table, and the rows whose largest value is sought.

    def choose_peak(self, sides):
        name = self.numbers.choice(("velocity", "acceleration", "acceleration", "jerk"))
        order = ("velocity", "acceleration", "jerk").index(name) + 1
        self.limits = "".join(line for line in self.limits.splitlines(True) if not line.startswith(name))
        self.caps = [] if name in ("acceleration", "jerk") else self.caps
        self.limits = self.limits if self.caps else ""
        unit, power = self.numbers.choice(UNITS if sides == (1.0, -1.0) else UNITS[1:])
        suffix = f"_{unit}{POWERS[name]}" if power else ""
        self.key = f"limits.{name}{suffix}"
        length = {"mm": 1.0, "in": 25.4, "m": 1000.0}[unit.split("_")[0]] if power else 1.0
        per = {"s": 1 / self.speed, "rad": 1.0, "deg": 180 / math.pi}[unit.split("_")[1]] if power else 1.0

        def row(stroke, sign):
            if not power:
                return sign * numpy.eye(4)[order], 0.0
            return stroke.sum((sign / length / per**order, order))
        self.sought = lambda stroke: [row(stroke, sign) for sign in sides]
        self.row, self.name, self.suffix, self.order = row, name, suffix, order

    def peak(self):
        self.choose_peak((1.0, -1.0))
        if self.numbers.random() < 0.5:
            self.limits += f"{self.name}{self.suffix} = {self.pick(1e-3, 1e3)}\n"

    def side(self):
        upper = self.numbers.random() < 0.5
        self.choose_peak((1.0,) if upper else (-1.0,))
        self.key += ".max" if upper else ".min"
        self.largest, self.signed = not upper, True
        stroke = max(self.strokes, key=lambda one: 1 / one.angle)
        other = float(f"{self.numbers.uniform(1.05, 2) * (1.9, 5.8, 75)[self.order - 1] * self.size_of(stroke):.5g}")
        given = float(f"{self.numbers.uniform(0.5, 4) * other:.5g}")
        pairs = {"min" if upper else "max": -other if upper else other, "max" if upper else "min": given if upper else -given}
        self.limits += f"{self.name}{self.suffix} = {{ min = {pairs['min']!r}, max = {pairs['max']!r} }}\n"
        sign = -1.0 if upper else 1.0
        self.caps.append(lambda one: (self.row(one, sign)[0], -other))

    def size_of(self, stroke):
        return abs(self.row(stroke, 1.0)[0][self.order])

    def roller(self, base, offsets=(0, 0, 3, 5, -4)):
        self.radius, self.offset = self.numbers.choice((4, 6, 10)), self.numbers.choice(offsets)
        self.tables += (f'[cam]\ntype = "disk"\nfollower = "translating_roller"\nbase_radius_mm = {base}\nroller_radius_mm = {self.radius}\n'
                        f"offset_mm = {self.offset}\n")
        self.base = base

    def pressure(self):
        self.roller(self.numbers.choice((20, 30, 45)))
        self.key = "limits.pressure_angle_deg"
        if self.numbers.random() < 0.5:
            self.limits += f"pressure_angle_deg = {self.pick(5, 80, 1)}\n"
        self.of_stroke = lambda stroke, caps: self.zero(stroke, caps, lambda angle: self.leaning(stroke, angle), 1e-3, 30.0, 89.0)

    def leaning(self, stroke, angle):
        """+- (s' - offset) <= tan (s + height)."""
        steep, height = math.tan(math.radians(angle)), math.sqrt((self.base + self.radius)**2 - self.offset**2)
        return [stroke.sum((sign, 1), -sign * self.offset, (-steep, 0), -steep * height) for sign in (1.0, -1.0)]

    def angle(self):
        """Of the rise. It is not known to be monotone: values beyond the first edge are tried, and nothing is claimed of all of them."""
        if self.kind == "RR":  # its return would follow
            self.kind = "DRD"
            self.make_strokes()
        self.roller(self.numbers.choice((20, 30, 45)), (0,))
        self.key, self.verdict = "motion.rise_deg" if self.kind == "DRD" else "motion.segments[0].angle_deg", "local"
        most = self.pick(15, 35, 1)
        self.limits += f"pressure_angle_deg = {most}\n"

        def turned(stroke, degrees):
            other = copy.copy(stroke)
            other.angle = math.radians(degrees)
            return other

        def least_angle(stroke, caps):
            if stroke is self.strokes[0]:
                return self.zero(stroke, caps, lambda degrees: self.leaning(turned(stroke, degrees), most), 5.0, 90.0, 200.0)
            if self.violation(stroke, caps, self.leaning(stroke, most), set()) > -CERTAIN:
                raise NoTest("no motion, whatever the first angle")
            return 0.0, 0.0
        self.of_stroke = least_angle

    def base_radius(self):
        self.roller(self.numbers.choice((20, 40, 200)))
        self.key = "cam.base_radius_mm"
        angle = self.pick(18, 40, 1)
        self.limits += f"pressure_angle_deg = {angle}\n"
        steep = math.tan(math.radians(angle))
        self.sought = lambda stroke: [stroke.sum((sign / steep, 1), -sign * self.offset / steep, (-1.0, 0)) for sign in (1.0, -1.0)]
        self.number_of = lambda height: math.sqrt(max(height, 0.0)**2 + self.offset**2) - self.radius

    def forces(self):
        """Without a cam of its own: a roller."""
        if not self.tables:
            self.roller(60)
        stroke = min(self.strokes, key=lambda one: one.angle)
        self.mass, self.damping = self.pick(0.2, 2), 0.0 if self.family == "fastest" else self.numbers.choice((0, 0, 40.0))
        inertia = 5.5 * self.mass * self.speed**2 * self.lift / 1000 / stroke.angle**2
        self.natural = inertia / self.lift
        self.rate = float(f"{self.numbers.uniform(0, 0.8) * self.natural:.4g}")  # N/mm
        self.load, self.least = self.numbers.choice((0, 0, 25, -20)), self.numbers.choice((0, 10, 30))
        self.held = float(f"{self.numbers.uniform(0.2, 1.5) * inertia:.4g}")
        if self.family in ("spring_rate", "fastest"):  # at s = 0, or at rest, nothing else holds the follower
            self.held += max(0, self.least - self.load)
        self.tables += (f"[forces]\nmass_kg = {self.mass}\ndamping_n_s_m = {self.damping}\nspring_rate_n_mm = {self.rate}\n"
                        f"preload_n = {self.held}\nload_n = {self.load}\n")

    def force(self, stroke, factor, rate, more, speed=None):
        """factor (m w² s'' + c w s' + rate s) + more, in N."""
        speed = self.speed if speed is None else speed
        return stroke.sum((factor * self.mass * speed**2 / 1000, 2), (factor * self.damping * speed / 1000, 1), (factor * rate, 0), more)

    def preload(self):
        self.forces()
        self.key = "forces.preload_n"
        self.limits += f"contact_force_min_n = {self.least}\n"
        self.sought = lambda stroke: [self.force(stroke, -1.0, self.rate, self.least - self.load)]

    def contact_force(self):
        self.forces()
        self.key, self.largest = "limits.contact_force_min_n", True
        if self.numbers.random() < 0.5:
            self.limits += f"contact_force_min_n = {self.least}\n"
        self.sought = lambda stroke: [self.force(stroke, -1.0, self.rate, -self.held - self.load)]

    def largest_force(self):
        self.forces()
        self.key = "limits.contact_force_max_n"
        if self.numbers.random() < 0.5:
            self.limits += f"contact_force_max_n = {self.pick(1, 5000, 1)}\n"
        self.sought = lambda stroke: [self.force(stroke, 1.0, self.rate, self.held + self.load)]

    def chosen_preload(self):
        """The least peak of the contact force, with the preload that keeps the follower on the cam."""
        if self.kind == "program":  # its strokes share the preload
            self.kind, self.strokes = "DRD", self.strokes[:1]
        self.forces()
        self.key, self.chosen = "limits.contact_force_max_n", (0.0, 4 * self.held + 50)
        self.tables = self.tables.replace(f"preload_n = {self.held}", f"preload_n = {{ min = 0, max = {self.chosen[1]} }}")
        self.limits += f"contact_force_min_n = {self.least}\n"
        self.caps.append(lambda stroke: (*self.force(stroke, -1.0, self.rate, self.least - self.load), -1.0))
        self.sought = lambda stroke: [(*self.force(stroke, 1.0, self.rate, self.load), 1.0)]

    def spring_rate(self):
        self.forces()
        self.key = "forces.spring_rate_n_mm"
        self.limits += f"contact_force_min_n = {self.least}\n"
        self.of_stroke = lambda stroke, caps: self.zero(
            stroke, caps, lambda rate: [self.force(stroke, -1.0, rate, self.least - self.load - self.held)], 0.0, 1.5 * self.natural, math.inf)

    def fastest(self):
        """The speed at which the follower just stays on the cam; by bisection over its reciprocal."""
        self.forces()
        self.key, self.largest = "motion.speed_rpm", True
        self.limits += f"contact_force_min_n = {self.least}\n"

        def largest_speed(stroke, caps):
            rows = lambda turn: [self.force(stroke, -1.0, self.rate, self.least - self.load - self.held, math.pi / 30 / turn)]
            turn, error = self.zero(stroke, caps, rows, 1e-5, 1e-2, math.inf)
            return 1 / turn, error / turn**2
        self.of_stroke = largest_speed

    def hertz(self):
        """p² = F / (pi b radius c) of a flat face, at rest and at the speed; of its cam's radius F <= pi b c p² radius is linear."""
        base, width, radius = self.numbers.choice((150, 250)), self.numbers.choice((8, 15, 30)), self.pick(1, 5, 1)
        self.tables = f'[cam]\ntype = "disk"\nfollower = "translating_flat"\nbase_radius_mm = {base}\n'
        self.forces()
        self.held = abs(self.held) + 30
        self.key = "limits.hertz_pressure_max_mpa"
        self.tables = "\n".join(f"preload_n = {self.held}" if line.startswith("preload_n") else line for line in self.tables.split("\n"))
        self.tables += f"contact_width_mm = {width}\nspeed_range_rpm = [0, {self.rpm}]\n"
        self.limits += f"cam_radius_min_mm = {radius}\n"
        self.caps.append(lambda stroke: stroke.sum((-1.0, 0), (-1.0, 2), radius - base))
        if self.numbers.random() < 0.5:
            self.limits += f"hertz_pressure_max_mpa = {self.pick(50, 2000, 0)}\n"
        compliance = 2 * (1 - 0.3**2) / 210e9

        def rows(stroke, pressure):
            carried = math.pi * width / 1000 * compliance * (1e6 * pressure)**2 / 1000  # N/mm
            body = stroke.sum((-carried, 0), (-carried, 2), -carried * base)
            loads = [self.force(stroke, 1.0, self.rate, self.held + self.load, speed) for speed in (0.0, self.speed)]
            return [(a + body[0], c + body[1]) for a, c in loads]
        self.of_stroke = lambda stroke, caps: self.zero(stroke, caps, lambda pressure: rows(stroke, pressure), 1.0, 500.0, math.inf)

    def flat_radius(self):
        base = self.numbers.choice((30, 60, 90))
        self.tables += f'[cam]\ntype = "disk"\nfollower = "translating_flat"\nbase_radius_mm = {base}\n'
        self.key, self.largest = "limits.cam_radius_min_mm", True
        if self.numbers.random() < 0.5:
            self.limits += f"cam_radius_min_mm = {self.pick(0, 20, 1)}\n"
        self.sought = lambda stroke: [stroke.sum((-1.0, 0), (-1.0, 2), -base)]

    def zero(self, stroke, caps, rows_at, low, high, end):
        """(the number whose least common violation is 0, its error), by regula falsi (Illinois) and bisection."""
        places = set()
        at = lambda number: self.violation(stroke, caps, rows_at(number), places)
        t_low, t_high = at(low), at(high)
        if t_low < CERTAIN:
            raise NoTest("the end of its range")
        for _ in range(10):
            if t_high < -CERTAIN:
                break
            low, t_low, high = high, t_high, min(2 * high, end)
            t_high = at(high)
        if t_high > -CERTAIN:
            raise NoTest("no motion with any value")
        for k in range(100):
            if high - low < ENCLOSED * high:
                break
            middle = low + (high - low) * (t_low / (t_low - t_high)) if k % 3 and low > 0.01 * high else (low + high) / 2
            middle = min(max(middle, low + 0.3 * ENCLOSED * high), high - 0.3 * ENCLOSED * high)
            t = at(middle)
            if t > 0:
                low, t_low = middle, t
            else:
                high, t_high = middle, t
        for part in BRACKETS:
            if at(high * (1 + part)) < -CERTAIN and at(high * (1 - part)) > CERTAIN:
                return high, part * high
        raise NoTest("the violation is too flat for HiGHS to say")

    @staticmethod
    def violation(stroke, caps, rows, places):
        size = max(float(numpy.abs(a) @ TYPICAL) + abs(c) for a, c in rows)
        program = LeastOf(stroke, caps, [(row, size) for row in rows], places, CERTAIN)
        least = program.solve()
        return least if least > CERTAIN else least + program.tolerance


FAMILIES = ("peak", "side", "pressure", "base_radius", "preload", "contact_force", "spring_rate", "flat_radius", "largest_force",
            "chosen_preload", "angle", "hertz", "fastest")


def judged(module, folder, scene, expected):
    """What is wrong with the result of a scene whose number is known."""
    value, error = expected
    result = json.loads((folder / "result.json").read_text())
    least = result["least"]
    if least is None:
        return f"{result['verdict']}, nothing is said of {scene.key}: expected {value}"
    sign = -1.0 if scene.largest else 1.0
    impossible, found = least["impossible"], least["value"]
    # Next to the edge the limits nearly contradict: the motion there is proved as well as doubles allow.
    proved = result["verdict"] == "optimal" or (result["verdict"] == "feasible" and (result["bound"]["gap"] or 1) < 1e-3)
    if least["verdict"] != scene.verdict or not proved or impossible is None:
        return f"{result['verdict']}, least {least}: expected {value}"
    if not sign * impossible <= sign * value + error or not sign * value <= sign * found + error:
        return f"{impossible}, {found} do not enclose {value} with error {error}"
    if abs(found - impossible) > scene.gap * abs(found) * (1 + 1e-9):
        return f"{impossible}, {found} are further apart than {scene.gap}"
    outcome = checker.outcome(module, folder)
    return None if outcome[0] == "confirmed" else f"{outcome}"


# Claims that are not so.

def edited(path, change):
    table = json.loads(path.read_text())
    change(table)
    path.write_text(json.dumps(table))


def replace_number(path, key, old, new):
    """In a scene as camopt writes it."""
    name = key.rpartition(".")[2]
    name = key.split(".")[1] if name in ("min", "max") else name
    lines = path.read_text().splitlines()
    for i, line in enumerate(lines):
        if line.startswith(f"{name} = "):
            text = next(form for form in (repr(old), f"{old:g}", f"{old:.12g}", str(int(old)) if old == int(old) else repr(old)) if form in line)
            lines[i] = line.replace(text, repr(new))
    path.write_text("\n".join(lines) + "\n")


def spoiled_claims(scene, least, other):
    """{name: change of a folder}."""
    value, impossible, key = least["value"], least["impossible"], scene.key

    def with_value(folder, new, name="value", place=""):
        replace_number(folder / place / "scene.toml", key, least[name], new)
        edited(folder / "result.json", lambda result: result["least"].update({name: new}))

    between = impossible + 0.999 * (value - impossible)

    def other_key(folder):
        text = (folder / "scene.toml").read_text().replace(f'"{key}"', '"limits.velocity"')
        (folder / "scene.toml").write_text(text)
        edited(folder / "result.json", lambda result: result["least"].update(key="limits.velocity"))

    def other_proof(folder):
        shutil.rmtree(folder / "least")
        shutil.copytree(other / "least", folder / "least")

    def other_certificate(folder):
        for name in ("certificate.json", "result.json"):
            shutil.copy(other / "least" / name, folder / "least" / name)

    def other_direction(folder):
        words = ("largest = ", "least = ") if scene.largest else ("least = ", "largest = ")
        text = (folder / "scene.toml").read_text().replace(f"\n{words[0]}", f"\n{words[1]}")
        (folder / "scene.toml").write_text(text)
        edited(folder / "result.json", lambda result: result["least"].update(largest=not scene.largest))

    def no_motion_claimed(folder):
        shutil.rmtree(folder / "least")
        shutil.copytree(folder, folder / "least")

    return {
        "value beyond impossible": lambda folder: with_value(folder, impossible + 0.5 * (impossible - value)),
        "value at impossible": lambda folder: with_value(folder, impossible),
        "value of the result alone": lambda folder: edited(folder / "result.json", lambda r: r["least"].update(value=between)),
        "impossible on the feasible side": lambda folder: with_value(folder, value + 0.5 * (value - impossible), "impossible", "least"),
        "impossible next to the value": lambda folder: with_value(folder, between, "impossible", "least"),
        "impossible of the result alone": lambda folder: edited(folder / "result.json", lambda r: r["least"].update(impossible=between)),
        "another key": other_key,
        "the other direction": other_direction,
        "least/ of another scene": other_proof,
        "the certificate of another scene": other_certificate,
        "a motion as proof": no_motion_claimed,
        "no proof": lambda folder: shutil.rmtree(folder / "least"),
        "nothing stated": lambda folder: edited(folder / "result.json", lambda r: r.update(least=None)),
    }


def confirmed_spoilings(module, place, folder, scene, other):
    """Names of spoiled claims that the checker confirms."""
    least = json.loads((folder / "result.json").read_text())["least"]
    confirmed = []
    for name, spoil in spoiled_claims(scene, least, other).items():
        copy = Path(place) / "spoiled"
        shutil.copytree(folder, copy)
        spoil(copy)
        try:
            outcome = checker.outcome(module, copy)
        except Exception as fault:  # the program reports it, and confirms nothing
            outcome = ("failed", repr(fault))
        if outcome[0] == "confirmed":
            confirmed.append(f"{name}, {scene.key}: confirmed")
        shutil.rmtree(copy)
    return confirmed


# Numbers that are not known to be monotone: an angle; the rate of a spring that is longer than free below s = 0.
NOT_MONOTONE = {
    "motion.rise_deg": """[motion]
type = "DRD"
lift_mm = 20
rise_deg = 60
[objective]
jerk = 1
least = "motion.rise_deg"
least_gap = 1e-3
[cam]
type = "disk"
follower = "translating_roller"
base_radius_mm = 25
roller_radius_mm = 10
[limits]
pressure_angle_deg = 28
""",
    "forces.spring_rate_n_mm": """[motion]
type = "RR"
lift_mm = 12
rise_deg = 100
speed_rpm = 300
via = [{ at = 1.5, displacement = -0.5 }]
[spline]
segments = 16
[objective]
acceleration = 0.5
jerk = 0.5
least = "forces.spring_rate_n_mm"
[cam]
type = "disk"
follower = "translating_roller"
base_radius_mm = 30
roller_radius_mm = 10
[forces]
mass_kg = 3
spring_rate_n_mm = 2
preload_n = 40
[limits]
contact_force_min_n = 0
"""}


def spoiled_local(module, camopt, place):
    """Nothing is claimed beyond the impossible value, and nobody may claim it."""
    faults = []
    for key, text in NOT_MONOTONE.items():
        folder = Path(place) / key
        checker.solve(camopt, text, folder)
        stated = json.loads((folder / "result.json").read_text())["least"]
        if stated["verdict"] != "local" or stated["impossible"] is None:
            faults.append(f"{key}: {stated}")
        elif (outcome := checker.outcome(module, folder))[0] != "confirmed":
            faults.append(f"{key}: {outcome}")
        for verdict in ("optimal", "feasible"):
            edited(folder / "result.json", lambda result, to=verdict: result["least"].update(verdict=to))
            if (outcome := checker.outcome(module, folder))[0] == "confirmed":
                faults.append(f"{key}, local -> {verdict}: {outcome}")
    return faults


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("camopt")
    parser.add_argument("--count", type=int, default=60)
    parser.add_argument("--seed", type=int, default=21)
    arguments = parser.parse_args()
    module, numbers, faults, met = checker.load(), random.Random(arguments.seed), [], {}
    with tempfile.TemporaryDirectory() as place:
        index, last = 0, None
        while index < arguments.count:
            scene = Scene(numbers, index)
            try:
                expected = scene.expected()
            except NoTest:
                continue
            folder = Path(place) / f"scene_{index}"
            words = f"{index}: {scene.kind}, degree {scene.degree}, {scene.segments} segments, {scene.key}, expected {expected[0]:.10g}"
            print(words, flush=True)
            try:
                checker.solve(arguments.camopt, scene.text(), folder)
                fault = judged(module, folder, scene, expected)
            except AssertionError as failure:
                fault = str(failure)
            if fault:
                faults.append(f"{words}: {fault}\n{scene.text()}")
            elif scene.verdict == "optimal" and (last is None or scene.family not in met):
                if last is not None:
                    faults += confirmed_spoilings(module, place, folder, scene, last)
                last = folder
            met[scene.family] = met.get(scene.family, 0) + 1
            index += 1
        faults += spoiled_local(module, arguments.camopt, place)
    print(met)
    return checker.end(faults)


if __name__ == "__main__":
    sys.exit(main())
