# SPDX-License-Identifier: MIT
"""Exact arithmetic: fractions and polynomials.

Theorem. The square root lies between the two fractions of `root`. `largest` encloses the maximum of polynomials over intervals: it lies below the largest Bernstein
coefficient, and at or above the value at each end of a part (de Casteljau).
"""
import heapq
import math
import sys

from .rational import Fraction

SAME_PLACE = Fraction(1, 10**13)   # x: a double meant as a breakpoint is this close to it
KEPT = Fraction(1, 10**8)          # a limit that is kept to within this part of it is kept, as camopt promises
STATED = Fraction(1, 10**9)        # numbers in the files are right to this, relative
NOT_CONVEX = 1000                  # solver.gap of scenes that are not convex, where it is not given: 1e-4 for 1e-7
JOINED = Fraction(1, 10**5)        # y'' and y''' of the delivered motion are those of the exact one to this, relative
ORDERS = {"velocity": 1, "acceleration": 2, "jerk": 3}


class Refuted(Exception):
    """Something is claimed that is not so, or not proved by what is there."""


class Unverified(Exception):
    """Something that this checker has no proof for."""


def require_every_row(left_out):
    """Of a proof that falls short: without rows that the checker does not use it is not known to be wrong."""
    if left_out:
        raise Unverified("rows of " + ", ".join(sorted(left_out)))


def number(value):
    """A number of a file, exactly: JSON's are doubles, TOML's are the decimals as written."""
    return Fraction(value)


def root(value):
    """(low, high) around the square root of value >= 0."""
    scale = 2**140
    low = math.isqrt(value.numerator * scale * scale // value.denominator)
    return Fraction(low, scale), Fraction(low + 1, scale)


def middle_of(enclosure):
    """(a short fraction in the middle, how far the number can be from it)."""
    middle = Fraction(round((enclosure[0] + enclosure[1]) * 2**119), 2**120)
    return middle, max(enclosure[1] - middle, middle - enclosure[0])


sys.set_int_max_str_digits(0)  # exact numbers are long


def add_to(function, row, factor=1):
    """A function of control points, {control point: weight}, plus another one times a factor."""
    for j, w in row.items():
        function[j] = function.get(j, Fraction(0)) + factor * w


def value_at(polynomial, t):
    """Of numbers, or of coefficients or a place that are enclosed."""
    total = polynomial[-1]
    for coefficient in reversed(polynomial[:-1]):
        total = total * t + coefficient
    return total


def derivative(polynomial, order=1):
    for _ in range(order):
        polynomial = [m * polynomial[m] for m in range(1, len(polynomial))] or [Fraction(0)]
    return polynomial


def product(a, b):
    result = [Fraction(0)] * (len(a) + len(b) - 1)
    for i, x in enumerate(a):
        for j, y in enumerate(b):
            result[i + j] += x * y
    return result


def combination(*terms):
    """Sum of factor * polynomial."""
    result = [Fraction(0)] * max(len(polynomial) for _, polynomial in terms)
    for factor, polynomial in terms:
        for m, coefficient in enumerate(polynomial):
            result[m] += factor * coefficient
    return result


def shifted(polynomial, by):
    """The polynomial of t + by."""
    result = [Fraction(0)]
    for coefficient in reversed(polynomial):
        result = combination((1, product(result, [by, Fraction(1)])), (1, [coefficient]))
    return result[:max(1, len(polynomial))]


def integral(polynomial, width):
    return sum((c * width**(m + 1) / (m + 1) for m, c in enumerate(polynomial)), Fraction(0))


def bernstein(polynomial, width):
    """Control values over 0 <= t <= width: the polynomial's values lie between the least and the largest."""
    d = len(polynomial) - 1
    scaled = [c * width**m / math.comb(d, m) for m, c in enumerate(polynomial)]
    return [sum((math.comb(j, m) * scaled[m] for m in range(j + 1)), Fraction(0)) for j in range(d + 1)]


GRID = 2**160  # control values are rounded to this grid before they are halved: halving them is then cheap
ROUNDED = 2**20  # steps of the grid: halving changes them by less, however often


def on_grid(control):
    return [c.numerator * GRID // c.denominator for c in control]


def halves(control):
    """Control values over the left and over the right half (de Casteljau), on the grid."""
    left, right, row = [control[0]], [control[-1]], control
    while len(row) > 1:
        row = [(a + b) >> 1 for a, b in zip(row, row[1:])]
        left.append(row[0])
        right.append(row[-1])
    return left, right[::-1]


def largest(pieces, closeness=Fraction(1, 10**12)):
    """(low, high) around the maximum over all pieces (polynomial, width): the stretch of the largest control value is
    halved until no stretch can hold more than what some end of a stretch has."""
    heap, low = [], None
    for count, (polynomial, width) in enumerate(pieces):
        control = on_grid(bernstein(polynomial, width))
        heap.append((-max(control), count, control))
        end = max(control[0], control[-1])
        low = end if low is None else max(low, end)
    if not heap:
        return Fraction(0), Fraction(0)
    heapq.heapify(heap)
    count = len(heap)
    room = int(GRID * closeness)
    while heap and -heap[0][0] > low + max(room, abs(low) * room // GRID):
        control = heapq.heappop(heap)[2]
        for half in halves(control):
            count += 1
            low = max(low, half[0], half[-1])
            if max(half) > low:
                heapq.heappush(heap, (-max(half), count, half))
    high = max(low, -heap[0][0]) if heap else low
    return Fraction(low - ROUNDED, GRID), Fraction(high + ROUNDED, GRID)


def largest_magnitude(pieces):
    both = [(p, w) for p, w in pieces] + [([-c for c in p], w) for p, w in pieces]
    return largest(both)
