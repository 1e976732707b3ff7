# SPDX-License-Identifier: MIT
"""Intervals whose ends are multiples of 2^-128, and functions that are enclosed over boxes.

Theorem. If each operand encloses its number, so does each result: ends are rounded outward. pi, sine, cosine and exponential are sums of
series in integers with 32 more bits, whose rounding and remainder are below the bit that is added on either side. A `Jet` encloses value, slopes
and second derivatives of a formula over a box by the rules of differentiation. `least` divides a box until the enclosure on each part, or
its value in the middle less what its slopes allow, decides: the number that it returns is a lower bound over the whole box.
"""
import functools
import math

from .exact import Unverified
from .rational import Fraction

BITS = 128
ONE = 1 << BITS
ZERO = (0, 0)
NONE = {}  # derivatives of a constant
GUARD = 32       # more bits for series, whose rounding is then below the last bit that is kept
MOST_PARTS = 20000
NARROW = ONE >> 10  # a box in which a formula must have a value
GOLDEN, SECTIONS = Fraction(618033988749895, 10**15), 45


def pi():
    """Machin: pi / 4 = 4 arctan 1/5 - arctan 1/239, in integers. Every term is rounded down, and the series alternate with falling terms."""
    def arctangent_of_inverse(n):
        total, power, k = 0, (1 << BITS + GUARD) // n, 0
        while power:
            total += (-1)**k * (power // (2 * k + 1))
            power, k = power // n**2, k + 1
        return total

    middle = 4 * (4 * arctangent_of_inverse(5) - arctangent_of_inverse(239))
    return (middle >> GUARD) - 1, (middle >> GUARD) + 2


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
        turn = 2 * PI.value[0], 2 * PI.value[1]
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


def negative(a):
    return -a[1], -a[0]


def squared(a):
    low, high = a[0] * a[0], a[1] * a[1]
    return (0 if a[0] <= 0 <= a[1] else min(low, high)) >> BITS, -(-max(low, high) >> BITS)


def halved(a):
    return a[0] >> 1, -(-a[1] >> 1)


def add_derivatives(found, more):
    """By variable."""
    for i, own in more.items():
        found[i] = added(found[i], own) if i in found else own


def times(derivatives, factor):
    return {i: multiplied(own, factor) for i, own in derivatives.items()}


class Jet:
    """A function over a box: enclosures of its value, by variable of its slopes and, of variables that are followed to the second order,
    of half its second derivative (`bends`). Jet a single place these are Taylor's coefficients there; over an interval of one variable
    the last one bounds the remainder:  f(m + t) is in f(m) + f'(m) t + [f''/2] t^2.  Plain numbers are taken as constants."""

    __slots__ = ("value", "slopes", "bends")

    def __init__(self, value, slopes=NONE, bends=NONE):
        self.value, self.slopes, self.bends = value, slopes, bends

    @staticmethod
    def number(low, high=None):
        """A constant that is known, or enclosed."""
        return Jet(interval(low, high))

    @staticmethod
    def along(value, slope, bend=ZERO):
        """A function of one variable, followed to the second order."""
        return Jet(value, {0: slope}, {0: bend})

    @property
    def c(self):
        """Value, slope and bend of a function of one variable."""
        return self.value, self.slopes.get(0, ZERO), self.bends.get(0, ZERO)

    def __add__(self, other):
        if other.__class__ is not Jet:
            return Jet(added(self.value, interval(other)), self.slopes, self.bends)
        if not other.slopes:
            return Jet(added(self.value, other.value), self.slopes, self.bends)
        slopes, bends = dict(self.slopes), dict(self.bends)
        add_derivatives(slopes, other.slopes)
        add_derivatives(bends, other.bends)
        return Jet(added(self.value, other.value), slopes, bends)

    __radd__ = __add__

    def __neg__(self):
        return Jet(negative(self.value), {i: negative(own) for i, own in self.slopes.items()} if self.slopes else NONE,
                   {i: negative(own) for i, own in self.bends.items()} if self.bends else NONE)

    def __sub__(self, other):
        return self + -other

    def __rsub__(self, other):
        return -self + other

    def __mul__(self, other):
        if other.__class__ is not Jet:
            return self.scaled(interval(other))
        if not other.slopes:
            return self.scaled(other.value)
        if not self.slopes:
            return other.scaled(self.value)
        a, b, bends = self.value, other.value, NONE
        slopes = times(self.slopes, b)
        add_derivatives(slopes, times(other.slopes, a))
        if self.bends or other.bends:
            bends = times(self.bends, b)
            add_derivatives(bends, times(other.bends, a))
            add_derivatives(bends, {i: multiplied(self.slopes[i], other.slopes[i]) for i in bends if i in self.slopes and i in other.slopes})
        return Jet(multiplied(a, b), slopes, bends)

    __rmul__ = __mul__

    def scaled(self, factor):
        """Times a constant that is enclosed."""
        return Jet(multiplied(self.value, factor), times(self.slopes, factor) if self.slopes else NONE,
                   times(self.bends, factor) if self.bends else NONE)

    def through(self, value, slope, bend=None):
        """A function of this, which has such values, such a slope and half such a second derivative."""
        bends = {i: added(multiplied(slope, own), multiplied(bend, squared(self.slopes[i]))) for i, own in self.bends.items()} \
            if self.bends else NONE
        return Jet(value, times(self.slopes, slope) if self.slopes else NONE, bends)

    def after(self, inner):
        """This function, of one variable, of what another one gives."""
        return inner.through(*self.c)

    def square(self):
        a, b = self.value
        return self.through(squared(self.value), (2 * a, 2 * b), (ONE, ONE))

    def inverse(self):
        """Of what is above 0."""
        value = inverted(self.value)
        square = multiplied(value, value)
        return self.through(value, negative(square), multiplied(square, value) if self.bends else None)

    def root(self):
        """Of what is above 0."""
        value = rooted(self.value)
        if not self.slopes:
            return Jet(value)
        slope = inverted((2 * value[0], 2 * value[1]))
        return self.through(value, slope, negative(multiplied(slope, squared(slope))) if self.bends else None)

    def exponential(self):
        value = exponential(self.value)
        return self.through(value, value, halved(value))

    def sine_and_cosine(self):
        sine, cosine = sine_and_cosine(self.value)
        return self.through(sine, cosine, negative(halved(sine))), self.through(cosine, negative(sine), negative(halved(cosine)))


PI = Jet(pi())
PI_ITSELF = fraction(sum(PI.value)) / 2  # to 37 digits: far below what limits and conditions are met to


@functools.cache
def tangent(degrees):
    sine, cosine = (degrees / 180 * PI).sine_and_cosine()
    return sine * cosine.inverse()


def over_box(formula, box):
    """The formula with a variable for each interval that is one."""
    return formula([Jet(ends, {i: (ONE, ONE)} if ends[0] < ends[1] else NONE) for i, ends in enumerate(box)])


def at_place(formula, place):
    return formula([Jet((x, x)) for x in place])


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
    return formula([Jet((x, x), {i: (ONE, ONE)}) for i, x in enumerate(place)])


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
            stack += divided_box(part, worst)
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
        stack += divided_box(part, worst)
    return lowest


def largest(pieces, places, close, what):
    """(low, high) around the largest of functions [(begin, end, x -> value)] over begin <= x <= end. It is searched at so many places of
    each, refined at the two best, and proved to be the largest up to the part `close` of its size."""
    def at(value, x):
        return ends_of(value(Jet.number(x)))[0]

    found = [(at(value, begin + (end - begin) * Fraction(i, places)), i, begin, end, value) for begin, end, value in pieces
             for i in range(places + 1 if end > begin else 1)]
    found.sort(key=lambda own: -own[0])
    low, size = found[0][0], max(abs(own[0]) for own in found)
    for _, i, begin, end, value in found[:2]:
        step = (end - begin) * Fraction(1, places)
        if step:
            low = max(low, refined(lambda x, value=value: at(value, x), begin + step * max(0, i - 1), begin + step * min(places, i + 1)))
    high = low + size * close
    for begin, end, value in pieces:
        if least(lambda numbers, value=value: high - value(numbers[0]), [interval(begin, end)], 0) is None:
            raise Unverified(f"the largest {what}")
    return low, high


def refined(at, begin, end):
    """The largest value between two places, where it has one maximum: golden section."""
    def inside(part):
        return Fraction(round((begin + part * (end - begin)) * 2**100), 2**100)

    inner = [inside(1 - GOLDEN), inside(GOLDEN)]
    found = [at(x) for x in inner]
    for _ in range(SECTIONS):
        if found[0] < found[1]:
            begin = inner[0]
            inner, found = [inner[1], inside(GOLDEN)], [found[1], None]
            found[1] = at(inner[1])
        else:
            end = inner[1]
            inner, found = [inside(1 - GOLDEN), inner[0]], [None, found[0]]
            found[0] = at(inner[0])
    return max(found)


def divided_box(box, i):
    half = sum(box[i]) // 2
    return [box[:i] + [ends] + box[i + 1:] for ends in ((box[i][0], half), (half, box[i][1]))]
