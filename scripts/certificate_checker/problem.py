# SPDX-License-Identifier: MIT
"""The problem, from the scene alone.

Theorem. The motions of the scene are the splines of `runs` that satisfy their conditions, joined with the laws and dwells of `stretches`; the
objective is the sum of weight * term over `terms` plus what dimensions cost, and the limits are `terms` with a cap, `bounds`
and those of the cam, the drive and the elastic follower. Assumption: the scene has passed known.py. Angles and units meet exactly, or with
pi to 35 digits.
"""
import itertools

from .conditions import AT_LIMIT, REST
from .enclosures import PI_ITSELF
from .exact import ORDERS, SAME_PLACE, Refuted, STATED, Unverified, add_to, number
from .laws import REVERSED, ends_of_law, is_same, polynomial_between, turns_back
from .measured import KINDS as DEVIATIONS, MeasuredTable, deviation_terms
from .motion_bounds import MotionBound, area_reference, motion_bounds
from .rational import Fraction
from .runs import Peak, Run, Stretch
from .spaces import CamSpace, Space
from .strokes import points_at_limits, turning_points
from .tolerance import Tolerances
from .units import LENGTHS, angle_of, in_unit, ratio

CLOSE = Fraction(1, 10**6)  # set points nearer than this, in x, fix a slope that a last digit moves


class Problem:
    """What the scene asks for. x counts in rises (programs: in angles of the first spline segment), y in lifts."""

    def __init__(self, scene, references, breakpoints_found=None, displacements=None, rises=None):
        """`displacements`: at each joint, where the scene leaves them free; empty: they remain free; None: that is not judged.
        `rises`: {segment: whether it rises} of a case."""
        self.scene, self.displacements, self.rises = scene, displacements, rises or {}
        self.ranges = None  # the scene with the ranges of angles that are searched
        self.free, self.farthest_level = set(), None  # joints whose displacement the scene leaves free, and how far it may be
        self.motion = scene["motion"]
        self.spline = scene.get("spline", {})
        self.limits = scene.get("limits", {})
        self.objective = scene.get("objective", {})
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
        self.copies = self.motion.get("repeat", 1)  # of all stretches, in a turn
        if self.type == "program":
            self.build_program()
        else:
            self.build_stroke()
        self.to_cam = None  # s = w_0 y + w_1 y' + w_2 y'' is the cam's motion, where that of the output is prescribed
        if self.prescribes_output():
            self.prescribe_output(scene["dynamics"])
        self.bounds = motion_bounds(self)
        self.references = references
        self.terms = self.terms_of(references)
        self.table = MeasuredTable(self) if any(term.kind in DEVIATIONS for term in self.terms) else None
        self.cam, self.left_out = None, {}
        self.train = None  # an elastic follower
        self.harmonics = None  # of the lift, where they are limited
        self.drive = None  # a motor in place of a cam

    def prescribes_output(self):
        return self.scene.get("dynamics", {}).get("prescribe", "cam") == "output"

    def prescribe_output(self, given):
        """The cam gives what a mass on its spring, return spring and damper to ground needs:
        s = (1 + k_r / k) y + c_g / (k T) y' + m / (k T^2) y'', T the seconds of a unit of x."""
        mass, back = number(given["mass_kg"]), number(given.get("return_spring_n_m", 0))
        damper, pace = number(given.get("ground_damping_n_s_m", 0)), self.turns_per_second()
        if "natural_frequency_hz" in given:
            stiffness = mass * (2 * PI_ITSELF * number(given["natural_frequency_hz"]))**2 - back
        elif "natural_frequency_rad_s" in given:
            stiffness = mass * number(given["natural_frequency_rad_s"])**2 - back
        else:
            stiffness = number(given["stiffness_n_m"])
        if "drive" in self.scene:
            raise Unverified("a motor that moves a prescribed output")
        if given.get("stage"):
            raise Unverified("an output prescribed with stages")
        self.to_cam = (1 + back / stiffness, damper / stiffness * pace, mass / stiffness * pace**2)
        for run in self.runs:
            run.cam_space = CamSpace(run.space, self.to_cam)

    def cam_at_rest(self, level):
        """Where the cam stands while the motion rests at a level."""
        return level * self.to_cam[0] if self.to_cam else level

    def least_cost(self):
        """What dimensions cost at least: the peaks share the rest."""
        return self.cam.least_cost() if self.cam and self.cam.judged else Fraction(0)

    def has_close_points(self):
        """Two set points nearer than a millionth to each other."""
        tables = [(self.motion.get("via", []), 1)]
        tables += [(segment.get("via", []), s.end - s.begin) for segment, s in
                   zip(self.motion.get("segments", []), self.stretches)]
        for via, width in tables:
            places = sorted(p for p in (self.place(point, "at", Fraction(0), width) for point in via) if p is not None)
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
        if "stops" in self.motion:
            return Fraction(360) / self.motion["stops"], "deg"
        return Fraction(1, 1000), "m"

    def lifts_of(self, table, name):
        """(how a displacement is written in a table, lifts of one in that unit), or (None, None)."""
        if name in table:
            return name, Fraction(1)
        size, kind = self.lift
        for unit, length in LENGTHS.items():
            if f"{name}_{unit}" in table and kind == "m":
                return f"{name}_{unit}", length / size
        for unit in ("deg", "rad"):
            if f"{name}_{unit}" in table:
                return f"{name}_{unit}", ratio((Fraction(1), unit), self.lift)
        return None, None

    def in_lifts(self, table, name):
        key, unit = self.lifts_of(table, name)
        return None if key is None else number(table[key]) * unit

    def turns_per_second(self):
        """Unit angles a second. rpm with degrees and rad/s with radians are exact, others to the 35 digits of pi."""
        for key, size, unit in (("speed_rpm", 6, "deg"), ("speed_rad_s", 1, "rad")):
            if key in self.motion:
                return in_unit((number(self.motion[key]) * size, unit), self.unit_angle[1]) / self.unit_angle[0]
        raise Unverified("numbers in units of time where no speed is given, or as it approaches 0")

    def derivative_of(self, table, name):
        """(how a velocity, acceleration or jerk is written in a table, y^(r) for one in that unit): normalised, by time or by the
        cam angle."""
        order = ORDERS[name.removeprefix("cam_")]
        if name in table:
            return name, Fraction(1)
        power = "" if order == 1 else str(order)
        size, kind = self.lift
        for unit, length in (LENGTHS if kind == "m" else {unit: in_unit((Fraction(1), unit), kind) for unit in ("deg", "rad")}).items():
            key = f"{name}_{unit}_s{power}"
            if key in table:
                return key, length / (size * self.turns_per_second()**order)
            for by in ("rad", "deg"):
                key = f"{name}_{unit}_{by}{power}"
                if key not in table:
                    continue
                return key, length / size * in_unit(self.unit_angle, by)**order
        found = [key for key in table if key.startswith(name + "_")]
        if found:
            raise Unverified(f"{found[0]}: this unit")
        return None, None

    def derivative_in_unit(self, table, name, width=Fraction(1)):
        """Its value; a normalised one is by the angle of a stretch of this width."""
        key, unit = self.derivative_of(table, name)
        if key is None:
            return None
        return number(table[key]) * (unit if key != name else 1 / width**ORDERS[name])

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
        regions = self.regions(self.motion.get("via", []), Fraction(0), Fraction(1))
        if self.motion.get("symmetric", False):
            regions += [(length - b, length - a) for a, b in regions]
        run = Run(Space(self.degree, self.continuity, self.breakpoints(Fraction(0), length, regions)), [stretch])
        run.curves = ((0, Fraction(0)),)
        run.states = [self.state_at_end(False), self.state_at_end(True)]
        for order in range(3):
            run.demand(Fraction(0), order, "right", run.states[0][order - 1] if order else Fraction(0), "state at the start")
            run.demand(length, order, "left", run.states[1][order - 1] if order else top, "state at the end")
        if self.type == "RR":
            run.demand(Fraction(1), 0, "right", Fraction(1), "top of the rise: y(1) = 1")
            run.demand(Fraction(1), 1, "right", Fraction(0), "top of the rise: y'(1) = 0")
        self.rest(run, True, True)
        self.set_points(run, self.motion.get("via", []), stretch, Fraction(1))
        if self.motion.get("symmetric", False):
            self.symmetry(run)
        self.runs = [run]
        for at in turning_points(self, stretch, self.motion.get("via", []), Fraction(0), Fraction(1)):
            run.demand(at, 1, "right", Fraction(0), "turning point")
        for at, order in points_at_limits(self, stretch, self.motion.get("via", []), Fraction(0), Fraction(1)):
            run.demand(at, order, "right", Fraction(0), AT_LIMIT)

    def state_at_end(self, at_end):
        """y' and y'' where a motion that is not closed starts or ends: what is asked, or that of a region there; else rest."""
        name, whole = ("end" if at_end else "start"), self.type != "program"
        own = self.stretches[-1 if at_end else 0]
        width = Fraction(1) if whole else own.end - own.begin
        if name in self.motion:
            found = [self.derivative_in_unit(self.motion[name], value, width) for value in ("velocity", "acceleration")]
            return tuple(value or Fraction(0) for value in found)
        via = self.motion.get("via", []) if whole else self.motion["segments"][-1 if at_end else 0].get("via", [])
        for point in via:
            begin, end = (self.place(point, key, own.begin, width) for key in ("from", "to"))
            if begin is not None and (end == own.end if at_end else begin == own.begin):
                return self.derivative_in_unit(point, "velocity", width), Fraction(0)
        return Fraction(0), Fraction(0)

    def rest_order(self):
        """The highest derivative that is 0 where a spline meets rest."""
        most = self.spline.get("rest", 3 if self.spline.get("end_jerk", "free") == "zero" else 2)
        return max(most, 4) if self.prescribes_output() else most

    def rest(self, run, at_start, at_end):
        """Where the run meets rest its derivatives are 0 up to spline.rest; y' and y'' are demanded with the state."""
        for order in range(3, self.rest_order() + 1):
            if at_start:
                run.demand(run.space.breakpoints[0], order, "right", Fraction(0), "spline.rest")
            if at_end:
                run.demand(run.space.breakpoints[-1], order, "left", Fraction(0), "spline.rest")

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
        kinds = [segment["kind"] for segment in segments]
        unit = next((i for kind in ("spline", "law") for i, own in enumerate(kinds) if own == kind), None)
        if unit is None:
            raise Unverified("a program of dwells only")
        self.unit_angle = angles[unit]
        joints = [Fraction(0)]
        for angle in angles:
            joints.append(joints[-1] + ratio(angle, self.unit_angle))
        closed = self.motion.get("closed", True)
        self.wraps = closed is True or closed == "relative"
        levels = self.levels(segments, closed is True)
        for i, segment in enumerate(segments):
            self.stretches.append(Stretch(segment["kind"], joints[i], joints[i + 1], levels[i], levels[i + 1],
                                          not self.free.isdisjoint((i, i + 1))))
            self.stretches[-1].law = segment.get("law")
        self.settle_laws(segments)
        groups = [[i for i, _ in group] for kind, group in itertools.groupby(enumerate(kinds), lambda own: own[1])
                  if kind == "spline"]
        joined = self.wraps and len(groups) > 1 and kinds[0] == kinds[-1] == "spline"
        self.measure_strokes(segments)
        first = groups.pop(0) if joined else []
        apart = int(joined and closed == "relative")  # then the delivered motion has a curve on either side of the start
        for k, group in enumerate(groups):
            passed = first if group is groups[-1] else []
            curves = [(k + apart, Fraction(0))] + [(0, joints[-1])] * (apart if passed else 0)
            self.add_run(segments, group + passed, passed, curves)

    # -- laws that depend on what is beside them

    def settle_laws(self, segments):
        """"polynomial" takes the states of both ends of its segment; a law that turns back has its top where the motion does."""
        for i, own in enumerate(self.stretches):
            if own.kind != "law":
                continue
            if own.law == "polynomial":
                if own.start is None or own.to is None or own.start == own.to:
                    raise Unverified("a polynomial without a rise that the scene states")
                rise, length = own.to - own.start, own.end - own.begin
                own.law = polynomial_between(*((v * length / rise, a if a is None else a * length**2 / rise)
                                               for v, a in (self.state_given(segments, i, after) for after in (0, 1))))
            elif turns_back(own.law):
                own.smooth_top = any(self.is_mirrored(i, other) for other in (i - 1, i + 1) if self.turns(i, other))
        for i, own in enumerate(self.stretches):
            if own.kind == "law" and turns_back(own.law) and self.turns(i, i - 1):
                own.law = REVERSED + own.law

    def is_mirrored(self, i, other):
        """Whether the neighbour runs through the same law backwards: then y'' does not jump between them."""
        own, other = self.stretches[i], self.stretches[other % len(self.stretches)]
        return other.kind == "law" and is_same(own.law, other.law) and own.end - own.begin == other.end - other.begin and \
            own.to - own.start == other.start - other.to

    def turns(self, i, other):
        """Whether the motion goes the other way at once in a neighbour."""
        if not (0 <= other < len(self.stretches) or self.wraps):
            return False
        own, other = self.stretches[i], self.stretches[other % len(self.stretches)]
        known = None not in (own.start, own.to, other.start, other.to)
        return other.kind != "dwell" and known and (own.to - own.start) * (other.to - other.start) < 0

    def state_given(self, segments, i, after):
        """y' and y'' at an end of a segment: what the scene states (of a joint without an acceleration: None), what a law next to it has, else rest."""
        other, count = (i + 1 if after else i - 1), len(segments)
        if not (0 <= other < count or self.wraps):
            point, width = self.motion.get("end" if after else "start"), self.stretches[i]
        else:
            before = i if after else other % count
            point, width = segments[before].get("end"), self.stretches[before]
        if point is not None:
            found = [self.derivative_in_unit(point, value, width.end - width.begin) for value in ("velocity", "acceleration")]
            return found[0] or Fraction(0), found[1] if found[1] is not None or 0 <= other < count or self.wraps else Fraction(0)
        beside = segments[other % count]
        if not (0 <= other < count or self.wraps) or beside["kind"] != "law" or beside["law"] == "polynomial":
            return Fraction(0), Fraction(0)
        own = self.stretches[other % count]
        if own.start is None or own.to is None:
            raise Unverified("a polynomial next to a law of a free displacement")
        return tuple(ends_of_law(own.law, order)[0 if after else 1] * (own.to - own.start) / (own.end - own.begin)**order
                     for order in (1, 2))

    def measure_strokes(self, segments):
        """What V, A and J are measured by: splines that join in motion are one stroke; or the whole motion is (objective.peaks)."""
        if self.objective.get("peaks", "strokes") == "motion":
            for stretch in self.stretches:
                stretch.measure = (Fraction(1), Fraction(1))
            return
        count = len(segments)

        def begins(i):
            before = (i or count) - 1
            if segments[i]["kind"] != "spline" or segments[before]["kind"] != "spline" or (i == 0 and not self.wraps):
                return True
            end = segments[before].get("end", {})
            width = self.stretches[before].end - self.stretches[before].begin
            moved = [self.stated_levels[j + 1] - self.stated_levels[j] for j in (before, i)
                     if None not in self.stated_levels[j:j + 2]]
            parts = len(moved) < 2 or (moved[0] * moved[1] < 0 or min(map(abs, moved)) < Fraction(1, 10**9))
            return parts or self.derivative_in_unit(end, "velocity", width) == 0

        starts = [i for i in range(count) if begins(i)]
        if not starts or self.motion.get("closed") == "relative" and all(one["kind"] == "spline" for one in segments):
            return  # a motion that never rests has no strokes, nor has one of splines alone that goes on and on
        for start, following in zip(starts, starts[1:] + [starts[0] + count]):
            if following - start > 1:
                self.measure_stroke(start, following, count)

    def measure_stroke(self, start, following, count):
        """Of the segments from start to following, which may go on at the start of the turn."""
        last = min(following, count)
        ends = [(self.stated_levels[start], self.stated_levels[last])]
        if following > count:
            ends.append((self.stated_levels[0], self.stated_levels[following - count]))
        known = all(level is not None for pair in ends for level in pair)
        moved = abs(sum(to - begin for begin, to in ends)) if known else Fraction(1)
        own = [self.stretches[i % count] for i in range(start, following)]
        angle = sum(stretch.end - stretch.begin for stretch in own)
        for stretch in own:
            stretch.measure = (angle, moved if moved >= Fraction(1, 10**9) else Fraction(1))

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
        self.free, self.stated_levels = {j for j, level in enumerate(known) if level is None}, list(known)
        if self.free and (self.displacements is None or self.motion.get("closed") == "relative"):
            raise Unverified("displacements that are free")
        given = [level for level in known if level is not None]
        least, most = min(given), max(given)
        span = max(Fraction(1), most - least)
        self.level_ends = least - span, most + span
        self.farthest_level = max(map(abs, self.level_ends))
        for j in sorted(self.free) if self.displacements else ():
            found = min(max(self.displacements[j], self.level_ends[0]), self.level_ends[1])
            if abs(found - self.displacements[j]) > STATED:
                raise Refuted(f"the displacement {float(self.displacements[j])} is further than one span beyond those given")
            known[j] = known[j - 1] if segments[j - 1]["kind"] == "dwell" else found
        return known

    def level_at(self, joint):
        """The displacement there as a function of those that are free: {-their joint: weight, None: a number}."""
        level = self.stretches[joint - 1].to if joint else Fraction(0)
        while level is None and self.stretches[joint - 1].kind == "dwell":
            joint -= 1
        return {-joint: Fraction(1)} if level is None else {None: level}

    def moved_between(self, joint, other):
        """By how much the displacement at the other joint is higher, as a function likewise."""
        moved = dict(self.level_at(other))
        add_to(moved, self.level_at(joint), -1)
        return moved

    def stretches_of_reference(self):
        """Those between displacements that the scene states, where a reference law moves: one that is free counts as the one before it."""
        if not self.free:
            return self.stretches
        found, level = [], Fraction(0)
        for own, start, to in zip(self.stretches, self.stated_levels, self.stated_levels[1:]):
            start = level if start is None else start
            level = start if to is None else to
            found.append(Stretch(own.kind, own.begin, own.end, start, level))
            found[-1].law = own.law
        return found

    def largest(self, value):
        """The largest magnitude of a number or of a function of displacements that are free."""
        return sum(abs(w) * (self.farthest_level if key else 1) for key, w in value.items()) if isinstance(value, dict) else value

    def is_rest(self, segments, index):
        """A dwell, or an open end."""
        outside = not self.wraps and not 0 <= index < len(segments)
        return outside or segments[index % len(segments)]["kind"] == "dwell"

    def add_run(self, segments, group, passed, curves):
        """The run of the segments that `group` counts; those of `passed` follow the start of the next turn."""
        turn, stretches, count = self.stretches[-1].end, [self.stretches[i] for i in group], len(segments)
        points = []
        for i, own in zip(group, stretches):
            regions = self.regions(segments[i].get("via", []), own.begin, own.end - own.begin)
            begin = turn if i in passed else 0
            points += [x + begin for x in self.breakpoints(own.begin, own.end, regions) if not points or x + begin > points[-1]]
        run = Run(Space(self.degree, self.continuity, points, turn if self.wraps else None), stretches,
                  [self.stretches[i] for i in passed], self.stretches[-1].to, tuple(curves))
        if self.wraps and len(group) == count:
            self.close(run)
        else:
            for place, neighbour in ((0, group[0] - 1), (1, group[-1] + 1)):
                state = self.state_beside(neighbour, place)
                run.states[place] = tuple(self.largest(value) for value in state)
                at, side, level = points[-place], ("right", "left")[place], run.ends()[place]
                level = self.level_at(group[-1] + 1 if place else group[0]) if level is None else level
                for order, value in enumerate((level, *state)):
                    run.demand(at, order, side, value, "state at the end of a spline")
        for i, following in zip(group, group[1:] + group[:1]):
            if following == group[0] and not run.is_ring():
                break
            if following != group[0]:
                own = self.stretches[i]
                level = self.level_at(i + 1) if own.to is None else own.to + run.level(own)
                run.demand(run.begin_of(own) + own.end - own.begin, 0, "left", level, "displacement at a joint")
            if self.turns_back(segments, i, following):
                run.demand(run.begin_of(self.stretches[following]), 1, "right", Fraction(0), "turning point")
            if self.rests_between(segments, i, following):
                run.demand(run.begin_of(self.stretches[following]), 2, "right", Fraction(0), REST)
        self.rest(run, *(self.is_rest(segments, neighbour) for neighbour in (group[0] - 1, group[-1] + 1)))
        for i, own in zip(group, stretches):
            self.set_points(run, segments[i].get("via", []), own, own.end - own.begin)
            for at in turning_points(self, own, segments[i].get("via", []), own.begin, own.end - own.begin):
                run.demand(at + run.begin_of(own) - own.begin, 1, "right", Fraction(0), "turning point")
            for at, order in points_at_limits(self, own, segments[i].get("via", []), own.begin, own.end - own.begin):
                run.demand(at + run.begin_of(own) - own.begin, order, "right", Fraction(0), AT_LIMIT)
            if "end" in segments[i]:
                self.set_points(run, [segments[i]["end"] | {"at": 1}], own, own.end - own.begin)
        self.runs.append(run)

    def close(self, run):
        """Splines all around: one turn goes on in the next as smoothly as anywhere."""
        begin, end = run.space.breakpoints[0], run.space.breakpoints[-1]
        run.states = [None, None]
        for at, side, level in ((begin, "right", run.ends()[0]), (end, "left", run.ends()[1])):
            run.demand(at, 0, side, level, "displacement at the start of the turn")
        for order in range(1, self.continuity + 1):
            row = run.space.functional(begin, order, "right")
            add_to(row, run.space.functional(end, order, "left"), -1)
            run.conditions.append((row, Fraction(0), f"derivative {order} at the start of the turn"))

    def state_beside(self, neighbour, after):
        """y' and y'' where a spline meets what is beside it: rest, what a law has at its end, or what is asked where the motion
        starts or ends. `after`: it follows the spline (1), or not (0)."""
        if not 0 <= neighbour < len(self.stretches):
            if not self.wraps:
                return self.state_at_end(neighbour > 0)
            neighbour %= len(self.stretches)
        own = self.stretches[neighbour]
        if own.kind != "law":
            return Fraction(0), Fraction(0)
        factors = [ends_of_law(own.law, order)[0 if after else 1] / (own.end - own.begin)**order for order in (1, 2)]
        if own.start is not None and own.to is not None:
            return tuple(factor * (own.to - own.start) for factor in factors)
        moved = self.moved_between(neighbour, neighbour + 1)
        return tuple({key: factor * w for key, w in moved.items()} if factor else Fraction(0) for factor in factors)

    def turns_back(self, segments, i, following):
        """Two splines that reverse the motion, neither of which may pass the joint between them."""
        if not self.motion.get("within_lift", True) and not self.motion.get("monotone", False):
            return False
        if following == 0 and not self.wraps:
            return False
        if not self.moved(i) * self.moved(following) < 0:
            return False
        passing = {j for j in (i, following) for point in segments[j].get("via", []) if any(k.startswith("displacement") for k in point)}
        if any(self.stretches[j].free for j in passing):
            return False
        upper, levels = self.moved(i) > 0, {i: self.stretches[i].to, following: self.stretches[following].start}
        return not any(self.leads_beyond(segments[j].get("via", []), self.stretches[j], levels[j], upper) for j in passing)

    def rests_between(self, segments, i, following):
        """Strokes of one direction with the velocity 0 where they join: each keeps to its side of the joint."""
        joint = segments[i].get("end", {})
        if (following == 0 and not self.wraps) or \
                (not self.motion.get("within_lift", True) and not self.motion.get("monotone", False)):
            return False
        if self.stretches[i].free or self.stretches[following].free or not self.moved(i) * self.moved(following) > 0:
            return False
        velocity = self.derivative_in_unit(joint, "velocity", self.stretches[i].end - self.stretches[i].begin) if joint else None
        if velocity != 0 or any(key.startswith("acceleration") for key in joint):
            return False
        rises = self.moved(i) > 0
        return not any(self.leads_beyond(segments[j].get("via", []), self.stretches[j], level, upper)
                       for j, level, upper in ((i, self.stretches[i].to, rises), (following, self.stretches[following].start, not rises)))

    def leads_beyond(self, via, stretch, level, upper):
        """Whether set points of a stroke lead beyond its upper or its lower end."""
        sign, width = 1 if upper else -1, stretch.end - stretch.begin
        for point in via:
            y, slope = self.in_lifts(point, "displacement"), self.derivative_in_unit(point, "velocity", width) or Fraction(0)
            if y is None:
                continue
            begin, end = (self.place(point, key, stretch.begin, width) for key in ("from", "to"))
            last = y if begin is None else y + slope * (end - begin)
            moves = abs(slope) > STATED or any(key.startswith("acceleration") for key in point)
            if max(sign * y, sign * last) > sign * level + (-STATED if moves else STATED):
                return True
        return False

    def moved(self, i):
        """By a stroke; of a free one 1 or -1 in the direction of the case, 0: not known."""
        own = self.stretches[i]
        return {True: 1, False: -1, None: 0}[self.rises.get(i)] if own.free else own.to - own.start

    def folded(self, x, side):
        """The place in the part of the turn that is repeated."""
        end = self.stretches[-1].end
        while self.copies > 1 and (x > end + SAME_PLACE or (side == "right" and x >= end - SAME_PLACE)) and \
                x <= self.copies * end + SAME_PLACE:
            x -= end
        return x

    def place_of(self, origin):
        """(x, the side) of a row. Nothing of the motion follows its end: a row there is one of what leads to it."""
        at_end = abs(origin.at - self.copies * self.stretches[-1].end) <= SAME_PLACE
        return origin.at, "left" if at_end else origin.side or "right"

    # -- breakpoints and set points

    def breakpoints(self, begin, end, regions):
        if self.free_breakpoints:
            if self.breakpoints_found is None:
                raise Unverified("free breakpoints without a motion")
            if self.type != "program":
                return self.breakpoints_found
        width = end - begin
        given = self.breakpoints_found if self.free_breakpoints else self.spline.get("breakpoints")
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

    def place(self, table, key, begin, width):
        """x of a place in a stretch; a normalised one is in parts of its width (DRD, RR: of the rise)."""
        if key in table:
            return begin + number(table[key]) * width
        angle = angle_of(table, key)
        return None if angle is None else begin + ratio(angle, self.unit_angle)

    def regions(self, via, begin, width):
        return [(self.place(p, "from", begin, width), self.place(p, "to", begin, width)) for p in via
                if self.place(p, "from", begin, width) is not None]

    def set_points(self, run, via, stretch, width):
        begin, end = run.begin_of(stretch), run.begin_of(stretch) + stretch.end - stretch.begin
        for point in via:
            at = self.place(point, "at", begin, width)
            region = at is None
            if region:
                at, until = (self.place(point, key, begin, width) for key in ("from", "to"))
            side = "right" if at < end else "left"
            displacement = self.in_lifts(point, "displacement")
            if displacement is not None:
                run.demand(at, 0, side, displacement + run.level(stretch), "via")
            velocity, acceleration = (self.derivative_in_unit(point, name, width) for name in ("velocity", "acceleration"))
            if acceleration is not None:
                run.demand(at, 2, side, acceleration, "via")
            if velocity is None:
                continue
            run.demand(at, 1, side, velocity, "via")
            if region:  # a straight line: every higher derivative of its pieces vanishes
                first, last = (run.space.segment_of(x, side)[0] for x, side in ((at, "right"), (until, "left")))
                for x in run.space.breakpoints[first:last + 1]:
                    for order in range(2, self.degree + 1):
                        run.demand(x, order, "right", Fraction(0), "via")

    # -- objective and limits

    def terms_of(self, references):
        terms = []
        for name, order in ORDERS.items():
            weight = number(self.objective.get(name, 0))
            key, cap = self.derivative_of(self.limits, name)
            cap = None if key is None or isinstance(self.limits[key], dict) else number(self.limits[key]) * cap
            error = Tolerances(self, self.scene).motion[order] if cap is not None and order < 3 else Fraction(0)
            if error and self.type == "program" and key == name:
                cap = None  # a bound on every stretch (made_caps)
            if cap is not None and (error or (self.type == "program" and key != name)):
                cap -= error
                whole = Fraction(0), self.stretches[-1].end * self.copies
                self.bounds += [MotionBound("limits." + key, order, sign, sign * cap, *whole, scale=cap) for sign in (1, -1)]
                cap = None
            if weight or cap is not None:
                terms.append(Peak("peak", order, weight, references[name], cap))
        for name in ("rms_acceleration", "rms_jerk"):
            weight = number(self.objective.get(name, 0))
            if weight:
                terms.append(Peak("rms", ORDERS[name[4:]], weight, references[name]))
        if number(self.objective.get("area", 0)):
            terms.append(Peak("area", 0, number(self.objective["area"]), area_reference(self)))
        if number(self.objective.get("torque", 0)):
            terms.append(Peak("torque", 2, number(self.objective["torque"]), references["torque"]))
        return terms + deviation_terms(self)

    def rms_weight(self, stretch, order):
        return 1 / stretch.scale(order)**2

    def stretch_at(self, x, side):
        """The stretch at a place of the part of the turn that is repeated, as seen from a side; None: outside the motion."""
        for stretch in self.stretches:
            inner = stretch.begin < x < stretch.end and min(x - stretch.begin, stretch.end - x) > SAME_PLACE
            if inner or (abs(x - stretch.begin) <= SAME_PLACE and side == "right") or \
                    (abs(x - stretch.end) <= SAME_PLACE and side == "left"):
                return stretch
        # The end of the motion has one side: a stretch of the cam angle that ends there is seen from within.
        return self.stretches[-1] if side == "right" and abs(x - self.stretches[-1].end) <= SAME_PLACE else None
