# SPDX-License-Identifier: MIT
"""The torque of a motor along laws and dwells: its largest value and its mean square, enclosed."""
from fractions import Fraction

from . import enclosures
from .disk_rules import constant
from .enclosures import ends_of
from .exact import Unverified, derivative, integral, product
from .laws import POLYNOMIALS, harmonic, motion_along, pieces_of

PLACES, HALVINGS = 24, 90    # where a largest value is looked for in each piece, and how closely
CLOSE = Fraction(1, 10**11)  # it is enclosed to this part of its size


class Formula:
    """A formula that is enclosed, multiplied by numbers."""

    def __init__(self, own):
        self.own = own

    def __add__(self, other):
        return Formula(self.own + other.own)

    def __mul__(self, other):
        return Formula(self.own * (other.own if isinstance(other, Formula) else constant(other)))


def largest_along(span, drive, formula, sign):
    """(low, high) around the largest of sign * formula(torque, n) along a law or a dwell."""
    def along(motion):
        def value(v):
            _, slope, bend = motion(v)
            torque = constant(drive.acceleration) * bend + constant(drive.velocity) * slope + constant(span.constant)
            return constant(sign) * formula(Formula(torque), Formula(constant(drive.speed) * slope)).own
        return value

    pieces = [(width, along(motion)) for width, motion in motion_along(span.stretch, 3)]
    if span.stretch.kind == "dwell":
        return ends_of(pieces[0][1](constant(0)))
    places = [(ends_of(value(constant(width * i / PLACES)))[0], i, width, value) for width, value in pieces for i in range(PLACES + 1)]
    low = max(places, key=lambda own: own[0])[0]
    size = max(abs(own[0]) for own in places)
    for _, i, width, value in sorted(places, key=lambda own: -own[0])[:2]:
        low = max(low, refined(value, width * max(0, i - 1) / PLACES, width * min(PLACES, i + 1) / PLACES))
    high = low + size * CLOSE
    for width, value in pieces:
        if enclosures.least(lambda numbers, value=value: constant(high) - value(numbers[0]),
                            [enclosures.interval(Fraction(0), width)], 0) is None:
            raise Unverified("the largest torque along a law")
    return low, high


def refined(value, begin, end):
    """The largest of a value between two places, where it has one maximum: golden section."""
    golden = Fraction(618033988749895, 10**15)
    inner = [end - golden * (end - begin), begin + golden * (end - begin)]
    found = [ends_of(value(constant(x)))[0] for x in inner]
    for _ in range(HALVINGS // 2):
        if found[0] < found[1]:
            begin, inner, found = inner[0], [inner[1], None], [found[1], None]
            inner[1] = rounded(begin + golden * (end - begin))
            found[1] = ends_of(value(constant(inner[1])))[0]
        else:
            end, inner, found = inner[1], [None, inner[0]], [None, found[0]]
            inner[0] = rounded(end - golden * (end - begin))
            found[0] = ends_of(value(constant(inner[0])))[0]
    return max(found)


def rounded(x):
    return Fraction(round(x * 2**100), 2**100)


def square_along(span, acceleration, velocity):
    """(low, high) around the integral of torque^2 over a law or a dwell.

    With u = y': the integral of (Ka u' + Kv u + c)^2 is Ka^2 that of u'^2, Kv^2 that of u^2, Ka Kv [u^2], 2 c (Ka [u] + Kv [y]) and
    c^2 times the length."""
    stretch, c = span.stretch, span.constant
    length = stretch.end - stretch.begin
    if stretch.kind == "dwell":
        return c * c * length, c * c * length
    rise = stretch.to - stretch.start
    slopes, bends, first, last = (tuple(own) for own in integrals_of(stretch.law))
    a, v = rise / length, rise / length**2
    jump = [(last[i] - first[1 - i]) * a for i in (0, 1)]
    jump_of_square = [(last[i]**2 - first[1 - i]**2) * a**2 for i in (0, 1)]
    low, high = (acceleration**2 * v**2 * length * bends[i] + velocity**2 * a**2 * length * slopes[i] +
                 acceleration * velocity * jump_of_square[i] +
                 2 * c * velocity * rise + c * c * length for i in (0, 1))
    linear = [2 * c * acceleration * j for j in jump]
    return low + min(linear), high + max(linear)


def integrals_of(law):
    """Enclosures of the integrals of f'^2 and f''^2, and of f' at both ends, of a law over 0 <= u <= 1."""
    if law in POLYNOMIALS:
        y = [Fraction(c) for c in POLYNOMIALS[law]]
        own = [derivative(y), derivative(y, 2)]
        squares = [integral(product(p, p), Fraction(1)) for p in own]
        ends = [own[0][0], sum(own[0])]
        return [(s, s) for s in squares + ends]
    slopes = bends = constant(0)
    formulas, begin = pieces_of(law), constant(0)
    for (width, a, b, c, w), (_, formula) in zip(harmonic(law), formulas):
        x, inverse = constant(width), w.inverse()
        sine, cosine = (w * x).sine_and_cosine()
        # Integrals of sin, cos, v sin, v cos, sin^2, cos^2, sin cos over the piece.
        s, o = (constant(1) - cosine) * inverse, sine * inverse
        vs, vo = (sine * inverse - x * cosine) * inverse, (x * sine - s) * inverse
        product_of = constant(Fraction(1, 2)) * sine * cosine * inverse
        ss, oo = constant(Fraction(1, 2)) * x - product_of, constant(Fraction(1, 2)) * x + product_of
        so = constant(Fraction(1, 2)) * sine.square() * inverse
        two, third = constant(2), constant(Fraction(1, 3))
        bends += a.square() * x + b.square() * ss + c.square() * oo + two * (a * (b * s + c * o) + b * c * so)
        # f' = d + a v + p sin + q cos
        d, p, q = begin + b * inverse, c * inverse, -(b * inverse)
        slopes += d.square() * x + d * a * x.square() + a.square() * third * x * x.square() + p.square() * ss + q.square() * oo + \
            two * (d * (p * s + q * o) + a * (p * vs + q * vo) + p * q * so)
        begin = formula(x)[1]
    return [ends_of(slopes), ends_of(bends), (Fraction(0), Fraction(0)), ends_of(begin)]
