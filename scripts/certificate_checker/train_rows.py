# SPDX-License-Identifier: MIT
"""Rows of an elastic follower's vibration in a bound.

After a motion the output rings with |E| / v, E complex and linear in the motion (train.py), at every speed of the range. For any
number u of magnitude 1 that is at least Re(conj(u) E) / v, which is linear. certificate.json names the speed of such a row, not its u:
which is taken is free. The checker takes that of the delivered motion, turned such that with the other rows as little as can be is left.
"""
from fractions import Fraction

from .exact import Unverified, add_to, number, root
from .runs import Row

LIGHT = Fraction(1, 10**7)  # rows lighter than this part of the heaviest are left out
FREE = Fraction(1, 10**4)   # how much less a turn is damped than that of a tangent: two speeds are no neighbours


def use_ringing_rows(bound):
    problem, train = bound.problem, bound.problem.train
    place = next(i for i, term in enumerate(problem.terms) if term.kind == "residual")
    reference = problem.terms[place].reference
    if bound.curve is None or len(problem.runs) != 1:
        raise Unverified("rows of " + bound.ringing[0][0]["rule"])
    weights = {}
    for origin, multiplier in bound.ringing:
        time = time_of(train, origin.get("remark", ""))
        if origin["limit"]:  # the row is in parts of the limit
            multiplier *= reference / train.residual_limit()
        add_to(weights, {time: multiplier})
    heaviest = max(weights.values())
    parts = []  # (real, imaginary) part of E / (v reference), the multiplier times u
    for time, weight in weights.items():
        if weight <= heaviest * LIGHT:
            continue
        functions = [in_units(f, reference) for f in train.residual_functions(problem.runs[0], time)]
        values = [sum((w * bound.curve.control[0][j] for j, (w, _) in f.items()), Fraction(0)) for f in functions]
        size = root(values[0]**2 + values[1]**2)[1]
        parts += [(function, weight * value / size) for function, value in zip(functions, values)]
    columns = [(0, {j: w for j, (w, _) in f.items()}, Fraction(1)) for f, _ in parts]
    size = max(abs(u) for _, u in parts)
    scaled = [(k, f, size) for k, f, _ in columns]
    beside = [(Parts(f), u) for (_, f, _), (_, u) in zip(columns, parts)]
    more = bound.fitted(scaled, [FREE] * len(parts), beside) or [Fraction(0)] * len(parts)
    turned = [(f, u + size * by) for (f, u), by in zip(parts, more)]
    most = bound.supremum[0][0] * problem.runs[0].space.spread(0)  # of a control point
    for (real, a), (imaginary, b) in zip(turned[::2], turned[1::2]):
        multiplier = root(a * a + b * b)[1]
        row = {j: (a * real[j][0] + b * imaginary[j][0]) / multiplier for j in real}
        error = sum((real[j][1] + imaginary[j][1] for j in real), Fraction(0)) * most
        bound.use(Row(f"residual at T = {float(1 / problem.turns_per_second())}", 0, row, error, place), multiplier)


class Parts:
    """What bound.fitted() wants of a row."""

    def __init__(self, function):
        self.run, self.function = 0, function


def in_units(function, size):
    return {j: (w / size, error / size) for j, (w, error) in function.items()}


def time_of(train, remark):
    """Seconds of a unit of x at the speed that a row names, "280 rpm"; any of the range will do."""
    words = remark.split()
    if len(words) != 2 or words[1] != "rpm":
        return train.times[0]
    return min(max(train.time_at(number(words[0])), train.times[0]), train.times[1])
