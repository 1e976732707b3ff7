# SPDX-License-Identifier: MIT
"""The delivered motion.

Theorem. `Curve` is a spline of the scene's own space that satisfies all of its conditions exactly, and whose distance from the delivered
numbers is at most `distance` (y to y'''), relative to the peaks within STATED or JOINED. Its objective is enclosed, and its caps, bounds and
strokes are satisfied at every x, to within KEPT.
"""

import contextlib

from .conditions import IMPLIED, Conditions
from .exact import (
    JOINED, KEPT, Refuted, SAME_PLACE, STATED, Unverified, bernstein, combination, derivative, integral, largest,
    largest_magnitude, number, product, root, shifted, value_at)
from .motion_bounds import keep_bounds, lost_area
from .laws import is_same
from .prescribed import peak_of
from .rational import Fraction
from .spaces import cam_of, output_of
from .strokes import stroke_of


@contextlib.contextmanager
def close_points_named(problem):
    """What a motion through points that are very close together departs from is not refuted."""
    try:
        yield
    except Refuted as fault:
        if problem.has_close_points():
            raise Unverified(f"set points so close together that rounding is much of the slope between them: {fault}") from fault
        raise


class Curve:
    """An exact motion of the problem within rounding of the delivered one. pieces[r]: (polynomial, width, x,
    stretch)."""

    def __init__(self, problem, result):
        self.problem = problem
        curves = result["motion"]["curves"]
        count = sum(len(run.curves) for run in problem.runs)
        if len(curves) != count:
            raise Refuted(f"the motion has {len(curves)} splines, the scene {count}")
        self.pieces, self.control, self.distance = [], [], [Fraction(0)] * 4
        for run in problem.runs:
            self.add(run, [(curves[index], further) for index, further in run.curves])
        self.parts(result["motion"]["parts"])
        if not problem.runs:
            return
        peaks = [largest_magnitude([(derivative(p, r), w) for run in self.pieces for p, w, _, _ in run])[1]
                 for r in range(4)]
        self.relative = [d / max(p, Fraction(1, 10**6)) for d, p in zip(self.distance, peaks)]
        for order, allowed in enumerate([STATED, STATED * 100, JOINED, JOINED]):
            if allowed < self.relative[order] <= 10 * allowed and any(run.is_fine() for run in problem.runs):
                raise Unverified(f"a motion on segments so short that its doubles say it to {float(self.relative[order]):.1e} only "
                                 f"(of the peak of its derivative {order})")
            if self.relative[order] > allowed:
                raise Refuted(f"the motion meets its conditions and joins only to {float(self.relative[order]):.1e} of "
                              f"the peak of its derivative {order}, or is not of the scene's spline space")

    def add(self, run, curves):
        """Of curves one after another, each with by how much its x is less than the run's."""
        space, points, delivered = run.space, [], []
        for curve, further in curves:
            own = [number(x) + further for x in curve["breakpoints"]]
            if points and abs(own.pop(0) - points[-1]) > SAME_PLACE:
                raise Refuted("the motion's splines do not join")
            points += own
            for piece in curve["pieces"]:
                piece = [number(a) for a in piece]
                if self.problem.to_cam:
                    piece = output_of(piece, self.problem.to_cam)
                delivered.append([piece[0] + (run.raised if further else 0)] + piece[1:])
        continuity = space.continuity - (2 if self.problem.to_cam else 0)
        if any((curve["degree"], curve["continuity"]) != (space.degree, continuity) for curve, _ in curves) or \
                len(points) != len(space.breakpoints) or len(delivered) != space.segments or \
                any(abs(a - b) > SAME_PLACE for a, b in zip(points, space.breakpoints)) or \
                any(len(piece) != space.degree + 1 for piece in delivered):
            raise Refuted("the motion's breakpoints or degree are not those of the scene")
        conditions = Conditions(run.conditions)
        if conditions.contradiction:
            name, by = conditions.contradiction
            raise Unverified(f"conditions that contradict each other by {float(by):.1e} ({name})")
        if run.is_fine():
            control = self.from_the_top(run, points, delivered)
        else:
            control = conditions.completed(space.control_points(points, delivered))
        distance = self.distances(space, control, points, delivered)
        if distance[0] > STATED and run.is_fine():
            other = self.from_the_top(run, points, delivered, by_width=True)
            control, distance = min((control, distance), (other, self.distances(space, other, points, delivered)), key=lambda own: own[1][0])
        given = [row for row in run.conditions if row[2] not in IMPLIED]
        if distance[0] > STATED and len(given) < len(run.conditions):
            # What follows from inequalities alone is met as they are, to their tolerance: with y' = 0 a y'' of its cube root.
            control = Conditions(given).completed(space.control_points(points, delivered))
            distance = self.distances(space, control, points, delivered)
        self.distance = [max(pair) for pair in zip(self.distance, distance)]
        self.control.append(control)
        self.pieces.append([(piece, space.width(i), space.breakpoints[i], run.stretch_at(space.breakpoints[i]))
                            for i, piece in enumerate(space.pieces(control))])

    @staticmethod
    def distances(space, control, points, delivered):
        """By order: a bound of how far the spline of these control points is from the delivered one."""
        distance = [Fraction(0)] * 4
        for i, piece in enumerate(space.pieces(control)):
            width = space.width(i)
            moved = shifted(delivered[i], space.breakpoints[i] - points[i])
            for order in range(4):
                error = bernstein(derivative(combination((1, piece), (-1, moved)), order), width)
                distance[order] = max(distance[order], *map(abs, error))
        return distance

    @staticmethod
    def from_the_top(run, points, delivered, by_width=False):
        """Where some segments are far narrower than others, the last digit of y there is all of its third derivative.
        So the conditions are solved for control points of that derivative, which weigh little where segments are
        narrow; `by_width`: for those of narrow segments, which the motion tells least of, where y is known to the same everywhere."""
        space, top, own, pieces, errors = run.space, run.top(), run.space_of_top(), None, None
        if by_width:
            known, pieces = zip(*own.best_pieces(top))
            errors = [1 / space.width(0)**order for order in range(top)] + list(known)
        conditions = run.conditions_in_top(errors)
        values = [derivative(delivered[0], order)[0] for order in range(top)]
        values += own.control_points(points, [derivative(piece, top) for piece in delivered], pieces)
        values = conditions.completed(values)
        control = values[top:]
        for order in range(top, 0, -1):
            lower = [values[order - 1]]
            for d, step in zip(control, space.steps(order)):
                lower.append(lower[-1] + d * step)
            control = lower
        return control

    def parts(self, parts):
        """The chain that the file describes is that of the scene."""
        stretches, copies = self.problem.stretches, self.problem.copies
        if len(parts) != copies * len(stretches):
            raise Refuted("the motion does not have the scene's segments")
        for i, part in enumerate(parts):
            stretch, by = stretches[i % len(stretches)], i // len(stretches) * stretches[-1].end
            near = abs(number(part["begin"]) - stretch.begin - by) + abs(number(part["end"]) - stretch.end - by)
            if near > STATED or (part["curve"] is not None) != (stretch.kind == "spline"):
                raise Refuted("the motion's segments are not those of the scene")
            if stretch.kind == "spline":
                run = next(run for run in self.problem.runs if stretch in run.stretches)
                curve, further = run.curves[-1 if stretch in run.passed else 0]
                x0 = by + further - (run.begin_of(stretch) - stretch.begin)
                if part["curve"] != curve or abs(number(part["x0"]) - x0) > STATED or part["x_scale"] != 1 or part["y0"] or \
                        part["y_scale"] != 1:
                    raise Refuted("the motion's parts do not join its splines")
            else:
                law = stretch.law if stretch.kind == "law" else None
                rise, length = stretch.to - stretch.start, stretch.end - stretch.begin
                rest = self.problem.cam_at_rest(stretch.start)
                if not is_same(part["law"], law) or abs(number(part["y0"]) - rest) > STATED or \
                        (law and (abs(number(part["y_scale"]) - rise) > STATED or abs(number(part["x_scale"]) - length) > STATED or
                                  abs(number(part["x0"]) - stretch.begin - by) > STATED)):
                    raise Refuted("the motion's dwells or laws are not those of the scene")

    def moved(self, i):
        """By how much y is higher after a stretch; 0 where it is not known."""
        stretch = self.problem.stretches[i]
        return Fraction(0) if None in (stretch.start, stretch.to) else stretch.to - stretch.start

    def cam_pieces(self):
        """What the cam does, as `pieces`."""
        weights = self.problem.to_cam
        return [[(cam_of(p, weights), w, x, s) for p, w, x, s in run] for run in self.pieces] if weights else self.pieces

    def value_at(self, k, x, side, order, pieces=None):
        """The derivative of this order of spline k at a place. `pieces`: other ones, as cam_pieces."""
        i, x = self.problem.runs[k].space.segment_of(x, side)
        piece, _, left, _ = (pieces or self.pieces)[k][i]
        if self.problem.runs[k].raised and not order:
            raise Unverified("a cam that goes on in the next turn from where it is")
        return value_at(derivative(piece, order), x - left)

    def along(self, order, stretch=None):
        """The derivative of this order on all spline pieces, or on those of one stretch."""
        return [(derivative(p, order), w) for run in self.pieces for p, w, _, s in run if stretch in (None, s)]

    def term(self, term):
        """(low, high) around a term's own figure, in units of its reference."""
        problem, low, high = self.problem, Fraction(0), Fraction(0)
        if term.kind.startswith("motor"):
            low, high = problem.drive.term(self, term)
            return low / term.reference, high / term.reference
        if not problem.runs and term.kind in ("peak", "rms", "torque"):
            return peak_of(problem, term)
        if term.kind == "rms":
            total, length = Fraction(0), Fraction(0)
            for run in self.pieces:
                for p, w, _, stretch in run:
                    bent = derivative(p, term.order)
                    total += integral(product(bent, bent), w) * problem.rms_weight(stretch, term.order)
                    length += w
            low, high = root(total / length)
            return low / term.reference, high / term.reference
        if term.kind == "area":
            lost, functions = lost_area(problem)
            lost += sum((w * control[j] for control, f in zip(self.control, functions) for j, w in f.items()), Fraction(0))
            return lost / term.reference, lost / term.reference
        if term.kind.startswith("deviation"):
            low, high = problem.table.figure(self, term.kind)
            return low / term.reference, high / term.reference
        if term.kind == "residual":
            low, high = problem.train.residual(self)
            return low / term.reference, high / term.reference
        for stretch in [s for s in problem.stretches if s.kind == "spline"]:
            if term.kind == "torque":
                pieces = [(product(derivative(p), derivative(p, 2)), w)
                          for run in self.pieces for p, w, _, s in run if s is stretch]
                scale = stretch.scale(1) * stretch.scale(2)
            else:
                pieces, scale = self.along(term.order, stretch), stretch.scale(term.order)
            own = largest_magnitude(pieces)
            low, high = max(low, own[0] / scale), max(high, own[1] / scale)
        return low / term.reference, high / term.reference

    def objective(self):
        """(low, high)."""
        low, high = self.problem.cam.cost if self.problem.cam else (Fraction(0), Fraction(0))
        for term in self.problem.terms:
            if term.weight:
                own = self.term(term)
                low, high = low + term.weight * own[0], high + term.weight * own[1]
        return low, high

    def keep_caps(self, relaxed):
        """Every cap on a peak, to within KEPT of it."""
        kept = []
        for term in self.problem.terms:
            if term.cap is not None:
                own = self.term(term)[1] * term.reference
                name = f"derivative {term.order}" if term.kind == "peak" else term.kind
                if own > term.cap * (1 + KEPT + relaxed):
                    raise Refuted(f"the limit of {name} is {float(term.cap)}, the motion reaches {float(own)}")
                kept.append(name)
        return kept + self.keep_strokes(relaxed) + keep_bounds(self.problem, self, relaxed)

    def keep_strokes(self, relaxed):
        """motion.within_lift and motion.monotone, to within KEPT of the stroke."""
        motion, room = self.problem.motion, KEPT + relaxed
        monotone, kept = motion.get("monotone", False), set()
        if not monotone and not motion.get("within_lift", True):
            return []
        for run, own in zip(self.problem.runs, self.pieces):
            for p, width, left, stretch in own:
                begin = left - run.begin_of(stretch) + stretch.begin
                for a, b in ((begin, min(begin + width, 1)), (max(begin, 1), begin + width)) if self.problem.type == "RR" else \
                        ((begin, begin + width),):
                    stroke = stroke_of(self.problem, stretch, b) if a < b else None
                    if stroke is None:
                        continue
                    part = shifted(p, a - begin)
                    if monotone and stroke.moved:
                        way = (stroke.end - stroke.begin) / (stroke.moved if stroke.to >= stroke.start else -stroke.moved)
                        rules = [([-c * way for c in derivative(part)], Fraction(0))]
                    else:
                        size = max(stroke.moved, Fraction(1))
                        rules = [([sign * c / size for c in part], (end + run.level(stretch)) * sign / size)
                                 for sign, end in ((-1, stroke.least), (1, stroke.most)) if end is not None]
                    for rule, most in rules:
                        excess = largest([(rule, b - a)])[1] - most
                        if excess > room:
                            raise Refuted(f"a stroke {'turns back' if monotone else 'leaves its range'} by {float(excess):.1e}")
                    kept.add("motion.monotone" if monotone else "motion.within_lift")
        return sorted(kept)

