# SPDX-License-Identifier: MIT
"""The verdict.

Theorem. CONFIRMED: the delivered motion satisfies the conditions exactly and all limits to within KEPT, its objective is the stated one to within
STATED, and no motion of the scene has an objective below the stated bound by more than a tenth of solver.gap; for "optimal" the gap is
closed, for "infeasible" the scene has no motion. REFUTED: a claim is false or the files do not prove it. NOT VERIFIED: neither; what is
missing is named.
"""
import json
import sys
import tomllib
from pathlib import Path

from .any_curve import any_curve_bound, require_no_curve
from .bound import OTHER_MEANS, Bound
from .box_proof import BoxProof
from .cam import Cam
from .cases import by_angles, by_direction, displacements_found, judge_cases, relaxed_by, searched_angles, with_angles
from .conditions import Conditions
from .drive import Drive, TERMS as MOTOR_TERMS, with_transmission_found
from .exact import NOT_CONVEX, Refuted, STATED, Unverified, number, require_every_row
from .known import name_what_is_unknown
from .least import judge_least, without_keys
from .machine import judge_machine
from .measured import KINDS as DEVIATIONS
from .motion import Curve, close_points_named
from .origins import read_certificate
from .prescribed import bound_of, is_prescribed, judge_passed_limit
from .problem import Problem
from .rational import Fraction, parsed
from .units import angle_of, in_known_units, in_unit
from .references import references_of
from .stored import check_box, factor_of, stored_bound
from .train import Train
from .valve import as_program
from .vipr import vipr


class Report:
    box_proof = None  # what the bound was proved by, where that was over boxes

    def __init__(self, quiet):
        self.quiet = quiet

    def say(self, text):
        if not self.quiet:
            print("  " + text)


def agree(certificate, result):
    """The two files speak of the same thing."""
    same = (certificate["verdict"] == result["verdict"] and certificate["objective"] == result["objective"] and
            certificate["lower_bound"] == result["bound"]["lower"] and certificate["gap"] == result["bound"]["gap"] and
            certificate["proof_kind"] == result["bound"]["proof"] and certificate["reason"] == result["reason"])
    if not same:
        raise Refuted("certificate.json and result.json disagree")
    proof, low = certificate["proof"], certificate["lower_bound"]
    if proof and proof["statement"] == "objective" and low is not None and certificate["proof_kind"] == "duality" and \
            number(proof["bound"]) < number(low):
        raise Refuted("the lower bound is above that of the stored proof")
    if proof and proof["bound"] is not None and stored_bound(proof) < number(proof["bound"]):
        raise Refuted("the stored proof does not give its bound")
    objective, gap = certificate["objective"], certificate["gap"]
    if gap is not None:
        actual = (number(objective) - number(low)) / max(1, abs(number(objective)))
        if actual > number(gap) + Fraction(1, 10**14):
            raise Refuted("the gap is larger than stated")


def close(stated, low, high):
    room = STATED * max(abs(stated), abs(high))
    return low - room <= stated <= high + room


def with_angles_found(scene, ranges, result):
    """The scene with the angles that were found in place of their ranges. They lie in these and fill the turn."""
    found = {i: number(result["segments"][i]["angle_deg"]) for i in ranges}
    for i, (_, (least, most)) in ranges.items():
        if not least * (1 - STATED) <= found[i] <= most * (1 + STATED):
            raise Refuted(f"an angle of {float(found[i])} deg is outside its range")
    scene = with_angles(scene, found)
    turn = sum(in_unit(angle_of(segment, "angle"), "deg") for segment in scene["motion"]["segments"])
    if scene["motion"].get("closed", True) and abs(1 - turn / 360) > STATED:
        raise Refuted("the angles found do not add up to a turn")
    return scene


def free_breakpoints(scene, result):
    """Those of the delivered motion where the scene leaves them free; else None."""
    if scene.get("spline", {}).get("knots") != "free" or not result["motion"]:
        return None
    if scene["motion"]["type"] == "program":  # parts of each segment
        design = zip(result["design"]["names"], result["design"]["values"])
        found = [number(0), *(number(value) for name, value in design if name.startswith("x[")), number(1)]
    else:
        found = [number(x) for x in result["motion"]["curves"][0]["breakpoints"]]
    if any(b <= a for a, b in zip(found, found[1:])) or found[0] != 0:
        raise Refuted("the breakpoints do not ascend")
    return found


def delivered_problem(scene, references, result):
    """With the angles, breakpoints and displacements that were found."""
    ranges = searched_angles(scene)
    own = with_angles_found(scene, ranges, result) if ranges else scene
    problem = Problem(own, references, free_breakpoints(scene, result), displacements_found(result) if result["motion"] else [])
    problem.ranges = scene if ranges else None
    return problem


def judge(folder, report, vipr_path):
    """What is not verified. Of a scene that seeks a number: of the scene with that number, and of the number."""
    written = tomllib.loads((folder / "scene.toml").read_text(), parse_float=parsed)
    scene, sought = without_keys(written)
    missing = judge_scene(folder, as_program(scene), report, vipr_path)
    if sought:
        result = json.loads((folder / "result.json").read_text())
        missing = missing + judge_least(folder, written, sought, result, lambda inner: outcome_of(inner, Report(True)), report)
    return missing


def judge_scene(folder, scene, report, vipr_path):
    if scene.get("measured", {}).get("use") == "given":
        raise Unverified("nothing: the motion is that of a given cam, and no claim is made about it")
    name_what_is_unknown(scene)
    result = json.loads((folder / "result.json").read_text())
    scene = with_transmission_found(in_known_units(scene), result)
    certificate = read_certificate(folder / "certificate.json")
    verdict, proof = certificate["verdict"], certificate["proof"]
    report.say(f"claimed: {verdict}, objective {certificate['objective']}, bound {certificate['lower_bound']}")
    agree(certificate, result)
    if verdict not in ("optimal", "local", "feasible", "infeasible"):
        raise Unverified(f"nothing: the verdict {verdict} claims nothing")
    shown = result["motion"] is not None or certificate["objective"] is not None
    if verdict == "infeasible" and shown and not is_prescribed(scene):
        raise Refuted("a motion is delivered where there is said to be none")
    if verdict != "infeasible" and result["motion"] is None:
        raise Refuted("no motion is delivered")
    references, ranges = references_of(scene, result["reference"]), searched_angles(scene)
    if verdict == "infeasible" and certificate["proof_kind"] == "any_curve_limit":
        if scene["motion"]["type"] != "DRD":
            raise Unverified("the limit of any curve for this kind of motion")
        return require_no_curve(Problem(scene, references, [Fraction(0), Fraction(1)]), report)
    if ranges and verdict == "infeasible":
        return require_empty(*judge_cases(by_angles(scene, references, cases_of(certificate)), cases_of(certificate), None, None, report))
    problem = delivered_problem(scene, references, result)
    problem = equipped(problem, result)
    scene = problem.scene
    if problem.free and verdict == "infeasible":
        free = with_free_displacements(problem, result)
        return judge_infeasible(free, proof, report, vipr_path, certificate["cases"], lambda rises: with_free_displacements(free, result, rises))
    relaxed = relaxed_by(proof) if proof else Fraction(0)
    if verdict == "infeasible":
        if is_prescribed(scene):  # the motion that passes the limit is shown
            if shown:
                judge_objective(problem, certificate, result, report)
            return judge_passed_limit(problem, proof, report)
        if "boxes" in certificate:
            return judge_empty_boxes(problem, certificate["boxes"], report)
        return judge_infeasible(problem, proof, report, vipr_path)
    return judge_motion(problem, certificate, result, relaxed, report, vipr_path)


def equipped(problem, result):
    """With its cam, its elastic follower or its motor, and their terms."""
    scene = problem.scene
    if "cam" in scene:
        problem.cam = Cam(problem, scene, result)
    if "dynamics" in scene:
        problem.train = Train(problem)
        problem.terms += problem.train.residual_term(result.get("dynamics") or {"terms": []})
    elif number(problem.objective.get("residual", 0)):
        raise Unverified("objective.residual without [dynamics]")
    if "drive" in scene:
        problem.drive = Drive(problem, result)
        problem.terms += problem.drive.terms
    elif any(number(problem.objective.get(name, 0)) for name in MOTOR_TERMS):
        raise Unverified("terms of a motor without [drive]")
    return problem


def with_free_displacements(problem, result, rises=None):
    """What bounds are of, where the scene leaves displacements free: the delivered motion has only some of them. `rises`: of a case."""
    if not problem.free:
        return problem
    if problem.train or problem.harmonics:
        raise Unverified("the bound of displacements that are free next to [dynamics] or limits of harmonics")
    return equipped(Problem(problem.scene, problem.references, problem.breakpoints_found, [], rises), result)


def cases_of(certificate):
    """One proof is a case that is the whole."""
    return certificate["cases"] or [{"proof": certificate["proof"], "proof_of_case": 0}]


def require_empty(value, left_out):
    """No case has a motion."""
    if value is None:
        return []
    require_every_row(left_out)
    raise Refuted("the cases do not prove that there is no motion")


def judge_infeasible(problem, proof, report, vipr_path, cases=None, make=None):
    for run in problem.runs:
        conditions = Conditions(run.conditions)
        contradiction = conditions.contradiction
        if conditions.rounding and not contradiction:
            raise Unverified(f"conditions that contradict each other by {float(conditions.rounding[1]):.1e} only")
        if contradiction:
            report.say(f"conditions contradict each other ({contradiction[0]}): no spline of the space meets them")
            return []
    if cases:
        return require_empty(*judge_cases(by_direction(make, cases), cases, None, None, report))
    if proof is None:
        raise Unverified("infeasibility without a stored proof")
    if proof["statement"] != "least_common_violation":
        raise Refuted("the conditions do not contradict each other")
    if proof["variables"] == ["common violation"]:
        return judge_passed_limit(problem, proof, report)
    bound = Bound(problem, None, Fraction(0)).add_rows(proof["rows"])
    value = bound.value(cost=False)
    report.say(f"Farkas: the multipliers give 0 >= {float(value):.9g}, rounding {float(bound.residual):.1e}")
    if value <= 0:
        require_every_row(bound.left_out)
        if value + bound.residual > 0:
            raise Unverified(f"infeasibility by less than the rounding of the multipliers, {float(bound.residual):.1e}")
        raise Refuted("the multipliers do not prove that there is no motion")
    write_vipr(vipr_path, bound, problem, False, value)
    return []


def judge_empty_boxes(problem, boxes, report):
    proof = BoxProof(problem, Bound(problem, None, Fraction(0)), boxes, None)
    proof.check()
    report.say(f"boxes: {len(proof.steps)} steps, {proof.planes} planes, {len(boxes['parts'])} parts; nothing is left in "
               "any of them")
    return []


def write_vipr(path, bound, problem, cost, value):
    signed = problem.cam and any(low < 0 and problem.cam.weights[name] for name, (low, _) in problem.cam.searched.items())
    if path and (None in bound.remainders or signed):
        print("no VIPR file is written: breakpoints too close together, free displacements, magnitudes of dimensions", file=sys.stderr)
    elif path:
        Path(path).write_text(vipr(bound, problem, cost, value))


def judge_objective(problem, certificate, result, report):
    """The delivered motion, and the largest its objective can be."""
    curve = Curve(problem, result)
    if problem.runs:
        report.say("motion: an exact spline of the space, on all conditions, lies within " +
                   ", ".join(f"{float(r):.0e}" for r in curve.relative) + " (of y, y', y'', y''', relative)")
    else:
        report.say("motion: prescribed, laws and dwells")
    check_terms(problem, curve, result)
    low, high = curve.objective()
    stated = number(certificate["objective"])
    report.say(f"objective: between {float(low):.15g} and {float(high):.15g}")
    if not close(stated, low, high):
        raise Refuted(f"the objective is {float(high)}, not {float(stated)}")
    return curve, high


def check_terms(problem, curve, result):
    """The figures of the lost area and of the distances from a table that the result states."""
    for term in problem.terms:
        stated = next((t for t in result.get("own_terms") or [] if t["name"] == term.kind), None)
        if term.kind in ("area", *DEVIATIONS) and (stated is None or not close(number(stated["reference"]), term.reference, term.reference) or
                                    not close(number(stated["value"]), *(v * term.reference for v in curve.term(term)))):
            raise Refuted(f"the stated {term.kind} is not that of the motion")


def judge_motion(problem, certificate, result, relaxed, report, vipr_path):
    verdict, proof = certificate["verdict"], certificate["proof"]
    missing = []
    with close_points_named(problem):
        curve, high = judge_objective(problem, certificate, result, report)
    kept = curve.keep_caps(relaxed)
    if problem.cam:
        more, missing = problem.cam.keep_limits(curve)
        kept += more
    if problem.train:
        more, unseen = problem.train.keep_limits(curve)
        kept, missing = kept + more, missing + unseen
    if problem.drive:
        kept += problem.drive.keep_limits(curve, relaxed)
        problem.drive.check_figures(curve, result)
    report.say("limits kept: " + (", ".join(kept) or "none given"))
    bound_stated = certificate["lower_bound"]
    if certificate["proof_kind"] == "none" or bound_stated is None:
        if verdict == "optimal":
            raise Refuted("optimal without a bound")
        return missing
    may_vanish = any(term.kind == "area" for term in problem.terms)  # and be negative: nothing is relative to it
    allowed = problem.gap * (max(Fraction(1), abs(high)) if may_vanish or high > Fraction(1, 16) else 16 * high)
    not_convex = "gap" not in problem.solver and not result["solver"]["convex"]
    allowed_gap = allowed * (NOT_CONVEX if not_convex else 1)
    rest = Fraction(0)  # what multipliers leave, bounded by less than the file knows
    if problem.ranges or (certificate["proof_kind"] == "boxes" and certificate["cases"]):
        if "boxes" in certificate or certificate["proof_kind"] not in ("boxes", "duality"):
            raise Unverified("a bound over angles that are searched, over boxes of motions")
        cases = cases_of(certificate)
        parts = by_angles(problem.ranges, problem.references, cases) if problem.ranges else \
            by_direction(lambda rises: with_free_displacements(problem, result, rises), cases)
        value, left_out = judge_cases(parts, cases, high, None if problem.ranges else curve, report)
        value = high if value is None else min(value, high)
        report.say(f"bound: no motion of the scene is below {float(value):.15g}")
    elif certificate["proof_kind"] == "boxes":
        boxes, allowed = certificate["boxes"], allowed_gap
        if number(bound_stated) > number(boxes["bound"]):
            raise Refuted("the lower bound is above that of the boxes")
        proof = report.box_proof = BoxProof(problem, Bound(problem, high, relaxed, curve), boxes, high)
        proof.check_holds(result)
        value, left_out = proof.check(), proof.left_out
        value = high if value is None else min(value, high)
        report.say(f"bound: {len(proof.steps)} steps over boxes, {proof.planes} planes, {len(boxes['parts'])} parts: "
                   f"no motion of the scene is below {float(value):.15g}")
    elif certificate["proof_kind"] == "any_curve_limit":
        if proof:
            raise Refuted("a proof by the limit of any curve has no rows")
        value, left_out = any_curve_bound(problem, curve), {}
        report.say(f"bound: no curve of any kind is below {float(value):.15g}")
    elif proof is None or proof["statement"] != "objective":
        raise Refuted("there is no stored proof of the bound")
    elif not problem.runs:
        value = bound_of(problem, curve, proof)
        left_out = problem.left_out
        report.say(f"bound: of a prescribed motion, with any cam: {float(min(value, high)):.15g}")
    else:
        factor = factor_of(proof, problem)
        check_box(proof, result, problem, factor)
        bound = Bound(with_free_displacements(problem, result), high, relaxed, curve).add_rows(proof["rows"], factor)
        value, left_out = bound.least_objective(), bound.left_out
        if bound.means and verdict != "optimal":  # the bound may be reached by another motion
            bound.leave_out(OTHER_MEANS, Fraction(0))
        rest = bound.residual
        report.say(f"bound: no motion of the scene is below {float(min(value, high)):.15g}, "
                   f"rounding {float(bound.residual):.1e}")
    short = number(bound_stated) - value
    if short > allowed / 10:
        require_every_row(left_out)
        if short <= allowed or (verdict != "optimal" and short <= rest):  # less than what optimal means, or than what is left
            raise Unverified(f"the last digits of the bound {bound_stated}: {float(value):.15g} is proved")
        raise Refuted(f"the bound {bound_stated} is not proved: only {float(value):.15g} is")
    if verdict == "optimal" and high - value > allowed_gap:
        require_every_row(left_out)
        raise Refuted(f"optimal is not proved: the gap is {float(high - value):.1e}, allowed {float(allowed_gap):.1e}")
    if certificate["proof_kind"] == "duality" and problem.runs and not problem.ranges:
        write_vipr(vipr_path, bound, problem, True, value)
    return missing


def outcome_of(folder, report, vipr_path=None):
    """(exit code, what is to be said)."""
    try:
        if (folder / "machine.json").exists():
            missing = judge_machine(folder, report, lambda axis: outcome_of(axis, Report(True)))
        else:
            missing = judge(folder, report, vipr_path)
    except Refuted as fault:
        return 1, f"REFUTED: {fault}"
    except Unverified as gap:
        return 2, f"NOT VERIFIED: {gap}"
    except (OSError, json.JSONDecodeError, tomllib.TOMLDecodeError) as fault:
        return 2, f"NOT VERIFIED: {fault}"
    except (KeyError, TypeError, IndexError, ValueError) as fault:
        return 1, f"REFUTED: the files are not what camopt writes ({type(fault).__name__}: {fault})"
    if missing:
        return 2, "NOT VERIFIED: " + ", ".join(missing) + " (everything else is confirmed)"
    return 0, "CONFIRMED"
