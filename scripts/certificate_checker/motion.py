# SPDX-License-Identifier: MIT
"""The delivered motion."""
from fractions import Fraction

from .conditions import Conditions
from .exact import (
    JOINED, KEPT, Refuted, SAME_PLACE, STATED, Unverified, combination, derivative, integral,
    largest_magnitude, number, product, root, shifted, value_at)
from .spaces import Space


class Curve:
    """An exact motion of the problem within rounding of the delivered one. pieces[r]: (polynomial, width, x,
    stretch)."""

    def __init__(self, problem, result):
        self.problem = problem
        curves = result["motion"]["curves"]
        if len(curves) != len(problem.runs):
            raise Refuted(f"the motion has {len(curves)} splines, the scene {len(problem.runs)}")
        self.pieces, self.control, self.distance = [], [], [Fraction(0)] * 4
        for run, curve in zip(problem.runs, curves):
            self.add(run, curve)
        self.parts(result["motion"]["parts"])
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

    def add(self, run, curve):
        space = run.space
        points = [number(x) for x in curve["breakpoints"]]
        delivered = [[number(a) for a in piece] for piece in curve["pieces"]]
        if (curve["degree"], curve["continuity"]) != (space.degree, space.continuity) or \
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
        self.control.append(control)
        exact = space.pieces(control)
        own = []
        for i, piece in enumerate(exact):
            left, width = space.breakpoints[i], space.width(i)
            moved = shifted(delivered[i], left - points[i])
            for order in range(4):
                error = derivative(combination((1, piece), (-1, moved)), order)
                size = sum((abs(c) * width**m for m, c in enumerate(error)), Fraction(0))
                self.distance[order] = max(self.distance[order], size)
            stretch = next(s for s in run.stretches if s.begin <= left < s.end)
            own.append((piece, width, left, stretch))
        self.pieces.append(own)

    @staticmethod
    def from_the_top(run, points, delivered):
        """Where some segments are far narrower than others, the last digit of y there is all of its third derivative.
        So the conditions are solved for control points of that derivative, which weigh little where segments are
        narrow."""
        space, top, conditions = run.space, run.top(), run.conditions_in_top()
        own = Space(space.degree - top, space.continuity - top, space.breakpoints)
        values = [derivative(delivered[0], order)[0] for order in range(top)]
        values += own.control_points(points, [derivative(piece, top) for piece in delivered])
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
        stretches = self.problem.stretches
        if len(parts) != len(stretches):
            raise Refuted("the motion does not have the scene's segments")
        curve = -1
        for part, stretch in zip(parts, stretches):
            near = abs(number(part["begin"]) - stretch.begin) + abs(number(part["end"]) - stretch.end)
            if near > STATED or (part["curve"] is not None) != (stretch.kind == "spline"):
                raise Refuted("the motion's segments are not those of the scene")
            if stretch.kind == "spline":
                run = next(k for k, run in enumerate(self.problem.runs) if stretch in run.stretches)
                if part["curve"] != run or number(part["x0"]) or part["x_scale"] != 1 or part["y0"] or \
                        part["y_scale"] != 1:
                    raise Refuted("the motion's parts do not join its splines")
                curve = run
            else:
                law = getattr(stretch, "law", None) if stretch.kind == "law" else None
                rise = stretch.to - stretch.start
                if part["law"] != law or abs(number(part["y0"]) - stretch.start) > STATED or \
                        (law and abs(number(part["y_scale"]) - rise) > STATED):
                    raise Refuted("the motion's dwells or laws are not those of the scene")
        if curve < 0:
            raise Refuted("the motion has no spline")

    def value_at(self, k, x, side, order):
        """The derivative of this order of spline k at a place."""
        i, x = self.problem.runs[k].space.segment_of(x, side)
        piece, _, left, _ = self.pieces[k][i]
        return value_at(derivative(piece, order), x - left)

    def along(self, order, stretch=None):
        """The derivative of this order on all spline pieces, or on those of one stretch."""
        return [(derivative(p, order), w) for run in self.pieces for p, w, _, s in run if stretch in (None, s)]

    def term(self, term):
        """(low, high) around a term's own figure, in units of its reference."""
        problem, low, high = self.problem, Fraction(0), Fraction(0)
        if term.kind == "rms":
            total, length = Fraction(0), Fraction(0)
            for run in self.pieces:
                for p, w, _, stretch in run:
                    bent = derivative(p, term.order)
                    total += integral(product(bent, bent), w) * problem.rms_weight(stretch, term.order)
                    length += w
            low, high = root(total / length)
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
        for order, cap, key in self.problem.motion_caps:
            own = largest_magnitude(self.along(order))[1]
            if own > cap * (1 + KEPT + relaxed):
                raise Refuted(f"{key}: the motion reaches {float(own / cap)} of it")
            if any(s.kind == "law" for s in self.problem.stretches):
                raise Unverified(f"{key} on a segment with a law")
            kept.append(key)
        return kept
