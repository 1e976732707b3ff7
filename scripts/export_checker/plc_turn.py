# SPDX-License-Identifier: MIT
"""The designed slave over the master position, one revolution, and how far a table is from it.

Stretches are polynomials (begin, end, [c0, c1, …], left) like the pieces of a table (plc_tables.py): the delivered splines and dwells as they
are, laws as their Taylor polynomials about the middle of each stretch. `left`: by how much each derivative of a law may differ from
that of its polynomial, for orders 0 to 3.
"""
import math

from certificate_checker.enclosures import ends_of
from certificate_checker.exact import Refuted, Unverified, combination, derivative, largest_magnitude, middle_of, number, shifted
from certificate_checker.laws import along, constant, harmonic, polynomials_of
from certificate_checker.rational import Fraction
from certificate_checker.units import RADIAN, angle_of

SAME_JOINT = Fraction(1, 10**9)  # deg: what rounding makes of one joint
NOTHING = (Fraction(0),) * 4
SMALL = Fraction(1, 10**24)      # of a lift: what a Taylor polynomial may leave
MOST_TERMS = 40
ROUNDED_UP = 1 + 1e-9  # a sum of doubles is never above its exact value by more


class LawPiece:
    """Of a law: f'' = a + sum of b sin w v + c cos w v (laws.py), or a polynomial, v from its begin."""

    def __init__(self, width, polynomial=None, piece=None):
        self.width, self.polynomial = width, polynomial
        if piece:
            self.waves, self.states = piece[2], along(*piece)

    def taylor(self, at, reach):
        """(coefficients about a place, what each derivative may differ within `reach` of it), of v."""
        if self.polynomial is not None:
            return shifted(self.polynomial, at), NOTHING
        v, terms = constant(at), []
        for w, b, c in self.waves:
            sine, cosine = (w * v).sine_and_cosine()
            terms.append((w, w * (b * cosine - c * sine), -w * (b * sine + c * cosine)))
        return self.series(self.states(v)[:3], terms, reach)

    @staticmethod
    def series(states, terms, reach):
        """`terms`: (w, the third derivative of a wave, and what is w times less than the fourth)."""
        sizes = [(max(map(abs, ends_of(w))), sum(max(map(abs, ends_of(part))) for part in parts)) for w, *parts in terms]
        coefficients, loose, factorial = [], [Fraction(0)] * 4, 1
        for order in range(MOST_TERMS):
            factorial *= max(order, 1)
            if order > 2:
                states.append(sum((following for _, following, _ in terms), constant(0)))
                terms = [(w, w * after, -w * following) for w, following, after in terms]
            value, radius = middle_of(ends_of(states[order]))
            coefficients.append(value / factorial)
            for r in range(min(order, 3) + 1):
                loose[r] += radius * reach**(order - r) / math.factorial(order - r)
            rest = sum(size * w**(order - 2) for w, size in sizes)  # of the derivative of the next order
            left = [rest * reach**(order + 1 - r) / math.factorial(order + 1 - r) for r in range(min(4, order + 1))]
            if order > 3 and max(left) < SMALL:
                return coefficients, tuple(a + b for a, b in zip(left, loose))
        raise Unverified("a law whose Taylor polynomial is too long")


def law_pieces(law):
    polynomials = polynomials_of(law)
    if polynomials is not None:
        return [LawPiece(width, polynomial) for width, polynomial in polynomials]
    return [LawPiece(piece[0], piece=piece) for piece in harmonic(law)]


class Stretch:
    """s = base + size · f((θ − origin) / scale), f a polynomial of t = argument − `at`, or a piece of a law; origin and scale in degrees."""

    def __init__(self, begin, end, origin, scale, base, size, shape, at):
        self.begin, self.end, self.origin, self.scale, self.base, self.size = begin, end, origin, scale, base, size
        self.shape, self.at = shape, at

    def about(self, begin, end):
        """(coefficients over t = θ − begin, what each derivative may differ) between two places of it."""
        middle = (begin + end) / 2
        argument = (middle - self.origin) / self.scale - self.at
        if isinstance(self.shape, LawPiece):
            own, left = self.shape.taylor(argument, abs((end - begin) / self.scale) / 2)
        else:
            own, left = shifted(self.shape, argument), NOTHING
        moved = shifted([self.size * c / self.scale**k for k, c in enumerate(own)], begin - middle)
        moved[0] += self.base
        return moved, tuple(abs(self.size / self.scale**r) * part for r, part in enumerate(left))


def part_stretches(part, curves, per_x, lift):
    """Of one part of the motion in result.json."""
    x0, scale, y0, y_scale = (number(part[name]) for name in ("x0", "x_scale", "y0", "y_scale"))
    origin, by, base, size = x0 * per_x, scale * per_x, y0 * lift, y_scale * lift
    if part["curve"] is None and part["law"] is None:
        return [Stretch(number(part["begin"]) * per_x, number(part["end"]) * per_x, origin, by, base, Fraction(0), [Fraction(0)], Fraction(0))]
    if part["curve"] is not None:
        curve = curves[part["curve"]]
        breaks = [number(x) for x in curve["breakpoints"]]
        shapes = [[number(c) for c in piece] for piece in curve["pieces"]]
    else:
        shapes = law_pieces(part["law"])
        breaks = [Fraction(0)]
        for piece in shapes:
            breaks.append(breaks[-1] + piece.width)
    found = []
    for begin, end, shape in zip(breaks, breaks[1:], shapes):
        ends = sorted((origin + by * begin, origin + by * end))
        found.append(Stretch(*ends, origin, by, base, size, shape, begin))
    return sorted(found, key=lambda own: own.begin)


def phase_of(problem):
    """Degrees of the master, where the motion begins."""
    value, unit = angle_of(problem.motion, "phase") or (Fraction(0), "deg")
    return value if unit == "deg" else value * RADIAN


def by_master(stretches, phase):
    """The same over the master, which is at `phase` (deg) where the motion begins: from its angle 0 on. What lies before the beginning of
    a motion that advances counts from the same displacement."""
    cut = -phase % 360  # the motion's own angle there
    if cut < SAME_JOINT or cut > 360 - SAME_JOINT:
        return stretches

    def value(stretch, begin, end, at):
        return sum(c * at**k for k, c in enumerate(stretch.about(begin, end)[0]))

    first, last = stretches[0], stretches[-1]
    travel = value(last, last.begin, last.end, last.end - last.begin) - value(first, first.begin, first.end, Fraction(0))
    early, late = [], []
    for own in stretches:
        for parts, begin, end, by, down in ((early, max(own.begin, cut), own.end, -cut, travel),
                                            (late, own.begin, min(own.end, cut), 360 - cut, Fraction(0))):
            if begin < end:
                parts.append(Stretch(begin + by, end + by, own.origin + by, own.scale, own.base - down, own.size, own.shape, own.at))
    return early + late


def whole_turn(motion, problem, per_x, lift):
    """The stretches of the delivered motion over 360 degrees of the master; where it ends earlier the slave rests."""
    stretches = [own for part in motion["parts"] for own in part_stretches(part, motion["curves"], per_x, lift)]
    end = stretches[-1].end
    if end < 360 - SAME_JOINT:
        coefficients, _ = stretches[-1].about(end - SAME_JOINT, end)
        level = Fraction(0) if problem.type == "RR" else sum(c * SAME_JOINT**k for k, c in enumerate(coefficients))
        stretches.append(Stretch(end, Fraction(360), Fraction(0), Fraction(1), level, Fraction(0), [Fraction(0)], Fraction(0)))
    return by_master(stretches, phase_of(problem))


def common(stretches, pieces, last):
    """(begin, end, stretch, number of the piece) between the joints of both; the table must go from 0 to the last angle."""
    reached = Fraction(0)
    for i, (begin, end, _) in enumerate(pieces):
        if abs(begin - reached) > SAME_JOINT or end <= begin:
            raise Refuted(f"row {i + 1}: from {float(begin)} to {float(end)} deg, the row before it ends at {float(reached)} deg")
        reached = end
    if abs(reached - last) > SAME_JOINT:
        raise Refuted(f"row {len(pieces)}: the table ends at {float(reached)} deg")
    merged = [Fraction(0)]
    for joint in sorted([s.begin for s in stretches] + [p[0] for p in pieces]) + [last]:
        if merged[-1] + SAME_JOINT < joint <= last:
            merged.append(joint)
    own = other = 0
    for begin, end in zip(merged, merged[1:]):
        middle = (begin + end) / 2
        while own + 1 < len(stretches) and stretches[own].end <= middle:
            own += 1
        while other + 1 < len(pieces) and pieces[other][1] <= middle:
            other += 1
        yield begin, end, stretches[own], other


class Departure:
    """The differences of a table from the motion: polynomials over t from `begin`, in the unit of the slave by degrees."""

    def __init__(self, stretches, pieces, last=Fraction(360)):
        self.parts = []  # (begin, width, difference, what a law leaves, number of the piece)
        for begin, end, stretch, index in common(stretches, pieces, last):
            own, left = stretch.about(begin, end)
            table = shifted(list(pieces[index][2]), begin - pieces[index][0])
            self.parts.append((begin, end - begin, combination((1, table), (-1, own)), left, index))

    def largest(self, order, unit):
        """(low, high, words for the place) of the largest magnitude of that order; `unit`: about its size."""
        sized = []
        for part in self.parts:
            polynomial = [c / unit for c in derivative(part[2], order)]
            reach = float(part[1])
            most = sum(abs(float(c)) * reach**k for k, c in enumerate(polynomial)) + float(part[3][order] / unit)
            sized.append((most * ROUNDED_UP, polynomial, part))
        sized.sort(key=lambda own: -own[0])
        low, high, worst = Fraction(-1), Fraction(0), sized[0][2]
        for most, polynomial, part in sized:
            if most <= low:  # so are all that follow
                break
            found = largest_magnitude([(polynomial, part[1])])
            left = part[3][order] / unit
            if found[0] - left > low:
                low, worst = found[0] - left, part
            high = max(high, found[1] + left)
        begin, width, index = worst[0], worst[1], worst[4]
        return low * unit, high * unit, f"row {index + 1}, {float(begin):.6g} to {float(begin + width):.6g} deg"
