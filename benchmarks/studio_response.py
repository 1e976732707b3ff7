#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""studio_response.py CAMOPT SCENES: from a slider's step to the drawn curve of `camopt studio`, in headless Chromium.

CSV on the standard output, one row a slider: scene, segments, slider, from, to, steps, and of the milliseconds from
the event of the slider to the frame after the curve's redraw the median, the least and the largest; the median until
its proof, words and tables stand beside it, of the solve of the curve alone and of the solve with proof; and the load of the
machine. While a slider moves (moving = true) only curves are drawn; when it is let go (false), as here without a move
before it, the proof follows the curve. Debian's chromium, chromium-driver and python3-selenium.
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
    """Of each step {stage: {ms, solve}}."""
    steps = []
    for step in range(STEPS):
        before = page.js("return Camopt.studio.times.length")
        page.js(MOVE, key, first + (last - first) * step / (STEPS - 1), moving)
        wanted = "curve" if moving else "proof"
        wait_for("the answer", lambda: wanted in (one["stage"] for one in page.js("return Camopt.studio.times")[before:]), 120)
        steps.append({one["stage"]: one for one in page.js("return Camopt.studio.times")[before:]})
    return steps[1:]  # the first has no neighbour


def row_of(steps, moving):
    drawn = [step.get("curve") or step["proof"] for step in steps]  # the proof draws the curve where it comes first
    curves = [one["ms"] for one in drawn]
    figures = [statistics.median(curves), min(curves), max(curves), statistics.median(one["solve"] for one in drawn)]
    proofs = [] if moving else [statistics.median(step["proof"][name] for step in steps) for name in ("ms", "solve")]
    return [f"{value:.1f}" for value in figures + proofs] + [""] * (2 if moving else 0)


def main(program, scenes):
    table = csv.writer(sys.stdout)
    table.writerow(["scene", "slider", "from", "to", "steps", "moving", "ms_median", "ms_min", "ms_max",
                    "solve_ms_median", "proof_ms_median", "proof_solve_ms_median", "load"])
    for scene, key, first, last in CASES:
        for moving in (True, False):
            with studio(program, pathlib.Path(scenes) / f"{scene}.toml") as running, browser_of() as page:
                page.driver.get(running.address)
                wait_for("the page", lambda one=page: one.js("return document.documentElement.dataset.studio === 'ready'"))
                steps = measure(page, key, first, last, moving)
            table.writerow([scene, key, first, last, STEPS - 1, str(moving).lower(), *row_of(steps, moving),
                            f"{os.getloadavg()[0]:.1f}"])
            sys.stdout.flush()


if __name__ == "__main__":
    main(*sys.argv[1:])
