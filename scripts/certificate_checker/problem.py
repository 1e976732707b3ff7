# SPDX-License-Identifier: MIT
"""The problem, from the scene alone."""
from fractions import Fraction

from .conditions import Conditions
from .exact import (
    ORDERS, PI, Refuted, STATED, Unverified, derivative, exactly, integral, largest_magnitude,
    middle_of, number, product, root, times)
from .spaces import Space

CLOSE = Fraction(1, 10**6)  # set points nearer than this, in x, fix a slope that a last digit moves
LENGTHS = {"mm": Fraction(1, 1000), "m": Fraction(1), "in": Fraction(254, 10000)}


def dimension_of(table, *names):
    """m, or (least, most) where it is searched; 0 where no name is given."""
    for unit, size in LENGTHS.items():
        for name in names:
            value = table.get(f"{name}_{unit}")
            if isinstance(value, dict):
                return number(value["min"]) * size, number(value["max"]) * size
            if value is not None:
                return number(value) * size
    return Fraction(0)


def angle_of(table, key):
    """(value, "deg" or "rad"), or None."""
    for unit in ("deg", "rad"):
        if f"{key}_{unit}" in table:
            value = table[f"{key}_{unit}"]
            if isinstance(value, dict):
                raise Unverified(f"{key}_{unit}: an angle that is searched")
            return number(value), unit
    return None


def ratio(a, b):
    """Of two angles in one unit. Degrees and radians mixed have no exact ratio."""
    if a[1] != b[1]:
        raise Unverified("angles in degrees and in radians in one scene")
    return a[0] / b[0]


class Stretch:
    """A part of the motion: a dwell, a law, or a spline between two displacements (None: what the spline makes)."""

    def __init__(self, kind, begin, end, start, to):
        self.kind, self.begin, self.end, self.start, self.to = kind, begin, end, start, to

    def scale(self, order):
        """y^(order) is this times what V, A and J of the stretch measure."""
        if self.start is None or self.to is None:
            raise Unverified("displacements that are free")
        displacement = abs(self.to - self.start)
        if displacement < Fraction(1, 10**9):
            displacement = Fraction(1)
        return displacement / (self.end - self.begin)**order


class Run:
    """A spline over neighbouring stretches: its space, and conditions (row, value, name) it meets exactly."""

    def __init__(self, space, stretches):
        self.space, self.stretches, self.conditions = space, stretches, []
        self.rests = (True, True)

    def is_fine(self):
        """Where a segment is far narrower than others, or than the whole, the last digit of y is much of its third derivative."""
        widths = [self.space.width(i) for i in range(self.space.segments)]
        return 1000 * min(widths) < max(max(widths), 2 * sum(widths))

    def top(self):
        return min(3, self.space.continuity)

    def in_top(self, row):
        """A function of the control points as one of y, y' ... at the start and the control points of the derivative
        top."""
        weights, starts = [row.get(j, Fraction(0)) for j in range(self.space.size)], []
        for order in range(1, self.top() + 1):
            start, weights = self.space.raised(weights, order)
            starts.append(start)
        return {j: w for j, w in enumerate(starts + weights) if w}

    def conditions_in_top(self):
        return Conditions([(self.in_top(row), value, name) for row, value, name in self.conditions])

    def demand(self, x, order, side, value, name):
        self.conditions.append((self.space.functional(x, order, side), value, name))


class Peak:
    """A term of the objective: weight * max |y^(order)| / reference (kind "rms": root mean square; "residual": vibration of an
    elastic follower's output after the motion)."""

    def __init__(self, kind, order, weight, reference, cap=None):
        self.kind, self.order, self.weight, self.reference, self.cap = kind, order, weight, reference, cap


class Problem:
    """What the scene asks for. x counts in rises (programs: in angles of the first spline segment), y in lifts."""

    def __init__(self, scene, references, breakpoints_found=None):
        self.scene = scene
        self.motion = scene["motion"]
        self.spline = scene.get("spline", {})
        self.limits = scene.get("limits", {})
        self.objective = scene["objective"]
        self.solver = scene.get("solver", {})
        self.gap = number(self.solver.get("gap", Fraction(1, 10**7)))
        self.type = self.motion["type"]
        self.degree = self.spline.get("degree", 3)
        self.continuity = self.spline.get("continuity", self.degree - 1)
        self.free_breakpoints = self.spline.get("knots") == "free"
        self.breakpoints_found = breakpoints_found
        self.lift = self.lift_of()
        self.unit_angle = None
        self.stretches, self.runs = [], []
        if self.type == "program":
            self.build_program()
        else:
            self.build_stroke()
        self.motion_caps = []  # (order, cap, key): caps in time on a program's motion itself
        self.references = references
        self.terms = self.terms_of(references)
        self.cam = None
        self.train = None  # an elastic follower

    def least_cost(self):
        """What dimensions cost at least: the peaks share the rest."""
        return self.cam.least_cost() if self.cam and self.cam.judged else Fraction(0)

    def has_close_points(self):
        """Two set points nearer than a millionth to each other."""
        tables = [self.motion.get("via", [])] + [segment.get("via", []) for segment in self.motion.get("segments", [])]
        for via in tables:
            places = sorted(p for p in (self.place(point, "at", Fraction(0)) for point in via) if p is not None)
            if any(b - a < CLOSE for a, b in zip(places, places[1:])):
                return True
        return False

    # -- lengths and angles

    def lift_of(self):
        for unit, size in LENGTHS.items():
            if f"lift_{unit}" in self.motion:
                return number(self.motion[f"lift_{unit}"]) * size, "m"
        for unit in ("deg", "rad"):
            if f"lift_{unit}" in self.motion:
                return number(self.motion[f"lift_{unit}"]), unit
        return Fraction(1, 1000), "m"

    def in_lifts(self, table, key):
        """A displacement: normalised, or in a unit of the lift."""
        if key in table:
            return number(table[key])
        size, kind = self.lift
        for unit, length in LENGTHS.items():
            if f"{key}_{unit}" in table and kind == "m":
                return number(table[f"{key}_{unit}"]) * length / size
        for unit in ("deg", "rad"):
            if f"{key}_{unit}" in table:
                return ratio((number(table[f"{key}_{unit}"]), unit), self.lift)
        return None

    def turns_per_second(self):
        """Unit angles a second. rpm with degrees and rad/s with radians are exact."""
        if "speed_rpm" in self.motion and self.unit_angle[1] == "deg":
            return number(self.motion["speed_rpm"]) * 6 / self.unit_angle[0]
        if "speed_rad_s" in self.motion and self.unit_angle[1] == "rad":
            return number(self.motion["speed_rad_s"]) / self.unit_angle[0]
        raise Unverified("a speed that has no exact ratio to the angles (rpm goes with degrees, rad/s with radians)")

    def derivative_in_unit(self, table, name):
        """A velocity (acceleration, jerk) of a table: normalised, by time or by the cam angle; and its key."""
        order = ORDERS[name]
        if name in table:
            return number(table[name]), name
        power = "" if order == 1 else str(order)
        size, kind = self.lift
        units = {**LENGTHS} if kind == "m" else {kind: Fraction(1)}
        for unit, length in units.items():
            key = f"{name}_{unit}_s{power}"
            if key in table:
                return number(table[key]) * length / (size * self.turns_per_second()**order), key
            for by in ("rad", "deg"):
                key = f"{name}_{unit}_{by}{power}"
                if key in table:
                    if self.unit_angle[1] != by:
                        if by != "rad":
                            raise Unverified(f"{key} with angles in radians")
                        angle = times(exactly(self.unit_angle[0] / 180), PI)
                        middle = middle_of(angle)[0]  # pi to 35 digits: far below what a condition is met to
                        return number(table[key]) * length / size * middle**order, key
                    return number(table[key]) * length / size * self.unit_angle[0]**order, key
        found = [key for key in table if key.startswith(name + "_")]
        if found:
            raise Unverified(f"{found[0]}: this unit")
        return None, None

    # -- one stroke: DRD, RR

    def build_stroke(self):
        rise = angle_of(self.motion, "rise") or (Fraction(180), "deg")
        self.unit_angle = rise
        length = Fraction(1)
        if self.type == "RR":
            back = angle_of(self.motion, "return") or rise
            length = 1 + ratio(back, rise)
        top = Fraction(1) if self.type == "DRD" else Fraction(0)
        # V, A and J of a stroke are measured by the lift and the rise.
        stretch = Stretch("spline", Fraction(0), length, Fraction(0), top)
        stretch.scale = lambda order: Fraction(1)
        self.stretches = [stretch]
        regions = self.regions(self.motion.get("via", []), Fraction(0))
        if self.motion.get("symmetric", False):
            regions += [(length - b, length - a) for a, b in regions]
        run = Run(Space(self.degree, self.continuity, self.breakpoints(Fraction(0), length, regions)), [stretch])
        for order in range(3):
            run.demand(Fraction(0), order, "right", Fraction(0), "start at rest")
            run.demand(length, order, "left", top if order == 0 else Fraction(0), "end at rest")
        if self.type == "RR":
            run.demand(Fraction(1), 0, "right", Fraction(1), "top of the rise: y(1) = 1")
            run.demand(Fraction(1), 1, "right", Fraction(0), "top of the rise: y'(1) = 0")
        self.end_jerk(run)
        self.set_points(run, self.motion.get("via", []), Fraction(0), length)
        if self.motion.get("symmetric", False):
            self.symmetry(run)
        self.runs = [run]

    def end_jerk(self, run):
        if self.spline.get("end_jerk", "free") == "zero":
            run.demand(run.space.breakpoints[0], 3, "right", Fraction(0), "spline.end_jerk")
            run.demand(run.space.breakpoints[-1], 3, "left", Fraction(0), "spline.end_jerk")

    def symmetry(self, run):
        """y(x) + y(1 - x) = 1 of DRD, y(x) = y(2 - x) of RR: control points in pairs."""
        points, last = run.space.breakpoints, run.space.size - 1
        if any(a + b != points[0] + points[-1] for a, b in zip(points, reversed(points))):
            raise Unverified("motion.symmetric on breakpoints that are not symmetric")
        sign = 1 if self.type == "DRD" else -1
        for j in range(last // 2 + 1):
            row = {j: Fraction(1), last - j: Fraction(sign)} if j != last - j else {j: Fraction(1 + sign)}
            if any(row.values()):
                run.conditions.append((row, Fraction(1 if sign > 0 else 0), "motion.symmetric"))

    # -- whole turns: programs

    def build_program(self):
        segments = self.motion["segments"]
        angles = [angle_of(segment, "angle") for segment in segments]
        first = [i for i, segment in enumerate(segments) if segment["kind"] == "spline"]
        self.unit_angle = angles[first[0]]
        joints = [Fraction(0)]
        for angle in angles:
            joints.append(joints[-1] + ratio(angle, self.unit_angle))
        closed, count = self.motion.get("closed", True), len(segments)
        levels = self.levels(segments, closed)
        for i, segment in enumerate(segments):
            self.stretches.append(Stretch(segment["kind"], joints[i], joints[i + 1], levels[i], levels[i + 1]))
            self.stretches[-1].law = segment.get("law")
        if closed and segments[0]["kind"] == "spline" and segments[-1]["kind"] == "spline":
            raise Unverified("a closed program whose spline lies across the start of the turn")
        i = 0
        while i < count:
            if segments[i]["kind"] != "spline":
                i += 1
                continue
            last = i
            while last + 1 < count and segments[last + 1]["kind"] == "spline":
                last += 1
            self.add_run(segments, i, last, closed)
            i = last + 1

    def levels(self, segments, closed):
        known = [None] * (len(segments) + 1)
        known[0] = Fraction(0)
        if closed:
            known[-1] = Fraction(0)
        for i, segment in enumerate(segments):
            to = self.in_lifts(segment, "to")
            if to is not None:
                known[i + 1] = to
        order = list(range(len(segments)))
        for i in order:
            if segments[i]["kind"] == "dwell" and known[i] is not None:
                known[i + 1] = known[i]
        for i in reversed(order):
            if segments[i]["kind"] == "dwell" and known[i + 1] is not None:
                known[i] = known[i + 1]
        if None in known:
            raise Unverified("displacements that are free")
        return known

    def add_run(self, segments, first, last, closed):
        points, conditions = [], []
        for i in range(first, last + 1):
            own = self.stretches[i]
            via = segments[i].get("via", [])
            regions = self.regions(via, own.begin)
            points += [x for x in self.breakpoints(own.begin, own.end, regions) if not points or x > points[-1]]
            conditions.append((via, own.begin, own.end))
        run = Run(Space(self.degree, self.continuity, points), self.stretches[first:last + 1])
        begin, end = self.stretches[first].begin, self.stretches[last].end
        for at, side, neighbour, level in ((begin, "right", first - 1, self.stretches[first].start),
                                           (end, "left", last + 1, self.stretches[last].to)):
            slope, bend = self.state_beside(neighbour % len(segments) if closed else neighbour)
            run.demand(at, 0, side, level, "displacement at the end of a spline")
            run.demand(at, 1, side, slope, "velocity at the end of a spline")
            run.demand(at, 2, side, bend, "acceleration at the end of a spline")
            if slope or bend:
                run.rests = (run.rests[0] and side != "right", run.rests[1] and side != "left")
        for i in range(first, last):
            run.demand(self.stretches[i].end, 0, "right", self.stretches[i].to, "displacement at a joint")
            if self.turns_back(segments, i):
                run.demand(self.stretches[i].end, 1, "right", Fraction(0), "turning point")
        self.end_jerk(run)
        for via, own_begin, own_end in conditions:
            self.set_points(run, via, own_begin, own_end)
        self.runs.append(run)

    def state_beside(self, neighbour):
        """y' and y'' where a spline meets what is beside it: rest, or what a law has at its end."""
        if not 0 <= neighbour < len(self.stretches) or self.stretches[neighbour].kind == "dwell":
            return Fraction(0), Fraction(0)
        own = self.stretches[neighbour]
        if own.law in ("cycloidal", "polynomial_345", "polynomial_4567", "polynomial_56789", "modified_sine",
                       "modified_trapezoid"):
            return Fraction(0), Fraction(0)
        if own.law == "constant_velocity":
            return (own.to - own.start) / (own.end - own.begin), Fraction(0)
        raise Unverified(f"a spline next to the law {own.law}")

    def stroke_at(self, stretch, at):
        """(displacement at its start, at its end, length) of the stroke at x; None where its set points are not between them,
        it moves next to a law, or ends where it began."""
        if self.type == "program":
            i = self.stretches.index(stretch)
            segments, beside = self.motion["segments"], (i - 1, (i + 1) % len(self.stretches))
            if segments[i].get("via") or any(self.stretches[j].kind == "law" for j in beside) or stretch.to == stretch.start:
                return None
            return stretch.start, stretch.to, stretch.end - stretch.begin
        for point in self.motion.get("via", []):
            displacement, is_region = self.in_lifts(point, "displacement"), self.place(point, "at", Fraction(0)) is None
            if displacement is not None and (is_region or not 0 < displacement < 1):
                return None
        if at <= 1:
            return Fraction(0), Fraction(1), Fraction(1)
        return Fraction(1), Fraction(0), stretch.end - 1

    def turns_back(self, segments, i):
        """Two splines that reverse the motion, neither of which may pass the joint between them."""
        if not self.motion.get("within_lift", True) and not self.motion.get("monotone", False):
            return False
        if any(key.startswith("displacement") for j in (i, i + 1)
               for point in segments[j].get("via", []) for key in point):
            return False
        before, after = self.stretches[i], self.stretches[i + 1]
        return (before.to - before.start) * (after.to - after.start) < 0

    # -- breakpoints and set points

    def breakpoints(self, begin, end, regions):
        if self.free_breakpoints:
            if self.breakpoints_found is None:
                raise Unverified("free breakpoints without a motion")
            return self.breakpoints_found
        given, width = self.spline.get("breakpoints"), end - begin
        if given:
            given = [number(x) for x in given]
            widths = [b - a for a, b in zip(given, given[1:])]
            if 1000 * min(widths) < max(widths):  # a last digit is a part of the narrow ones: the doubles are meant
                given = [number(float(x)) for x in given]
            unit = width / (given[-1] - given[0])
            points, closest = [begin + unit * (x - given[0]) for x in given], Fraction(1, 10**12)
        elif self.type == "RR" and "segments" not in self.spline and width != 2:  # six over either stroke
            points = [Fraction(i, 6) for i in range(6)] + [1 + (width - 1) * i / 6 for i in range(7)]
            closest = Fraction(1, 10**12)
        else:
            count = self.spline.get("segments", 12)
            points = [begin + width * i / count for i in range(count + 1)]
            closest = width / count / 4
        merged = []
        for a, b in sorted(regions):
            if merged and a < merged[-1][1]:
                merged[-1] = (merged[-1][0], max(b, merged[-1][1]))
            else:
                merged.append((a, b))
        kept = [x for x in points if x in (begin, end) or
                not any(a - closest < x < b + closest for a, b in merged)]
        return sorted(set(kept) | {x for ab in merged for x in ab})

    def place(self, table, key, begin):
        if key in table:
            return begin + number(table[key])
        angle = angle_of(table, key)
        return None if angle is None else begin + ratio(angle, self.unit_angle)

    def regions(self, via, begin):
        return [(self.place(p, "from", begin), self.place(p, "to", begin)) for p in via
                if self.place(p, "from", begin) is not None]

    def set_points(self, run, via, begin, end):
        for point in via:
            at = self.place(point, "at", begin)
            region = at is None
            if region:
                at, until = self.place(point, "from", begin), self.place(point, "to", begin)
            side = "right" if at < end else "left"
            displacement = self.in_lifts(point, "displacement")
            if displacement is not None:
                run.demand(at, 0, side, displacement, "via")
            velocity = self.derivative_in_unit(point, "velocity")[0]
            acceleration = self.derivative_in_unit(point, "acceleration")[0]
            if acceleration is not None:
                run.demand(at, 2, side, acceleration, "via")
            if velocity is None:
                continue
            run.demand(at, 1, side, velocity, "via")
            if region:  # a straight line: every higher derivative of the one piece vanishes
                run.demand(at, 2, "right", Fraction(0), "via")
                for order in range(3, self.degree + 1):
                    run.demand(at, order, "right", Fraction(0), "via")
                if run.space.segment_of(at, "right")[0] != run.space.segment_of(until, "left")[0]:
                    raise Unverified("a region of constant velocity over several pieces")

    # -- objective and limits

    def terms_of(self, references):
        terms = []
        for name, order in ORDERS.items():
            weight = number(self.objective.get(name, 0))
            cap, key = self.derivative_in_unit(self.limits, name)
            if cap is not None and self.type == "program" and key != name:
                self.motion_caps.append((order, cap, "limits." + key))
                cap = None
            if weight or cap is not None:
                terms.append(Peak("peak", order, weight, references[name], cap))
        for name in ("rms_acceleration", "rms_jerk"):
            weight = number(self.objective.get(name, 0))
            if weight:
                terms.append(Peak("rms", ORDERS[name[4:]], weight, references[name]))
        if number(self.objective.get("torque", 0)):
            terms.append(Peak("torque", 2, number(self.objective["torque"]), references["torque"]))
        return terms

    def rms_weight(self, stretch, order):
        return 1 / stretch.scale(order)**2


def references_of(scene, stated):
    """What the objective divides by: the scene's numbers, or the peaks of a law. camopt writes these as doubles; they
    are checked against their formulas and then are the definition of the objective."""
    objective = scene["objective"]
    asked = objective.get("reference", "modified_sine")
    names = [n for n in (*ORDERS, "torque", "rms_acceleration", "rms_jerk") if number(objective.get(n, 0))]
    references = {}
    for name in names:
        if isinstance(asked, dict):
            if name not in asked:
                raise Unverified(f"objective.reference without {name}")
            references[name] = number(asked[name])
        else:
            low, high = law_peak(asked, name)
            references[name] = number(stated[name])
            if not low * (1 - STATED) <= references[name] <= high * (1 + STATED):
                raise Refuted(f"the reference {name} is {float(references[name])}, but that of the law is {float(low)}")
    for name in ORDERS:  # the unit of a peak that is only capped
        if name not in references:
            unit = stated.get(name)
            references[name] = number(float(sum(law_peak("modified_sine", name)) / 2) if unit is None else unit)
    return references


def modified_sine_torque():
    """max of A^2/(4 pi) cos p (1 + 3 sin p) over the middle of the law: at sin p = (sqrt 73 - 1)/12."""
    sine = tuple((r - 1) / 12 for r in root(Fraction(73)))
    cosine = root(1 - sine[1]**2)[0], root(1 - sine[0]**2)[1]
    acceleration = law_peak("modified_sine", "acceleration")
    factor = times(times(acceleration, acceleration), (1 / (4 * PI[1]), 1 / (4 * PI[0])))
    return times(factor, times(cosine, tuple(1 + 3 * s for s in sine)))


def law_peak(law, name):
    """(low, high) around a peak of a law of the catalogue."""
    one = exactly(Fraction(1))
    inverse = (1 / (4 + PI[1]), 1 / (4 + PI[0]))
    bent = (1 / (2 + PI[1]), 1 / (2 + PI[0]))
    square = times(PI, PI)
    cube = times(square, PI)
    known = {
        ("modified_sine", "velocity"): lambda: times(exactly(4), times(PI, inverse)),
        ("modified_sine", "acceleration"): lambda: times(exactly(4), times(square, inverse)),
        ("modified_sine", "jerk"): lambda: times(exactly(16), times(cube, inverse)),
        ("modified_sine", "torque"): modified_sine_torque,
        ("modified_trapezoid", "velocity"): lambda: times(exactly(2), one),
        ("modified_trapezoid", "acceleration"): lambda: times(exactly(8), times(PI, bent)),
        ("modified_trapezoid", "jerk"): lambda: times(exactly(32), times(square, bent)),
        ("parabolic", "velocity"): lambda: times(exactly(2), one),
        ("parabolic", "acceleration"): lambda: times(exactly(4), one),
        ("simple_harmonic", "velocity"): lambda: times(exactly(Fraction(1, 2)), PI),
        ("simple_harmonic", "acceleration"): lambda: times(exactly(Fraction(1, 2)), square),
        ("cycloidal", "velocity"): lambda: times(exactly(2), one),
        ("cycloidal", "acceleration"): lambda: times(exactly(2), PI),
        ("cycloidal", "jerk"): lambda: times(exactly(4), square),
    }
    polynomials = {"polynomial_345": [0, 0, 0, 10, -15, 6], "polynomial_4567": [0, 0, 0, 0, 35, -84, 70, -20],
                   "polynomial_56789": [0, 0, 0, 0, 0, 126, -420, 540, -315, 70]}
    if (law, name) in known:
        return known[(law, name)]()
    if law in polynomials:
        y = [Fraction(c) for c in polynomials[law]]
        if name in ORDERS:
            return largest_magnitude([(derivative(y, ORDERS[name]), Fraction(1))])
        if name.startswith("rms_"):
            bent = derivative(y, ORDERS[name[4:]])
            return root(integral(product(bent, bent), Fraction(1)))
        return largest_magnitude([(product(derivative(y), derivative(y, 2)), Fraction(1))])
    raise Unverified(f"the {name} of the law {law}, which the objective divides by")
