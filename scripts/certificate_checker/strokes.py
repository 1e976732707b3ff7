# SPDX-License-Identifier: MIT
"""What a stroke may pass: motion.within_lift and motion.monotone.

Theorem. `stroke_of` gives the range least <= y <= most that the scene demands of a stroke, None where set points or what is beside it open it;
`turning_points` and `points_at_limits` are conditions that every motion of the scene satisfies.
"""

from .exact import ORDERS, STATED, number
from .rational import Fraction

SLOW = STATED  # lifts by x: what passes a place no faster does not leave the range there


class Stroke:
    """From `start` to `to` between `begin` and `end`; `least` and `most` are what it keeps between, None where it may leave. It is
    measured by its displacement, one that is free by the lift."""

    def __init__(self, begin, end, start, to, free=False):
        self.begin, self.end, self.start, self.to = begin, end, start, to
        self.least, self.most = (None, None) if None in (start, to) else (min(start, to), max(start, to))
        self.moved = Fraction(1) if free else abs(to - start)
        self.rests = [2, 2]  # derivatives up to these orders are 0 at its ends, where it rests

    def near(self, at, order, ends=(True, True)):
        """What a row of y^(order) is divided by: the powers that it leaves its ends with, of those of its ends that it touches."""
        along, unit, near = (at - self.begin) / (self.end - self.begin), sum(ends), Fraction(1)
        for touches, distance, rest in zip(ends, (along, 1 - along), self.rests):
            if touches:
                near *= (unit * distance)**(rest + 1 - order)
        return near


def stroke_of(problem, stretch, at):
    """The stroke at x; None where none is kept to."""
    if problem.type != "program":
        rises = at <= 1
        found = Stroke(Fraction(0), Fraction(1), Fraction(0), Fraction(1)) if rises else \
            Stroke(Fraction(1), stretch.end, Fraction(1), Fraction(0))
        slopes = [problem.runs[0].states[0][0] if rises else Fraction(0),
                  problem.runs[0].states[1][0] if problem.type == "DRD" or not rises else Fraction(0)]
        if rises:
            found.rests[0] = problem.rest_order()
        if problem.type == "DRD" or not rises:
            found.rests[1] = problem.rest_order()
        via, width, begin = problem.motion.get("via", []), Fraction(1), Fraction(0)
    else:
        i = problem.stretches.index(stretch)
        found = Stroke(stretch.begin, stretch.end, stretch.start, stretch.to, stretch.free)
        slopes = [slope_beside(problem, i - 1, 0), slope_beside(problem, i + 1, 1)]
        found.rests = [problem.rest_order() if problem.is_rest(problem.motion["segments"], j) else 2 for j in (i - 1, i + 1)]
        via, width, begin = problem.motion["segments"][i].get("via", []), stretch.end - stretch.begin, stretch.begin
    passed = [p for point in via for p in passed_points(problem, point, begin, width, found)]
    if stretch.free:
        return None if passed else found
    return found if set_range(found, passed, slopes) else None


def turning_points(problem, stretch, via, begin, width):
    """Places where y' = 0 follows from motion.within_lift: set points on the edge of the range; in a program beyond both ends."""
    if not problem.motion.get("within_lift", True) or stretch.free:
        return
    for point in via:
        at, y = problem.place(point, "at", begin, width), problem.in_lifts(point, "displacement")
        if at is None or y is None or any(key.startswith(("velocity", "acceleration")) for key in point):
            continue
        stroke = stroke_of(problem, stretch, at)
        if not stroke or not stroke.begin < at < stroke.end or y not in (stroke.least, stroke.most):
            continue
        ends = sorted((stroke.start, stroke.to))
        if problem.type != "program" or y < ends[0] - STATED or y > ends[1] + STATED:
            yield at


def points_at_limits(problem, stretch, via, begin, width):
    """[(x, order)]: derivatives that are 0 because the one before them has the value of a limit, or of the edge of a corridor that lies on
    both sides of the place."""
    for point in via:
        at = problem.place(point, "at", begin, width)
        if at is None or not stretch.begin + STATED < at < stretch.end - STATED:
            continue
        slope, bend = (problem.derivative_in_unit(point, name, width) for name in ("velocity", "acceleration"))
        values = [problem.in_lifts(point, "displacement"), slope, bend]
        for order in range(2):
            if values[order] is not None and values[order + 1] is None and \
                    any(abs(values[order] - edge) <= STATED * max(1, abs(edge)) for edge in edges(problem, stretch, order, at)):
                yield at, order + 1


def edges(problem, stretch, order, at):
    """What y^(order) is bounded by around a place."""
    name = ("displacement", *ORDERS)[order]
    key, unit = problem.derivative_of(problem.limits, name) if order else (None, None)
    if key is not None:
        size = stretch.scale(order) if problem.type == "program" and key == name else unit
        limit = problem.limits[key]
        yield from (number(limit[side]) * size for side in limit) if isinstance(limit, dict) else (sign * number(limit) * size for sign in (1, -1))
    for corridor in problem.motion.get("corridor", []):
        first, last = (problem.place(corridor, end, Fraction(0), Fraction(1)) for end in ("from", "to"))
        key, unit = problem.derivative_of(corridor, name) if order else problem.lifts_of(corridor, name)
        if key and (first or 0) < at and (last is None or at < last):
            yield from (number(bound) * unit for bound in corridor[key].values())
    if order == 1 and problem.motion.get("monotone", False):
        yield Fraction(0)


def slope_beside(problem, neighbour, after):
    if 0 <= neighbour < len(problem.stretches) or problem.wraps:
        beside = problem.stretches[neighbour % len(problem.stretches)]
        if beside.kind == "spline" or beside.free:
            return Fraction(0)
    return problem.state_beside(neighbour, after)[0]


def passed_points(problem, point, begin, width, stroke):
    """[(y, y', y'' or None)] that a set point of the stroke gives, a region at both of its ends."""
    y = problem.in_lifts(point, "displacement")
    at = problem.place(point, "at", begin, width)
    region = at is None
    first, last = (problem.place(point, key, begin, width) for key in ("from", "to")) if region else (at, at)
    if y is None or first < stroke.begin - STATED or last > stroke.end + STATED:
        return []
    slope = problem.derivative_in_unit(point, "velocity", width) or Fraction(0)
    own = [(y, slope, problem.derivative_in_unit(point, "acceleration", width))]
    return own + ([(y + slope * (last - first), slope, None)] if region else [])


def set_range(stroke, passed, slopes):
    """Whether there is a range: it opens where the motion passes its ends."""
    if abs(stroke.to - stroke.start) < STATED and not passed:
        return False
    least = min([stroke.least] + [y for y, _, _ in passed])
    most = max([stroke.most] + [y for y, _, _ in passed])
    opened = [(stroke.start, slopes[0] < -SLOW, slopes[0] > SLOW), (stroke.to, slopes[1] > SLOW, slopes[1] < -SLOW)]
    for y, slope, bend in passed:
        moves = abs(slope) > SLOW
        opened.append((y, moves or (bend is not None and bend <= SLOW), moves or (bend is not None and bend >= -SLOW)))
    below = any(down and y <= least + STATED for y, down, _ in opened)
    above = any(up and y >= most - STATED for y, _, up in opened)
    stroke.least, stroke.most = None if below else least, None if above else most
    return True


def farthest(problem, run, relaxed):
    """The largest |y| of a run whose strokes all keep to a range; None: some may leave it."""
    if not problem.motion.get("within_lift", True) and not problem.motion.get("monotone", False):
        return None
    ends = []
    for stretch in run.stretches:
        for at in (stretch.begin, stretch.end):
            stroke = stroke_of(problem, stretch, at)
            if stroke is not None and stretch.free:  # between its ends, whichever these are
                ends.append(problem.farthest_level * (1 + relaxed))
                continue
            if stroke is None or stroke.least is None or stroke.most is None:
                return None
            room = relaxed * (stroke.most - stroke.least)
            ends += [stroke.least - room + run.level(stretch), stroke.most + room + run.level(stretch)]
    return max(abs(end) for end in ends)
