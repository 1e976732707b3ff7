# SPDX-License-Identifier: MIT
"""The lower bound for every curve."""
import math
from fractions import Fraction

from .conditions import solved
from .exact import Unverified, largest_magnitude, number


def any_curve_bound(problem, curve):
    """A lower bound of w . (V, A, J) over all motions of a rise between dwells. The quickest motion for given peaks is
    the double-S, so that every motion has

        g1 = 1/V + V/A + A/J <= 1,   g2 = V^2/A + VA/J <= 1,   g3 = A^2/(VJ) <= 1.

    With multipliers m >= 0, F = w.(V, A, J) + m.(g - 1) is a sum of exponentials of the logarithms of V, A, J, hence
    convex in these: F >= F0 + slope . (logarithms - theirs at the point). The point: the delivered motion's own
    peaks."""
    if problem.type != "DRD" or any(t.kind != "peak" for t in problem.terms if t.weight):
        raise Unverified("the limit of any curve for this kind of motion")
    weights = [Fraction(0)] * 3
    for term in problem.terms:
        weights[term.order - 1] += term.weight / term.reference
    if not all(weights):
        raise Unverified("the limit of any curve where a weight is 0")
    peaks = [largest_magnitude(curve.along(order))[1] for order in (1, 2, 3)]
    incumbent = sum(w * p for w, p in zip(weights, peaks))
    best = Fraction(0)
    for used in ((0,), (0, 1), (0, 2), (0, 1, 2)):
        found = stationary(weights, peaks, used)
        if found is None:
            continue
        point, multipliers = found
        bound = sum(w * p for w, p in zip(weights, point))
        slope = [w * p for w, p in zip(weights, point)]
        for m, terms in zip(multipliers, double_s(point)):
            bound += m * (sum(value for value, _ in terms) - 1)
            slope = [s + m * sum(value * e[i] for value, e in terms) for i, s in enumerate(slope)]
        # 1 <= V, A, J <= incumbent / weight of every motion that is better; |log q| <= max(q, 1/q) - 1.
        bound -= sum(abs(s) * max(incumbent / w / p, p) for s, w, p in zip(slope, weights, point))
        best = max(best, bound)
    return best


def double_s(point):
    """g1, g2, g3 as terms (value, exponents of V, A, J)."""
    v, a, j = point
    return [[(1 / v, (-1, 0, 0)), (v / a, (1, -1, 0)), (a / j, (0, 1, -1))],
            [(v * v / a, (2, -1, 0)), (v * a / j, (1, 1, -1))],
            [(a * a / (v * j), (-1, 2, -1))]]


def stationary(weights, peaks, used):
    """Newton's method in floating point: peaks and multipliers where F is level and the constraints in use are met."""
    weights, point, multipliers = [float(w) for w in weights], [float(p) for p in peaks], [0.0] * 3
    for _ in range(60):
        size = 3 + len(used)
        matrix = [[Fraction(0)] * (size + 1) for _ in range(size)]
        for i in range(3):
            matrix[i][i] += number(weights[i] * point[i])
            matrix[i][size] -= number(weights[i] * point[i])
        terms = double_s(point)
        for column, k in enumerate(used):
            for value, e in terms[k]:
                for i in range(3):
                    matrix[i][size] -= number(multipliers[k] * value * e[i])
                    matrix[i][3 + column] += number(value * e[i])
                    matrix[3 + column][i] += number(value * e[i])
                    for j in range(3):
                        matrix[i][j] += number(multipliers[k] * value * e[i] * e[j])
            matrix[3 + column][size] += number(1 - sum(value for value, _ in terms[k]))
        step = solved(matrix)
        if step is None or max(abs(s) for s in step) > 10**6:
            return None
        part = min(1.0, 0.5 / max(1e-300, max(abs(float(s)) for s in step[:3])))
        point = [p * math.exp(part * float(s)) for p, s in zip(point, step)]
        for column, k in enumerate(used):
            multipliers[k] += part * float(step[3 + column])
    if min(multipliers) < 0:
        return None
    return [number(p) for p in point], [number(m) for m in multipliers]
