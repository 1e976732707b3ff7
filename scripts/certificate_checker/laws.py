# SPDX-License-Identifier: MIT
"""Laws of the catalogue as formulas: f from 0 to 1 over 0 <= u <= 1, with its derivatives.

Theorem. `pieces_of` encloses f, f', f'', f''' of a law at every u; `law_peak`, `square_integral` and `mean_of` enclose the largest value, the
integral of the square and the mean. f'' of every law has a formula piece by piece, a polynomial or a number with sines and cosines, up to a
factor that makes f(1) = 1. Two widths of pieces are irrational and taken to 35 digits.

A law is named by its key, with numbers in place of its customary ones in brackets ("modified_sine(0.2)", "scca(sine = 1, constant = 2,
cosine = 1, coast = 0)"). "polynomial" is, between velocities v and accelerations a of both ends by u,
    f = v0 u + a0/2 u^2 + (10 - 6 v0 - 4 v1 - 3/2 a0 + a1/2) u^3 + (-15 + 8 v0 + 7 v1 + 3/2 a0 - a1) u^4 + (6 - 3 v0 - 3 v1 - a0/2 + a1/2) u^5,
an acceleration that is not given the one that makes the highest coefficient vanish. "reversed_..." is 1 - f(1 - u).
"""
import functools

from . import enclosures
from .enclosures import Jet, PI, PI_ITSELF, ends_of
from .exact import ORDERS, Unverified, derivative, integral, middle_of, product, root, shifted, value_at
from .rational import Fraction

PLACES = 24                  # where a largest value is searched in each piece
CLOSE = Fraction(5, 10**10)  # it is enclosed to this part of its size

FIXED = {"constant_velocity": [0, 1], "polynomial_345": [0, 0, 0, 10, -15, 6],
               "polynomial_4567": [0, 0, 0, 0, 35, -84, 70, -20],
               "polynomial_56789": [0, 0, 0, 0, 0, 126, -420, 540, -315, 70],
               "one_dwell_polynomial_345": [0, 0, 0, Fraction(20, 3), Fraction(-25, 3), Fraction(8, 3)],
               "one_dwell_polynomial_3456": [0, 0, 0, 8, -12, 6, -1],
               "run_in": [0, 0, 0, 2, -1], "run_out": [0, 2, 0, -2, 1]}
EIGHTH, THIRD, HALF = Fraction(1, 8), Fraction(1, 3), Fraction(1, 2)
# Names of the numbers of a law and its customary ones.
NUMBERS = {"modified_sine": {"Ta": EIGHTH}, "modified_trapezoid": {"Ta": EIGHTH}, "mcv_50": {"a": EIGHTH / 2, "b": Fraction(1, 4)},
           "mcv_33": {"a": Fraction(1, 12), "b": THIRD}, "mcv_20": {"a": Fraction(1, 10), "b": Fraction(2, 5)},
           "scca": {"sine": Fraction(135, 2), "constant": Fraction(333, 10), "cosine": Fraction(99, 2), "coast": Fraction(297, 10)},
           "trapezoid": {"acceleration": THIRD, "coast": THIRD}, "s_curve": {"acceleration": THIRD, "coast": THIRD, "ramp": Fraction(1, 4)},
           "one_dwell_modified_sine": {"Ta": EIGHTH}, "one_dwell_modified_trapezoid": {"Ta": EIGHTH},
           "polynomial": dict.fromkeys(("start_velocity", "start_acceleration", "end_velocity", "end_acceleration"), Fraction(0))}
for _law in ("parabolic", "cycloidal", "polynomial_345", "modified_sine", "modified_trapezoid"):
    NUMBERS["asymmetric_" + _law] = NUMBERS.get(_law, {}) | {"split": Fraction(2, 5)}
REVERSED = "reversed_"


@functools.cache
def parsed(name):
    """(key, {name: number}, whether it is reversed) of a law."""
    backwards = name.startswith(REVERSED)
    key, bracket, inside = name[len(REVERSED) * backwards:].partition("(")
    numbers = dict(NUMBERS.get(key.strip(), {}))
    if bracket and not inside.endswith(")"):
        raise Unverified(f"the law {name}")
    for place, argument in enumerate(inside[:-1].split(",") if bracket else ()):
        given, sign, value = argument.rpartition("=")
        own = given.strip() if sign else list(numbers)[place] if place < len(numbers) else None
        if own not in numbers:
            raise Unverified(f"the law {name}")
        numbers[own] = Fraction(value.strip())
    return key.strip(), numbers, backwards


def is_same(name, other):
    """Whether two names mean one law; numbers as doubles."""
    if name is None or other is None:
        return name is other
    (key, numbers, way), (other_key, other_numbers, other_way) = parsed(name), parsed(other)
    return key == other_key and way == other_way and \
        all(abs(own - other_numbers[n]) <= CLOSE * max(1, abs(own)) for n, own in numbers.items())


def jumps(name):
    """Whether f'' jumps inside, or at an end that rests."""
    key, numbers, _ = parsed(name)
    return key in ("parabolic", "asymmetric_parabolic", "simple_harmonic", "trapezoid") or \
        key == "scca" and not (numbers["sine"] and numbers["cosine"]) or \
        key == "polynomial" and any(numbers[f"{end}_acceleration"] and not numbers[f"{end}_velocity"] for end in ("start", "end"))


def turns_back(name):
    return parsed(name)[0].startswith(("one_dwell_", "double_"))


def constant(value):
    return Jet.number(Fraction(value))


# -- pieces of f'': (width, a polynomial, [(half turns of the argument, factor of the sine, of the cosine)])

def sine_up(width, height=1):
    return width, [0], [(HALF, height, 0)]


def cosine_down(width, height=1):
    return width, [0], [(HALF, 0, height)]


def half_sine(width, height=1):
    return width, [0], [(1, height, 0)]


def level(width, height=1):
    return width, [height], []


def odd_sines(*amplitudes):
    """The first half of u - sum of amplitude sin 2 pi (2 k + 1) u, up to a factor."""
    return [(HALF, [0], [(n, a * n * n, 0) for n, a in zip((1, 3, 5), amplitudes)])]


def stretched(pieces, by):
    return [(width * by, [c / by**(m + 1) for m, c in enumerate(line)], [(h, s / by, c / by) for h, s, c in waves]) for width, line, waves in pieces]


HALVES = {"parabolic": [level(HALF)], "simple_harmonic": [cosine_down(HALF)], "cycloidal": [half_sine(HALF)],
          "cycloidal_cv50": [half_sine(HALF / 2), level(HALF / 2, 0)],
          "gutman_13": odd_sines(Fraction(15, 32), Fraction(1, 96)), "freudenstein_13": odd_sines(Fraction(27, 56), Fraction(1, 168)),
          "freudenstein_135": odd_sines(Fraction(1), Fraction(1, 54), Fraction(1, 1250))}


def scca(sine, constant, cosine, coast):
    """The first half: a quarter sine, its height, a quarter cosine, nothing."""
    parts = [sine_up(sine) if sine else None, level(constant) if constant else None, cosine_down(cosine) if cosine else None,
             level(coast, 0) if coast else None]
    return [part for part in parts if part]


def half_of(key, numbers):
    """Pieces of f'' over 0 <= u <= 1/2 of a law with f(u) + f(1 - u) = 1; None: it is none."""
    if key == "scca":
        whole = 2 * sum(numbers.values())
        return scca(*(part / whole for part in numbers.values()))
    if key == "modified_sine":
        return scca(numbers["Ta"], 0, HALF - numbers["Ta"], 0)
    if key == "modified_trapezoid":
        return scca(numbers["Ta"], HALF - 2 * numbers["Ta"], numbers["Ta"], 0)
    if key.startswith("mcv_"):
        return scca(numbers["a"], 0, numbers["b"] - numbers["a"], HALF - numbers["b"])
    if key == "polynomial_345":
        return [(HALF, derivative(FIXED[key], 2), [])]
    return HALVES.get(key)


def turned(pieces):
    """Pieces of f'' of 1 - f(1 - u), a wave from its end, up to a sign; of the second half where f(u) + f(1 - u) = 1."""
    found = []
    for width, line, waves in reversed(pieces):
        own = []
        for h, s, c in waves:
            if h == HALF:
                own.append((h, -c, -s))
            else:
                sign = (-1)**int(h)
                own.append((h, sign * s, -sign * c))
        found.append((width, [-c * (-1)**m for m, c in enumerate(shifted(line, width))], own))
    return found


@functools.cache
def shape_of(law):
    """(f'(0), pieces of f'') of a law, up to a factor. Laws with waves begin and end with f' = 0."""
    key, numbers, backwards = parsed(law)
    slope, own = 0, one_dwell(key, numbers)
    if key == "polynomial" or key in FIXED:
        whole = FIXED.get(key) or between_states(*numbers.values())
        slope, own = whole[1], [(Fraction(1), derivative(whole, 2), [])]
    elif key in ("trapezoid", "s_curve"):
        own = ramped(*numbers.values())
    elif key.startswith("asymmetric_"):
        half, split = half_of(key[len("asymmetric_"):], {n: x for n, x in numbers.items() if n != "split"}), numbers["split"]
        own = half and stretched(half, 2 * split) + stretched(turned(half), 2 * (1 - split))
    elif own is None:
        half = half_of(key, numbers)
        own = half and half + turned(half)
    if not own:
        raise Unverified(f"the law {law}")
    if not backwards:
        return slope, own
    if not any(waves for _, _, waves in own):
        slope += sum(integral(line, width) for width, line, _ in own)
    return slope, turned(own)


def one_dwell(key, numbers):
    if key == "double_harmonic":
        return [(Fraction(1), [0], [(1, 0, 1), (2, 0, -1)])]
    if key == "one_dwell_modified_sine":
        ta = numbers["Ta"]
        zero = 1 / (2 - ta)
        return [sine_up(ta), cosine_down(zero - ta), sine_up(1 - zero, -1 / (1 - ta))]
    if key == "one_dwell_cycloidal":
        two = middle_of(root(Fraction(2)))[0]
        return [half_sine(2 - two), sine_up(two - 1, -two)]
    if key == "one_dwell_modified_trapezoid":
        ta = numbers["Ta"]
        zero = HALF + ta * (HALF - 1 / PI_ITSELF)
        return [sine_up(ta), level(zero - 2 * ta), (2 * ta, [0], [(1, 0, 1)]), level(1 - zero - ta, -1)]
    return None


def is_symmetric(law):
    """Whether f(u) + f(1 - u) = 1."""
    key, numbers, _ = parsed(law)
    if key in ("trapezoid", "s_curve"):
        return 2 * numbers["acceleration"] + numbers["coast"] == 1
    return not key.startswith(("asymmetric", "one_dwell", "double", "run_")) and key != "polynomial"


def ramped(acceleration, coast, ramp=Fraction(0)):
    """Pieces of f'' of acceleration, constant velocity, deceleration, up to a factor."""
    found, last = [], 1 - acceleration - coast
    for width, height in ((acceleration, Fraction(1)), (coast, Fraction(0)), (last, -acceleration / last)):
        edge = ramp * width if height else Fraction(0)
        parts = [(edge, [Fraction(0), height / edge if edge else 0], []), (width - 2 * edge, [height], []),
                 (edge, [height, -height / edge if edge else 0], [])]
        found += [part for part in parts if part[0]]
    return found


def between_states(v0, a0, v1, a1):
    return [Fraction(0), v0, a0 / 2, 10 - 6 * v0 - 4 * v1 - a0 * 3 / 2 + a1 / 2, -15 + 8 * v0 + 7 * v1 + a0 * 3 / 2 - a1,
            6 - 3 * v0 - 3 * v1 - a0 / 2 + a1 / 2]


@functools.cache
def polynomials_of(law):
    """[(width, f by v from the piece's beginning)], or None: f is none."""
    slope, pieces = shape_of(law)
    if any(waves for _, _, waves in pieces):
        return None
    found, y = [], Fraction(0)
    for width, line, _ in pieces:
        own = [y, slope] + [Fraction(c) / ((m + 1) * (m + 2)) for m, c in enumerate(line)]
        found.append((width, own))
        y, slope = value_at(own, width), value_at(derivative(own), width)
    return [(width, [c / y for c in own]) for width, own in found]


def polynomial_of(law):
    """f as one polynomial; None: it is none."""
    found = polynomials_of(law)
    return found[0][1] if found and len(found) == 1 else None


def polynomial_between(begin, end):
    """The name of the polynomial between states (velocity, acceleration or None: free) of both ends, by u."""
    (v0, a0), (v1, a1) = begin, end
    if a0 is None and a1 is None:
        a0, a1 = 6 - 4 * v0 - 2 * v1, -6 + 2 * v0 + 4 * v1
    elif a1 is None:
        a1 = -12 + 6 * v0 + 6 * v1 + a0
    elif a0 is None:
        a0 = 12 - 6 * v0 - 6 * v1 + a1
    return f"polynomial({v0}, {a0}, {v1}, {a1})"


@functools.cache
def harmonic(law):
    """Pieces (width, a, [(w, b, c)], [f, f'] at its beginning) of f'' = a + sum of b sin w v + c cos w v, v from there."""
    size = None
    for _ in range(2):  # the second time with f(1) = 1
        found, begin = [], [constant(0), constant(0)]
        for width, line, waves in shape_of(law)[1]:
            if len(line) > 1:
                raise Unverified(f"the law {law}")
            own = (width, constant(line[0]), [(PI * (h / width), constant(s), constant(c)) for h, s, c in waves])
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
        found = [begin[0] + begin[1] * v + a * v.square() * Fraction(1, 2), begin[1] + a * v, a, constant(0)]
        for (w, b, c), inverse in zip(waves, inverses):
            sine, cosine = (w * v).sine_and_cosine()
            rest = 1 - cosine
            parts = (b * (v - sine * inverse) + c * inverse * rest) * inverse, (b * rest + c * sine) * inverse, b * sine + c * cosine, \
                (b * cosine - c * sine) * w
            found = [f + part for f, part in zip(found, parts)]
        return found
    return piece


@functools.cache
def pieces_of(law):
    """[(width, v -> [f, f', f'', f'''])]; nothing of where f'' jumps."""
    polynomials = polynomials_of(law)
    if polynomials is None:
        return [(piece[0], along(*piece)) for piece in harmonic(law)]
    orders = [(width, [[constant(c) for c in derivative(y, order)] for order in range(4)]) for width, y in polynomials]
    return [(width, lambda v, own=own: [value_at(c, v) for c in own]) for width, own in orders]


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
            found = [(rise / length**order) * f for order, f in enumerate(piece(v)[:orders])]
            return [stretch.start + found[0]] + found[1:]
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
    total = line[0].square() * x + line[0] * line[1] * x.square() + line[1].square() * x * x.square() * Fraction(1, 3)

    def of_wave(w):
        """Integrals of sin, cos, v sin, v cos."""
        sine, cosine = (w * x).sine_and_cosine()
        inverse = w.inverse()
        s, c = (1 - cosine) * inverse, sine * inverse
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
    if is_symmetric(law):
        return Fraction(1, 2)
    polynomials = polynomials_of(law)
    if polynomials is not None:
        return sum(integral(y, width) for width, y in polynomials)
    total = constant(0)
    for width, a, waves, begin in harmonic(law):
        x, half = constant(width), constant(Fraction(1, 2))
        total = total + begin[0] * x + begin[1] * x.square() * half + a * x * x.square() * Fraction(1, 6)
        for w, b, c in waves:
            sine, cosine = (w * x).sine_and_cosine()
            inverse = w.inverse()
            total = total + (b * (x.square() * half - (1 - cosine) * inverse.square()) +
                             c * inverse * (x - sine * inverse)) * inverse
    return middle_of(ends_of(total))[0]


@functools.cache
def law_peak(law, name):
    """(low, high) around the largest |f^(r)|, of "torque" |f' f''|, of "rms_..." a root mean square."""
    if name.endswith("jerk") and jumps(law):
        raise Unverified(f"the {name} of the law {law}")
    if name.startswith("rms_"):
        low, high = square_integral(law, ORDERS[name[4:]])
        return root(low)[0], root(high)[1]

    def value(piece, sign):
        def at(v):
            found = piece(v)
            return sign * (found[1] * found[2] if name == "torque" else found[ORDERS[name]])
        return at
    return enclosures.largest([(0, width, value(piece, sign)) for width, piece in pieces_of(law) for sign in (1, -1)], PLACES, CLOSE,
                              f"{name} along a law")
