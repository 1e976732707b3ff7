#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""studio_response.py CAMOPT SCENES: from a slider's step to the drawn curve of `camopt studio`, in headless Chromium.

CSV on the standard output, one row a slider: scene, segments, slider, from, to, steps, and of the milliseconds from
the event of the slider to the frame after the redraw the median, the least and the largest; beside them the median of
the wall seconds of the solve alone, and the load of the machine. While it moves (moving = true) the scene is solved to
1e-6; when it is let go (false) to its own tolerance, with all words and tables. Debian's chromium, chromium-driver and
python3-selenium.
"""

import csv
import os
import pathlib
import statistics
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "tests" / "browser"))
from browser import browser_of, wait_for  # noqa: E402
from studio import studio  # noqa: E402

STEPS = 25
CASES = (  # scene, slider, from, to
    ("drd_cubic_32", "objective.velocity", 0.2, 0.8),
    ("drd_cubic_32", "objective.jerk", 0.1, 0.4),
    ("drd_quintic_12", "objective.acceleration", 0.2, 0.8),
    ("cam_roller", "objective.velocity", 0.2, 0.8),
    ("cam_roller", "cam.base_radius_mm", 16, 24),
    ("cam_roller", "limits.pressure_angle_deg", 29, 35),
    ("cam_drdrd", "cam.base_radius_mm", 26, 34),
    ("cam_smallest", "objective.base_radius", 0.2, 0.8),
    ("cam_arm_roller", "objective.velocity", 0.2, 0.8),
    ("swing_limits", "objective.velocity", 0.2, 0.8),
)

MOVE = """
const [key, value, moving] = arguments;
const slider = document.querySelector(`[data-key="${key}"] input[type=range]`);
slider.max = Math.max(Number(slider.max), value);
slider.step = 'any';
slider.value = value;
slider.dispatchEvent(new Event(moving ? 'input' : 'change'));
"""


def measure(page, key, first, last, moving):
    milliseconds, solves = [], []
    for step in range(STEPS):
        before = page.js("return Camopt.studio.times.length")
        page.js(MOVE, key, first + (last - first) * step / (STEPS - 1), moving)
        wait_for("the curve", lambda: page.js("return Camopt.studio.times.length") > before, 120)
        milliseconds.append(page.js("return Camopt.studio.times.at(-1)"))
        solves.append(1000.0 * page.js("return Camopt.studio.answer.seconds"))
    return milliseconds[1:], solves[1:]  # the first has no neighbour


def main(program, scenes):
    table = csv.writer(sys.stdout)
    table.writerow(["scene", "slider", "from", "to", "steps", "moving", "ms_median", "ms_min", "ms_max",
                    "solve_ms_median", "load"])
    for scene, key, first, last in CASES:
        for moving in (True, False):
            with studio(program, pathlib.Path(scenes) / f"{scene}.toml") as running, browser_of() as page:
                page.driver.get(running.address)
                wait_for("the page", lambda one=page: one.js("return document.documentElement.dataset.studio === 'ready'"))
                milliseconds, solves = measure(page, key, first, last, moving)
            table.writerow([scene, key, first, last, STEPS - 1, str(moving).lower(),
                            *(f"{value:.1f}" for value in (statistics.median(milliseconds), min(milliseconds),
                                                           max(milliseconds), statistics.median(solves))),
                            f"{os.getloadavg()[0]:.1f}"])
            sys.stdout.flush()


if __name__ == "__main__":
    main(*sys.argv[1:])
