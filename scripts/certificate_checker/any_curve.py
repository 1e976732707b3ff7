# SPDX-License-Identifier: MIT
"""The lower bound for every curve, of a rise between dwells whose objective is a sum of weighted peaks V, A, J of y', y'', y'''.

Theorem. Let y rise from rest at 0 to rest at 1 over a unit of x, with |y'| <= V, |y''| <= A, |y'''| <= J. The fastest motion within these peaks
is the double-S, so that g <= 1 for the three functions g of `double_s`. Each g, each weighted peak and each peak / limit is a sum of
exponentials of linear functions of (log V, log A, log J), hence convex in these: the tangent plane of objective + multipliers * (g - 1) at any
point, for any multipliers >= 0, is a lower bound of the objective over every motion in the range of V, A, J (`any_curve_bound`). If a finite
cover of that range has a g above 1 in each of its boxes, no motion exists (`require_no_curve`).
"""
import itertools
import math

from .conditions import solved
from .exact import Refuted, STATED, Unverified, largest_magnitude, number
from .rational import Fraction

MOST_BOXES = 40000
SIGNS = [(a, b) for a in (1, -1) for b in (1, -1)]  # of the exponents of V and A in a term that is least there


def tops_of(problem, options):
    """The largest that V, A and J can be, from options of each (None: without bound): A <= J and V <= A are parts of g1. Also the limits."""
    if problem.type != "DRD" or problem.runs[0].rests != (True, True):
        raise Unverified("the limit of any curve for this kind of motion")
    caps, tops, above = [None] * 3, [None] * 3, None
    for term in problem.terms:
        if term.kind == "peak" and term.cap is not None:
            caps[term.order - 1] = term.cap
    for i in (2, 1, 0):
        tops[i] = above = min((top for top in (options[i], caps[i], above) if top is not None), default=None)
    return tops, caps


def any_curve_bound(problem, curve):
    """A lower bound of w . (V, A, J) over all motions of a rise between dwells. The quickest motion for given peaks is
    the double-S, so that every motion has

        g1 = 1/V + V/A + A/J <= 1,   g2 = V^2/A + VA/J <= 1,   g3 = A^2/(VJ) <= 1,

    and its limits, V/limit <= 1. With multipliers m >= 0, F = w.(V, A, J) + m.(g - 1) is a sum of exponentials of the logarithms of V, A, J,
    hence convex in these: F >= F0 + slope . (logarithms - theirs at the point). The point: the delivered motion's own
    peaks. Terms with a peak that nothing bounds, all of them above 0, are left out."""
    if any(t.kind != "peak" for t in problem.terms if t.weight):
        raise Unverified("the limit of any curve for this kind of motion")
    weights = [Fraction(0)] * 3
    for term in problem.terms:
        weights[term.order - 1] += term.weight / term.reference
    peaks = [largest_magnitude(curve.along(order))[1] for order in (1, 2, 3)]
    incumbent = sum(w * p for w, p in zip(weights, peaks))
    tops, caps = tops_of(problem, [incumbent / w if w else None for w in weights])
    active = [i for i in range(3) if tops[i] is not None]
    best = Fraction(0)
    for used in subsets([0, 1, 2] + [3 + i for i in active if caps[i] is not None]):
        found = stationary(weights, peaks, used, active, caps)
        if found is None:
            continue
        point, multipliers = found
        bound = sum(weights[i] * point[i] for i in active)
        slope = [w * p for w, p in zip(weights, point)]
        for m, k in zip(multipliers, used):
            terms = rules_at(point, active, caps)[k]
            bound += m * (sum(value for value, _ in terms) - 1)
            slope = [s + m * sum(value * e[i] for value, e in terms) for i, s in enumerate(slope)]
        # 1 <= V, A, J <= tops of every motion that is better; |log q| <= max(q, 1/q) - 1.
        bound -= sum(abs(slope[i]) * max(tops[i] / point[i], point[i]) for i in active)
        best = max(best, bound)
        if incumbent - best < incumbent * STATED:
            break
    return best


def subsets(rules):
    return [used for count in range(1, 4) for used in itertools.combinations(rules, count)]


def rules_at(point, active, caps):
    """g1, g2, g3 without terms of peaks that nothing bounds, and peak / limit of each."""
    kept = [[(value, e) for value, e in terms if all(i in active for i in range(3) if e[i])] for terms in double_s(point)]
    return kept + [[(point[i] / caps[i], tuple(int(i == j) for j in range(3)))] if caps[i] is not None else [] for i in range(3)]


def require_no_curve(problem, report):
    """No V, A, J within the limits satisfy g <= 1: boxes of V and A are halved, J is its limit."""
    tops, caps = tops_of(problem, [None] * 3)
    active = [i for i in range(3) if tops[i] is not None]
    boxes, count = [[(Fraction(1), top) if top is not None else (Fraction(1),) * 2 for top in tops[:2]]], 0
    while boxes:
        box, count = boxes.pop(), count + 1
        if any(low > high for low, high in box) or (tops[2] is not None and tops[2] < 1):
            continue
        corners = [tuple(Fraction(1) if e == 0 else box[i][0] if e > 0 else box[i][1] for i, e in enumerate(s)) for s in SIGNS]
        least = [0] * 3
        for k, terms in enumerate(zip(*(rules_at([*corner, tops[2] or Fraction(1)], active, [None] * 3)[:3] for corner in corners))):
            for n in range(len(terms[0])):
                least[k] += min(terms[c][n][0] for c in range(len(corners)))
        if max(least) > 1:
            continue
        middle = [sum(ends) / 2 for ends in box]
        if max(sum(value for value, _ in terms) for terms in rules_at([*middle, tops[2] or Fraction(1)], active, [None] * 3)[:3]) <= 1:
            raise Refuted("a curve satisfies all limits on the peaks")
        if count > MOST_BOXES:
            raise Unverified("limits on the peaks that a curve nearly satisfies")
        wide = max((0, 1), key=lambda i: box[i][1] - box[i][0])
        boxes += [[(box[i][0], middle[i]) if i == wide else box[i] for i in (0, 1)],
                  [(middle[i], box[i][1]) if i == wide else box[i] for i in (0, 1)]]
    report.say(f"no curve of any kind satisfies the limits on its peaks: {count} boxes")
    return []


def double_s(point):
    """g1, g2, g3 as terms (value, exponents of V, A, J)."""
    v, a, j = point
    return [[(1 / v, (-1, 0, 0)), (v / a, (1, -1, 0)), (a / j, (0, 1, -1))],
            [(v * v / a, (2, -1, 0)), (v * a / j, (1, 1, -1))],
            [(a * a / (v * j), (-1, 2, -1))]]


def stationary(weights, peaks, used, active, caps):
    """Newton's method in floating point: peaks and multipliers where F is level and the constraints in use are met."""
    weights, point, multipliers = [float(w) for w in weights], [float(p) for p in peaks], [0.0] * len(used)
    caps = [None if cap is None else float(cap) for cap in caps]
    count = len(active)
    for _ in range(60):
        size = count + len(used)
        matrix = [[Fraction(0)] * (size + 1) for _ in range(size)]
        for row, i in enumerate(active):
            matrix[row][row] += number(weights[i] * point[i])
            matrix[row][size] -= number(weights[i] * point[i])
        rules = rules_at(point, active, caps)
        for column, k in enumerate(used):
            for value, e in rules[k]:
                for row, i in enumerate(active):
                    matrix[row][size] -= number(multipliers[column] * value * e[i])
                    matrix[row][count + column] += number(value * e[i])
                    matrix[count + column][row] += number(value * e[i])
                    for other, j in enumerate(active):
                        matrix[row][other] += number(multipliers[column] * value * e[i] * e[j])
            matrix[count + column][size] += number(1 - sum(value for value, _ in rules[k]))
        step = solved(matrix)
        if step is None or max(abs(s) for s in step) > 10**15:
            return None
        part = min(1.0, 0.5 / max(1e-300, max(abs(float(s)) for s in step[:count])))
        for i, s in zip(active, step):
            point[i] *= math.exp(part * float(s))
        for column in range(len(used)):
            multipliers[column] += part * float(step[count + column])
    if min(multipliers) < 0:
        return None
    return [number(p) for p in point], [number(m) for m in multipliers]
