# SPDX-License-Identifier: MIT
"""Truncated Taylor series with interval coefficients.

A `Jet` encloses f, f' and f''/2 of a function over an interval of its variable. Over a single point the coefficients
are the Taylor polynomial there; over an interval the last one bounds the remainder:

    f(m + t) is in f(m) + f'(m) t + [f''/2] t^2.

Ends of intervals are multiples of 2^-128, rounded outward (certificate_checker.enclosures).
"""
from certificate_checker.enclosures import BITS, ONE, added, interval, inverted, multiplied, rooted, sine_and_cosine

ZERO = (0, 0)


def negative(a):
    return -a[1], -a[0]


def halved(a):
    return a[0] >> 1, -(-a[1] >> 1)


def doubled(a):
    return 2 * a[0], 2 * a[1]


def squared(a):
    low, high = a[0] * a[0], a[1] * a[1]
    least = 0 if a[0] <= 0 <= a[1] else min(low, high)
    return least >> BITS, -(-max(low, high) >> BITS)


class Jet:
    """`c`: enclosures of f, f' and f''/2."""

    __slots__ = ("c",)

    def __init__(self, value, slope=ZERO, bend=ZERO):
        self.c = value, slope, bend

    @staticmethod
    def number(low, high=None):
        """A constant that is known, or enclosed."""
        return Jet(interval(low, high))

    def __add__(self, other):
        (a0, a1, a2), (b0, b1, b2) = self.c, other.c
        return Jet((a0[0] + b0[0], a0[1] + b0[1]), (a1[0] + b1[0], a1[1] + b1[1]), (a2[0] + b2[0], a2[1] + b2[1]))

    def __neg__(self):
        return Jet(*(negative(a) for a in self.c))

    def __sub__(self, other):
        (a0, a1, a2), (b0, b1, b2) = self.c, other.c
        return Jet((a0[0] - b0[1], a0[1] - b0[0]), (a1[0] - b1[1], a1[1] - b1[0]), (a2[0] - b2[1], a2[1] - b2[0]))

    def __mul__(self, other):
        (a0, a1, a2), (b0, b1, b2) = self.c, other.c
        return Jet(multiplied(a0, b0), added(multiplied(a0, b1), multiplied(a1, b0)),
                   added(added(multiplied(a0, b2), multiplied(a2, b0)), multiplied(a1, b1)))

    def scaled(self, factor):
        """Times a constant that is enclosed."""
        a0, a1, a2 = self.c
        return Jet(multiplied(a0, factor), multiplied(a1, factor), multiplied(a2, factor))

    def square(self):
        a0, a1, a2 = self.c
        return Jet(squared(a0), doubled(multiplied(a0, a1)), added(doubled(multiplied(a0, a2)), squared(a1)))

    def after(self, inner):
        """This function of what another one gives."""
        (a0, a1, a2), (_, b1, b2) = self.c, inner.c
        return Jet(a0, multiplied(a1, b1), added(multiplied(a1, b2), multiplied(a2, squared(b1))))

    def inverse(self):
        """Of what is above 0: from f g = 1."""
        a0, a1, a2 = self.c
        g0 = inverted(a0)
        g1 = negative(multiplied(squared(g0), a1))
        return Jet(g0, g1, negative(multiplied(g0, added(multiplied(a2, g0), multiplied(a1, g1)))))

    def root(self):
        """Of what is above 0: from r^2 = f."""
        r0 = rooted(self.c[0])
        half = inverted(doubled(r0))
        r1 = multiplied(self.c[1], half)
        bend = self.c[2]
        square = squared(r1)
        return Jet(r0, r1, multiplied((bend[0] - square[1], bend[1] - square[0]), half))

    def sine_and_cosine(self):
        a0, a1, a2 = self.c
        sine, cosine = sine_and_cosine(a0)
        half = halved(squared(a1))
        return (Jet(sine, multiplied(cosine, a1), added(multiplied(cosine, a2), negative(multiplied(sine, half)))),
                Jet(cosine, negative(multiplied(sine, a1)),
                    negative(added(multiplied(sine, a2), multiplied(cosine, half)))))


def largest_magnitude(value, slope, bend, reach):
    """An upper bound of |f| over |t| <= reach, as a double: f(m) and f'(m) are narrow, `bend` encloses f''/2."""
    low, high = range_over(value, slope, bend, reach)
    return max(-low, high)


def range_over(value, slope, bend, reach):
    """Doubles around f(m) + f'(m) t + bend t^2 over |t| <= reach. The slack covers the rounding of the doubles, whose
    relative error is below 1e-15 for each term."""
    h = reach / ONE
    a = value[0] / ONE, value[1] / ONE
    b = max(abs(slope[0]), abs(slope[1])) / ONE * h
    c = bend[0] / ONE * h * h, bend[1] / ONE * h * h
    slack = 1e-13 * (abs(a[0]) + abs(a[1]) + b + abs(c[0]) + abs(c[1])) + 1e-25
    low, high = a[0] - b + c[0], a[1] + b + c[1]
    if c[0] > 0 and b < 2 * c[0]:
        low = a[0] - b * b / (4 * c[0])
    if c[1] < 0 and b < -2 * c[1]:
        high = a[1] - b * b / (4 * c[1])
    return low - slack, high + slack
