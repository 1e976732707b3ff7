# SPDX-License-Identifier: MIT
"""Where the values and the slopes of a formula lie over a box, and how low the formula goes there.

Ends of intervals are whole multiples of 2^-128, always rounded outward: quick, and nothing is lost by rounding.
"""
import math

from .exact import PI, Unverified
from .rational import Fraction

BITS = 128
ONE = 1 << BITS
GUARD = 32       # more bits for series, whose rounding is then below the last bit that is kept
MOST_PARTS = 20000
NARROW = ONE >> 10  # a box in which a formula must have a value


def interval(low, high=None):
    """The grid's interval around [low, high]."""
    high = low if high is None else high
    return low.numerator * ONE // low.denominator, -(-high.numerator * ONE // high.denominator)


def fraction(end):
    return Fraction(end, ONE)


def ends_of(value):
    """The ends of what is enclosed, as fractions."""
    return fraction(value.value[0]), fraction(value.value[1])


def multiplied(a, b):
    """By cases of the signs: two products instead of four, which are most of the time of a check."""
    a0, a1 = a
    b0, b1 = b
    if a0 >= 0:
        low = a0 * b0 if b0 >= 0 else a1 * b0
        high = a1 * b1 if b1 >= 0 else a0 * b1
    elif a1 <= 0:
        low = a0 * b1 if b1 >= 0 else a1 * b1
        high = a1 * b0 if b0 >= 0 else a0 * b0
    else:
        low, high = min(a0 * b1, a1 * b0), max(a0 * b0, a1 * b1)
    return low >> BITS, -(-high >> BITS)


def added(a, b):
    return a[0] + b[0], a[1] + b[1]


def inverted(a):
    """Of what is above 0."""
    if a[0] <= 0:
        raise Unverified("a formula that may divide by 0 in a box")
    return ONE * ONE // a[1], -(-ONE * ONE // a[0])


def rooted(a):
    if a[0] < 0:
        raise Unverified("a formula with the root of what may be below 0 in a box")
    return math.isqrt(a[0] << BITS), math.isqrt(a[1] << BITS) + 1


def sine_and_cosine(a):
    """Taylor's series in the middle m, and sin(m + d) = sin m cos d + cos m sin d, 1 - d^2/2 <= cos d <= 1,
    |sin d| <= |d|."""
    middle = (a[0] + a[1]) // 2
    if abs(middle) > 8 * ONE:  # without whole turns
        turn = interval(*(2 * end for end in PI))
        turns = middle // turn[0]
        a = added(a, multiplied((-turns * ONE,) * 2, turn))
        middle = (a[0] + a[1]) // 2
    x, unit = middle << GUARD, BITS + GUARD
    terms, term = [1 << unit], 1 << unit
    while term:
        term = abs(term * x >> unit) // len(terms)
        terms.append(term)
    sign = -1 if middle < 0 else 1

    def series(first):
        total = sum((1 if k % 4 < 2 else -1) * t for k, t in enumerate(terms) if k % 2 == first)
        return total - (1 << GUARD), total + (1 << GUARD)

    sine, cosine = [((low >> GUARD), -(-high >> GUARD)) for low, high in (series(1), series(0))]
    if sign < 0:
        sine = -sine[1], -sine[0]
    away = max(a[1] - middle, middle - a[0])
    turned = ONE - (away * away >> BITS + 1) - 1, ONE
    aside = -away, away
    return added(multiplied(sine, turned), multiplied(cosine, aside)), \
        added(multiplied(cosine, turned), multiplied((-sine[1], -sine[0]), aside))


def exponential(a):
    """exp of the 2^-k th part by Taylor's series, squared k times; exp rises."""
    ends = []
    for end in a:
        halvings = max(0, abs(end).bit_length() - BITS + 1)
        x, unit = (end << GUARD) >> halvings, BITS + GUARD
        total, term, n = 1 << unit, 1 << unit, 0
        while term > 1 or term < -1:
            n += 1
            term = (term * x >> unit) // n
            total += term
        value = (total - (1 << GUARD)) >> GUARD, -(-(total + (1 << GUARD)) >> GUARD)
        for _ in range(halvings):
            value = multiplied(value, value)
        ends.append(value)
    return ends[0][0], ends[1][1]


class Over:
    """A formula over a box: the interval of its values and, by variable, that of its slopes."""

    __slots__ = ("value", "slopes")

    def __init__(self, value, slopes=None):
        self.value, self.slopes = value, slopes or {}

    @staticmethod
    def number(low, high=None):
        return Over(interval(low, high))

    def __add__(self, other):
        slopes = dict(self.slopes)
        for i, slope in other.slopes.items():
            slopes[i] = added(slopes[i], slope) if i in slopes else slope
        return Over(added(self.value, other.value), slopes)

    def __neg__(self):
        return Over((-self.value[1], -self.value[0]), {i: (-s[1], -s[0]) for i, s in self.slopes.items()})

    def __sub__(self, other):
        return self + -other

    def __mul__(self, other):
        slopes = {i: multiplied(slope, other.value) for i, slope in self.slopes.items()}
        for i, slope in other.slopes.items():
            own = multiplied(slope, self.value)
            slopes[i] = added(slopes[i], own) if i in slopes else own
        return Over(multiplied(self.value, other.value), slopes)

    def through(self, value, slope):
        """A function of this, which has such values and such a slope."""
        return Over(value, {i: multiplied(slope, own) for i, own in self.slopes.items()})

    def square(self):
        a, b = self.value
        least = 0 if a <= 0 <= b else min(a * a, b * b) >> BITS
        return self.through((least, -(-max(a * a, b * b) >> BITS)), (2 * a, 2 * b))

    def inverse(self):
        value = inverted(self.value)
        square = multiplied(value, value)
        return self.through(value, (-square[1], -square[0]))

    def root(self):
        value = rooted(self.value)
        return self.through(value, inverted((2 * value[0], 2 * value[1])) if self.slopes else (0, 0))

    def exponential(self):
        value = exponential(self.value)
        return self.through(value, value)

    def sine_and_cosine(self):
        sine, cosine = sine_and_cosine(self.value)
        return self.through(sine, cosine), self.through(cosine, (-sine[1], -sine[0]))


def over_box(formula, box):
    """The formula with a variable for each interval that is one."""
    return formula([Over(ends, {i: (ONE, ONE)} if ends[0] < ends[1] else None) for i, ends in enumerate(box)])


def at_place(formula, place):
    return formula([Over((x, x)) for x in place])


class Complex:
    """re + i im, of numbers that are enclosed."""

    __slots__ = ("re", "im")

    def __init__(self, re, im):
        self.re, self.im = re, im

    def __add__(self, other):
        return Complex(self.re + other.re, self.im + other.im)

    def __sub__(self, other):
        return Complex(self.re - other.re, self.im - other.im)

    def __mul__(self, other):
        return Complex(self.re * other.re - self.im * other.im, self.re * other.im + self.im * other.re)

    def scaled(self, factor):
        return Complex(self.re * factor, self.im * factor)

    def square(self):
        """Of the magnitude."""
        return self.re.square() + self.im.square()

    def inverse(self):
        return Complex(self.re, -self.im).scaled(self.square().inverse())

    def exponential(self):
        size = self.re.exponential()
        sine, cosine = self.im.sine_and_cosine()
        return Complex(size * cosine, size * sine)


def tangent_at(formula, place):
    """The formula at a place, with its slopes there."""
    return formula([Over((x, x), {i: (ONE, ONE)}) for i, x in enumerate(place)])


def least(formula, box, enough):
    """What no value of the formula over the box lies below, at least `enough`; None where some place has less than that.
    The box is halved until it is decided.

    A part of the box is never halved along a variable in whose direction the formula rises or falls throughout: its
    least value lies on that side. What is left is bounded from its middle and its slopes."""
    stack, lowest, parts = [list(box)], None, 0
    while stack:
        part = stack.pop()
        parts += 1
        if parts > MOST_PARTS:
            raise Unverified("a plane that comes too near to its rule")
        try:
            found = over_box(formula, part)
        except Unverified:  # too wide a box for a quotient or a root
            worst = max(range(len(part)), key=lambda i: part[i][1] - part[i][0])
            if part[worst][1] - part[worst][0] < NARROW:
                raise
            stack += halved(part, worst)
            continue
        while True:
            side = [(a, a) if i in found.slopes and found.slopes[i][0] >= 0 else
                    (b, b) if i in found.slopes and found.slopes[i][1] <= 0 else (a, b)
                    for i, (a, b) in enumerate(part)]
            if side == part:
                break
            part = side
            found = over_box(formula, part)
        middle = [(a + b) // 2 for a, b in part]
        there = at_place(formula, middle).value
        fall = {i: -multiplied(slope, (part[i][0] - middle[i], part[i][1] - middle[i]))[0]
                for i, slope in found.slopes.items()}
        low = max(found.value[0], there[0] - sum(fall.values()))
        if low >= enough:
            lowest = low if lowest is None else min(lowest, low)
            continue
        if there[1] < enough or not fall:
            return None
        worst = max(fall, key=fall.get)
        if part[worst][1] - part[worst][0] < 4:
            raise Unverified("a plane that comes too near to its rule")
        stack += halved(part, worst)
    return lowest


def halved(box, i):
    half = sum(box[i]) // 2
    return [box[:i] + [ends] + box[i + 1:] for ends in ((box[i][0], half), (half, box[i][1]))]
