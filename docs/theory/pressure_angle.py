#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""The numbers of docs/theory/pressure_angle.md, computed with nothing of camopt: NumPy and SciPy's linear programs.

A cubic C2 spline on n equal segments, its B-spline coefficients the variables; rows at 40 points a segment, so that the
figures are below the true optima by the little that can happen between them. mm, rad.
"""

import math
import sys

import numpy
from scipy.interpolate import BSpline
from scipy.optimize import linprog

LIFT, RISE, LIMIT = 20.0, math.radians(60), math.radians(30)
COST = [0.4 / 1.76, 0.4 / 5.53, 0.2 / 69.0]
SAMPLES = 40


def values(n, order, points):
    """The matrix from coefficients to the order-th derivative at the points, x in [0, 1]."""
    knots = numpy.concatenate([[0.0] * 3, numpy.linspace(0.0, 1.0, n + 1), [1.0] * 3])
    return numpy.array([BSpline(knots, unit, 3)(points, nu=order) for unit in numpy.eye(n + 3)]).T


def optimum(n, prime=None, antisymmetric=False):
    """(objective, prime radius) with a given prime radius; with prime = None the least one that can be."""
    points = (numpy.arange(n * SAMPLES) + 0.5) / (n * SAMPLES)
    points = numpy.sort(numpy.concatenate([points, numpy.linspace(0.0, 1.0, n + 1)]))
    size = n + 3
    rows, right = [], []
    for order in (1, 2, 3):
        y = values(n, order, points)
        peak = numpy.zeros((len(points), 4))
        peak[:, order - 1] = -1.0
        rows += [numpy.hstack([y, peak]), numpy.hstack([-y, peak])]
        right += [numpy.zeros(2 * len(points))]
    y, slope = values(n, 0, points), values(n, 1, points)
    tangent = math.tan(LIMIT)
    for sign in (1.0, -1.0):  # sign s' <= tan(limit) (s0 + s)
        spline = sign * LIFT / RISE * slope - tangent * LIFT * y
        rows.append(numpy.hstack([spline, numpy.tile([0.0, 0.0, 0.0, -tangent], (len(points), 1))]))
        right.append(numpy.zeros(len(points)))
    ends = [numpy.vstack([values(n, order, numpy.array([x])) for order in (0, 1, 2)]) for x in (0.0, 1.0)]
    equal = [numpy.hstack([numpy.vstack(ends), numpy.zeros((6, 4))])]
    level = [[0.0, 0.0, 0.0, 1.0, 0.0, 0.0]]
    if antisymmetric:
        half = (size + 1) // 2
        pairs = numpy.eye(size)[:half] + numpy.eye(size)[::-1][:half]
        equal.append(numpy.hstack([pairs, numpy.zeros((half, 4))]))
        level.append([1.0] * half)
    cost = numpy.zeros(size + 4)
    cost[size : size + 3] = COST
    bounds = [(None, None)] * size + [(0, None)] * 3 + [(prime, prime)]
    if prime is None:
        cost[:] = 0.0
        cost[-1], bounds[-1] = 1.0, (0.0, None)
    found = linprog(cost, numpy.vstack(rows), numpy.concatenate(right), numpy.vstack(equal), numpy.concatenate(level),
                    bounds, method="highs")
    return (found.fun, found.x[-1]) if found.status == 0 else None


def main():
    print(f"any motion: prime radius >= {LIFT / (math.exp(RISE * math.tan(LIMIT)) - 1.0):.4f} mm")
    for n in [24, 48] + ([96] if "long" in sys.argv else []):
        print(f"least of a cubic of {n} segments: {optimum(n)[1]:.4f} mm")
    for prime in (50, 40, 35, 30, 28):
        words = [f"{found[0]:.6f}" if found else "infeasible" for found in (optimum(24, prime), optimum(24, prime, True))]
        print(f"prime radius {prime} mm: {words[0]}, antisymmetric {words[1]}")


main()
