# SPDX-License-Identifier: MIT
"""Vectors (x, y) of enclosed numbers, and signs of numbers that are enclosed.

Theorem. Each function encloses its result where its operands do; `sign_of` is exact for a number whose enclosure does not contain 0.
"""
from .laws import constant
from .exact import Unverified


def plus(a, b):
    return a[0] + b[0], a[1] + b[1]


def minus(a, b):
    return a[0] - b[0], a[1] - b[1]


def scaled(factor, a):
    return factor * a[0], factor * a[1]


def dot(a, b):
    return a[0] * b[0] + a[1] * b[1]


def across(a):
    """Turned by +90 degrees."""
    return -a[1], a[0]


def turned(a, by):
    """By the angle of a unit vector."""
    return a[0] * by[0] - a[1] * by[1], a[0] * by[1] + a[1] * by[0]


def direction(angle):
    sine, cosine = angle.sine_and_cosine()
    return cosine, sine


def sign_of(number):
    """+1 or -1 as a number, of what is not 0 anywhere."""
    low, high = number.value
    if low <= 0 <= high:
        raise Unverified("a formula whose lever may vanish in a box")
    return constant(1 if low > 0 else -1)


def divided(a, b):
    """a / b, b on one side of 0."""
    sign = sign_of(b)
    return sign * a * (sign * b).inverse()
