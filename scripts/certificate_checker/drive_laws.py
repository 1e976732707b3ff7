# SPDX-License-Identifier: MIT
"""The torque of a motor along laws and dwells.

Theorem. `largest_along` and `square_along` enclose the largest value of a formula of torque and speed, and the integral of torque^2, over the
span of a law or a dwell along which the friction's direction is constant.
"""
from .enclosures import ends_of, largest
from .laws import CLOSE, PLACES, constant, ends_of_law, motion_along, square_integral


class Span:
    """A part of the motion along which friction has one direction."""

    def __init__(self, stretch, begin, end, way, constant):
        self.stretch, self.begin, self.end, self.way, self.constant = stretch, begin, end, way, constant


def largest_along(span, drive, formula, sign):
    """(low, high) around the largest of sign * formula(torque, n) along a law or a dwell."""
    def along(motion):
        def value(v):
            _, slope, bend = motion(v)
            torque = drive.acceleration * bend + drive.velocity * slope + span.constant
            return sign * formula(torque, drive.speed * slope)
        return value

    pieces = [(0, width, along(motion)) for width, motion in motion_along(span.stretch, 3)]
    if span.stretch.kind == "dwell":
        return ends_of(pieces[0][2](constant(0)))
    return largest(pieces, PLACES, CLOSE, "torque along a law")


def square_along(span, acceleration, velocity):
    """(low, high) around the integral of torque^2 over a law or a dwell.

    With u = y': the integral of (Ka u' + Kv u + c)^2 is Ka^2 that of u'^2, Kv^2 that of u^2, Ka Kv [u^2], 2 c (Ka [u] + Kv [y]) and
    c^2 times the length."""
    stretch, c = span.stretch, span.constant
    length = stretch.end - stretch.begin
    if stretch.kind == "dwell":
        return c * c * length, c * c * length
    rise = stretch.to - stretch.start
    slopes, bends = (square_integral(stretch.law, order) for order in (1, 2))
    first, last = ends_of_law(stretch.law, 1)
    a, v = rise / length, rise / length**2
    return tuple(acceleration**2 * v**2 * length * bends[i] + velocity**2 * a**2 * length * slopes[i] +
                 acceleration * velocity * (last**2 - first**2) * a**2 + 2 * c * (velocity * rise + acceleration * (last - first) * a) +
                 c * c * length for i in (0, 1))
