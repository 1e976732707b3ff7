# SPDX-License-Identifier: MIT
"""An electronic cam: the largest departure of what the controller does from the designed motion, and the limits of the scene."""
import copy

from certificate_checker.drive import Drive
from certificate_checker.exact import KEPT, Refuted, Unverified, derivative, largest, number, shifted
from certificate_checker.known import name_what_is_unknown
from certificate_checker.motion import Curve
from certificate_checker.rational import Fraction
from certificate_checker.references import references_of
from certificate_checker.units import in_known_units, in_unit
from certificate_checker.valve import as_program
from certificate_checker.verdict import delivered_problem

from .outcome import Outcome
from .plc_tables import READERS, STRAIGHT, TEXT_READERS
from .plc_turn import SAME_JOINT, Departure, phase_of, whole_turn

QUANTITIES = "svaj"
ROUNDING = Fraction(1, 10**12)  # of a claim: its own last digit
SLACKS = [Fraction(0)] + [Fraction(1, 10**k) for k in range(7, 0, -1)]  # of a limit


def problem_of(scene, design):
    scene = as_program(scene)
    name_what_is_unknown(scene)
    scene = in_known_units(scene)
    problem = delivered_problem(scene, references_of(scene, design["reference"]), design)
    if "drive" in scene:
        problem.drive = Drive(problem, design)
    return problem


def scales_of(problem):
    """(mm or degrees of a lift, degrees of x = 1)."""
    size, unit = problem.lift
    return size * 1000 if unit == "m" else in_unit(problem.lift, "deg"), in_unit(problem.unit_angle, "deg")


def pieces_of(text, claims, second=False):
    """The table in degrees and in mm or degrees of the slave."""
    try:
        read = (TEXT_READERS if second else READERS)[claims["format"]]
        start = number(claims["slave_at_start"])
        return [(begin, end, [c[0] + start, *c[1:]]) for begin, end, c in read(text, claims["units"])]
    except (KeyError, ValueError, IndexError) as fault:
        raise Refuted(f"the table is not complete ({type(fault).__name__}: {fault})") from fault


def verify(text, claims, scene, second=False):
    """`second`: the format's other file, of bare points."""
    design, outcome = claims["design"], Outcome()
    problem = problem_of(scene, design)
    lift, per_x = scales_of(problem)
    pieces = pieces_of(text, claims, second)
    departure = Departure(whole_turn(design["motion"], problem, per_x, lift), pieces)
    orders = 2 if claims["format"] in STRAIGHT else 4
    for order, (quantity, row) in enumerate(zip(QUANTITIES, claims["loss"])):
        if order >= orders:
            continue
        if row["quantity"] != quantity or row["per_degree"] is None:
            raise Refuted(f"no departure of {quantity} is claimed")
        judge(outcome, quantity, departure, order, number(row["per_degree"]))
    judge_limits(outcome, problem, design, by_own_angle(pieces, phase_of(problem)), per_x, lift, orders)
    return outcome


def judge(outcome, quantity, departure, order, claimed, size=1):
    """`size`: what 1 mm or degree by degrees is in the unit of the claim."""
    low, high, outcome.places[quantity] = departure.largest(order, claimed / size or Fraction(1))
    low, high = low * size, high * size
    outcome.bounds[quantity] = float(high)
    if low > claimed * (1 + ROUNDING):
        outcome.faults.append(f"{outcome.places[quantity]}: {quantity} departs by {float(low):.3g}, {float(claimed):.3g} is claimed")
    elif high > claimed * (1 + ROUNDING):
        outcome.unverified.append(f"the last digits of {quantity}: {float(high):.6g} is proved, {float(claimed):.6g} is claimed")


def exported_curve(problem, design, pieces, per_x, lift):
    """The delivered motion with the table in the place of its splines."""
    curve = copy.copy(Curve(problem, design))
    length, found = problem.stretches[-1].end, []
    for run, own in zip(problem.runs, curve.pieces):
        found.append([])
        for turn in range(problem.copies):
            for _, width, left, stretch in own:
                begin = left - run.begin_of(stretch) + stretch.begin + turn * length
                found[-1] += [(p, w, left + at - begin, stretch) for p, w, at in
                              table_between(pieces, begin, begin + width, per_x, lift, run.level(stretch))]
    curve.pieces = found
    return curve


def table_between(pieces, begin, end, per_x, lift, level):
    """[(y by x, width, x)] of the table between two places."""
    for from_deg, to_deg, c in pieces:
        at, until = max(begin, from_deg / per_x), min(end, to_deg / per_x)
        if (until - at) * per_x <= SAME_JOINT:
            continue
        own = [part * per_x**k / lift for k, part in enumerate(shifted(list(c), at * per_x - from_deg))]
        yield [own[0] + level, *own[1:]], until - at, at


def by_own_angle(pieces, phase):
    """Of a table over the master: over the motion's own angle, which begins at `phase` of the master."""
    cut = phase % 360
    if not cut:
        return pieces
    (_, _, first), (begin, end, last) = pieces[0], pieces[-1]
    travel = shifted(list(last), end - begin)[0] - first[0]
    early, late = [], []
    for begin, end, c in pieces:
        for parts, low, high, by, up in ((early, max(begin, cut), end, -cut, 0), (late, begin, min(end, cut), 360 - cut, travel)):
            if low < high:
                moved = shifted(list(c), low - begin)
                parts.append((low + by, high + by, [moved[0] + up, *moved[1:]]))
    return early + late


def keep_beside_splines(problem, pieces, per_x, lift, slack):
    """Caps and bounds along laws and dwells, for the table in their place."""
    for stretch in problem.stretches:
        if stretch.kind == "spline":
            continue
        for turn in range(problem.copies):
            by = turn * problem.stretches[-1].end
            own = [(p, w, at) for p, w, at in table_between(pieces, stretch.begin + by, stretch.end + by, per_x, lift, Fraction(0))]
            for bound in problem.bounds:
                inside = [(p, w) for p, w, at in own if bound.begin < at + w and at < bound.end]
                if bound.stretch in (None, stretch) and inside and \
                        largest([([bound.sign * c for c in derivative(p, bound.order)], w) for p, w in inside])[1] > \
                        bound.most + bound.scale * (KEPT + slack):
                    raise Refuted(f"{bound.key} is passed from {float(stretch.begin * per_x):.6g} deg")


def judge_limits(outcome, problem, design, pieces, per_x, lift, orders):
    """Of the motion and of a motor; those of a cam are not of an electronic one."""
    limited = problem.drive or problem.bounds or any(term.cap is not None for term in problem.terms)
    if not limited:
        outcome.limits = "none given on the motion"
        return
    if orders < 4:
        outcome.limits = "not judged: straight lines have no acceleration"
        return
    curve, passed = exported_curve(problem, design, pieces, per_x, lift), ""
    for slack in SLACKS:
        try:
            kept = curve.keep_caps(slack)
            keep_beside_splines(problem, pieces, per_x, lift, slack)
            if problem.drive:
                kept += problem.drive.keep_limits(curve, slack)
        except Refuted as fault:
            passed = passed or str(fault)
            continue
        except Unverified as gap:
            outcome.unverified.append(f"limits of the exported motion: {gap}")
            return
        if problem.drive and any(stretch.kind == "law" for stretch in problem.stretches):
            outcome.unverified.append("limits of the motor for the exported motion along laws")
        words = ", ".join(kept) or "none given on the motion"
        outcome.limits = f"kept: {words}" if not slack else f"passed by less than {float(slack):.0e} of each: {words} ({passed})"
        return
    outcome.limits = f"passed: {passed}"
