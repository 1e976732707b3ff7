#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""handbook_picture.py CAMOPT SCENE PICTURE.svg: the optimum of scenes/handbook_nine_points.toml over the one quintic spline
through all its conditions (docs/programs.md). Python's standard library only."""

import csv
import pathlib
import subprocess
import sys
import tempfile

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))
from plot import COLOURS, Axis, Panel, Picture  # noqa: E402

# An angle for each of the twenty conditions; the inner breakpoints are the means of five neighbours.
ANGLES = [0] * 3 + [45] * 2 + [90] * 3 + [135] * 2 + [150] + [180] * 3 + [210] + [225] * 2 + [270] * 3
BREAKPOINTS = [0.0] + [sum(ANGLES[j:j + 5]) / 5 / 270 for j in range(1, 15)] + [1.0]
CURVES = (("s_mm", "displacement", "mm", -3, 23, 5), ("dds_mm_rad2", "acceleration", "mm/rad²", -65, 65, 20),
          ("ddds_mm_rad3", "jerk", "mm/rad³", -300, 300, 100))


def solved(camopt, scene, *settings):
    with tempfile.TemporaryDirectory() as place:
        more = ["--set", *settings] if settings else []
        subprocess.run([camopt, "solve", scene, "--out", f"{place}/out", *more], check=True, stdout=subprocess.DEVNULL)
        with open(f"{place}/out/motion.csv", newline="", encoding="utf-8") as file:
            return [{key: float(value) for key, value in row.items()} for row in csv.DictReader(file)]


def main():
    camopt, scene, target = sys.argv[1:4]
    curves = (solved(camopt, scene, "spline.breakpoints=[" + ",".join(map(repr, BREAKPOINTS)) + "]"), solved(camopt, scene))
    picture = Picture(900, 860, "Nine points of a handbook's cam", "Lift 20 mm; by the cam angle")
    picture.legend(90, 96, [("the one spline through all points", COLOURS[1], "line", True),
                            ("proved optimum, a breakpoint every 5°", COLOURS[0], "line", True)])
    for k, (key, caption, unit, lower, upper, step) in enumerate(CURVES):
        ticks = [(v, str(v)) for v in range(-(-lower // step) * step, upper + 1, step)]
        panel = Panel(picture, (90, 140 + 240 * k, 760, 170),
                      Axis(0, 270, "deg" if k == 2 else "", False, [(v, str(v)) for v in range(0, 271, 45)]),
                      Axis(lower, upper, unit, False, ticks), caption)
        for rows, colour in zip(curves, (COLOURS[1], COLOURS[0])):
            panel.line([(row["theta_deg"], row[key]) for row in rows if row["theta_deg"] <= 270], colour)
    pathlib.Path(target).write_text(picture.svg(), encoding="utf-8")


main()
