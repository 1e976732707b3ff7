# SPDX-License-Identifier: MIT
"""cam.nc of a three-dimensional cam: four axes, or five where the follower rotates.

- The finishing pass, or that of either flank: the passes that come last. Of each the longest part in which the table turns one way
  is compared with the path of the cutter's axis; it must go around the whole cam, of an indexing cam from outside of the
  blank to outside.
- Every feed against the finished cam, which is the blank less all places of the roller (groove_feed.py).
- Rapids above the blank, in any order of the axes; moves outside of the room for clamps.
"""
import math
import re

from certificate_checker.enclosures import ONE
from certificate_checker.exact import Refuted, Unverified

from certificate_checker.rational import Fraction
from .clearance import ROUNDING
from .groove_feed import GrooveFeed
from .nc_reader import Program
from .outcome import Outcome
from .refine import largest
from .spatial_cam import SpatialCam
from .table_stands import Blank, Stand, lowest_between, stay_clear

LOWERED = re.compile(r"[(;]offset: (-?\d+(?:\.\d+)?(?:e[+-]?\d+)?) mm are subtracted from Z")
CLAMPED = re.compile(r"[(;]fixture: the cam is clamped at both ends within diameter (\d+(?:\.\d+)?) mm about its axis"
                     r"(?:, at most (\d+(?:\.\d+)?) mm from its centre)?")
FILLS = Fraction(1, 1000)        # mm: a cutter this much narrower than the roller finishes the groove in one pass
PRINTED = Fraction(1, 10**5)     # of a revolution: digits of a turn
MOST_PARTS = 20000               # that are divided
SHORTEST = (ONE >> 40) + 1       # likewise the least
NEIGHBOURS = range(-3, 4)        # revolutions in which a roller of an indexing cam is searched


def largest_of(parts, bounds, degrees):
    """(an upper bound of what `bounds(part)` encloses over all parts, its place)."""
    found = [(*bounds(part), part) for part in parts]
    return largest([(upper, part) for upper, _, part in found], max((there for _, there, _ in found), default=0.0), bounds,
                   lambda part: f"line {part.feed.move.line}, {degrees(part.middle()):.4f} deg", len(found) + MOST_PARTS, SHORTEST)


class GrooveProgram:
    def __init__(self, text, scene, design):
        self.cam, self.program = SpatialCam(scene, design), Program(text)
        if len(self.program.axes.letters) != (5 if self.cam.tilts else 4):
            raise Unverified("a program for another machine than " + ("five axes" if self.cam.tilts else "four axes"))
        lowered, clamped = LOWERED.search(text), CLAMPED.search(text)
        self.z_offset = Fraction(lowered[1]) if lowered else Fraction(0)
        if self.program.blank is None:
            raise Unverified("a program that does not state its blank")
        self.blank = Blank(*self.program.blank)
        self.clamps = Fraction(clamped[1]) / 2 if clamped else None
        self.clamps_reach = math.hypot(self.clamps, Fraction(clamped[2])) + ROUNDING if clamped and clamped[2] else math.inf
        self.radius, self.moves = self.program.radius, self.program.moves
        if not any(move.kind == 1 for move in self.moves):
            raise Refuted("a program without feeds")
        for move in self.moves:
            if self.cam.tilts and move.end[4] is not None and abs(move.end[4]) >= 90:
                raise Refuted(f"line {move.line}: a tilt of {float(move.end[4]):g} deg")

    def set_up(self):
        words = [f"cutter of diameter {float(2 * self.radius):g} mm", f"blank of diameter {2 * self.blank.radius:g} mm from "
                 f"{self.blank.lower:g} to {self.blank.upper:g} mm"]
        words += [f"{float(self.z_offset):g} mm subtracted from Z"] if self.z_offset else []
        words += self.program.words_of_stock()
        return ", ".join(words + ([f"clamps within diameter {float(2 * self.clamps):g} mm"] if self.clamps else ["no room for clamps"]))

    def stand(self, position):
        """None where an axis has no value yet."""
        return None if None in position else Stand(position, self.z_offset, self.radius)

    # -- the groove

    def feed_at(self, move, turns):
        places = [self.cam.place(own[3]) + self.cam.motion.turn * turns for own in (move.start, move.end)]
        return GrooveFeed(self.cam, move, places, self.z_offset, self.blank.reach)

    def passes_ends(self, move, turns):
        """By how much, in the unit of x, a feed passes the ends of a groove that ends."""
        feed = self.feed_at(move, turns)
        return 0 if self.cam.indexes else max(-feed.begin, -feed.end, feed.begin - self.cam.motion.turn, feed.end - self.cam.motion.turn, 0)

    def followed(self):
        """(the parts of all feeds that may cut, each in the revolution in which it is nearest to the roller; faults)."""
        found, faults, known = [], [], None
        for move in self.moves:
            if move.kind == 0:
                known = None
                continue
            if not move.is_known():
                raise Refuted(f"line {move.line}: a feed from an unknown position")
            known = self.nearest_turn(move, known)
            if stay_clear(self.stand(move.start), self.stand(move.end), self.blank):
                continue
            if known is None:
                faults.append(f"line {move.line}: a feed beyond the ends of the groove")
                continue
            found += self.feed_at(move, known).parts()
        return found, faults

    def nearest_turn(self, move, known):
        """Revolutions to add to the turn of the table; None: the roller never stands there."""
        motion = self.cam.motion
        first = -math.floor(self.cam.place(move.start[3]) / motion.turn)
        if motion.closes:
            return first
        if known is not None and self.cam.indexes:
            return known

        def distance(turns):
            return self.feed_at(move, turns).parts(0, 1)[0].depth_bounds(self.radius)[1]
        beyond = {first + k: self.passes_ends(move, first + k) for k in NEIGHBOURS}
        if 0 < min(beyond.values()) < PRINTED * motion.turn:
            raise Unverified(f"line {move.line}: a turn that printed digits put beyond the end of the groove")
        return min((turns for turns, by in beyond.items() if not by), key=distance, default=None)

    # -- the finishing passes

    def passes(self):
        """Feeds between rapids."""
        found, feeding = [], False
        for move in self.moves:
            if move.kind == 1 and not feeding:
                found.append([])
            feeding = move.kind == 1
            if feeding:
                found[-1].append(move)
        return found

    @staticmethod
    def longest_turn(moves):
        """The moves with the largest total turn one way, one after the other."""
        begin, sense, most, best = 0, 0, 0, None
        for i, move in enumerate(moves):
            by = move.end[3] - move.start[3]
            if by and by * sense <= 0:
                begin, sense = i, by
            if by and abs(move.end[3] - moves[begin].start[3]) > most:
                most, best = abs(move.end[3] - moves[begin].start[3]), moves[begin:i + 1]
        if not best:
            raise Refuted(f"line {moves[0].line}: a finishing pass in which the table does not turn")
        return best

    def departure_of_pass(self, moves, offsets):
        """(offset that fits, bound, where)."""
        run = self.longest_turn(moves)
        words = f"the finishing pass, lines {run[0].line} to {run[-1].line},"
        ends = [self.cam.place(run[0].start[3]), self.cam.place(run[-1].end[3])]
        motion, middle = self.cam.motion, run[len(run) // 2]

        def error(turns, offset):
            return self.feed_at(middle, turns).parts(0, 1)[0].path_bounds(offset)[1]
        first = -math.floor(min(ends) / motion.turn + (0 if motion.closes else PRINTED))
        if self.cam.indexes:
            turns, offset = min(((first + k, own) for k in NEIGHBOURS for own in offsets), key=lambda own: error(*own))
            window = -math.inf, math.inf
            if not all(self.stand(end).is_clear_of(self.blank) for end in (run[0].start, run[-1].end)):
                raise Refuted(f"{words} does not lead from outside of the blank to outside")
        else:
            turns, offset = first, min(offsets, key=lambda own: error(first, own))
            low, high = (end + first * motion.turn for end in sorted(ends))
            begin = low if low == 0 or (motion.closes and high - low == motion.turn) else motion.turn if motion.closes else Fraction(0)
            window = begin, begin + motion.turn
            missing = max(low - begin, window[1] - high)
            if missing >= PRINTED * motion.turn:
                raise Refuted(f"{words} does not go around the whole cam")
            if missing > 0:
                raise Unverified(f"{words} which by printed digits of the turn ends before the groove")
        parts = [part for move in run for part in self.parts_within(self.feed_at(move, turns), *window)]
        return offset, *largest_of(parts, lambda part: part.path_bounds(offset), self.cam.degrees)

    @staticmethod
    def parts_within(feed, low, high):
        """Those between two places, all of a feed that does not turn there."""
        if low == -math.inf or (low <= min(feed.begin, feed.end) and max(feed.begin, feed.end) <= high):
            return feed.parts()
        if max(feed.begin, feed.end) <= low or min(feed.begin, feed.end) >= high:
            return []
        ends = sorted(min(max((x - feed.begin) / (feed.end - feed.begin), Fraction(0)), Fraction(1)) for x in (low, high))
        return feed.parts(math.floor(ends[0] * ONE), math.ceil(ends[1] * ONE))

    def finishing_departure(self):
        room = self.cam.radius - self.radius - self.program.stock
        if abs(room) <= FILLS:
            _, bound, place = self.departure_of_pass(self.passes()[-1], [Fraction(0)])
            return bound + float(abs(room)) * (1 + 1e-15), place
        if room < 0:
            raise Refuted("the cutter is wider than the roller")
        found = [self.departure_of_pass(moves, [room, -room]) for moves in self.passes()[-2:]]
        if len({offset for offset, _, _ in found}) < 2:
            raise Refuted("the last two passes do not finish both flanks")
        return max(own[1:] for own in found)

    # -- everything

    def verified(self):
        outcome = Outcome(stated=self.set_up())
        outcome.bounds["path_mm"], outcome.places["path_mm"] = self.finishing_departure()
        parts, outcome.faults = self.followed()
        outcome.bounds["gouge_mm"], outcome.places["gouge_mm"] = largest_of(parts, lambda part: part.depth_bounds(self.radius), self.cam.degrees)
        outcome.faults += [f"line {move.line}: a rapid that may enter the blank" for i, move in enumerate(self.moves)
                           if move.kind == 0 and not self.is_above(move, i == 0)]
        if self.clamps is not None:
            outcome.faults += [f"line {move.line}: enters the room for clamps" for move in self.moves if self.may_touch_clamps(move)]
        return outcome

    def may_touch_clamps(self, move):
        """Rapids pass above the blank; where the table tilts, above what clamps may reach at any angle, or z moves alone."""
        if move.kind == 0:
            z = [z for z in (move.start[2], move.end[2]) if z is not None]
            if not self.cam.tilts or (z and min(z) + self.z_offset >= self.clamps_reach):
                return False
            if not move.is_known() or any(k != 2 and a != b for k, (a, b) in enumerate(zip(move.start, move.end))):
                return True
        return lowest_between(self.stand(move.start), self.stand(move.end)) < self.clamps

    def is_above(self, move, is_first):
        """Each axis of a rapid runs at its own speed: z alone decides, at any angle of the table or at the one at which it stands. The
        first move may begin anywhere, along z alone."""
        (z, z1), others = (move.start[2], move.end[2]), [k for k in range(len(move.end)) if k != 2 and move.start[k] != move.end[k]]
        if z1 is None or (z is None and (others or not is_first)):
            return False
        lowest = (z1 if z is None else min(z, z1)) + self.z_offset
        if lowest >= (self.blank.reach if self.cam.tilts else self.blank.radius):
            return True
        return not others and move.is_known() and self.stand(move.end).is_over(self.blank) and self.stand(move.start).is_over(self.blank)


def verify(text, scene, design):
    """The Outcome of a program: "path_mm" of the finishing pass, "gouge_mm" of all feeds."""
    return GrooveProgram(text, scene, design).verified()
