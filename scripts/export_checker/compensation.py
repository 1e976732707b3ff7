# SPDX-License-Identifier: MIT
"""Where the cutter's centre goes under G41 and G42, as docs/nc.md says that a control does it.

The centre runs at the cutter's radius to the left (G41) or to the right of the programmed path. The first block, a line, ends beside
its programmed end. At outer corners the cutter rolls about the corner, at inner ones the two offsets meet. Points are computed in
doubles, which nc.py leaves room for.
"""
import math

from certificate_checker.exact import Refuted, Unverified
from certificate_checker.plane_vectors import across, dot

from certificate_checker.rational import Fraction
from .gouges import doubles
from .moves import Move

NO_ROLL = 1e-6     # rad: a roll by less is a line within 1e-13 of the radius
TANGENTIAL = 1e-5  # rad: both offsets of such a corner meet beside it within 2e-11 of the radius, lines or arcs


def from_point(point, length, direction):
    return point[0] + length * direction[0], point[1] + length * direction[1]


def unit(start, end, line):
    size = math.dist(start, end)
    if size == 0:
        raise Refuted(f"line {line}: a move without a direction under cutter compensation")
    return (end[0] - start[0]) / size, (end[1] - start[1]) / size


class Element:
    """A programmed move; `first`, `last`: the directions of travel at its ends; `shift`: the radius, above 0 to the left."""

    def __init__(self, move, shift):
        self.move, self.shift, self.start, self.end, self.inner = move, shift, doubles(move.start), doubles(move.end), 0.0
        if move.kind == 1:
            self.first = self.last = unit(self.start, self.end, move.line)
            return
        sense = 1 if move.kind == 3 else -1
        self.center, self.inner = doubles(move.center), sense * shift
        arms = [unit(self.center, z, move.line) for z in (self.start, self.end)]
        self.first, self.last = [from_point((0, 0), sense, across(arm)) for arm in arms]
        if min(math.dist(self.center, z) for z in (self.start, self.end)) <= self.inner:
            raise Refuted(f"line {move.line}: the cutter does not fit into the arc")

    def beside(self, point, direction):
        return from_point(point, self.shift, across(direction))


def joint(before, after):
    """(where the offset of a move ends, where that of the next one begins, the angle from one to the other)."""
    corner, shift = before.end, before.shift
    (ax, ay), (bx, by) = before.last, after.first
    turn = math.atan2(ax * by - ay * bx, dot(before.last, after.first))
    if turn * shift <= 0:
        return before.beside(corner, before.last), before.beside(corner, after.first), turn
    kinds = before.move.kind, after.move.kind
    if kinds == (1, 1) or turn * math.copysign(1, shift) < TANGENTIAL:
        met = from_point(corner, shift / math.cos(turn / 2), across(unit((0, 0), (ax + bx, ay + by), after.move.line)))
    elif kinds[0] == 1:
        met = crossing(before, before.last, after, corner)
    elif kinds[1] == 1:
        met = crossing(after, after.first, before, corner)
    else:
        raise Unverified(f"line {after.move.line}: an inner corner of two arcs under cutter compensation")
    return met, met, 0.0


def crossing(line, direction, arc, corner):
    """Of the offsets of a line and an arc, next to their corner."""
    radius = math.dist(arc.center, corner) - arc.inner
    start = line.beside(corner, direction)
    mx, my = start[0] - arc.center[0], start[1] - arc.center[1]
    along = dot((mx, my), direction)
    rest = along * along - dot((mx, my), (mx, my)) + radius * radius
    if rest < 0:
        raise Refuted(f"line {arc.move.line}: the cutter does not fit between the blocks")
    root = math.sqrt(rest)
    return from_point(start, min(-along - root, -along + root, key=abs), direction)


def compensated(moves, shift):
    """The moves of the cutter's centre."""
    for move in moves:
        if move.kind == 0 or not move.is_known():
            raise Unverified(f"line {move.line}: a rapid under cutter compensation, or one from an unknown position")
        if move.start[2] != move.end[2]:
            raise Refuted(f"line {move.line}: Z moves under cutter compensation")
    elements = [Element(move, shift) for move in moves if move.moves_in_plane()]
    if not elements or elements[0].move.kind != 1:
        raise Refuted(f"line {moves[0].line}: cutter compensation that does not begin with a line")
    found, place, height = [], elements[0].start, moves[0].start[2]

    def go(move, kind, end, center, wanted):
        nonlocal place
        ends = [(*map(Fraction, z), height) for z in (place, end)]
        found.append(Move(move.line, kind, *ends, center, wanted))
        place = end

    for i, own in enumerate(elements):
        last = i + 1 == len(elements)
        end, following, turn = (own.beside(own.end, own.last), None, 0.0) if last else joint(own, elements[i + 1])
        if i and own.move.kind == 1 and sum((e - p) * d for e, p, d in zip(end, place, own.last)) <= 0:
            raise Refuted(f"line {own.move.line}: the cutter does not fit between the blocks")
        go(own.move, own.move.kind, end, own.move.center, own.move.wanted)
        if turn:
            corner = own.move.end[:2]
            rolls = (2 if shift > 0 else 3) if abs(turn) > NO_ROLL else 1
            go(elements[i + 1].move, rolls, following, corner if rolls > 1 else None, (corner, corner))
    return found
