# SPDX-License-Identifier: MIT
"""The file's own arithmetic, repeated exactly.

Theorem. `stored_bound` is the number that the file's own rows, multipliers and box prove by weak duality; the box contains the delivered motion
(`check_box`), or what is beyond it costs no less. Nothing else relies on these rows: bound.py builds its own.
"""

import itertools

from .exact import ORDERS, Refuted, STATED, number
from .rational import Fraction
from .runs import name_in_run, name_of_peak

QUOTE = "'"  # of a derivative in the name of a state


def stored_bound(proof):
    """The recipe of the file, in exact arithmetic: what its own numbers prove."""
    reduced = [number(c) for c in proof["cost"]]
    total = number(proof["constant"])
    for row in proof["rows"]:
        m = number(row["multiplier"])
        if not m:
            continue
        side = row["upper"] if m > 0 else row["lower"]
        if side is None:
            raise Refuted(f"{row['name']}: the multiplier leans on a side that is open")
        total -= m * number(side)
        if len(row["indices"]) != len(row["values"]):
            raise Refuted(f"{row['name']}: its lists do not match")
        for index, weight in zip(row["indices"], row["values"]):
            reduced[index] += m * number(weight)
    for r, low, high in zip(reduced, proof["box"]["lower"], proof["box"]["upper"], strict=True):
        if r:
            end = low if r > 0 else high
            if end is None:
                raise Refuted("the stored proof leans on a side of the box that is open")
            total += r * number(end)
    return total


def factor_of(proof, problem):
    """Weights and references far from 1 are divided by the same power of two before they are solved: the file's rows
    then are in other units, and its multipliers are all smaller (or larger) by this factor."""
    for name, cost in zip(proof["variables"], proof["cost"]):
        for term in problem.terms:
            if term.weight and cost and term.kind in ("peak", "deviation") and name == name_of_peak(term):
                return term.weight / number(cost)
    return Fraction(1)


def check_box(proof, result, problem, factor):
    """The box is said to hold the best motion: the delivered one lies in it, but for peaks that cost no less than the bound by themselves
    (`dear`). States at the joints of several strokes may be in units of either."""
    sizes = [Fraction(1)] + [problem.references[name] / factor for name in ORDERS]
    curves, design = result["motion"]["curves"], dict(zip(result["design"]["names"], result["design"]["values"]))
    values = {}
    for (k, curve), (order, size) in itertools.product(enumerate(curves), enumerate(sizes)):
        for i, x in enumerate(curve["breakpoints"]):
            name = name_in_run(f"y{order * QUOTE}[{i}]", k, len(curves))
            if name in design:
                values[name] = [number(design[name]) / size / own for own in strokes_at(problem, number(x), order)]
    for term in problem.terms:
        if term.kind == "peak":
            name = next(name for name, order in ORDERS.items() if order == term.order)
            values[name_of_peak(term)] = [number(result["peaks"][name]["value"]) / sizes[term.order]]
    for name, cost, low, high in zip(proof["variables"], proof["cost"], proof["box"]["lower"], proof["box"]["upper"], strict=True):
        dear = cost > 0 and None not in (high, proof["bound"]) and number(cost) * number(high) >= number(proof["bound"])
        if name in values and not any((low is None or v >= number(low) - STATED * 1000 * max(1, abs(v))) and
                                      (high is None or dear or v <= number(high) + STATED * 1000 * max(1, abs(v)))
                                      for v in values[name]):
            raise Refuted(f"the box of {name} does not hold the delivered motion")


def strokes_at(problem, x, order):
    """What a derivative at a breakpoint may be in units of: of one stroke, or of two that join there."""
    if problem.type == "RR":  # beyond the top in units of the return
        return [Fraction(1), 1 / (problem.stretches[0].end - 1)**order]
    if len(problem.stretches) == 1 or not order:
        return [Fraction(1)]
    return [Fraction(1)] + [s.scale(order) for s in problem.stretches
                            if s.kind == "spline" and s.begin - STATED <= x <= s.end + STATED]
