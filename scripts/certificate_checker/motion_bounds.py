# SPDX-License-Identifier: MIT
"""Linear rules on the motion itself: limits of one side, corridors, and the lost area.

Theorem. Every motion of the scene satisfies sign * y^(order) <= most of each `MotionBound` from `begin` to `end`; the delivered motion does so at
every x to within KEPT (`keep_bounds`). The lost area, 1 - the mean displacement in lifts, is affine in the control points (`lost_area`).
"""

import itertools

from . import enclosures
from .exact import KEPT, ORDERS, Refuted, Unverified, add_to, derivative, integral, largest, number, shifted
from .laws import jumps, mean_of, parts_along, turns_back
from .rational import Fraction
from .tolerance import Tolerances

TYPICAL = (1, 2, 6, 60)  # of y ... y''' over one lift: what a bound near 0 is measured by
SIDES = {"min": -1, "max": 1}


class MotionBound:
    """sign * y^(order) <= most from `begin` to `end`; of a stretch alone where one is given. Exceeding it by `scale` is a
    violation of 100 %."""

    of_cam = False  # of the motion of the cam, where that of the output is prescribed

    def __init__(self, key, order, sign, most, begin, end, stretch=None, scale=None):
        self.key, self.order, self.sign, self.most, self.begin, self.end = key, order, sign, sign * most, begin, end
        self.stretch = stretch
        self.scale = scale or max(abs(most), TYPICAL[order] * (stretch.scale(order) if stretch else 1))

    def is_meant(self, rule, order, sign, stretch):
        return (rule, order, sign) == (self.key, self.order, self.sign) and self.stretch in (None, stretch)


def motion_bounds(problem):
    """Of a scene: normalised limits of a program hold for each spline (of a prescribed motion each law)."""
    whole = Fraction(0), problem.stretches[-1].end * problem.copies
    kind = "spline" if problem.runs else "law"
    all_bounds = []
    for name, order in [*ORDERS.items(), *((f"cam_{name}", order) for name, order in ORDERS.items())]:
        key, unit = problem.derivative_of(problem.limits, name)
        of_cam = name.startswith("cam_")
        if key is None or not (of_cam or isinstance(problem.limits[key], dict)):
            continue
        limit = problem.limits[key]
        own = [None]
        if problem.type == "program" and key == name:
            own = [s for s in problem.stretches if s.kind == kind]
        sides = limit.items() if isinstance(limit, dict) else (("min", -number(limit)), ("max", limit))
        for side, value in sides:
            for stretch in own:
                most = number(value) * (stretch.scale(order) if stretch else unit)
                named = f"limits.{key}.{side}" if isinstance(limit, dict) else f"limits.{key}"
                all_bounds.append(MotionBound(named, order, SIDES[side], most, *whole, stretch))
                all_bounds[-1].of_cam = of_cam
    for i, corridor in enumerate(problem.motion.get("corridor", [])):
        begin = problem.place(corridor, "from", Fraction(0), Fraction(1)) or Fraction(0)
        end = problem.place(corridor, "to", Fraction(0), Fraction(1)) or whole[1]
        for order, name in enumerate(("displacement", *ORDERS)):
            key, unit = problem.derivative_of(corridor, name) if order else problem.lifts_of(corridor, name)
            for side, value in corridor[key].items() if key else ():
                all_bounds.append(MotionBound(f"motion.corridor[{i}].{key}.{side}", order, SIDES[side], number(value) * unit,
                                              begin, min(end, whole[1])))
    errors = [*Tolerances(problem, problem.scene).motion, Fraction(0)]
    for bound in all_bounds:
        bound.most -= errors[bound.order]
    return all_bounds + made_caps(problem, errors, whole, kind)


def made_caps(problem, errors, whole, kind):
    """Normalised limits of a program with tolerances: a made cam is off by as much on every stretch."""
    found = []
    for name, order in ORDERS.items():
        key = problem.derivative_of(problem.limits, name)[0]
        if problem.type != "program" or key != name or isinstance(problem.limits[key], dict) or not errors[order]:
            continue
        for stretch, sign in itertools.product([s for s in problem.stretches if s.kind == kind], (1, -1)):
            most = number(problem.limits[key]) * stretch.scale(order)
            bound = MotionBound(f"limits.{key}", order, sign, sign * most, *whole, stretch)
            bound.most -= errors[order]
            bound.scale = bound.most if bound.most > 0 else most
            found.append(bound)
    return found


def keep_bounds(problem, curve, relaxed):
    """Names of the bounds that the delivered motion keeps at every place, ends included."""
    for bound in problem.bounds:
        room = bound.scale * (KEPT + relaxed)
        for copy in range(problem.copies):
            by = copy * problem.stretches[-1].end
            if largest(along_splines(curve, bound, by))[1] > bound.most + room:
                raise Refuted(f"{bound.key}: the motion passes it")
            for stretch in problem.stretches:
                ends = max(bound.begin, stretch.begin + by) - by, min(bound.end, stretch.end + by) - by
                if stretch.kind != "spline" and bound.stretch in (None, stretch) and ends[0] <= ends[1] and \
                        not keeps(stretch, bound.order, bound.sign, bound.most + room, *ends):
                    raise Refuted(f"{bound.key} is passed along a law or in a dwell")
    return sorted({bound.key for bound in problem.bounds})


def along_splines(curve, bound, by):
    """sign * y^(order) - most where the bound holds, on a copy of the turn's part."""
    pieces = [([-abs(bound.most) - 1 + bound.most], Fraction(1))]  # one that is kept
    for run, own in zip(curve.problem.runs, curve.cam_pieces() if bound.of_cam else curve.pieces):
        for p, width, left, stretch in own:
            x = left - run.begin_of(stretch) + stretch.begin + by
            begin, end = max(bound.begin, x), min(bound.end, x + width)
            if begin > end or (begin == end and bound.begin < bound.end) or bound.stretch not in (None, stretch):
                continue
            rule = [bound.sign * c for c in derivative(shifted(p, begin - x), bound.order)]
            if not bound.order:
                rule[0] -= bound.sign * run.level(stretch)
            pieces.append((rule, end - begin))
    return pieces


def keeps(stretch, order, sign, most, begin, end):
    """Whether sign * y^(order) <= most along a dwell or a law from `begin` to `end`."""
    if order == 3 and stretch.kind == "law" and (jumps(stretch.law) or turns_back(stretch.law) and not stretch.smooth_top):
        raise Unverified(f"the jerk of the law {stretch.law}")
    length = stretch.end - stretch.begin
    for at, until, motion in parts_along(stretch, order + 1):
        low, high = max((begin - stretch.begin) / length, at), min((end - stretch.begin) / length, until)
        if low <= high:
            def room(numbers, motion=motion):
                return most - sign * motion(numbers[0])[order]
            if enclosures.least(room, [enclosures.interval(low - at, high - at)], 0) is None:
                return False
    return True


# -- the lost area: 1 - the mean displacement in lifts

def lost_area(problem):
    """(constant, a function of the control points of each run): the lost area is their sum."""
    length = problem.stretches[-1].end
    total, functions, free = Fraction(0), [], {}
    for i, stretch in enumerate(problem.stretches):
        if stretch.kind == "spline":
            continue
        mean = mean_of(stretch.law) if stretch.kind == "law" else Fraction(0)
        if stretch.free:
            for level, share in ((problem.level_at(i), 1 - mean), (problem.level_at(i + 1), mean)):
                add_to(free, level, share * (stretch.end - stretch.begin))
        else:
            total += (stretch.end - stretch.begin) * (stretch.start + mean * (stretch.to - stretch.start))
    total += free.pop(None, Fraction(0))
    for run in problem.runs:
        total -= sum(((s.end - s.begin) * run.level(s) for s in run.stretches), Fraction(0))
        function = {}
        for i in range(run.space.segments):
            for j, basis in enumerate(run.space.basis(i), run.space.first(i)):
                add_to(function, {j: integral(basis, run.space.width(i))}, -1 / length)
        functions.append(function)
    if free:
        add_to(functions[0], free, -1 / length)
    return 1 - total / length, functions


def area_reference(problem):
    """The scene's number, or the lost area of the reference law on the strokes of the scene, its mirror image where they fall."""
    asked = problem.objective.get("reference", "modified_sine")
    if isinstance(asked, dict):
        if "area" not in asked:
            raise Unverified("objective.reference without area")
        return number(asked["area"])
    mean = mean_of(asked)
    if problem.type != "program":
        return 1 - mean
    area = Fraction(0)
    for s in problem.stretches_of_reference():
        own = mean_of(s.law) if s.kind == "law" else mean if s.to >= s.start else 1 - mean
        area += (s.end - s.begin) * (s.start + (s.to - s.start) * own)
    return 1 - area / problem.stretches[-1].end
