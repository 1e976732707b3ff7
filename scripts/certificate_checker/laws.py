# SPDX-License-Identifier: MIT
"""Laws of the catalogue as formulas: f from 0 to 1 over 0 <= u <= 1, with its derivatives.

Of most laws f'' has a formula piece by piece: a number and sines and cosines, up to a factor that makes f(1) = 1. Two widths of pieces
are irrational and taken to 35 digits.
"""
import functools

from . import enclosures
from .enclosures import Over, ends_of
from .exact import ORDERS, PI_ITSELF, PI, Unverified, derivative, integral, middle_of, product, root, shifted
from .rational import Fraction

PLACES, HALVINGS = 24, 90    # where a largest value is looked for in each piece, and how closely
CLOSE = Fraction(5, 10**10)  # it is enclosed to this part of its size

POLYNOMIALS = {"constant_velocity": [0, 1], "polynomial_345": [0, 0, 0, 10, -15, 6],
               "polynomial_4567": [0, 0, 0, 0, 35, -84, 70, -20],
               "polynomial_56789": [0, 0, 0, 0, 0, 126, -420, 540, -315, 70],
               "one_dwell_polynomial_345": [0, 0, 0, Fraction(20, 3), Fraction(-25, 3), Fraction(8, 3)],
               "one_dwell_polynomial_3456": [0, 0, 0, 8, -12, 6, -1],
               "run_in": [0, 0, 0, 2, -1], "run_out": [0, 2, 0, -2, 1]}
END_VELOCITIES = {"constant_velocity": (1, 1), "run_in": (0, 2), "run_out": (2, 0)}  # others rest
JUMPING = ("parabolic", "asymmetric_parabolic", "simple_harmonic")  # y'' jumps


def constant(value):
    return Over.number(Fraction(value))


# -- pieces of f'': (width, a number, [(half turns of the argument, factor of the sine, of the cosine)])

def sine_up(width, height=1):
    return width, 0, [(Fraction(1, 2), height, 0)]


def cosine_down(width, height=1):
    return width, 0, [(Fraction(1, 2), 0, height)]


def half_sine(width, height=1):
    return width, 0, [(1, height, 0)]


def level(width, height=1):
    return width, height, []


def mirrored(pieces):
    """What follows them where f''(1 - u) = -f''(u)."""
    return [(width, -a, [(h, -c, -s) if h == Fraction(1, 2) else (h, -s, c) for h, s, c in waves]) for width, a, waves in reversed(pieces)]


def odd_sines(*amplitudes):
    """The first half of u - sum of amplitude sin 2 pi (2 k + 1) u, up to a factor."""
    return [(Fraction(1, 2), 0, [(n, a * n * n, 0) for n, a in zip((1, 3, 5), amplitudes)])]


def stretched(pieces, by):
    return [(width * by, a / by, [(h, s / by, c / by) for h, s, c in waves]) for width, a, waves in pieces]


def shapes():
    e, half, quarter = Fraction(1, 8), Fraction(1, 2), Fraction(1, 4)
    halves = {"parabolic": [level(half)], "simple_harmonic": [cosine_down(half)], "cycloidal": [half_sine(half)],
              "modified_sine": [sine_up(e), cosine_down(3 * e)],
              "modified_trapezoid": [sine_up(e), level(quarter), cosine_down(e)],
              "cycloidal_cv50": [half_sine(quarter), level(quarter, 0)],
              "gutman_13": odd_sines(Fraction(15, 32), Fraction(1, 96)), "freudenstein_13": odd_sines(Fraction(27, 56), Fraction(1, 168)),
              "freudenstein_135": odd_sines(Fraction(1), Fraction(1, 54), Fraction(1, 1250))}
    for name, a, b in (("mcv_50", half * e, quarter), ("mcv_33", Fraction(1, 12), Fraction(1, 3)), ("mcv_20", Fraction(1, 10), Fraction(2, 5))):
        halves[name] = [sine_up(a), cosine_down(b - a), level(half - b, 0)]
    found = {name: own + mirrored(own) for name, own in halves.items()}
    split = Fraction(2, 5)
    for name in ("parabolic", "cycloidal", "modified_sine", "modified_trapezoid"):
        own = halves[name]
        found["asymmetric_" + name] = stretched(own, 2 * split) + stretched(mirrored(own), 2 * (1 - split))
    found["double_harmonic"] = [(Fraction(1), 0, [(1, 0, 1), (2, 0, -1)])]
    zero = Fraction(8, 15)
    found["one_dwell_modified_sine"] = [sine_up(e), cosine_down(zero - e), sine_up(1 - zero, Fraction(-8, 7))]
    two = middle_of(root(Fraction(2)))[0]
    found["one_dwell_cycloidal"] = [half_sine(2 - two), sine_up(two - 1, -two)]
    zero = half + e * (half - 1 / PI_ITSELF)
    found["one_dwell_modified_trapezoid"] = [sine_up(e), level(zero - 2 * e), (2 * e, 0, [(1, 0, 1)]), level(1 - zero - e, -1)]
    return found


SHAPES = shapes()
LAWS = {*SHAPES, *POLYNOMIALS, "asymmetric_polynomial_345"}
# Laws with y(u) + y(1 - u) = 1.
SYMMETRIC = {law for law in LAWS if not law.startswith(("asymmetric", "one_dwell", "double", "run_"))}


def polynomials_of(law):
    """[(width, f by v from the piece's beginning)], or None: f is none."""
    if law == "asymmetric_polynomial_345":  # two halves of f, each stretched both ways
        own, found = [Fraction(c) for c in POLYNOMIALS["polynomial_345"]], []
        for by, begin in ((Fraction(4, 5), Fraction(0)), (Fraction(6, 5), Fraction(1, 2))):
            part = [by * c / by**m for m, c in enumerate(shifted(own, begin))]
            found.append((by / 2, [part[0] + (1 - by if begin else 0)] + part[1:]))
        return found
    return [(Fraction(1), [Fraction(c) for c in POLYNOMIALS[law]])] if law in POLYNOMIALS else None


@functools.cache
def harmonic(law):
    """Pieces (width, a, [(w, b, c)], [f, f'] at its beginning) of f'' = a + sum of b sin w v + c cos w v, v from there."""
    if law not in SHAPES:
        raise Unverified(f"the law {law}")
    size, pi = None, Over.number(*PI)
    for _ in range(2):  # the second time with f(1) = 1
        found, begin = [], [constant(0), constant(0)]
        for width, a, waves in SHAPES[law]:
            own = (width, constant(a), [(pi * constant(h / width), constant(s), constant(c)) for h, s, c in waves])
            if size:
                own = (width, own[1] * size, [(w, s * size, c * size) for w, s, c in own[2]])
            found.append((*own, begin))
            begin = along(*found[-1])(constant(width))[:2]
        size = begin[0].inverse()
    return found


def along(_, a, waves, begin):
    """v -> [f, f', f'', f'''] of a piece."""
    inverses = [w.inverse() for w, _, _ in waves]

    def piece(v):
        found = [begin[0] + begin[1] * v + a * v.square() * constant(Fraction(1, 2)), begin[1] + a * v, a, constant(0)]
        for (w, b, c), inverse in zip(waves, inverses):
            sine, cosine = (w * v).sine_and_cosine()
            rest = constant(1) - cosine
            parts = (b * (v - sine * inverse) + c * inverse * rest) * inverse, (b * rest + c * sine) * inverse, b * sine + c * cosine, \
                (b * cosine - c * sine) * w
            found = [f + part for f, part in zip(found, parts)]
        return found
    return piece


def at_time(polynomial, t):
    """A polynomial with coefficients that are enclosed, at a time that is."""
    total = polynomial[-1]
    for coefficient in reversed(polynomial[:-1]):
        total = total * t + coefficient
    return total


@functools.cache
def pieces_of(law):
    """[(width, v -> [f, f', f'', f'''])]; nothing of where f'' jumps."""
    polynomials = polynomials_of(law)
    if polynomials is None:
        return [(piece[0], along(*piece)) for piece in harmonic(law)]
    orders = [(width, [[constant(c) for c in derivative(y, order)] for order in range(4)]) for width, y in polynomials]
    return [(width, lambda v, own=own: [at_time(c, v) for c in own]) for width, own in orders]


def ends_of_law(law, order):
    """f^(order) at both ends, irrational ones to 35 digits."""
    (_, first), (width, last) = pieces_of(law)[0], pieces_of(law)[-1]
    ends = [ends_of(first(constant(0))[order]), ends_of(last(constant(width))[order])]
    return [Fraction(0) if low <= 0 <= high else middle_of((low, high))[0] for low, high in ends]


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


# -- largest values and integrals

def largest_value(pieces, what):
    """(low, high) around the largest of values (width, v -> value) over 0 <= v <= width."""
    places = [(ends_of(value(constant(width * i / PLACES)))[0], i, width, value) for width, value in pieces for i in range(PLACES + 1)]
    low = max(places, key=lambda own: own[0])[0]
    size = max(abs(own[0]) for own in places)
    for _, i, width, value in sorted(places, key=lambda own: -own[0])[:2]:
        low = max(low, refined(value, width * max(0, i - 1) / PLACES, width * min(PLACES, i + 1) / PLACES))
    high = low + size * CLOSE
    for width, value in pieces:
        if enclosures.least(lambda numbers, value=value: constant(high) - value(numbers[0]),
                            [enclosures.interval(Fraction(0), width)], 0) is None:
            raise Unverified(f"the largest {what} along a law")
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


@functools.cache
def square_integral(law, order):
    """(low, high) around the integral of the square of f^(order), 1 to 3."""
    polynomials = polynomials_of(law)
    if polynomials is not None:
        total = sum(integral(product(p, p), width) for width, p in ((width, derivative(y, order)) for width, y in polynomials))
        return total, total
    total = constant(0)
    for width, a, waves, begin in harmonic(law):
        if order == 1:  # f'(0) + a v + sum of (b (1 - cos) + c sin) / w
            line = [begin[1] + sum((b * w.inverse() for w, b, _ in waves), constant(0)), a]
            waves = [(w, c * w.inverse(), -b * w.inverse()) for w, b, c in waves]
        else:
            line = [a if order == 2 else constant(0), constant(0)]
            waves = waves if order == 2 else [(w, -c * w, b * w) for w, b, c in waves]
        total = total + square_of(line, waves, constant(width))
    return ends_of(total)


def square_of(line, waves, x):
    """The integral over 0 <= v <= x of (line[0] + line[1] v + sum of s sin w v + c cos w v)^2."""
    two, half = constant(2), constant(Fraction(1, 2))
    total = line[0].square() * x + line[0] * line[1] * x.square() + line[1].square() * x * x.square() * constant(Fraction(1, 3))

    def of_wave(w):
        """Integrals of sin, cos, v sin, v cos."""
        sine, cosine = (w * x).sine_and_cosine()
        inverse = w.inverse()
        s, c = (constant(1) - cosine) * inverse, sine * inverse
        return s, c, (c - x * cosine) * inverse, (x * sine - s) * inverse

    for i, (w, s, c) in enumerate(waves):
        sine, cosine, v_sine, v_cosine = of_wave(w)
        total = total + two * (line[0] * (s * sine + c * cosine) + line[1] * (s * v_sine + c * v_cosine))
        sine, cosine = of_wave(w + w)[:2]
        total = total + half * ((s.square() + c.square()) * x + (c.square() - s.square()) * cosine + two * s * c * sine)
        for other, p, q in waves[:i]:  # w is above the other
            low, high = of_wave(w - other), of_wave(w + other)
            total = total + (c * q + s * p) * low[1] + (s * q - c * p) * low[0] + (c * q - s * p) * high[1] + (s * q + c * p) * high[0]
    return total


@functools.cache
def mean_of(law):
    """The mean of f, to 35 digits where it is irrational."""
    if law in SYMMETRIC:
        return Fraction(1, 2)
    polynomials = polynomials_of(law)
    if polynomials is not None:
        return sum(integral(y, width) for width, y in polynomials)
    total = constant(0)
    for width, a, waves, begin in harmonic(law):
        x, half = constant(width), constant(Fraction(1, 2))
        total = total + begin[0] * x + begin[1] * x.square() * half + a * x * x.square() * constant(Fraction(1, 6))
        for w, b, c in waves:
            sine, cosine = (w * x).sine_and_cosine()
            inverse = w.inverse()
            total = total + (b * (x.square() * half - (constant(1) - cosine) * inverse.square()) +
                             c * inverse * (x - sine * inverse)) * inverse
    return middle_of(ends_of(total))[0]


@functools.cache
def law_peak(law, name):
    """(low, high) around the largest |f^(r)|, of "torque" |f' f''|, of "rms_..." a root mean square."""
    if name.endswith("jerk") and law in JUMPING:
        raise Unverified(f"the {name} of the law {law}")
    if name.startswith("rms_"):
        low, high = square_integral(law, ORDERS[name[4:]])
        return root(low)[0], root(high)[1]

    def value(piece, sign):
        def at(v):
            found = piece(v)
            return constant(sign) * (found[1] * found[2] if name == "torque" else found[ORDERS[name]])
        return at
    return largest_value([(width, value(piece, sign)) for width, piece in pieces_of(law) for sign in (1, -1)], name)
