# SPDX-License-Identifier: MIT
"""verdicts_test.py SCENES SOLVED: every example scene of a disk or a linear cam comes to the verdict that the manual shows, with the
limit that is active there (SOLVED: solve_examples.py)."""

import json
import pathlib
import sys

# Verdict, an active limit ("": none).
EXPECTED = {
    "cam_arm_flat": ("optimal", "limits.cam_radius_min_mm"),
    "cam_arm_roller": ("optimal", ""),
    "cam_clockwise": ("optimal", "limits.rise_pressure_angle_deg"),
    "cam_conjugate": ("optimal", "limits.pressure_angle_deg"),
    "cam_drdrd": ("optimal", "limits.pressure_angle_deg"),
    "cam_flat": ("optimal", "limits.cam_radius_min_mm"),
    "cam_forces": ("optimal", "limits.contact_force_min_n"),
    "cam_grooved": ("optimal", "limits.hertz_pressure_max_mpa"),
    "cam_infeasible": ("infeasible", ""),
    "cam_knife": ("optimal", "limits.pressure_angle_deg"),
    "cam_laws_and_splines": ("optimal", ""),
    "cam_roller": ("optimal", "limits.pressure_angle_deg"),
    "cam_smallest": ("optimal", "limits.pressure_angle_deg"),
    "cam_tolerances": ("optimal", "limits.pressure_angle_deg"),
    "cam_undercut": ("optimal", "limits.cam_radius_min_mm"),
    "linear_arm": ("optimal", "limits.pressure_angle_deg"),
    "linear_knife": ("optimal", "limits.concave_radius_min_mm"),
    "linear_press": ("optimal", "limits.pressure_angle_deg"),
}


def faults_of(result, verdict, limit):
    if result["verdict"] != verdict:
        yield f"found {result['verdict']}; expected {verdict}"
    elif verdict != "infeasible":
        if result["worst_violation"] > 1e-7:
            yield f"a limit is violated by {result['worst_violation']}"
        if result["cam"]["undercut"]:
            yield "undercut"
        if result["bound"]["lower"] is None:
            yield "no lower bound"
        if limit and not any(one["key"] == limit and one["active"] for one in result["constraints"]):
            yield f"{limit} is not active"


def main():
    scenes, solved = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2])
    unknown = {path.stem for path in scenes.glob("*.toml") if path.stem.startswith(("cam_", "linear_"))} ^ set(EXPECTED)
    faults = [f"{name}: is a scene or an expectation alone" for name in sorted(unknown)]
    for name, (verdict, limit) in EXPECTED.items():
        result = json.loads((solved / name / "result.json").read_text())
        faults += [f"{name}: {fault}" for fault in faults_of(result, verdict, limit)]
    print("\n".join(faults + [f"{len(EXPECTED)} scenes, {len(faults)} faults"]))
    return 1 if faults else 0


sys.exit(main())
