# SPDX-License-Identifier: MIT
"""Tolerances of every kind of cam: tolerance_kinds_test.py CAMOPT [NAME ...].

Example scenes with a table of tolerances are solved and must be confirmed; with slope errors 40 times as large in scene.toml they must not."""
import json
import re
import sys
import tempfile
from pathlib import Path

import checker

LENGTHS = 'profile_um = 5\nslope_um_deg = 0.2\n'
# What the table has besides, and what is set.
SCENES = {
    "barrel_paper_cup": ("slope_mdeg_deg = 0.5\nroller_radius_mm = 0.01\n", ()),
    "cylinder_slide": ("slope_um_deg = 0.5\nroller_radius_mm = 0.01\n", ()),
    "inverse_feeder": ("slope_um_deg = 0.5\nroller_radius_mm = 0.01\npin_angle_deg = 0.01\n", ()),
    "linear_press": (LENGTHS, ()),
    "tappet_75": ("slope_um_deg = 0.5\nlever_arm_mm = 0.01\n", ()),
    "cam_drdrd": (LENGTHS, ("limits.acceleration=7.5",)),
}


def wider(folder):
    """The same result said of a scene whose slope error is larger."""
    scene = folder / "scene.toml"
    scene.write_text(re.sub(r"(slope_\w+ = )(\S+)", lambda found: f"{found[1]}{40 * float(found[2])}", scene.read_text()))


def main():
    module, faults = checker.load(), []
    chosen = sys.argv[2:] or list(SCENES)
    with tempfile.TemporaryDirectory() as place:
        for name in chosen:
            table, settings = SCENES[name]
            folder = Path(place) / name
            text = (checker.ROOT / "scenes" / f"{name}.toml").read_text() + "\n[tolerance]\n" + table
            verdict = checker.solve(sys.argv[1], text, folder, settings)
            found, why = checker.outcome(module, folder)
            made = json.loads((folder / "result.json").read_text()).get("tolerance")
            print(f"{name}: {verdict}: {why}", flush=True)
            if found != "confirmed" or made is None:
                faults.append(f"{name}: {found}: {why}")
            wider(folder)
            found, why = checker.outcome(module, folder)
            if found != "refuted":
                faults.append(f"{name} with a wider slope error: {found}: {why}")
    return checker.end(faults)


if __name__ == "__main__":
    sys.exit(main())
