# SPDX-License-Identifier: MIT
"""The designed motion of the cam over one revolution, as pieces with enclosures.

The motion is the exact spline that certificate_checker.motion constructs from the delivered numbers, next to the scene's
own laws and dwells; where that of an output is prescribed, what the cam does for it. x counts in the scene's unit angle, y in lifts.
"""
import bisect
import collections

from certificate_checker.enclosures import ONE, Jet, added, interval, multiplied
from certificate_checker.exact import STATED, Refuted, Unverified, derivative
from certificate_checker.known import name_what_is_unknown
from certificate_checker.laws import parts_along
from certificate_checker.motion import Curve
from certificate_checker.rational import Fraction
from certificate_checker.units import in_known_units, in_unit
from certificate_checker.valve import as_program
from certificate_checker.verdict import delivered_problem

ORDERS = 4                          # y, y', y'', y''' by x
SAME_TURN = Fraction(1, 10**8)      # a program this near to one revolution, in parts of it, is one
ENOUGH_FOR_A_JOINT = 1 << 68        # 2^-60: y and y' agree at a joint to this


def exact_numbers(value):
    """A scene with its decimals as fractions: a double stands for the shortest decimal that reads as it."""
    if isinstance(value, dict):
        return {key: exact_numbers(own) for key, own in value.items()}
    if isinstance(value, list):
        return [exact_numbers(own) for own in value]
    return Fraction(repr(value)) if isinstance(value, float) else value


class MotionPiece:
    """One formula of the motion. `begin`, `end`: x in multiples of 2^-128, rounded down; `states(x)`: enclosures of
    [y, y', y'', y'''] by x, of an interval of x that may pass an end by a rounding."""

    def __init__(self, begin, end, states):
        self.begin, self.end, self.states = on_grid(begin), on_grid(end), states


def on_grid(x):
    return x.numerator * ONE // x.denominator


class DesignedMotion:
    """`pieces` cover one revolution from `begin` to `end` without gaps: 0 to `turn` where it ends as it began. A motion that
    `is_open` rests as long before as after; unless it `rests`, it is the motion alone."""

    def __init__(self, scene, design, is_open=False, rests=True):
        self.scene, self.problem, self.is_open, self.rests = scene, None, is_open, rests
        self.problem, curve = exact_motion(scene, design)
        unit = self.problem.unit_angle
        self.turn = in_unit((Fraction(360), "deg"), unit[1]) / unit[0]
        self.pieces = self.pieces_of(curve)
        self.starts = [piece.begin for piece in self.pieces]
        self.begin, self.end = self.starts[0], self.pieces[-1].end
        self.check_joints()

    def pieces_of(self, curve):
        length, pieces = self.problem.stretches[-1].end, []
        for copy in range(self.problem.copies):
            by = copy * length
            pieces += spline_pieces(curve, by)
            for stretch in self.problem.stretches:
                if stretch.kind != "spline":
                    pieces += law_pieces(self.problem, stretch, by)
        pieces.sort(key=lambda piece: piece.begin)
        end = length * self.problem.copies
        if end > self.turn * (1 + SAME_TURN):
            raise Unverified("a motion that is longer than one revolution")
        if any(a.end != b.begin for a, b in zip(pieces, pieces[1:])) or pieces[0].begin != 0:
            raise Refuted("the motion's segments do not cover the revolution")
        if end < self.turn * (1 - SAME_TURN) and self.rests:  # the follower rests for the remainder
            before = (self.turn - end) / 2 if self.is_open else 0
            first, last = (self.problem.cam_at_rest(level) for level in (self.problem.stretches[0].start, self.problem.stretches[-1].to))
            pieces.append(MotionPiece(end, self.turn - before, at_rest(last)))
            pieces[:0] = [MotionPiece(-before, Fraction(0), at_rest(first))] if before else []
        return pieces

    def piece_at(self, x):
        """The piece of a place, begin <= x < end; at the end the last one."""
        return self.pieces[bisect.bisect_right(self.starts, x) - 1]

    def within(self, x):
        """A place without whole revolutions."""
        return x if self.is_open else x % self.end

    def degrees(self, x):
        """Cam angle of a place, for messages."""
        return self.within(x) / ONE / float(self.turn) * 360

    def check_joints(self):
        """y and y' do not jump: a profile exists without gaps, and the cam closes."""
        for piece, following in zip(self.pieces, self.pieces[1:] + self.pieces[:0 if self.is_open else 1]):
            before, after = piece.states((piece.end,) * 2), following.states((following.begin,) * 2)
            for order, name in ((0, "displacement"), (1, "velocity")):
                (low, high), (least, most) = before[order], after[order]
                if low - most > ENOUGH_FOR_A_JOINT or least - high > ENOUGH_FOR_A_JOINT:
                    raise Unverified(f"a cam whose {name} jumps at {self.degrees(piece.end):.3f} deg, or that does not close")


def exact_motion(scene, design):
    """The problem and its curve. Objective and limits have no part in the motion, so they are left out."""
    if not design.get("motion"):
        raise Unverified("a result without a motion")
    motion = {key: value for key, value in scene["motion"].items() if key != "corridor"}
    scene = as_program(scene | {"motion": motion, "objective": {}, "limits": {}})
    name_what_is_unknown(scene)
    problem = delivered_problem(in_known_units(scene), collections.defaultdict(lambda: Fraction(1)), design)
    if any(abs(run.raised) > STATED for run in problem.runs):
        raise Unverified("a cam that continues in the next revolution from where it is")
    return problem, Curve(problem, design)


def spline_pieces(curve, by):
    pieces = []
    for run, own in zip(curve.problem.runs, curve.cam_pieces()):
        for polynomial, width, left, stretch in own:
            begin = left - run.begin_of(stretch) + stretch.begin + by
            pieces.append(MotionPiece(begin, begin + width, along_polynomial(polynomial, begin)))
    return pieces


def along_polynomial(polynomial, begin):
    orders = [[interval(c) for c in derivative(polynomial, order)] for order in range(ORDERS)]
    start = interval(begin)

    def states(x):
        t, found = (x[0] - start[1], x[1] - start[0]), []
        for coefficients in orders:
            total = coefficients[-1]
            for coefficient in reversed(coefficients[:-1]):
                total = added(multiplied(total, t), coefficient)
            found.append(total)
        return found
    return states


def at_rest(level):
    own = [interval(level)] + [(0, 0)] * (ORDERS - 1)
    return lambda x: own


def law_pieces(problem, stretch, by):
    if stretch.kind == "dwell":
        return [MotionPiece(stretch.begin + by, stretch.end + by, at_rest(problem.cam_at_rest(stretch.start)))]
    length = stretch.end - stretch.begin
    pieces = []
    for begin, end, motion in parts_along(stretch, ORDERS):
        start = stretch.begin + by + begin * length
        pieces.append(MotionPiece(start, stretch.begin + by + end * length, along_law(motion, start, length)))
    return pieces


def along_law(motion, start, length):
    left, inverse = interval(start), interval(1 / length)

    def states(x):
        v = multiplied((x[0] - left[1], x[1] - left[0]), inverse)
        return [own.value for own in motion(Jet(v))]
    return states
