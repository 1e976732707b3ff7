# SPDX-License-Identifier: MIT
"""The bound in the format VIPR.

Theorem. The file is a linear program over control points and peaks whose rows every motion satisfies, and one combination of its rows that proves
the bound, or that there is no motion.
"""

from .rational import Fraction


def once(rows):
    """Each row with all of its multiplier: a correction of it is a further entry, and may be negative."""
    totals = {}
    for row, multiplier in rows:
        totals[id(row)] = row, totals.get(id(row), (row, 0))[1] + multiplier
    return list(totals.values())


def vipr(bound, problem, cost, proved):
    """The bound as a certificate in the VIPR format, version 1.0: the linear program over the control points and the
    peaks, and the one combination of its rows that proves the bound (or that there is no motion)."""
    names, first = [], []
    for k, run in enumerate(problem.runs):
        first.append(len(names))
        names += [f"c{k}_{j}" for j in range(run.space.size)]
    peaks = len(names)
    names += [f"peak{i}" for i in range(len(problem.terms))]
    cam = problem.cam
    searched = {name: len(names) + i for i, name in enumerate(cam.searched if cam else {})}
    names += searched
    rows, steps = [], []  # (sense, right side, {variable: weight}), (row, multiplier)

    def add(sense, right, row, multiplier):
        steps.append((len(rows), multiplier))
        rows.append((sense, right, {j: w for j, w in row.items() if w}))

    for i, (slope, most) in enumerate(zip(bound.slopes, bound.most)):
        if slope >= 0:
            add("G", Fraction(0), {peaks + i: Fraction(1)}, slope)
        else:
            add("L", most, {peaks + i: Fraction(1)}, slope)
    for name, variable in searched.items():
        low, high = cam.searched[name]
        lean = (cam.weights[name] if cost else Fraction(0)) + bound.leaning.get(name, Fraction(0))
        if lean >= 0:
            add("G", low, {variable: Fraction(1)}, lean)
        else:
            add("L", high, {variable: Fraction(1)}, lean)
    bounds = len(rows)
    for row, multiplier in once(bound.rows):
        weights = {first[k] + j: w for k, function in row.functions().items() for j, w in function.items()}
        if row.peak is not None:
            weights[peaks + row.peak] = Fraction(-1)
        weights |= {searched[name]: slope for name, slope in row.searched.items()}
        add("L", row.most, weights, -multiplier)
    for k, (run, (conditions, function, pieces)) in enumerate(zip(problem.runs, bound.remainders)):
        for pivot, (row, value) in conditions.rows.items():
            own = {first[k] + j: w for j, w in row.items()}
            own[first[k] + pivot] = Fraction(1)
            add("E", value, own, function.get(pivot, Fraction(0)))
        for row, weight, most in pieces:
            add("G" if weight > 0 else "L", -most if weight > 0 else most, {first[k] + j: w for j, w in row.items()}, weight)

    def text(row):
        return " ".join([str(len(row))] + [f"{j} {w}" for j, w in sorted(row.items())])

    objective = {peaks + i: t.weight for i, t in enumerate(problem.terms) if t.weight and t.kind != "area"} if cost else {}
    if cost:
        objective |= {first[k] + j: w for k, function in enumerate(bound.area[1]) for j, w in function.items()}
        objective |= {variable: cam.weights[name] for name, variable in searched.items() if cam.weights[name]}
    target = proved - (cam.fixed if cam and cost else Fraction(0)) - bound.area[0]
    lines = ["% The bound of certificate.json over the B-spline control points, in exact arithmetic.",
             f"% Left out of the objective: {bound.area[0]} of the lost area.", "VER 1.0",
             f"VAR {len(names)}", " ".join(names), "INT 0", "OBJ min", text(objective), f"CON {len(rows)} {bounds}"]
    lines += [f"R{i} {sense} {right} {text(row)}" for i, (sense, right, row) in enumerate(rows)]
    lines += [f"RTP range {target} inf" if cost else "RTP infeas", "SOL 0", "DER 1"]
    used = [(i, m) for i, m in steps if m]
    combined = " ".join(f"{i} {m}" for i, m in used)
    lines.append(f"B G {target} {'OBJ' if cost else '0'} {{ lin {len(used)} {combined} }} -1")
    return "\n".join(lines) + "\n"
