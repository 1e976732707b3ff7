# SPDX-License-Identifier: MIT
"""How deep moves of a cutter enter the finished cam."""
import math

from certificate_checker.exact import Refuted

from .clearance import ROUNDING, Arc, Polygon

FINEST_ARC = 1e-6     # mm: an arc is divided until its chords are this near to it


def doubles(point):
    return float(point[0]), float(point[1])


class Wall:
    """An outline of the finished cam, at a distance `offset` outside the profile. The cutter stays outside of it; of the outer
    flank of a groove inside."""

    def __init__(self, cam, offset, sag, outside=True):
        self.polygon, self.outside = Polygon(cam, offset, sag), outside

    def is_passed(self, point):
        return self.polygon.contains(point) == self.outside


class Gouges:
    """The depth by which moves enter the finished cam; `largest` so far, at `place`. A cutter of this radius enters where its
    centre is nearer to a wall, or has passed it."""

    def __init__(self, cam, radius, walls):
        self.cam, self.radius, self.walls = cam, float(radius), walls
        self.largest, self.place, self.clear_at = 0.0, "nowhere", None

    def look_at(self, move):
        if not move.is_known():
            raise Refuted(f"line {move.line}: a move below the cam's upper face from an unknown position")
        start, end = doubles(move.start), doubles(move.end)
        for wall in self.walls:
            if self.clear_at != start and wall.is_passed(start):
                self.note(move, -math.dist(start, wall.polygon.corners[0]), math.dist(start, end))
            elif move.kind in (2, 3):
                self.along_arc(wall.polygon, move, start, end)
            elif move.kind == 0 and start[0] != end[0] and start[1] != end[1]:
                self.over_rectangle(wall.polygon, move, start, end)
            else:
                self.along_line(wall.polygon, move, start, end, math.dist(start, end))
        # Which side of a wall a point is on is only determined where a move may have reached one.
        self.clear_at = end if self.largest < self.radius else None

    def room(self):
        """Distances from a wall at which a move does not enter deeper than those before."""
        return max(self.radius - self.largest, ROUNDING)

    def note(self, move, clear, further, place=None):
        """`clear`: distance from a wall. A move that reaches it may pass it, by `further` at most."""
        depth = self.radius - clear + (further if clear <= 0 else 0)
        if depth > self.largest:
            self.largest = depth
            self.place = f"line {move.line}" + ("" if place is None else f", {self.cam.degrees(place):.4f} deg")

    def along_line(self, polygon, move, start, end, further):
        clear, place = polygon.distance(start, end, self.room())
        if place is not None:
            self.note(move, clear, further, place)

    def over_rectangle(self, polygon, move, start, end):
        """A rapid moves each axis at its own speed: any point of the rectangle between its ends may be reached."""
        corners = [start, (end[0], start[1]), end, (start[0], end[1])]
        for a, b in zip(corners, corners[1:] + corners[:1]):
            self.along_line(polygon, move, a, b, math.dist(start, end))
        if all(min(a, b) < z < max(a, b) for a, b, z in zip(start, end, polygon.corners[0])):
            self.note(move, 0.0, math.dist(start, end))

    def along_arc(self, polygon, move, start, end):
        arc = Arc(start, end, doubles(move.center), move.kind == 3)
        stack = [(0.0, 1.0)]
        while stack:
            low, high = stack.pop()
            a, b, sag = arc.at(low), arc.at(high), arc.sag(high - low)
            clear, place = polygon.distance(a, b, self.room() + sag)
            if place is None:
                continue
            if sag <= arc.band + FINEST_ARC:
                self.note(move, clear - sag, arc.length(), place)
            else:
                middle = (low + high) / 2
                stack += [(low, middle), (middle, high)]
