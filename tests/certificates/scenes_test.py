# SPDX-License-Identifier: MIT
"""Every example scene, judged by the checker: scenes_test.py SOLVED [NAME ...] (SOLVED: solve_examples.py).

A scene that the checker cannot judge stands in NOT_COVERED with what it must name; all others must be confirmed.
Bounds that are also written in the VIPR format are read by an independent reader and must prove the same.
"""
import json
import sys
import tempfile
from fractions import Fraction
from pathlib import Path

import checker
import vipr_reader

NOT_COVERED = {
    "barrel_paper_cup": "rows of limits.pressure_angle_deg",
    "barrel_smallest": "dimensions of this kind of cam",
    "dynamics_fast_slide": "[dynamics]",
    "inverse_feeder": "rows of limits.pressure_angle_deg",
    "program_constant_velocity": "an angle that is searched",
    "tappet_75": "limits.pressure_angle_deg",
    "tappet_90": "rows of limits.pressure_angle_deg",
}
# Proved over boxes, which VIPR files do not have, or over the breakpoints alone.
WITHOUT_VIPR = {"cam_arm_flat", "cam_grooved", "cam_undercut", "drd_free_knots", "drd_torque", "ocrf_indexing"}


def main():
    solved, chosen = Path(sys.argv[1]), sys.argv[2:]
    module, faults, confirmed, proved = checker.load(), [], 0, 0
    scenes = sorted((checker.ROOT / "scenes").glob("*.toml"))
    unknown = (set(NOT_COVERED) | set(chosen)) - {scene.stem for scene in scenes}
    if unknown:
        faults.append(f"no such scenes: {sorted(unknown)}")
    with tempfile.TemporaryDirectory() as place:
        for scene in scenes:
            if chosen and scene.stem not in chosen:
                continue
            folder, proof = solved / scene.stem, Path(place) / (scene.stem + ".vipr")
            found, why = checker.outcome(module, folder, proof)
            print(f"{scene.stem}: {why}", flush=True)
            expected = "not verified" if scene.stem in NOT_COVERED else "confirmed"
            if found != expected or NOT_COVERED.get(scene.stem, "") not in why:
                faults.append(f"{scene.stem}: {why}; expected: {expected}")
            confirmed += found == "confirmed"
            if found == "confirmed" and proof.exists() == (scene.stem in WITHOUT_VIPR):
                faults.append(f"{scene.stem}: {'a' if proof.exists() else 'no'} VIPR file was written")
            if proof.exists():
                proved += 1
                faults += vipr_faults(scene.stem, proof, json.loads((folder / "certificate.json").read_text()))
    print(f"{confirmed} confirmed, {proved} bounds read from VIPR files")
    if not chosen and (confirmed < 46 or proved < 40):
        faults.append("fewer scenes than there are")
    for fault in faults:
        print("FAULT:", fault)
    return 1 if faults else 0


def vipr_faults(name, proof, certificate):
    try:
        kind, bound = vipr_reader.check(proof.read_text())
    except vipr_reader.Invalid as fault:
        return [f"{name}.vipr: {fault}"]
    if certificate["verdict"] == "infeasible":
        return [] if kind == "infeasible" else [f"{name}.vipr proves no infeasibility"]
    if kind != "bound" or bound < Fraction(certificate["lower_bound"]) - Fraction(1, 10**7) - constant_of(certificate):
        return [f"{name}.vipr proves {kind} {bound and float(bound)}, not {certificate['lower_bound']}"]
    return []


def constant_of(certificate):
    """What fixed dimensions cost stands outside of the linear program."""
    proof = certificate["proof"]
    return Fraction(proof["constant"]) if not any(name.startswith("rms") for name in proof["variables"]) else 0


if __name__ == "__main__":
    sys.exit(main())
