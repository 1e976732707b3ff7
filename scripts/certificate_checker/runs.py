# SPDX-License-Identifier: MIT
"""What a motion is made of, and what its objective is.

Theorem. A `Row` is an inequality, function . c + searched . dimensions - peak <= most, that the module which makes it proves for every motion.
"""

from .conditions import Conditions
from .exact import ORDERS, add_to
from .rational import Fraction
from .spaces import Space


class Stretch:
    """A part of the motion: a dwell, a law, or a spline between two displacements (None: not known). `free`: the scene leaves one of
    them open."""

    def __init__(self, kind, begin, end, start, to, free=False):
        self.kind, self.begin, self.end, self.start, self.to, self.free = kind, begin, end, start, to, free
        self.measure = None  # (angle, displacement) of its stroke, where that is more than the stretch
        self.smooth_top = False  # of a law that turns back: y'' does not jump there

    def scale(self, order):
        """y^(order) is this times what V, A and J of the stretch measure."""
        if self.measure:
            return self.measure[1] / self.measure[0]**order
        displacement = Fraction(1) if self.free else abs(self.to - self.start)
        if displacement < Fraction(1, 10**9):
            displacement = Fraction(1)
        return displacement / (self.end - self.begin)**order


class Run:
    """A spline over neighbouring stretches: its space, and conditions (row, value, name) it meets exactly. Those of `passed`
    come after the start of the next turn: there the run's own x is a turn further, and its y higher by `raised` (a relative
    motion). `curves`: those of the delivered motion in the run's order, with by how much x of each is less than the run's."""

    def __init__(self, space, stretches, passed=(), raised=Fraction(0), curves=()):
        self.space, self.stretches, self.passed, self.raised, self.conditions = space, stretches, passed, raised, []
        self.curves = curves
        self.cam_space = space  # another one where the output is prescribed (prescribe_output)
        # y' and y'' at both ends; None: where one turn goes on in the next.
        self.states = [(Fraction(0), Fraction(0)), (Fraction(0), Fraction(0))]

    @property
    def rests(self):
        return tuple(state == (0, 0) for state in self.states)

    def is_ring(self):
        return self.states[0] is None

    def level(self, stretch):
        """The run's own y less that of the motion."""
        return self.raised if stretch in self.passed else Fraction(0)

    def ends(self):
        """Its own y at both ends (None: not known)."""
        last = self.stretches[-1]
        return self.stretches[0].start, None if last.to is None else last.to + self.level(last)

    def begin_of(self, stretch):
        """Its own x where a stretch begins."""
        return stretch.begin + (self.space.period if stretch in self.passed else 0)

    def stretch_at(self, x):
        return next(s for s in self.stretches if self.begin_of(s) <= x < self.begin_of(s) + s.end - s.begin)

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
        return {j: w for j, w in enumerate(starts + weights) if w} | {j: w for j, w in row.items() if j < 0}

    def space_of_top(self):
        return Space(self.space.degree - self.top(), self.space.continuity - self.top(), self.space.breakpoints)

    def conditions_in_top(self, errors=None):
        return Conditions([(self.in_top(row), value, name) for row, value, name in self.conditions], errors)

    def demand(self, x, order, side, value, name):
        """`value`: a number, or a function of displacements that are free (Problem.level_at)."""
        row = self.space.functional(x, order, side)
        if isinstance(value, dict):
            add_to(row, {key: w for key, w in value.items() if key is not None}, -1)
            value = value.get(None, Fraction(0))
        self.conditions.append((row, value, name))


class Peak:
    """A term of the objective: weight * max |y^(order)| / reference (kind "rms": root mean square; "residual": vibration of an
    elastic follower's output after the motion)."""

    def __init__(self, kind, order, weight, reference, cap=None):
        self.kind, self.order, self.weight, self.reference, self.cap = kind, order, weight, reference, cap


def name_of_peak(term):
    """The name of its variable in proofs."""
    return "peak " + next(name for name, order in ORDERS.items() if order == term.order) if term.kind == "peak" else \
        "peak torque" if term.kind == "torque" else term.kind


def name_in_run(name, k, count):
    """The name in proofs of a number of spline k, one of so many."""
    return name if count == 1 else f"{name} of run {k + 1}"


class Row:
    """function(control points of run) + searched . dimensions - (the peak, where there is one) <= most. Of a tangent of a
    convex rule `leaning(by)` is another row under the rule, whose slope by y is larger by that. `beside`: functions of further
    runs, by their numbers."""

    def __init__(self, name, run, function, most, peak=None, searched=None, leaning=None, beside=None):
        self.leaning, self.beside = leaning, beside or {}
        self.name, self.run, self.function, self.most, self.peak = name, run, function, most, peak
        self.searched = searched or {}

    @staticmethod
    def over_runs(name, functions, constant, size, most, peak=None):
        """(functions of the runs + constant) / size <= most, and the peak."""
        scaled = [{j: w / size for j, w in function.items()} for function in functions]
        return Row(name, 0, scaled[0] if scaled else {}, most - constant / size, peak, beside=dict(enumerate(scaled[1:], 1)))

    def functions(self):
        return {self.run: self.function} | self.beside
