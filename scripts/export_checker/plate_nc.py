# SPDX-License-Identifier: MIT
"""cam.nc of a linear cam on three axes: the surface of a plate, milled from a block.

- The finishing pass, the last feeds at the lowest depth, against the designed path of the cutter's centre, both ways; what it has
  beyond either end of the surface is left out.
- Every move with the tip below the plate's upper face (z = 0) against the finished plate: its surface, sides and bottom.
- No rapid enters the block; no move the room below the surface that the program leaves to clamps.
"""
import math

from certificate_checker.exact import Refuted, Unverified

from .clearance import ROUNDING
from .departure import largest_departure
from .gouges import Gouges, Wall, doubles
from .linear_cam import LinearCam
from .nc_reader import Program
from .outcome import Outcome
from .places import Places


def surface_part(places, stretch):
    """(moves along the surface, whether they run against the cam angle)."""
    moves = [move for move in stretch if move.moves_in_plane()]
    points = [doubles(move.start) for move in moves] + [doubles(moves[-1].end)]
    begin, end = (min(range(len(points)), key=lambda i, own=own: math.dist(points[i], own)) for own in (places.samples[0], places.samples[-1]))
    if begin == end:
        raise Refuted(f"the finishing pass, lines {stretch[0].line} to {stretch[-1].line}, is not along the plate")
    return moves[min(begin, end):max(begin, end)], begin > end


def finishing_departure(cam, program, stretch, ways):
    """(bound, where)."""
    offset = program.radius + program.stock
    places = Places(cam, offset)
    moves, backwards = surface_part(places, stretch)
    rounded = ROUNDING if any(move.wanted[0] != move.start[:2] for move in moves) else 0.0
    segments = [ways.segment_of(move, backwards) for move in (reversed(moves) if backwards else moves)]
    if not backwards:  # a block states where its move ends
        for before, segment in zip(segments, segments[1:]):
            segment.start_line = before.line
    points = [doubles(segment.start) for segment in segments] + [doubles(segments[-1].end)]
    bound, place = largest_departure(cam, segments, places.along(points), offset)
    return bound + rounded, place


def gap(a, b, low, high):
    """Of an interval between a and b from another one."""
    return max(low - max(a, b), min(a, b) - high, 0)


def is_near(move, radius, box):
    """Whether the cutter may come to (x, y) in `box`, each axis at its own speed."""
    x = gap(move.start[0], move.end[0], box[0], box[1])
    y = gap(move.start[1], move.end[1], box[2], box[3])
    return x * x + y * y < radius * radius


def lowest(move):
    return min((point[2] for point in (move.start, move.end) if point[2] is not None), default=-math.inf)


def rapid_in_block(program, move):
    """A rapid whose tip may enter the block, which removed material belongs to."""
    if move.kind != 0 or not move.is_known() or lowest(move) >= program.bar[5]:
        return False
    return is_near(move, program.radius, program.bar[:4])


def enters_clamps(program, move):
    """Whether the cutter may enter the block below the height that the program leaves to clamps."""
    if program.held is None or lowest(move) >= program.held[1]:
        return False
    return not move.is_known() or is_near(move, program.radius, (*program.bar[:3], program.held[0]))


def verify(text, scene, design, ways):
    """The Outcome of a program; `ways`: of nc.py, which finds the finishing pass and the low moves of any program on three axes."""
    cam, program = LinearCam(scene, design), Program(text)
    outcome = Outcome(stated=", ".join(program.words_of_stock()))
    if len(program.axes.letters) != 3:
        raise Unverified("a program for another machine than three axes")
    if program.bar is None:
        raise Unverified("a program that does not state the block that the plate is milled from")
    stretches = ways.lowest_stretches(program.moves)
    if not stretches:
        raise Refuted("no feed at the lowest depth")
    profile, place = finishing_departure(cam, program, stretches[-1], ways)
    outcome.bounds["profile_mm"], outcome.places["profile_mm"] = profile, place
    sag = min(ways.MOST_SAG, max(ways.LEAST_SAG, ways.SAG_OF_BOUND * profile))
    gouges = Gouges(cam, program.radius, [Wall(cam, 0, sag)])
    for move in ways.low_moves(program.moves):
        gouges.look_at(move)
    outcome.bounds["gouge_mm"], outcome.places["gouge_mm"] = gouges.largest, gouges.place
    outcome.faults += [f"line {move.line}: a rapid through the blank" for move in program.moves if rapid_in_block(program, move)]
    outcome.faults += [f"line {move.line}: enters the room for clamps" for move in program.moves if enters_clamps(program, move)]
    return outcome
