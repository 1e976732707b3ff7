# SPDX-License-Identifier: MIT
"""Scenes with limits and terms that are not convex, drawn at random: boxes_test.py CAMOPT [SEED].

Whatever camopt calls optimal or infeasible, the checker must confirm; what it calls otherwise must not be refuted. So
many of the proofs must be over boxes that none can fall silent. Of every proof each own step of the checker must hold at
the delivered motion, which satisfies all limits: a step that does not would prove too much.
"""
import json
import random
import sys
import tempfile
from fractions import Fraction
from pathlib import Path

import checker

SETTINGS = ("solver.max_seconds=40",)
LEAST_PROOFS = 30
# The motion keeps its limits to 1e-8, and a step may say so of it, relative to the sizes of its terms.
KEPT = 1e-7


def scene(motion, objective, cam="", limits="", segments=12):
    weights = "\n".join(f"{name} = {weight}" for name, weight in objective.items())
    text = f"[motion]\n{motion}\n[spline]\nsegments = {segments}\n[objective]\n{weights}\n"
    return text + (f'[cam]\ntype = "disk"\n{cam}\n[limits]\n{limits}\n' if cam else "")


PEAKS = {"velocity": 0.4, "acceleration": 0.4, "jerk": 0.2}


def roller(r, limits, more="", sizes=None, objective=None):
    lift, rise = r.randint(10, 20), r.choice((50, 55, 60))
    sizes = sizes or f"base_radius_mm = {r.randint(20, 26)}\nroller_radius_mm = {r.randint(7, 10)}"
    return scene(f'type = "DRD"\nlift_mm = {lift}\nrise_deg = {rise}', objective or PEAKS,
                 f'follower = "translating_roller"\n{sizes}\n{more}', limits, r.choice((10, 12)))


def arm(r, limits):
    return scene('type = "DRD"\nlift_deg = 20\nrise_deg = 60', PEAKS,
                 f'follower = "oscillating_roller"\nbase_radius_mm = {r.randint(38, 42)}\nroller_radius_mm = 20\n'
                 f'center_distance_mm = 80\narm_length_mm = 45\nrotation = "{r.choice(("clockwise", "counterclockwise"))}"',
                 limits, 10)


def flat_arm(r):
    return scene('type = "DRD"\nlift_deg = 14\nrise_deg = 70', PEAKS,
                 f'follower = "oscillating_flat"\nbase_radius_mm = {r.randint(26, 30)}\ncenter_distance_mm = 70\n'
                 'face_offset_mm = 6', f"undercut_margin = {r.choice((0.4, 0.45, 0.5))}", 10)


def torque(r):
    weights = dict(zip(PEAKS, r.sample((0.1, 0.2, 0.3), 3)))
    return scene('type = "DRD"', weights | {"torque": 0.5}, segments=r.choice((6, 8, 10)))


def scenes(seed):
    r = random.Random(seed)
    for _ in range(10):
        yield "roller, convex radius", roller(r, f"pressure_angle_deg = 36\ncam_radius_min_mm = {r.randint(7, 11)}")
    for _ in range(8):
        yield "roller, undercut margin", roller(r, f"undercut_margin = {r.choice((0.45, 0.5, 0.55))}")
    for _ in range(4):
        yield "roller, concave radius", roller(r, f"concave_radius_min_mm = {r.randint(38, 44)}")
        yield "roller beside the centre", roller(r, f"undercut_margin = {r.choice((0.45, 0.5))}", "offset_mm = 4")
        yield "roller, base radius searched", roller(
            r, "pressure_angle_deg = 38\ncam_radius_min_mm = 9",
            sizes="base_radius_mm = { min = 15, max = 60 }\nroller_radius_mm = 8", objective=PEAKS | {"base_radius": 0.3})
    for _ in range(6):
        yield "arm with a roller", arm(r, f"undercut_margin = {r.choice((0.45, 0.5, 0.55))}")
        yield "arm with a face", flat_arm(r)
    for _ in range(8):
        yield "torque peak", torque(r)


def faults_at_the_motion(proof):
    """Steps of the checker's own proof that the delivered motion, where it keeps their assumptions, breaks."""
    if proof is None:
        return []
    x = [value_of(proof, variable) for variable in proof.variables]
    found = []
    for k, step in enumerate(proof.steps):
        if any(product(proof.steps[i].weights, x) > proof.steps[i].stated for i in step.splits):
            continue
        size = 1 + sum(abs(w * x[j]) for j, w in step.weights.items())
        if product(step.weights, x) > step.side + Fraction(KEPT) * size:
            found.append(f"step {k} does not hold at the delivered motion")
    return found


def value_of(proof, variable):
    if variable[0] == "c":
        return proof.bound.curve.control[variable[1]][variable[2]]
    if variable[0] == "peak":
        return proof.bound.curve.term(proof.problem.terms[variable[1]])[1]
    cam = proof.problem.cam
    size = cam.sizes[variable[1]] / max(map(abs, cam.searched[variable[1]]))
    return abs(size) if variable[0] == "magnitude" else size


def product(weights, x):
    return sum((w * x[j] for j, w in weights.items()), Fraction(0))


def main():
    camopt, seed = sys.argv[1], int(sys.argv[2]) if len(sys.argv) > 2 else 4
    module, faults, proofs = checker.load(), [], 0
    with tempfile.TemporaryDirectory() as place:
        for number, (name, text) in enumerate(scenes(seed)):
            folder = Path(place) / str(number)
            verdict = checker.solve(camopt, text, folder, SETTINGS)
            report = checker.Silent()
            found, why = checker.outcome(module, folder, report=report)
            boxes = "boxes" in json.loads((folder / "certificate.json").read_text())
            print(f"{number} {name}: {verdict}{' over boxes' if boxes else ''}: {why}", flush=True)
            claims = verdict in ("optimal", "infeasible")
            proofs += claims and boxes and found == "confirmed"
            if found == "refuted" or (claims and found != "confirmed"):
                faults.append(f"{number} {name}: {verdict}: {why}")
                continue
            faults += [f"{number} {name}: {fault}" for fault in faults_at_the_motion(report.box_proof)]
    print(f"{proofs} proofs over boxes confirmed")
    if proofs < LEAST_PROOFS:
        faults.append(f"{proofs} proofs over boxes, expected {LEAST_PROOFS}")
    return checker.end(faults)


if __name__ == "__main__":
    sys.exit(main())
