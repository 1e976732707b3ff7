# SPDX-License-Identifier: MIT
"""The file's own arithmetic."""

from .exact import ORDERS, Refuted, STATED, number
from .rational import Fraction


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
            own = "peak " + next(n for n, o in ORDERS.items() if o == term.order) if term.kind == "peak" else term.kind
            if term.weight and name == own and own.startswith(("peak", "deviation")) and cost and term.kind != "deviation_rms":
                return term.weight / number(cost)
    return Fraction(1)


def check_box(proof, result, problem, factor):
    """The box is said to hold the best motion: the delivered one lies in it. States at the joints of several strokes may be in
    units of either."""
    sizes = {"'" * order: problem.references[name] / factor for name, order in ORDERS.items()} | {"": Fraction(1)}
    values = {}
    for name, value in zip(result["design"]["names"], result["design"]["values"]):
        own = name.split(" of run ")[0]
        marks = "'" * own.count("'")
        if name.startswith("y") and marks in sizes:
            values[name] = [number(value) / sizes[marks] / size for size in strokes_at(result, problem, name, len(marks))]
    for name, order in ORDERS.items():
        size = sizes.get("'" * order)
        term = next((t for t in problem.terms if t.kind == "peak" and t.order == order), None)
        if size and term:
            values["peak " + name] = [number(result["peaks"][name]["value"]) / size]
    for name, low, high in zip(proof["variables"], proof["box"]["lower"], proof["box"]["upper"], strict=True):
        if name in values and not any((low is None or v >= number(low) - STATED * 1000 * max(1, abs(v))) and
                                      (high is None or v <= number(high) + STATED * 1000 * max(1, abs(v)))
                                      for v in values[name]):
            raise Refuted(f"the box of {name} does not hold the delivered motion")


def strokes_at(result, problem, name, order):
    """What a state of a breakpoint, "y''[3] of run 2", may be in units of: of one stroke, or of two that join there."""
    if problem.type == "RR":  # beyond the top in units of the return
        return [Fraction(1), 1 / (problem.stretches[0].end - 1)**order]
    if len(problem.stretches) == 1 or not order:
        return [Fraction(1)]
    index, _, run = name.split("[")[1].partition("]")
    curve = result["motion"]["curves"][int(run.removeprefix(" of run ") or 1) - 1]
    x = number(curve["breakpoints"][int(index)])
    return [Fraction(1)] + [s.scale(order) for s in problem.stretches
                            if s.kind == "spline" and s.begin - STATED <= x <= s.end + STATED]
