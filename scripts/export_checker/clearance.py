# SPDX-License-Identifier: MIT
"""Lower bounds of the distance between moves of a cutter and the finished cam.

An outline of the finished cam is approximated by a polygon: every point of the outline lies within `sag` of an edge, proved
as for a drawn curve. Distances between edges and moves are computed in doubles. Coordinates are below 1e4 mm, so their
rounding stays far below ROUNDING, which is subtracted.
"""
import math

from certificate_checker.enclosures import ONE
from certificate_checker.exact import Unverified

from certificate_checker.rational import Fraction
from .departure import Part
from .segments import straight

ROUNDING = 1e-9       # mm
FIRST_STEPS = 360
MOST_EDGES = 40000
LEAST_STEP = ONE >> 40
LEAF = 4              # edges in a leaf of the tree
NO_TURN = 1e-9        # rad


class Polygon:
    """Around the curve at a distance `offset` outside the profile, of a plate closed by its sides and its bottom at y = 0. `corners` in
    order, their `places`; no point of the curve is further than `sag` from the edges."""

    def __init__(self, cam, offset, sag):
        self.cam, self.offset, self.sag, self.corners, self.places = cam, offset, 0.0, [], []
        end, is_open = cam.motion.end, cam.motion.is_open
        x = cam.motion.begin if is_open else 0
        step = (end - x) // FIRST_STEPS
        self.places.append(x)
        self.corners.append(cam.point(x, offset)[:2])
        while x < end:
            piece = cam.motion.piece_at(x)
            to = min(x + step, piece.end)
            corner = cam.point(to, offset)[:2] if to < end or is_open else self.corners[0]
            found = self.departure(piece, x, to, corner)
            width, ratio = to - x, min(2.0, max(0.2, math.sqrt(0.8 * sag / max(found, 1e-30))))
            if found <= sag:
                self.sag = max(self.sag, found)
                self.places.append(to)
                self.corners.append(corner)
                x = to
                step = max(step, int(width * ratio)) if width < step else int(width * ratio)
                continue
            step = int(width * ratio)  # the deviation grows with the square of the width
            if step < LEAST_STEP or len(self.corners) > MOST_EDGES:
                raise Unverified(f"an outline that no polygon approximates at {cam.degrees(x):.3f} deg")
        if is_open:
            self.corners += [(self.corners[-1][0], 0.0), (self.corners[0][0], 0.0), self.corners[0]]
            self.places += [x, x, x]
        self.tree = Node(self.corners, 0, len(self.corners) - 1)

    def departure(self, piece, lo, hi, corner):
        ends = [tuple(map(Fraction, point)) for point in (self.corners[-1], corner)]
        if ends[0] == ends[1]:
            return math.inf
        return Part(straight(0, *ends), piece, lo, hi, 0).bounds(self.cam, self.offset)[0]

    def contains(self, point):
        """By the number of edges crossed on the way to the right."""
        x, y = point
        inside = False
        for (ax, ay), (bx, by) in zip(self.corners, self.corners[1:]):
            if (ay > y) != (by > y) and x < ax + (y - ay) / (by - ay) * (bx - ax):
                inside = not inside
        return inside

    def distance(self, start, end, below):
        """(the distance of a line from the outline, less what is not certain, and its place); `below`: larger distances are
        not told apart."""
        box = min(start[0], end[0]), min(start[1], end[1]), max(start[0], end[0]), max(start[1], end[1])
        best, place, stack = below + self.sag + ROUNDING, None, [self.tree]
        while stack:
            node = stack.pop()
            if node.distance(box) >= best:
                continue
            if node.children:
                stack += sorted(node.children, key=lambda child: -child.distance(box))
                continue
            for i in range(node.first, node.last):
                own = between(start, end, self.corners[i], self.corners[i + 1])
                if own < best:
                    best, place = own, self.places[i]
        return best - self.sag - ROUNDING, place


class Node:
    """A box around the edges from corner `first` to corner `last`."""

    __slots__ = ("first", "last", "children", "box")

    def __init__(self, corners, first, last):
        self.first, self.last, self.children = first, last, ()
        if last - first > LEAF:
            middle = (first + last) // 2
            self.children = Node(corners, first, middle), Node(corners, middle, last)
            boxes = [child.box for child in self.children]
        else:
            boxes = [(x, y, x, y) for x, y in corners[first:last + 1]]
        self.box = tuple(f(box[k] for box in boxes) for k, f in enumerate((min, min, max, max)))

    def distance(self, box):
        """From another box."""
        dx = max(self.box[0] - box[2], box[0] - self.box[2], 0.0)
        dy = max(self.box[1] - box[3], box[1] - self.box[3], 0.0)
        return math.hypot(dx, dy)


def point_to_line(point, a, b):
    dx, dy = b[0] - a[0], b[1] - a[1]
    square = dx * dx + dy * dy
    px, py = point[0] - a[0], point[1] - a[1]
    t = min(1.0, max(0.0, (px * dx + py * dy) / square)) if square else 0.0
    return math.hypot(px - t * dx, py - t * dy)


def side(a, b, point):
    return (b[0] - a[0]) * (point[1] - a[1]) - (b[1] - a[1]) * (point[0] - a[0])


def between(a, b, c, d):
    """The distance of two lines: 0 where they cross, else that of an end of one from the other."""
    if side(a, b, c) * side(a, b, d) < 0 and side(c, d, a) * side(c, d, b) < 0:
        return 0.0
    return min(point_to_line(a, c, d), point_to_line(b, c, d), point_to_line(c, a, b), point_to_line(d, a, b))


class Arc:
    """Printed digits make both ends lie at slightly different radii: the path lies within `band` of the mean one."""

    def __init__(self, start, end, center, counterclockwise):
        arms = [(z[0] - center[0], z[1] - center[1]) for z in (start, end)]
        radii = [math.hypot(*arm) for arm in arms]
        self.center, self.radius, self.band = center, sum(radii) / 2, abs(radii[1] - radii[0]) / 2
        self.first = math.atan2(arms[0][1], arms[0][0])
        turn = (math.atan2(arms[1][1], arms[1][0]) - self.first) % (2 * math.pi)
        if turn < NO_TURN or turn > 2 * math.pi - NO_TURN:  # a whole circle, or what rounding cannot tell from one
            turn = 2 * math.pi
        elif not counterclockwise:
            turn -= 2 * math.pi
        self.turn = turn

    def at(self, part):
        """The point at a part of the arc, 0 to 1."""
        angle = self.first + self.turn * part
        return self.center[0] + self.radius * math.cos(angle), self.center[1] + self.radius * math.sin(angle)

    def length(self):
        return abs(self.turn) * (self.radius + self.band)

    def sag(self, part):
        """How far a chord over this part of the arc is from the path."""
        half = min(math.pi / 2, abs(self.turn) * part / 2)
        return 2 * self.radius * math.sin(half / 2)**2 + self.band
