# SPDX-License-Identifier: MIT
"""cam.nc of a disk cam on three axes; plate_nc.py judges those of plates, groove_nc.py those of other cams. Paths are those of the cutter's centre, under G41 and
G42 too (compensation.py).

- The finishing pass, the last closed path at the lowest depth, against the designed path of the cutter's centre, both ways.
  The cutter's edge then lies within the same bound of the profile: the discs around both paths do. A groove is finished in
  one pass by a cutter as wide as it, else in two.
- Every move with the tip below the cam's upper face (z = 0) against the finished cam: the cutter is a cylinder without an
  upper end, so it cuts where its centre comes nearer to an outline than its radius.
"""
import math
import sys

from certificate_checker.exact import Refuted, Unverified

from . import groove_nc, plate_nc
from certificate_checker.rational import Fraction
from .clearance import ROUNDING, Arc, point_to_line
from .departure import largest_departure
from .gouges import Gouges, Wall, doubles
from .nc_reader import Program
from .outcome import Outcome
from .places import Places
from .plane_cam import PlaneCam
from .segments import around, straight

TOP = 0               # z of the cam's upper face
SAG_OF_BOUND = 0.05   # polygons around the finished cam are this fine, in parts of the bound of the finishing pass
LEAST_SAG, MOST_SAG = 1e-5, 1e-3  # mm
CHORDS = 32           # of an arc, to compare it with the room for clamps
FILLS = Fraction(1, 1000)         # mm: a cutter this much narrower than a groove finishes it in one pass


# -- the finishing pass

def lowest_stretches(moves):
    """Feeds at the lowest depth, in stretches of moves one after the other."""
    depths = [z for move in moves for z in (move.start[2], move.end[2]) if z is not None]
    if not depths or min(depths) >= TOP:
        raise Refuted("no move goes below the cam's upper face")
    deepest, stretches, joined = min(depths), [], False
    for move in moves:
        is_low = move.kind != 0 and move.is_known() and move.start[2] == move.end[2] == deepest
        if is_low and joined:
            stretches[-1].append(move)
        elif is_low:
            stretches.append([move])
        joined = is_low
    return stretches


def closed_part(stretch):
    """The moves of the longest closed path."""
    first, best = {}, None
    for i, move in enumerate(stretch):
        first.setdefault(move.wanted[0], i)
        begin = first.get(move.wanted[1])
        if begin is not None and (best is None or i - begin > best[1] - best[0]):
            best = begin, i
    if best is None:
        raise Refuted(f"the finishing pass, lines {stretch[0].line} to {stretch[-1].line}, is not closed")
    return stretch[best[0]:best[1] + 1]


def segment_of(move, backwards):
    start, end = (move.end, move.start) if backwards else (move.start, move.end)
    if move.kind == 1:
        return straight(move.line, start[:2], end[:2])
    return around(move.line, start[:2], end[:2], move.center, (move.kind == 3) != backwards)


def departure_of_pass(cam, places, stretch):
    moves = [move for move in closed_part(stretch) if move.moves_in_plane()]
    backwards = places.are_against([doubles(move.start) for move in moves])
    segments = [segment_of(move, backwards) for move in (reversed(moves) if backwards else moves)]
    if not backwards:  # a block states where its move ends
        for before, segment in zip(segments[-1:] + segments, segments):
            segment.start_line = before.line
    gap = math.dist(doubles(segments[-1].end), doubles(segments[0].start))
    rounded = ROUNDING if any(move.wanted[0] != move.start[:2] for move in moves) else 0.0
    if segments[-1].end != segments[0].start:  # under cutter compensation, by printed digits
        segments.append(straight(segments[-1].line, segments[-1].end, segments[0].start))
    bound, place = largest_departure(cam, segments, places.along([doubles(segment.start) for segment in segments]), places.offset)
    return bound + gap + rounded, place


def finishing_departure(cam, program):
    """(bound, where) over the finishing passes."""
    stretches = lowest_stretches(program.moves)
    if not stretches:
        raise Refuted("no feed at the lowest depth")
    if cam.form != "grooved":
        return departure_of_pass(cam, Places(cam, program.radius + program.stock), stretches[-1])
    half = cam.roller + cam.clearance / 2
    room = half - program.radius - program.stock
    if abs(room) <= FILLS:
        bound, place = departure_of_pass(cam, Places(cam, cam.roller), stretches[-1])
        return bound + float(abs(room)) * (1 + 1e-15), place
    found = []  # the paths along both flanks are parts of the last two stretches, in either order
    for offset in (cam.roller - room, cam.roller + room):
        places = Places(cam, offset)
        nearest = min(stretches[-2:], key=lambda own: places.distance(doubles(own[len(own) // 2].start)))
        found.append(departure_of_pass(cam, places, nearest))
    return max(found)


# -- all moves

def enters_clamps(program, move):
    """Whether the cutter may enter the cylinder that the program leaves to clamps."""
    heights = [point[2] for point in (move.start, move.end) if point[2] is not None]
    if program.clamps is None or (heights and min(heights) >= program.clamps[1]):
        return False
    if not move.is_known():
        return True
    axis, start, end = (0.0, 0.0), doubles(move.start), doubles(move.end)
    least = float(program.radius + program.clamps[0])
    if move.kind in (2, 3):
        arc = Arc(start, end, doubles(move.center), move.kind == 3)
        points, less = [arc.at(i / CHORDS) for i in range(CHORDS + 1)], arc.sag(1 / CHORDS)
    else:  # each axis of a rapid runs at its own speed
        points, less = [start, (end[0], start[1]), end, (start[0], end[1]), start] if move.kind == 0 else [start, end], 0.0
        if move.kind == 0 and all(min(a, b) < 0 < max(a, b) for a, b in zip(start, end)):
            return True
    return min(point_to_line(axis, a, b) for a, b in zip(points, points[1:])) - less < least


def rapid_in_blank(program, move):
    """A rapid whose tip may enter the blank, which removed material belongs to."""
    if program.blank is None or move.kind != 0 or not move.is_known():
        return False
    radius, _, top = program.blank
    if min(move.start[2], move.end[2]) >= top:
        return False
    x, y = (0 if min(a, b) <= 0 <= max(a, b) else min(abs(a), abs(b)) for a, b in zip(move.start[:2], move.end[:2]))
    return x * x + y * y < (radius + program.radius)**2


def low_moves(moves):
    """Those with the tip below the cam's upper face. Only the first move may start at an unknown height, along z alone."""
    found = []
    for i, move in enumerate(moves):
        if move.end[2] is None or (move.start[2] is None and (i or move.moves_in_plane())):
            raise Refuted(f"line {move.line}: a move at an unknown height")
        if move.end[2] < TOP or (move.start[2] is not None and move.start[2] < TOP):
            found.append(move)
    return found


def walls_of(cam, sag):
    if cam.form != "grooved":
        return [Wall(cam, Fraction(0), sag)]
    half = cam.clearance / 2
    return [Wall(cam, -half, sag), Wall(cam, 2 * cam.roller + half, sag, outside=False)]


def is_second(text):
    """Whether a program of a conjugate cam says that it is for the second disk: the first comment, its title."""
    title = next((line for line in text.splitlines() if line.startswith(("(", ";"))), "")
    return title.removesuffix(")").endswith(", second disk")


def verify(text, scene, design, second=None):
    """The Outcome of a program: "profile_mm" of the finishing pass, "gouge_mm" of all moves. `second`: whether it is for the
    second disk of a conjugate cam; None: as its title says."""
    if scene.get("cam", {}).get("type") in ("barrel", "cylindrical"):
        return groove_nc.verify(text, scene, design)
    if scene.get("cam", {}).get("type") == "linear":
        return plate_nc.verify(text, scene, design, sys.modules[__name__])
    cam = PlaneCam(scene, design, is_second(text) if second is None else second)
    if cam.motion.is_open:
        raise Unverified("a program of a cam that is not closed")
    program = Program(text)
    if len(program.axes.letters) != 3:
        raise Unverified("a program for another machine than three axes")
    outcome = Outcome(stated=", ".join(program.words_of_stock()))
    profile, place = finishing_departure(cam, program)
    outcome.bounds["profile_mm"], outcome.places["profile_mm"] = profile, place
    sag = min(MOST_SAG, max(LEAST_SAG, SAG_OF_BOUND * profile))
    gouges = Gouges(cam, program.radius, walls_of(cam, sag))
    for move in sorted(low_moves(program.moves), key=lambda own: own.kind in (2, 3)):  # arcs last: a known depth saves dividing them
        gouges.look_at(move)
    outcome.bounds["gouge_mm"], outcome.places["gouge_mm"] = gouges.largest, gouges.place
    outcome.faults += [f"line {move.line}: a rapid through the blank" for move in program.moves if rapid_in_blank(program, move)]
    outcome.faults += [f"line {move.line}: enters the room for clamps" for move in program.moves if enters_clamps(program, move)]
    if cam.form == "grooved":
        check_floor(program, outcome)
    return outcome


def check_floor(program, outcome):
    """The tip stays above the floor of the groove that the program states."""
    if program.groove_depth is None:
        outcome.unverified.append("the depth of the groove, which the program does not state")
        return
    for move in program.moves:
        if move.end[2] is not None and move.end[2] < -program.groove_depth:
            outcome.faults.append(f"line {move.line}: below the floor of the groove")
