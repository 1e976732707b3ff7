# SPDX-License-Identifier: MIT
"""Motions of laws and dwells only: there is exactly one.

Theorem. Its peaks are those of its laws (`peak_of`). The scene is infeasible where that motion violates a limit at the place that the proof names
(`judge_passed_limit`). Only dimensions of the cam may be chosen: each place that the proof names gives a lower bound of the one searched
dimension, hence of the objective (`bound_of`).
"""

from .enclosures import Jet, ends_of, tangent
from .exact import ORDERS, SAME_PLACE, Refuted, Unverified, add_to, middle_of, root
from .laws import constant, jumps, law_peak, parts_along, turns_back
from .origins import Origin
from .rational import Fraction
from .runs import Stretch
from .units import dimension_of

UNKNOWN = Fraction(10**9)


def is_prescribed(scene):
    segments = scene["motion"].get("segments", [])
    return bool(segments) and all(segment["kind"] != "spline" for segment in segments)


def peak_of(problem, term):
    """(low, high) around a peak (the largest of all laws), or a root mean square (over all laws), in units of the reference."""
    laws = [s for s in problem.stretches if s.kind == "law"]
    if term.kind == "peak":
        name = next(n for n, order in ORDERS.items() if order == term.order)
        ends = [law_peak(s.law, name) for s in laws]
    elif term.kind == "torque":
        ends = [law_peak(s.law, "torque") for s in laws]
    else:
        name = "rms_" + next(n for n, order in ORDERS.items() if order == term.order)
        ends = [law_peak(s.law, name) for s in laws]
        length = sum((s.end - s.begin for s in laws), Fraction(0))
        squares = [sum(((s.end - s.begin) * own[i]**2 for s, own in zip(laws, ends)), Fraction(0)) / length for i in (0, 1)]
        return root(squares[0])[0] / term.reference, root(squares[1])[1] / term.reference
    return max(low for low, _ in ends) / term.reference, max(high for _, high in ends) / term.reference


def state_at(problem, at, side):
    """[y, y', y'', y'''] at a place of the motion, enclosed, and its stretch."""
    at = problem.folded(at, side)
    stretch = problem.stretch_at(at, side)
    if stretch is None:
        raise Refuted(f"a row speaks of x = {float(at)}, outside the motion")
    if stretch.kind == "spline":
        return rest_of(problem, stretch, at), stretch
    if None in (stretch.start, stretch.to):
        raise Unverified("rows where a displacement that is free rests, or along a law from or to it")
    return state_on(problem, stretch, at, side), stretch


def state_on(problem, stretch, at, side):
    """The same of one stretch."""
    at = problem.folded(at, side)
    v = min(max((at - stretch.begin) / (stretch.end - stretch.begin), Fraction(0)), Fraction(1))
    parts = parts_along(stretch, 4)
    begin, _, motion = next((part for part in parts if v < part[1] or (v == part[1] and side == "left")), parts[-1])
    return motion(constant(v - begin))


def value_beside(problem, at, side, order):
    """A derivative of y along a law or in a dwell: ({displacement that is free: weight}, (low, high)), the function plus what is between.

    y = a + (b - a) f, f the law, a and b the displacements before and after it."""
    stretch = problem.stretch_at(problem.folded(at, side), side)
    if stretch is None or not stretch.free:
        return {}, ends_of(state_at(problem, at, side)[0][order])
    i, share = problem.stretches.index(stretch), (Fraction(0), Fraction(0))
    if stretch.kind == "law":
        unit = Stretch("law", stretch.begin, stretch.end, Fraction(0), Fraction(1))
        unit.law = stretch.law
        share = ends_of(state_on(problem, unit, at, side)[order])
    middle, half = middle_of(share)
    function = {key: w * ((order == 0) - middle) for key, w in problem.level_at(i).items()}
    add_to(function, problem.level_at(i + 1), middle)
    room, known = 2 * half * problem.farthest_level, function.pop(None, Fraction(0))
    return function, (known - room, known + room)


def rest_of(problem, stretch, at):
    """The same where a spline starts or ends at rest, or at the top of a rise and return; what is not known is any number."""
    run, unknown = next(run for run in problem.runs if stretch in run.stretches), Jet.number(-UNKNOWN, UNKNOWN)
    if problem.type == "RR" and abs(at - 1) <= SAME_PLACE:
        return [constant(1), constant(0), unknown, unknown]
    for place in (0, 1):
        if abs(run.space.breakpoints[-place] - at) <= SAME_PLACE and run.states[place] == (0, 0) and run.ends()[place] is not None:
            return [constant(run.ends()[place]), constant(0), constant(0), unknown]
    raise Refuted(f"nothing makes the motion rest at x = {float(at)}")


# -- no motion: the one there is passes a limit

def judge_passed_limit(problem, proof, report):
    """The proof names a limit and a place."""
    if proof is None or proof["statement"] != "least_common_violation" or len(proof["rows"]) != 1:
        raise Unverified("infeasibility at a place that the scene prescribes without a row that says where")
    origin = Origin.of(proof["rows"][0]["origin"])
    rule, (at, side) = origin.key, problem.place_of(origin)
    sides = [own for own in ("right", "left") if own == (side if origin.side else own) and
             problem.stretch_at(problem.folded(at, own), own)]
    passed, unknown = False, None
    for side in sides:
        try:
            passed = passed or passes(problem, rule, origin.part, at, side)
        except Unverified as fault:
            unknown = fault
    if not passed:
        raise unknown or Refuted(f"{rule} is satisfied at x = {float(at)}")
    report.say(f"{rule} is passed at x = {float(at):.9g}, where the scene prescribes the motion")
    return []


def limits_at(problem, rule, at, stretch):
    """[(order, sign, most, scale)] of a limit at a place where the motion is prescribed: sign * y^(order) <= most. Peaks beside splines
    are those of the splines."""
    caps = [(t.order, t.cap * stretch.scale(t.order)) for t in problem.terms if t.kind == "peak" and t.cap is not None and
             not problem.runs and stretch.kind == "law" and rule in [f"limits.{n}" for n, order in ORDERS.items() if order == t.order]]
    return [(order, sign, cap, cap) for order, cap in caps for sign in (1, -1)] + [
        (b.order, b.sign, b.most, b.scale) for b in problem.bounds if b.key == rule and b.stretch in (None, stretch) and
        b.begin - SAME_PLACE <= at <= b.end + SAME_PLACE]


def passes(problem, rule, part, at, side):
    """Whether a limit is certainly passed at a place."""
    state, stretch = state_at(problem, at, side)
    if problem.drive and rule.startswith("limits.motor_"):
        return problem.drive.passes(rule, at, side)
    own = [limit[:3] for limit in limits_at(problem, rule, at, stretch)]
    signs = {sign for order, sign, _ in own if order == 3 and rule.startswith("limits.")}
    if stretch.kind == "law" and signs and turns_back(stretch.law) and not stretch.smooth_top:
        raise Unverified(f"the jerk where the law {stretch.law} turns back")
    if stretch.kind == "law" and jumps(stretch.law) and (len(signs) == 2 or (signs and stretch.law != "simple_harmonic")):
        return True  # y'' jumps at an end of the law (of all but simple_harmonic up and down)
    if problem.cam and rule.startswith("cam.face_") and problem.cam.width:
        own += [(1, sign, problem.cam.width[1] * problem.cam.beta[1] / problem.cam.lift) for sign in (1, -1)]
    if own:
        return any(ends_of(sign * state[order])[0] > most for order, sign, most in own)
    if problem.cam is None or problem.cam.rules is None or not problem.cam.judged:
        raise Unverified(f"{rule} along a law")
    found = [] if problem.cam.searched else problem.cam.formulas_along(rule.removeprefix("limits."), part)
    if not found:
        raise Unverified(f"{rule} along a law")
    problem.cam.as_found.load = constant(problem.cam.forces.load_at(at, side) if problem.cam.forces else 0)
    return any(ends_of(formula(state))[0] > 0 for formula in found)


# -- the bound: what limits leave of a dimension that is searched

def bound_of(problem, curve, proof):
    """No cam of this motion has a smaller objective: each place that the proof names bounds the dimension."""
    terms = sum((term.weight * curve.term(term)[0] for term in problem.terms if term.weight), Fraction(0))
    cam = problem.cam
    if cam is None or not cam.searched:
        return terms + (cam.cost[0] if cam else Fraction(0))
    if len(cam.searched) > 1 or cam.kind != "disk" or cam.swings or not set(cam.searched) <= {"base_radius", "roller_radius"}:
        raise Unverified("a bound of a prescribed motion over these dimensions")
    (name, (least, _)), = cam.searched.items()
    left_out = set()
    for row in proof["rows"]:
        origin = Origin.of(row["origin"])
        if origin.at is None or not row["multiplier"]:
            continue
        at, side = problem.place_of(origin)
        found = least_dimension(cam, origin, state_at(problem, at, side)[0], name)
        if found is None:
            left_out.add(origin.key)
        else:
            least = max(least, found)
    problem.left_out = left_out
    return terms + cam.fixed + cam.weights[name] * least


def least_dimension(cam, origin, state, name):
    """What a limit at a place demands of the base radius or the roller radius, m; None: nothing is made of it here."""
    rule, sign, lift = origin.key, origin.sign, cam.lift
    s, slope, bend = (ends_of(own) for own in state[:3])
    fixed = sum((size for other, size in cam.sizes.items() if other != name and other != "offset"), Fraction(0))
    squares = [b * b for b in cam.beta]
    if rule.startswith("limits.cam_radius_min") and cam.follower == "translating_flat":
        # base + s + s'' >= least
        highest = lift * s[1] + max(lift * b / square for b in bend for square in squares)
        return dimension_of(cam.problem.limits, "cam_radius_min") - highest
    limit = cam.pressure[0 if sign > 0 else 1] if sign else None
    if rule.endswith("pressure_angle_deg") and limit is not None and not cam.sizes.get("offset") and cam.follower != "translating_flat":
        # sign s' <= tan (base + roller + s)
        least = min(sign * lift * v / b for v in slope for b in cam.beta)
        return min(least / steep for steep in ends_of(tangent(limit))) - fixed - lift * s[1]
    return None
