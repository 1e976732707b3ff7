# SPDX-License-Identifier: MIT
"""cam.nc: the moves of a program for three to five axes, read word by word.

The control is modelled by the words that post-processors write, in mm or inches. Any other word is refused or
left unverified, since it might move the axes. Lengths are exact decimals in mm, those of the axes as the header states them (axes.py). Comments are in brackets, or lines that begin
with a semicolon.
"""
import re

from certificate_checker.exact import Refuted, Unverified

from .axes import Axes
from certificate_checker.rational import Fraction
from .compensation import compensated
from .moves import Move

WORD = re.compile(r"\s*([A-Z])\s*([+-]?(?:\d+\.?\d*|\.\d+))")
COMMENT = re.compile(r"\([^()]*\)|^;.*")
TOOL = re.compile(r"[(;]tool: cylindrical end mill, diameter (\d+(?:\.\d+)?(?:e[+-]?\d+)?) mm\b")
BLANK = re.compile(r"[(;]blank: cylinder about the axis of the cam, diameter (\d+(?:\.\d+)?) mm, from (-?\d+(?:\.\d+)?) to (-?\d+(?:\.\d+)?) mm ")
MILLIMETRES = r"(-?\d+(?:\.\d+)?)"
BLOCK = re.compile(r"[(;]blank: block, " + ", ".join(f"{axis} from {MILLIMETRES} to {MILLIMETRES} mm" for axis in "xyz"))
HELD = re.compile(rf"[(;]fixture: the plate is held below y = {MILLIMETRES} mm, clamps lie at most {MILLIMETRES} mm above the blank")
REGISTER = re.compile(r"[(;]compensation: .*, register D(\d+) holds the cutter's radius of (\d+(?:\.\d+)?) mm")
PRINTED = Fraction(1, 10**4)        # mm: of that radius
CLAMPS = re.compile(r"[(;]fixture: .*clamps lie within diameter (\d+(?:\.\d+)?) mm about its axis, at most (\d+(?:\.\d+)?) mm above the blank")
STOCK = re.compile(r"[(;]stock: (\d+(?:\.\d+)?(?:e[+-]?\d+)?) mm are left on the finished surface")
GROOVE = re.compile(r"[(;]the groove, \d+(?:\.\d+)? mm wide, (\d+(?:\.\d+)?) mm deep,")
PLAIN = {17, 49, 80, 93, 94}        # XY plane, no compensation of the tool's length, no cycle, either way to state a feed
ORIGINS = range(54, 60)             # one of them before the first move: coordinates count from the machine's zero of this job
UNITS = {20: Fraction(254, 10), 21: Fraction(1)}
MOTIONS = {0, 1, 2, 3}
HARMLESS_M = {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 30}
HARMLESS = set("FSTNO")             # feed, speed, tool, number of block and program


class Program:
    """`axes`, by which the moves are those of the cam; `moves` of the cutter's centre; `radius` of the cutter; `blank`: (radius, from, to)
    along z, or None; `stock`: left on the surface. `groove_depth`, or None. `clamps`: (radius about the cam's axis, z up to which they may reach), or None.
    `bar`: the block of a plate, from and to along x, y, z, or None; `held`: (y up to which clamps may hold it, z likewise), or None. `side`: 1
    under G41, -1 under G42; `programmed`: the moves there so far."""

    def __init__(self, text):
        tools, blank = TOOL.findall(text), BLANK.search(text)
        self.axes = Axes(text)
        if len(tools) != 1:
            raise Unverified("a program that does not state the diameter in mm of one cutter")
        self.radius = Fraction(tools[0]) / 2
        stock = STOCK.search(text)
        self.stock = Fraction(stock[1]) if stock else Fraction(0)
        groove = GROOVE.search(text)
        self.groove_depth = Fraction(groove[1]) if groove else None
        self.blank = (Fraction(blank[1]) / 2, Fraction(blank[2]), Fraction(blank[3])) if blank else None
        clamps = CLAMPS.search(text)
        self.clamps = (Fraction(clamps[1]) / 2, self.blank[2] + Fraction(clamps[2])) if clamps and self.blank else None
        bar, held = BLOCK.search(text), HELD.search(text)
        self.bar = tuple(map(Fraction, bar.groups())) if bar else None
        self.held = (Fraction(held[1]), self.bar[5] + Fraction(held[2])) if held and self.bar else None
        self.unit, self.absolute, self.kind, self.ended = None, None, None, False
        self.position, self.moves = [None] * len(self.axes.letters), []
        self.register, self.side, self.last_side, self.programmed = REGISTER.search(text), 0, 0, []
        for i, line in enumerate(text.splitlines()):
            self.read(i + 1, line)
        if not self.ended:
            raise Refuted("the program does not end with M2 or M30")
        if self.programmed:
            raise Refuted(f"line {self.programmed[-1].line}: no G40 ends the cutter compensation")

    def words_of_stock(self):
        return [f"{float(self.stock):g} mm left as stock"] if self.stock else []

    def read(self, line, text):
        code = COMMENT.sub(" ", text).strip()
        if code in ("", "%"):
            return
        if self.ended:
            raise Refuted(f"line {line}: {code!r} after the end of the program")
        words, place = [], 0
        while place < len(code):
            found = WORD.match(code, place)
            if not found:
                raise Refuted(f"line {line}: {code[place:]!r} is not a word")
            words.append((found[1], Fraction(found[2])))
            place = found.end()
        self.block(line, words)

    def block(self, line, words):
        values, registers = {}, 0
        for letter, value in words:
            if letter == "G":
                self.mode(line, value)
            elif letter == "M":
                if value not in HARMLESS_M:
                    raise Refuted(f"line {line}: M{float(value):g} is not known")
                self.ended |= value in (2, 30)
            elif letter == "R":
                raise Unverified(f"line {line}: R (an arc by its radius)")
            elif letter == "D":
                registers += 1
                stated = self.register and abs(Fraction(self.register[2]) - self.radius) <= PRINTED
                if not stated or int(self.register[1]) != value:
                    raise Unverified(f"line {line}: a register D that the program does not state to hold the cutter's radius")
            elif letter in "IJ" or letter in self.axes.letters:
                if letter in values:
                    raise Refuted(f"line {line}: {letter} twice")
                values[letter] = value
            elif letter not in HARMLESS:
                raise Refuted(f"line {line}: {letter} is not known")
        if registers != sum(own in (("G", 41), ("G", 42)) for own in words) or registers > 1:
            raise Refuted(f"line {line}: G41 or G42 without its register D, or D alone")
        if values:
            self.move(line, values)

    def mode(self, line, value):
        if value in MOTIONS:
            self.kind = int(value)
        elif value in UNITS:
            self.unit = UNITS[int(value)]
        elif value in (90, 91):
            self.absolute = value == 90
        elif value in (40, 41, 42):
            if self.programmed and value != 40:
                raise Unverified(f"line {line}: G{value} under cutter compensation")
            self.side = {40: 0, 41: 1, 42: -1}[int(value)] * (-1 if self.axes.mirrored else 1)
            if self.side:
                self.require_plane(line)
        elif value in ORIGINS:
            if self.moves:
                raise Refuted(f"line {line}: G{value} changes the origin after the first move")
        elif value not in PLAIN:
            raise Refuted(f"line {line}: G{float(value):g} is not known")

    def move(self, line, values):
        if self.unit is None or self.absolute is None or self.kind is None:
            raise Refuted(f"line {line}: a move before units (G20, G21), G90 or G91, and a kind of motion are set")
        start, end = self.position, list(self.position)
        for k, letter in enumerate(self.axes.letters):
            if letter in values:
                by = values[letter] * (self.unit if k < 3 else 1)
                if not self.absolute and start[k] is None:
                    raise Refuted(f"line {line}: a step from an unknown position")
                end[k] = self.axes.value(k, by) if self.absolute else start[k] + self.axes.signs[k] * by
        center, kind = None, self.kind
        if kind in (2, 3):
            self.require_plane(line)
            if None in start[:2]:
                raise Refuted(f"line {line}: an arc from an unknown position")
            center = tuple(start[k] + self.axes.signs[k] * values.get(letter, Fraction(0)) * self.unit for k, letter in enumerate("IJ"))
            kind = 5 - kind if self.axes.mirrored else kind
        elif "I" in values or "J" in values:
            raise Refuted(f"line {line}: I or J without an arc")
        self.add(Move(line, kind, start, end, center))
        self.position = end

    def require_plane(self, line):
        """Arcs and compensation are those of the plane X Y."""
        if self.axes.letters[:2] != ["X", "Y"] or len(self.axes.letters) > 3:
            raise Unverified(f"line {line}: an arc or cutter compensation where x and y are not the plane of X and Y alone")

    def add(self, move):
        if self.side:
            self.last_side = self.side
            self.programmed.append(move)
            return
        if self.programmed:  # the block with G40 begins where the compensated path ends
            if move.kind in (2, 3):
                raise Refuted(f"line {move.line}: G40 with an arc")
            self.moves += compensated(self.programmed, float(self.radius) * self.last_side)
            self.programmed = []
            move = Move(move.line, move.kind, (*self.moves[-1].end[:2], move.start[2]), move.end)
        self.moves.append(move)
