# SPDX-License-Identifier: MIT
"""Proofs by cases: the strokes whose displacement is free rise or fall; angles that are searched lie in boxes.

Theorem. If the cases cover every choice of directions (`require_cover`), or every choice of angles that fills the revolution (`by_angles`),
then no motion of the scene is below the least bound of the cases, and there is no motion where no case has one.

Of angles: each segment's y over its own part u of the path. Where every spline rests at both ends (y' = y'' = 0), only limits in time
depend on the angles, |y^(r)(u)| <= limit * angle^r, and a larger angle loosens them, each side that allows rest. The least objective with
the largest angles of a box, which need not add up to the revolution, is then at or below that of any angles in the box.
"""
import itertools

from .bound import Bound
from .exact import KEPT, Refuted, SAME_PLACE, Unverified, number
from .problem import Problem
from .rational import Fraction
from .stored import factor_of, stored_bound
from .strokes import stroke_of
from .units import angle_of, in_unit

MOST_STROKES = 12  # that are split: all their directions are counted
LARGER = 1 + Fraction(1, 10**12)  # ends of boxes are doubles


def displacements_found(result):
    """Of the delivered motion, at each joint of the part that is repeated and beyond."""
    levels = [number(0)]
    for part in result["motion"]["parts"]:
        if part["curve"] is None:
            levels.append(number(part["y0"]) + (number(part["y_scale"]) if part["law"] else 0))
        else:
            curve, x = result["motion"]["curves"][part["curve"]], number(part["end"]) - number(part["x0"])
            points = [number(point) for point in curve["breakpoints"]]
            i = min(range(1, len(points)), key=lambda i: abs(points[i] - x))
            levels.append(sum(number(c) * (points[i] - points[i - 1])**m for m, c in enumerate(curve["pieces"][i - 1])))
    return levels


def relaxed_by(proof):
    relaxed = number(proof["limits_relaxed_by"])
    if not 0 <= relaxed <= KEPT * 100:
        raise Refuted(f"limits are relaxed by {float(relaxed)}")
    return relaxed


def region_of(case):
    """{segment: whether it rises}."""
    parts = case.get("parts", [])
    if any("rises" not in part for part in parts):
        raise Unverified("a proof by cases of " + ", ".join(case["region"]))
    return {part["segment"]: part["rises"] for part in parts}


def require_cover(problem, regions):
    """Every choice of directions is one of a case."""
    split = sorted({i for region in regions for i in region})
    if any(i >= len(problem.stretches) or problem.stretches[i].kind != "spline" or not problem.stretches[i].free for i in split):
        raise Refuted("a case of a stroke whose displacement is not free")
    if len(split) > MOST_STROKES:
        raise Unverified(f"a proof by cases of {len(split)} strokes")
    for choice in itertools.product((True, False), repeat=len(split)):
        chosen = dict(zip(split, choice))
        if not any(region.items() <= chosen.items() for region in regions):
            raise Refuted("the cases leave out that " + ", ".join(f"segment {i} {'rises' if up else 'falls'}" for i, up in chosen.items()))


def contradicts(problem, region):
    """Whether the given displacements are too far apart for the directions: from 1 no motion rises, and then rises again, to 0."""
    if not problem.motion.get("within_lift", True) and not problem.motion.get("monotone", False):
        return False
    levels = [own.start for own in problem.stretches] + [problem.stretches[-1].to]
    least, most = list(levels), list(levels)  # None: not known

    def rises(a, b):
        least[b] = max((level for level in (least[a], least[b]) if level is not None), default=None)
        most[a] = min((level for level in (most[a], most[b]) if level is not None), default=None)

    for _, (i, own) in itertools.product(levels, enumerate(problem.stretches)):
        up = region.get(i) if own.kind == "spline" and stroke_of(problem, own, own.begin) else None
        if own.kind == "dwell" or up:
            rises(i, i + 1)
        if own.kind == "dwell" or up is False:
            rises(i + 1, i)
    return any(a is not None and b is not None and a > b for a, b in zip(least, most))


def by_direction(make, cases):
    """[(problem, {segment: whether it rises})] of the cases; `make`: the problem of directions."""
    regions = [region_of(case) for case in cases]
    require_cover(make({}), regions)
    return [(make(region), region) for region in regions]


# -- angles that are searched

def searched_angles(scene):
    """{segment: (its key, (least, most) in deg)}."""
    return {i: (key, tuple(in_unit((number(segment[key][end]), key.removeprefix("angle_")), "deg") for end in ("min", "max")))
            for i, segment in enumerate(scene["motion"].get("segments", [])) for key in ("angle_deg", "angle_rad")
            if isinstance(segment.get(key), dict)}


def with_angles(scene, angles):
    """The scene with these in place of the ranges, {segment: deg}."""
    segments, ranges = [dict(segment) for segment in scene["motion"]["segments"]], searched_angles(scene)
    for i, angle in angles.items():
        key = ranges[i][0]
        segments[i][key] = in_unit((angle, "deg"), key.removeprefix("angle_"))
    return scene | {"motion": scene["motion"] | {"segments": segments}}


def require_growth(problem):
    """The least objective can only fall where an angle grows."""
    units = {key for segment in problem.motion["segments"] for point in [*segment.get("via", []), segment.get("end", {})] for key in point
             if key not in ("at", "from", "to", "velocity", "acceleration") and not key.startswith("displacement")}
    if units or any(table in problem.scene for table in ("cam", "drive", "dynamics")) or problem.copies > 1 or \
            any(b.most < 0 or not b.key.startswith("limits.") for b in problem.bounds) or \
            any(term.kind != "peak" for term in problem.terms) or {"start", "end"} & set(problem.motion) or \
            problem.motion.get("closed", True) is not True or any(len(run.stretches) > 1 or run.rests != (True, True) for run in problem.runs):
        raise Unverified("a bound over angles that are searched, where larger ones do not only help")


def narrowed(box, rest):
    """What of a box of angles {segment: (least, most)} can add up to the rest; None: nothing."""
    least, most = (sum((ends[i] for ends in box.values()), Fraction(0)) for i in (0, 1))
    if not least <= rest <= most:
        return None
    return {k: (max(low, rest - most + high), min(high, rest - least + low)) for k, (low, high) in box.items()}


def by_angles(scene, references, cases):
    """[(problem with the largest angles of a box that holds the case, {})]. The whole is halved until a case holds each part, so that the
    cases leave out no angles that add up to the turn. A case may rest on the proof of any box that was halved on the way to it."""
    box = {i: ends for i, (_, ends) in searched_angles(scene).items()}
    rest = 360 - sum((in_unit(angle_of(s, "angle"), "deg") for i, s in enumerate(scene["motion"]["segments"]) if i not in box), Fraction(0))
    regions = [box_of(case) or box for case in cases]
    tops, parts = [[] for _ in cases], [(box, list(range(len(cases))), [])]
    while parts:
        box, own, before = parts.pop()
        box = narrowed(box, rest)
        box = box and narrowed(box, rest)
        if box is None:
            continue
        if not own:
            raise Refuted("the cases leave out angles " + ", ".join(f"{float(low):.6g} to {float(high):.6g} deg" for low, high in box.values()))
        before = before + [{k: high for k, (_, high) in box.items()}]
        if len(own) == 1 and all(high <= regions[own[0]][k][1] * LARGER for k, (_, high) in box.items()):
            tops[own[0]] = before
            continue
        for k in sorted(box, key=lambda k: box[k][0] - box[k][1]):
            middle = sum(box[k]) / 2
            sides = [[c for c in own if regions[c][k][1] <= middle * LARGER], [c for c in own if regions[c][k][0] * LARGER >= middle]]
            if len(own) > 1 and sorted(sides[0] + sides[1]) == sorted(own):
                parts += [(box | {k: (box[k][0], middle)}, sides[0], before), (box | {k: (middle, box[k][1])}, sides[1], before)]
                break
        else:
            raise Refuted("the cases are no boxes of angles that were halved")
    if not all(tops):
        raise Refuted("a case of angles that do not add up to the turn")
    proofs = [None if case["proof_of_case"] is None else cases[case["proof_of_case"]]["proof"] for case in cases]
    return [(proof and nearest_problem(scene, references, proof, own), {}) for proof, own in zip(proofs, tops)]


def box_of(case):
    """{segment: (least, most)} in deg."""
    parts = case.get("parts", [])
    if any("angle_deg" not in part for part in parts):
        raise Unverified("a proof by cases of " + ", ".join(case["region"]))
    return {part["segment"]: tuple(map(number, part["angle_deg"])) for part in parts}


def nearest_problem(scene, references, proof, tops):
    """That of the angles on whose joints most rows of the proof are."""
    places = {number(row["origin"]["at"]) for row in proof["rows"] if "at" in row["origin"]}
    problems = [Problem(with_angles(scene, top), references, None, []) for top in tops]
    require_growth(problems[0])

    def fitting(problem):
        return sum(any(abs(x - at) <= SAME_PLACE for run in problem.runs for x in run.space.breakpoints) for at in places)
    return max(problems, key=fitting)


def least_objective(problem):
    """No cost but an area is negative."""
    if any(term.kind == "area" for term in problem.terms):
        raise Unverified("a case without a bound next to an area")
    return Fraction(0)


def judge_cases(parts, cases, incumbent, curve, report):
    """(the least bound of all cases, what was left out): no motion of the scene is below it; None: there is no motion at all."""
    left_out, values = {}, []
    for case, (problem, region) in zip(cases, parts):
        if region and contradicts(problem, region):
            continue
        if case["proof_of_case"] is None:  # it was not solved to its end
            values.append(least_objective(problem))
            continue
        proof = cases[case["proof_of_case"]]["proof"]
        if stored_bound(proof) < number(proof["bound"]):
            raise Refuted("the stored proof of a case does not give its bound")
        bound = Bound(problem, incumbent, relaxed_by(proof), curve, region).add_rows(proof["rows"], factor_of(proof, problem))
        if proof["statement"] == "objective":
            values.append(bound.least_objective())
        elif bound.value(cost=False) <= 0:
            values.append(least_objective(problem))
        left_out |= bound.left_out
    report.say(f"cases: {len(cases)}, of which {len(cases) - len(values)} have no motion")
    return min(values, default=None), left_out
