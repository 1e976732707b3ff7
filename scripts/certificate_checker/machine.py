# SPDX-License-Identifier: MIT
"""A machine: several axes on one master, with clearances between them.

Theorem. At a speed that is said to be impossible, multipliers of rows of all axes and clearances together are a contradiction (Farkas), and where
limits only tighten with speed (`only_tightens`) there is no motion above it. The delivered motions satisfy their own limits (each axis is
judged as a scene) and every clearance at every master angle, to within KEPT. If no speed is left to gain, no motions have less in total
than the bound of all axes together.
"""
import json
import tomllib

from . import enclosures
from .bound import Bound
from .cam import Cam
from .conditions import Conditions
from .drive import Drive
from .enclosures import ends_of
from .exact import KEPT, Refuted, SAME_PLACE, STATED, Unverified, add_to, combination, largest, number, require_every_row, shifted, value_at
from .known import name_unknown_of_machine, name_what_is_unknown
from .laws import constant, parts_along, polynomial_of
from .motion import Curve, close_points_named
from .origins import Origin, read_certificate
from .prescribed import state_at
from .problem import Problem
from .rational import Fraction, parsed
from .references import references_of
from .units import LENGTHS, angle_of, in_known_units, in_unit
from .valve import as_program

TURN = Fraction(360)
SAME_TURN = Fraction(1, 10**7)  # deg
IN_TIME = "_s", "_s2", "_s3"
OF_FORCES = "contact_force", "torque_max", "hertz_pressure", "residual", "dynamic_"


class Axis:
    """One axis of the machine at a speed: its problem, and where it is at a master angle (degrees)."""

    def __init__(self, folder, written, speed, result=None):
        """`result`: with its objective, whose references it states."""
        self.name = written["name"]
        self.scene = as_program(tomllib.loads((folder / f"{self.name}.toml").read_text(), parse_float=parsed))
        name_what_is_unknown(self.scene)
        self.scene = in_known_units(self.scene)
        motion = {k: v for k, v in self.scene["motion"].items() if not k.startswith("speed_")}
        if speed is not None:
            motion["speed_rpm"] = speed
        else:  # as the speed approaches 0 nothing that counts in time is left
            self.scene["limits"] = {k: v for k, v in self.scene.get("limits", {}).items()
                                    if not k.endswith(IN_TIME) and not k.startswith(("motor_speed", *OF_FORCES))}
        self.scene["motion"] = motion
        if result is None:
            self.scene["objective"] = {}
        self.phase = in_unit(angle_of(written, "phase") or (Fraction(0), "deg"), "deg")
        self.problem = Problem(self.scene, references_of(self.scene, result["reference"] if result else {}))
        if "cam" in self.scene:
            self.problem.cam = Cam(self.problem, self.scene, result or {})
        if "drive" in self.scene:
            self.problem.drive = Drive(self.problem, result or {}, speed is None)
            self.problem.terms += self.problem.drive.terms
        self.unit_angle = in_unit(self.problem.unit_angle, "deg")

    def only_tightens(self):
        """Whether a motion at a speed is one at any lower speed: it has to be where limits in time allow rest, and torque without viscous
        friction lies between that at the speed and that at rest."""
        limits, drive = self.problem.limits, self.problem.drive
        segments = self.problem.motion["segments"]
        tables = [t for s in segments for t in (*s.get("via", []), s.get("end", {}))] + self.problem.motion.get("corridor", [])
        sided = [v for k, v in limits.items() if k.endswith(IN_TIME) and isinstance(v, dict)]
        if any(k.endswith(IN_TIME) for t in tables for k in t) or any(v.get("min", 0) > 0 or v.get("max", 0) < 0 for v in sided):
            return False
        if any(k.startswith(("motor_curve", *OF_FORCES)) for k in limits):
            return False
        return not any(k.startswith("motor_torque") for k in limits) or \
            (not drive.quantity("viscous") and drive.returns_to_its_speed())

    def place(self, angle):
        """x of the axis at a master angle."""
        x = (angle - self.phase) % TURN / self.unit_angle
        end = self.problem.stretches[-1].end * self.problem.copies  # angles as written add up to nearly a turn
        return x if x < end * (1 - SAME_PLACE) else Fraction(0)

    @property
    def advance(self):
        """y gained in every cycle."""
        if self.problem.motion.get("closed") != "relative":
            return Fraction(0)
        return self.problem.stretches[-1].to * self.problem.copies

    def advanced(self, angle):
        """y gained before the axis begins its motion in the cycle of that master angle: it counts from the cycle's start, and falls back at
        360 deg."""
        master = min(angle, TURN) if angle <= TURN + SAME_TURN else angle - TURN
        return self.advance * ((master - self.phase % TURN) // TURN)

    def lift(self, unit):
        """In the unit of a clearance."""
        size, kind = self.problem.lift
        if kind == "m" and unit in LENGTHS:
            return size / LENGTHS[unit]
        if kind != "m" and unit in ("deg", "rad"):
            return in_unit(self.problem.lift, unit)
        raise Refuted(f"a clearance in {unit} of {self.name}")

    def breaks(self):
        """Master angles where its formula changes."""
        for stretch in self.problem.stretches:
            points = [stretch.begin]
            if stretch.kind == "law":
                points += [stretch.begin + begin * (stretch.end - stretch.begin) for begin, _, _ in parts_along(stretch, 1)]
            for run in self.problem.runs:
                if stretch in run.stretches:
                    by = run.begin_of(stretch) - stretch.begin
                    points += [x - by for x in run.space.breakpoints if stretch.begin <= x - by <= stretch.end]
            for copy in range(self.problem.copies):
                by = copy * self.problem.stretches[-1].end
                yield from ((self.phase + (x + by) * self.unit_angle) % TURN for x in points)


class Clearance:
    def __init__(self, index, written, axes):
        self.name = f"clearance[{index}]"
        key = next(k for k in written if k.startswith("at_least_"))
        self.unit, self.at_least = key[len("at_least_"):], number(written[key])
        self.axes = [next(a for a in axes if a.name == name) for name in written["between"]]
        self.factors = [number(f) for f in written.get("factors", [1] * len(self.axes))]
        self.begin, end = (in_unit(angle_of(written, key) or (whole, "deg"), "deg") for key, whole in (("from", 0 * TURN), ("to", TURN)))
        self.length = end - self.begin if end > self.begin else end - self.begin + TURN
        self.scale = Fraction(0)
        for axis, factor in zip(self.axes, self.factors):
            levels = [Fraction(0)] + [s.to for s in axis.problem.stretches]
            lift = axis.lift(self.unit)
            self.scale += abs(factor) * lift * max(max(levels) - min(levels), Fraction(1, 1000))

    def holds_at(self, angle):
        """The angle, moved into the stretch by no more than rounding."""
        along = angle - self.begin if 0 <= angle - self.begin <= self.length else (angle - self.begin) % TURN
        if along > TURN - Fraction(1, 10**6):
            along = Fraction(0)
        if along > self.length + Fraction(1, 10**6):
            raise Refuted(f"{self.name} does not hold at {float(angle)} deg")
        return self.begin + min(along, self.length)

    def use(self, bounds, angle, multiplier):
        """at_least - sum of factor * lift * y <= 0, times the multiplier over the scale."""
        if multiplier < 0:
            raise Refuted(f"{self.name}: a multiplier below 0 of a row that has no lower side")
        angle, multiplier = self.holds_at(angle), multiplier / self.scale
        least = multiplier * self.at_least
        for axis, factor in zip(self.axes, self.factors):
            bound, x = bounds[axis.name], axis.place(angle)
            size = -multiplier * factor * axis.lift(self.unit)
            least += size * axis.advanced(angle)
            k, run, stretch = bound.run_at(x, "right")
            if run is None:
                state, _ = state_at(axis.problem, x, "right")
                least += min(size * y for y in ends_of(state[0]))
                continue
            least -= size * run.level(stretch)
            add_to(bound.functions[k], run.space.functional(axis.problem.folded(x, "right"), 0), size)
        return least

    def check(self, curves):
        """The largest of at_least - sum over the stretch is within what camopt promises of 0."""
        points = {Fraction(0), self.length}
        for axis in self.axes:
            breaks = (*axis.breaks(), Fraction(0)) if axis.advance else axis.breaks()
            points |= {p for p in ((b - self.begin) % TURN for b in breaks) if p < self.length}
        points = sorted(points)
        for left, right in zip(points, points[1:]):
            total, formulas = [self.at_least], []
            for axis, factor in zip(self.axes, self.factors):
                own, size = y_along(axis, curves[axis.name], self.begin + left, right - left), -factor * axis.lift(self.unit)
                total = combination((1, total), (size, [axis.advanced(self.begin + (left + right) / 2)]))
                if callable(own):
                    formulas.append((size, own))
                else:
                    total = combination((1, total), (size, own))
            if not stays_below(total, formulas, KEPT * self.scale):
                raise Refuted(f"{self.name} is violated between {float(self.begin + left)} and {float(self.begin + right)} deg")


def y_along(axis, curve, angle, width):
    """y of an axis by u in [0, 1] over the master angles from `angle` on, between breakpoints: a polynomial, or of most laws a formula."""
    problem, wide = axis.problem, width / axis.unit_angle
    middle = problem.folded(axis.place(angle + width / 2), "right")
    stretch = problem.stretch_at(middle, "right")
    for run, pieces in zip(problem.runs, curve.pieces):
        if stretch not in run.stretches:
            continue
        i, at = run.space.segment_of(middle + run.begin_of(stretch) - stretch.begin, "right")
        piece, _, left, _ = pieces[i]
        moved = shifted(piece, at - wide / 2 - left)
        return [c * wide**m for m, c in enumerate(moved)]
    if stretch.kind != "law":
        return [stretch.start]
    at, wide = ((own / (stretch.end - stretch.begin)) for own in (middle - stretch.begin, wide))
    if polynomial_of(stretch.law) is not None:
        rise = stretch.to - stretch.start
        moved = shifted(polynomial_of(stretch.law), at - wide / 2)
        return combination((1, [stretch.start]), (rise, [c * wide**m for m, c in enumerate(moved)]))
    parts = parts_along(stretch, 1)
    begin, _, motion = next((part for part in parts if at < part[1]), parts[-1])
    return lambda u: motion((at - wide / 2 - begin) + wide * u)[0]


def stays_below(polynomial, formulas, most):
    """Whether a polynomial of u in [0, 1] and formulas of it, each with its factor, are nowhere above `most` together."""
    if formulas:
        def room(numbers):
            own = [size * formula(numbers[0]) for size, formula in formulas]
            return most - sum(own, value_at([constant(c) for c in polynomial], numbers[0]))
        return enclosures.least(room, [enclosures.interval(Fraction(0), Fraction(1))], 0) is not None
    return largest([(polynomial, Fraction(1))])[1] <= most


def add_rows(bounds, clearances, rows):
    """The constant that clearances leave."""
    left = Fraction(0)
    for row in rows:
        origin = Origin.of(row["origin"])
        clearance = next((c for c in clearances if c.name == origin.key), None)
        if clearance:
            left += clearance.use(bounds, in_unit((origin.at, "rad"), "deg"), number(row["multiplier"]))
        elif origin.axis in bounds:
            bounds[origin.axis].add_row(row)
        else:
            raise Refuted(f"the machine has no rule {origin}")
    return left


def judge_least_objective(axes, clearances, curves, certificate, report):
    """The bound of the total objective; returns what is not verified."""
    proof, stated = certificate["proof"], certificate["lower_bound"]
    if proof is None or stated is None or proof["statement"] != "objective" or number(proof["limits_relaxed_by"]):
        return ["the least total objective"]
    reached = sum(curve.objective()[1] for curve in curves.values())
    bounds = {axis.name: Bound(axis.problem, reached, Fraction(0), curves[axis.name]) for axis in axes}
    value = add_rows(bounds, clearances, proof["rows"])
    for axis in axes:
        if not axis.problem.runs:  # prescribed: its objective is a number
            value += curves[axis.name].objective()[0]
            continue
        value += bounds[axis.name].least_objective()
    report.say(f"bound: no motions of the machine have less in total than {float(value):.12g}; reached: {float(reached):.12g}")
    allowed = min(axis.problem.gap for axis in axes) * max(Fraction(1), abs(reached))
    if number(stated) - value > allowed / 10 or reached - value > allowed:
        return [f"the last digits of the bound {stated}: {float(value):.12g} is proved"]
    return []


def judge_impossible(axes, clearances, proof, report):
    """Farkas, over all axes together."""
    for axis in axes:
        for run in axis.problem.runs:
            if Conditions(run.conditions).contradiction:
                report.say(f"{axis.name}: conditions contradict each other: no spline of the space meets them")
                return
    if proof is None or proof["statement"] != "least_common_violation":
        raise Refuted("there is no stored proof of impossibility")
    bounds = {axis.name: Bound(axis.problem, None, Fraction(0)) for axis in axes}
    value = add_rows(bounds, clearances, proof["rows"]) + sum(bound.value(cost=False) for bound in bounds.values())
    report.say(f"Farkas: the multipliers of {len(proof['rows'])} rows give 0 >= {float(value):.9g}, "
               f"rounding {float(sum(b.residual for b in bounds.values())):.1e}")
    if value > 0:
        return
    require_every_row({rule for bound in bounds.values() for rule in bound.left_out})
    raise Refuted("the multipliers do not prove that there are no motions")


def judge_machine(folder, report, outcome_of):
    """`outcome_of`: of the result folder of one axis."""
    machine = tomllib.loads((folder / "machine.toml").read_text(), parse_float=parsed)
    result = json.loads((folder / "machine.json").read_text(), parse_float=parsed)
    certificate = read_certificate(folder / "certificate.json")
    name_unknown_of_machine(machine)
    verdict, impossible, (least, most) = result["verdict"], result["impossible_above_rpm"], speeds_of(machine)
    claims = [verdict, f"{len(machine['axis'])} axes"]
    claims += [f"motions at {float(result['speed_rpm']):.9g} rpm"] if result["speed_rpm"] is not None else []
    claims += [f"none at {float(impossible):.9g} rpm"] if impossible is not None else []
    if verdict == "infeasible":
        own = f"{float(least):.9g} rpm" + (" or above" if least < most else "")
        claims.append("none at " + ("any speed" if result["at_standstill"] else own))
    report.say("claimed: " + ", ".join(claims))
    if verdict != certificate["verdict"] and not (verdict == "optimal" and impossible is not None):
        raise Refuted("certificate.json and machine.json disagree")

    def at(speed):
        axes = [Axis(folder, written, speed) for written in machine["axis"]]
        return axes, [Clearance(i, written, axes) for i, written in enumerate(machine.get("clearance", []))]

    def not_above(axes):
        """What is not verified of all speeds above one that is impossible."""
        return [f"the speeds above: limits of {a.name} do not only tighten with speed" for a in axes if not a.only_tightens()]

    if verdict == "infeasible":
        axes, clearances = at(None if result["at_standstill"] else least)
        judge_impossible(axes, clearances, certificate["proof"], report)
        return [] if result["at_standstill"] or least == most else not_above(axes)
    if not result["axes"]:
        raise Unverified("nothing: no motions are delivered")
    missing = []
    if not least * (1 - STATED) <= number(result["speed_rpm"]) <= most * (1 + STATED):
        raise Refuted("motions are delivered at a speed outside the machine's range")
    if verdict == "optimal" and least < most and impossible is None and number(result["speed_rpm"]) < most * (1 - STATED):
        raise Refuted("nothing proves that the speed is the largest")
    if impossible is not None:
        if number(impossible) <= number(result["speed_rpm"]):
            raise Refuted("motions are delivered at a speed that is said to be impossible")
        proof = read_certificate(folder / "impossible.json")["proof"]
        axes, clearances = at(number(impossible))
        judge_impossible(axes, clearances, proof, report)
        missing += not_above(axes) if verdict == "optimal" else []
    for written in machine["axis"]:
        code, text = outcome_of(folder / written["name"])
        report.say(f"{written['name']}: {text}")
        if code == 1:
            raise Refuted(f"{written['name']}: {text}")
        missing += [f"{written['name']}: {text}"] * (code == 2)
    axes, clearances = at(number(result["speed_rpm"]))
    curves = {}
    for axis in axes:
        own = tomllib.loads((folder / axis.name / "scene.toml").read_text(), parse_float=parsed)
        if own != tomllib.loads((folder / f"{axis.name}.toml").read_text(), parse_float=parsed):
            raise Refuted(f"{axis.name}: its result is of another scene")
        if abs(own["motion"]["speed_rpm"] / number(result["speed_rpm"]) - 1) > STATED:
            raise Refuted(f"{axis.name}: its result is of another speed")
        with close_points_named(axis.problem):
            curves[axis.name] = Curve(axis.problem, result_of(folder, {"name": axis.name}))
    for clearance in clearances:
        clearance.check(curves)
    if clearances:
        report.say("clearances kept: " + ", ".join(c.name for c in clearances))
    if impossible is None and not result["reached_most"]:
        axes = [Axis(folder, written, number(result["speed_rpm"]), result_of(folder, written)) for written in machine["axis"]]
        clearances = [Clearance(i, written, axes) for i, written in enumerate(machine.get("clearance", []))]
        curves = {axis.name: Curve(axis.problem, result_of(folder, {"name": axis.name})) for axis in axes}
        missing += judge_least_objective(axes, clearances, curves, certificate, report)
    return missing


def result_of(folder, written):
    return json.loads((folder / written["name"] / "result.json").read_text())


def speeds_of(machine):
    """(the least speed, the largest), rpm."""
    key, = machine["machine"]
    speed, unit = machine["machine"][key], {"speed_rpm": Fraction(1), "speed_rad_s": in_unit((Fraction(1, 6), "rad"), "deg")}[key]
    return [number(speed[end] if isinstance(speed, dict) else speed) * unit for end in ("min", "max")]
