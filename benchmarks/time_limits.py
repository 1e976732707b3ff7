#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""time_limits.py CAMOPT SCENES [LIMIT ...]: how `camopt solve` keeps `solver.max_seconds` on scenes that want more.

CSV on the standard output: scene, limit, wall seconds of the whole command (reading, search, proof, tie-break,
explanation, forward check, files), their ratio, seconds of the processor, verdict and reason. SCENES: the folder of the
project's scenes; limits: 1, 5 and 20 s. On a loaded machine read the seconds of the processor: what is above the limit
there is the program's. Python's standard library only.
"""

import pathlib
import sys
import tempfile

from measured_command import measured

LIMITS = (1.0, 5.0, 20.0)
PAPER = ("objective.velocity=0.4", "objective.acceleration=0.4", "objective.jerk=0.2")


def quintic(continuity, segments, *more):
    return ("drd_cubic_12", "spline.degree=5", f"spline.continuity={continuity}", f"spline.segments={segments}", *more)


CASES = {
    "quintic, continuity 3, 200 segments": quintic(3, 200, *PAPER),
    "quintic, continuity 4, 200 segments": quintic(4, 200, *PAPER),
    "the same, velocity capped at its least": quintic(3, 200, "limits.velocity=1.5"),
    "the same by Ipopt": quintic(3, 200, 'solver.name="ipopt"'),
    "the same by SLSQP": quintic(3, 60, 'solver.name="nlopt.slsqp"'),
    "COBYLA, 64 cubic segments": ("drd_cubic_64", 'solver.name="nlopt.cobyla"'),
    "CCSAQ, 64 cubic segments": ("drd_cubic_64", 'solver.name="nlopt.ccsaq"'),
    "root mean squares, 200 segments": quintic(3, 200, "objective.rms_jerk=0.5", "objective.reference.rms_jerk=20"),
    "free breakpoints, 40 segments": ("drd_free_knots", "spline.segments=40"),
    "free breakpoints, quintic": ("drd_free_knots", "spline.degree=5", "spline.segments=24"),
    "barrel with undercut margin": ("barrel_paper_cup",),
    "barrel that no motion fits": ("barrel_paper_cup", "limits.undercut_margin=0.9"),
    "cylinder that no motion fits": ("cylinder_slide", "limits.pressure_angle_deg=12"),
    "tappet, 90 degrees": ("tappet_90",),
    "tappet that no motion fits": ("tappet_90", "limits.pressure_angle_deg=8"),
    "cam without a feasible motion": ("cam_infeasible", "limits.cam_radius_min_mm=8"),
    "arm with a roller, 64 segments": ("cam_arm_roller", "spline.segments=64"),
    "arm with a face, 64 segments": ("cam_arm_flat", "spline.segments=64"),
    "torque, 64 segments": ("drd_torque", "spline.segments=64"),
    "laws and splines, 60 segments": ("cam_laws_and_splines", "spline.segments=60"),
}


def run(camopt, scenes, case, limit, folder):
    """Wall and processor seconds of one command, and what it said."""
    scene, *settings = case
    command = [camopt, "solve", str(scenes / f"{scene}.toml"), "--out", str(folder), "--json"]
    for setting in (*settings, f"solver.max_seconds={limit:g}"):
        command += ["--set", setting]
    wall, user, system, result, done = measured(command)
    if result is None:
        said = f"exit {done.returncode}", done.stderr.strip().splitlines()[-1] if done.stderr.strip() else ""
    else:
        said = result.get("verdict", "?"), result.get("reason", "")
    return wall, user + system, said


def main():
    camopt, scenes = sys.argv[1], pathlib.Path(sys.argv[2])
    limits = [float(limit) for limit in sys.argv[3:]] or LIMITS
    print("scene,limit,seconds_wall,ratio,seconds_processor,verdict,reason")
    with tempfile.TemporaryDirectory() as place:
        for name, case in CASES.items():
            for limit in limits:
                wall, processor, (verdict, reason) = run(camopt, scenes, case, limit, pathlib.Path(place) / "out")
                print(f'"{name}",{limit:g},{wall:.2f},{wall / limit:.2f},{processor:.2f},{verdict},"{reason}"', flush=True)


if __name__ == "__main__":
    main()
