# SPDX-License-Identifier: MIT
"""Laws of the catalogue as formulas: f from 0 to 1 over 0 <= u <= 1, with f' and f''."""
from fractions import Fraction

from .disk_rules import constant
from .enclosures import Over
from .exact import PI, Unverified, derivative

# Laws with y(u) + y(1 - u) = 1.
SYMMETRIC = ("constant_velocity", "polynomial_345", "polynomial_4567", "polynomial_56789", "cycloidal", "simple_harmonic",
             "parabolic", "modified_sine", "modified_trapezoid")
POLYNOMIALS = {"constant_velocity": [0, 1], "polynomial_345": [0, 0, 0, 10, -15, 6],
               "polynomial_4567": [0, 0, 0, 0, 35, -84, 70, -20],
               "polynomial_56789": [0, 0, 0, 0, 0, 126, -420, 540, -315, 70],
               "run_in": [0, 0, 0, 2, -1], "run_out": [0, 2, 0, -2, 1]}
END_VELOCITIES = {"constant_velocity": (1, 1), "run_in": (0, 2), "run_out": (2, 0)}  # others rest


def harmonic(law):
    """Pieces (width, a, b, c, w) of f'' = a + b sin w v + c cos w v, v from the piece's beginning."""
    pi, none = Over.number(*PI), constant(0)
    eighth, quarter, half, whole = Fraction(1, 8), Fraction(1, 4), Fraction(1, 2), Fraction(1)
    steep = constant(4) * pi
    if law == "cycloidal":
        return [(whole, none, constant(2) * pi, none, constant(2) * pi)]
    if law == "simple_harmonic":
        return [(whole, none, none, pi * pi * constant(half), pi)]
    if law == "parabolic":
        return [(half, constant(4), none, none, pi), (half, constant(-4), none, none, pi)]
    if law == "modified_sine":
        size = constant(4) * pi * pi * (pi + constant(4)).inverse()
        return [(eighth, none, size, none, steep), (6 * eighth, none, none, size, steep * constant(Fraction(1, 3))),
                (eighth, none, none, -size, steep)]
    if law == "modified_trapezoid":
        size = constant(8) * pi * (pi + constant(2)).inverse()
        return [(eighth, none, size, none, steep), (quarter, size, none, none, steep), (quarter, none, none, size, steep),
                (quarter, -size, none, none, steep), (eighth, none, none, -size, steep)]
    raise Unverified(f"limits along the law {law}")


def at_time(polynomial, t):
    """A polynomial with coefficients that are enclosed, at a time that is."""
    total = polynomial[-1]
    for coefficient in reversed(polynomial[:-1]):
        total = total * t + coefficient
    return total


def pieces_of(law):
    """[(width, v -> [f, f', f'', f'''])]; nothing of where f'' jumps."""
    if law in POLYNOMIALS:
        orders = [[constant(c) for c in derivative([Fraction(c) for c in POLYNOMIALS[law]], order)] for order in range(4)]
        return [(Fraction(1), lambda v: [at_time(c, v) for c in orders])]
    pieces, begin = [], [constant(0), constant(0)]
    for width, a, b, c, w in harmonic(law):
        inverse = w.inverse()

        def piece(v, begin=tuple(begin), a=a, b=b, c=c, w=w, inverse=inverse):
            sine, cosine = (w * v).sine_and_cosine()
            rest = constant(1) - cosine
            return [begin[0] + begin[1] * v + a * v.square() * constant(Fraction(1, 2)) +
                    b * inverse * (v - sine * inverse) + c * inverse * inverse * rest,
                    begin[1] + a * v + (b * rest + c * sine) * inverse, a + b * sine + c * cosine,
                    (b * cosine - c * sine) * w]

        pieces.append((width, piece))
        begin = piece(constant(width))[:2]
    return pieces


def motion_along(stretch, orders=3):
    """[(width, v -> [y, y' ...])] of a law or a dwell, v in parts of the stretch."""
    if stretch.kind == "dwell":
        return [(Fraction(1), lambda v: [constant(stretch.start)] + [constant(0)] * (orders - 1))]
    rise, length = stretch.to - stretch.start, stretch.end - stretch.begin

    def scaled(piece):
        def states(v):
            found = [constant(rise / length**order) * f for order, f in enumerate(piece(v)[:orders])]
            return [constant(stretch.start) + found[0]] + found[1:]
        return states

    return [(width, scaled(piece)) for width, piece in pieces_of(stretch.law)]


def parts_along(stretch, orders):
    """[(begin, end, v -> [y, y' ...], v from there)] of motion_along, in parts of the stretch."""
    end, found = Fraction(0), []
    for width, motion in motion_along(stretch, orders):
        found.append((end, end + width, motion))
        end += width
    return found
