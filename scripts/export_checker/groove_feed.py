# SPDX-License-Identifier: MIT
"""A feed along the groove of a three-dimensional cam, compared at every instant with the roller at the same turn of the table.

All axes move in proportion, so the turn, x(t), and the other axes are linear in t from 0 to 1. In the fixed frame of spatial_cam.py
the cutter's axis is P + s up, with s from the tip upward. Two comparisons, as Jets of t:

- `off_path`: the differences at the tip and a working length above it from where the cutter belongs: its tip
  TIP_BEYOND below the far end of the roller, beside the roller's axis by `offset` along n. Every other height is in between.
- `beside_roller`: the differences across the roller's axis, at the tip and where the cutter leaves the blank, and how far the tip is below
  the roller's end (at the same depth). Lengthened upward, a roller of radius r contains a cutter of radius R that is d beside it up to
  d + R - r: so deep, or below the floor, it enters the finished cam at most.
"""
import math

from certificate_checker.enclosures import ONE, ZERO, Jet, added, fraction, interval, multiplied
from certificate_checker.exact import Unverified

from certificate_checker.rational import Fraction
from .clearance import ROUNDING
from .refine import largest_magnitude, range_over

TIP_BEYOND = Fraction(1, 2)  # mm, as docs/nc.md says


class GrooveFeed:
    """`begin`, `end`: its places x, fractions of the scene's unit angle. `z_offset`: what the program subtracts from Z. `reach`: of the
    blank from the cam's centre; `way`: more than the length of the cutter's axis that may be in the blank."""

    def __init__(self, cam, move, places, z_offset, reach):
        self.cam, self.move, self.begin, self.end = cam, move, *places
        self.x = self.linear(*places)
        (x, y, z), (x1, y1, z1) = move.start[:3], move.end[:3]
        self.way = max(Fraction(reach) - min(z, z1) - z_offset, Fraction(1))
        self.axes = self.linear(x, x1), self.linear(y, y1), self.linear(z + z_offset, z1 + z_offset)
        if cam.tilts:
            self.tilt = self.linear(*(cam.radians(own[4]) for own in (move.start, move.end)))

    @staticmethod
    def linear(begin, end):
        return interval(begin), interval(end - begin)

    def parts(self, lo=0, hi=ONE):
        """Those within one piece of the motion each, between two t."""
        ends = [added(self.x[0], multiplied(self.x[1], (t, t)))[0] for t in (lo, hi)]
        steps = self.cam.pieces_between(min(ends), max(ends))
        if len(steps) == 1:
            return [FeedPart(self, steps[0][0], steps[0][3], lo, hi)]
        along = [fraction(step[1] - self.x[0][0]) / (self.end - self.begin) for step in steps[1:]]
        joints = [lo, *(min(max(int(t * ONE), lo), hi) for t in (along if ends[1] > ends[0] else reversed(along))), hi]
        steps = steps if ends[1] > ends[0] else steps[::-1]
        return [FeedPart(self, step[0], step[3], a, b) for step, a, b in zip(steps, joints, joints[1:])]


class FeedPart:
    """Between two t, within one piece of the motion, `turns` revolutions from the first."""

    def __init__(self, feed, piece, turns, lo, hi):
        self.feed, self.piece, self.turns, self.lo, self.hi = feed, piece, turns, lo, hi

    def halves(self):
        middle = (self.lo + self.hi) // 2
        return [FeedPart(self.feed, self.piece, self.turns, lo, hi) for lo, hi in ((self.lo, middle), (middle, self.hi))]

    def middle(self):
        """x there."""
        return self.feed.x[0][0] + int(fraction((self.lo + self.hi) // 2) * (self.feed.end - self.feed.begin) * ONE)

    def cutter(self, t):
        """(P, up) in the fixed frame, up without its first component, which is 0."""
        def along(way):
            return Jet.along(added(way[0], multiplied(way[1], t)), way[1])
        x, y, z = (along(way) for way in self.feed.axes)
        if not self.feed.cam.tilts:
            return (y, z, x), None
        sine, cosine = along(self.feed.tilt).sine_and_cosine()
        return (y, z * cosine - x * sine, x * cosine + z * sine), (cosine, sine)

    def roller(self, t):
        feed = self.feed
        return feed.cam.roller(self.piece, self.turns, Jet.along(added(feed.x[0], multiplied(feed.x[1], t)), feed.x[1]))

    def off_path(self, t, offset):
        cam, roller = self.feed.cam, self.roller(t)
        wanted, velocity = cam.axis(roller, cam.length)
        if offset:
            wanted = [c + n.scaled(interval(offset)) for c, n in zip(wanted, cam.normal(roller, wanted, velocity))]
        (px, py, pz), up = self.cutter(t)
        beyond, length = interval(TIP_BEYOND), interval(cam.length + TIP_BEYOND)
        if not cam.tilts:
            return [(px - wanted[0], py - wanted[1] + Jet(beyond), pz - wanted[2])]
        _, sine, cosine, _ = roller  # up of the roller: (0, cos q, -sin q)
        tip = px - wanted[0], py - wanted[1] + cosine.scaled(beyond), pz - wanted[2] - sine.scaled(beyond)
        return [tip, (tip[0], tip[1] + (up[0] - cosine).scaled(length), tip[2] + (up[1] + sine).scaled(length))]

    def beside_roller(self, t):
        """([(across, across) at the tip and `feed.way` above it], how far the tip is below the floor, the sine of the angle of both axes)."""
        cam, roller = self.feed.cam, self.roller(t)
        foot, _ = cam.axis(roller, cam.length)
        (px, py, pz), up = self.cutter(t)
        vx, vy, vz = px - foot[0], py - foot[1], pz - foot[2]
        beyond = Jet.number(TIP_BEYOND)
        if not cam.tilts:
            return [(vx, vz)], -vy - beyond, Jet(ZERO)
        _, sine, cosine, _ = roller
        tip = vx, vy * sine + vz * cosine
        leaned = up[0] * sine + up[1] * cosine
        return [tip, (vx, tip[1] + leaned.scaled(interval(self.feed.way)))], vz * sine - vy * cosine - beyond, leaned

    # -- bounds: (an upper one over the part, the value in its middle)

    def path_bounds(self, offset):
        middle, reach = (self.lo + self.hi) // 2, (self.hi - self.lo) // 2 + 1
        try:
            there, over = self.off_path((middle, middle), offset), self.off_path((self.lo, self.hi), offset)
        except Unverified:  # a normal over too long a part
            return math.inf, 0.0
        return max(size(a, b, reach) for a, b in zip(there, over)), max(size(a, a, 0) for a in there)

    def depth_bounds(self, radius):
        """Of a cutter with this radius. The rim of one that leans is lower than its tip."""
        middle, reach = (self.lo + self.hi) // 2, (self.hi - self.lo) // 2 + 1
        there, over = self.beside_roller((middle, middle)), self.beside_roller((self.lo, self.hi))
        less, found = float(self.feed.cam.radius - radius) - ROUNDING, []
        for own, within in ((over, reach), (there, 0)):
            side = max(size(a, b, within) for a, b in zip(there[0], own[0])) - less
            under = range_over(there[1].c[0], there[1].c[1], own[1].c[2], within)[1] + float(radius) * size(there[2:], own[2:], within)
            found.append(math.hypot(side, under) if side > 0 and under > 0 else max(side, under))
        return found


def size(there, over, reach):
    """An upper bound of the length of a vector, from its components or from its square."""
    parts = [largest_magnitude(a.c[0], a.c[1], b.c[2], reach) for a, b in zip(there, over)]
    from_parts = math.hypot(*parts) * (1 + 1e-15)
    square, squares = there[0].square(), over[0].square()
    for a, b in zip(there[1:], over[1:]):
        square, squares = square + a.square(), squares + b.square()
    most = range_over(square.c[0], square.c[1], squares.c[2], reach)[1]
    return min(from_parts, math.sqrt(max(most, 0.0)) * (1 + 1e-15))
