# SPDX-License-Identifier: MIT
"""Every example scene, judged by the checker: scenes_test.py SOLVED [--quick | NAME ...] (SOLVED: solve_examples.py).

--quick leaves out SLOW, which take half of the time.

A scene that the checker cannot judge stands in NOT_COVERED with what it must name; all others must be confirmed.
Bounds that are also written in the VIPR format are read by an independent reader and must prove the same.
"""
import json
import re
import shutil
import sys
import tempfile
from fractions import Fraction
from pathlib import Path

import checker
import vipr_reader

GIVEN = "the motion is that of a given cam"
NOT_COVERED = {name: GIVEN for name in ("given_drum", "given_guide_forward", "given_guide_return", "given_tappet", "given_wedge")}
# Proved over boxes, which VIPR files do not have, or over the breakpoints alone, or not bounded.
WITHOUT_VIPR = {"barrel_smallest", "cam_arm_flat", "cam_grooved", "cam_undercut", "cylinder_drum", "drd_free_knots", "drd_torque",
                "inverse_feeder", "linear_arm", "linear_knife", "ocrf_indexing", "one_dwell_laws", "prescribed_tappet", "program_constant_velocity", "tappet_75"}
SLOW = {"barrel_paper_cup", "barrel_smallest", "dynamics_fast_slide", "tappet_75"}
OUT_OF_TIME = {"tappet_90"}  # the machine decides how far its bound comes: over boxes, or not yet
# A limit that is a little tighter than what the motion reaches.
TIGHTER = {"barrel_paper_cup": ("pressure_angle_deg = 42", "pressure_angle_deg = 41.9"),
           "barrel_smallest": ("pressure_angle_deg = 40", "pressure_angle_deg = 39.9"),
           "cylinder_drum": ("pressure_max_mpa = 650", "pressure_max_mpa = 649.9"),
           "dynamics_fast_slide": ("residual_um = 100", "residual_um = 99.9"),
           "inverse_feeder": ("pressure_angle_deg = 10", "pressure_angle_deg = 9.99"),
           "tappet_75": ("pressure_angle_deg = 30", "pressure_angle_deg = 29.9"),
           "tappet_90": ("cam_radius_min_mm = 10", "cam_radius_min_mm = 60")}


def main():
    solved, chosen = Path(sys.argv[1]), sys.argv[2:]
    module, faults, confirmed, proved = checker.load(), [], 0, 0
    scenes = sorted((checker.ROOT / "scenes").glob("*.toml"))
    left_out = set()
    if chosen == ["--quick"]:
        chosen, left_out = [], SLOW
    unknown = (set(NOT_COVERED) | set(chosen) | SLOW) - {scene.stem for scene in scenes}
    if unknown:
        faults.append(f"no such scenes: {sorted(unknown)}")
    with tempfile.TemporaryDirectory() as place:
        for scene in scenes:
            if scene.stem in left_out or chosen and scene.stem not in chosen:
                continue
            folder, proof = solved / scene.stem, Path(place) / (scene.stem + ".vipr")
            found, why = checker.outcome(module, folder, proof)
            if scene.stem == "program_constant_velocity":
                faults += moved_angles(module, folder, Path(place) / "moved")
            if scene.stem in TIGHTER:
                faults += tighter_limit(module, folder, Path(place) / "tighter", *TIGHTER[scene.stem])
            print(f"{scene.stem}: {why}", flush=True)
            expected = "not verified" if scene.stem in NOT_COVERED else "confirmed"
            if found != expected or NOT_COVERED.get(scene.stem, "") not in why:
                faults.append(f"{scene.stem}: {why}; expected: {expected}")
            confirmed += found == "confirmed"
            if found == "confirmed" and scene.stem not in OUT_OF_TIME and proof.exists() == (scene.stem in WITHOUT_VIPR):
                faults.append(f"{scene.stem}: {'a' if proof.exists() else 'no'} VIPR file was written")
            if proof.exists():
                proved += 1
                faults += vipr_faults(scene.stem, proof, json.loads((folder / "certificate.json").read_text()))
    print(f"{confirmed} confirmed, {proved} bounds read from VIPR files")
    if not chosen and (confirmed < 66 - len(left_out) or proved < 49 - len(left_out - WITHOUT_VIPR)):
        faults.append("fewer scenes than there are")
    return checker.end(faults)


def tighter_limit(module, folder, copy, written, tighter):
    """A motion that passes a limit is refuted."""
    shutil.copytree(folder, copy, dirs_exist_ok=True)
    scene = (folder / "scene.toml").read_text()
    (copy / "scene.toml").write_text(scene.replace(written, tighter))
    found, why = checker.outcome(module, copy)
    return [] if written in scene and found == "refuted" else [f"{folder.name} with {tighter}: {found}: {why}"]


def moved_angles(module, folder, copy):
    """A certificate of another angle than the motion has, or of one outside its range, is refuted."""
    faults = []
    for name, by, lift in (("angle moved", 1e-3, 0.0), ("out of its range", 0.0, 40.0)):
        shutil.copytree(folder, copy, dirs_exist_ok=True)
        result = json.loads((folder / "result.json").read_text())
        result["segments"][1]["angle_deg"] += by
        (copy / "result.json").write_text(json.dumps(result))
        scene = (folder / "scene.toml").read_text()
        narrower = re.sub(r"min = 30(\.0)?, max = 60(\.0)?", f"min = 30, max = {60 - lift}", scene)
        if lift and narrower == scene:
            faults.append("the scene has no such range")
        (copy / "scene.toml").write_text(narrower)
        found, why = checker.outcome(module, copy)
        if found != "refuted":
            faults.append(f"{name}: {found}: {why}")
    return faults


def vipr_faults(name, proof, certificate):
    try:
        kind, bound = vipr_reader.check(proof.read_text())
    except vipr_reader.Invalid as fault:
        return [f"{name}.vipr: {fault}"]
    if certificate["verdict"] == "infeasible":
        return [] if kind == "infeasible" else [f"{name}.vipr proves no infeasibility"]
    if kind != "bound" or bound < Fraction(certificate["lower_bound"]) - Fraction(1, 10**7) - constant_of(certificate) - left_out(proof):
        return [f"{name}.vipr proves {kind} {bound and float(bound)}, not {certificate['lower_bound']}"]
    return []


def left_out(proof):
    """The constant of the lost area, which the file states."""
    return Fraction(re.search(r"^% Left out of the objective: (\S+) of", proof.read_text(), re.M)[1])


def constant_of(certificate):
    """What fixed dimensions cost stands outside of the linear program."""
    proof = certificate["proof"]
    return Fraction(proof["constant"]) if not any("rms" in name for name in proof["variables"]) else 0


if __name__ == "__main__":
    sys.exit(main())
