# SPDX-License-Identifier: MIT
"""Random scenes solved by camopt and by a linear program that shares no code with it: verdicts, objectives, what is counted."""
import argparse
import json
import random
import tempfile
from pathlib import Path

import checker

SKIPPED, UNDECIDED = "skipped", "undecided"
MOST_SKIPPED = 0.1  # of the scenes: HiGHS solves none of their programs


def optimum_of(program):
    """Its optimum, None where there is no motion, SKIPPED where HiGHS gives up."""
    try:
        return program.solve()
    except AssertionError as error:
        if not any(word in str(error) for word in ("HiGHS", "does not end", "do not end")):
            raise
        return SKIPPED


def difference(verdict, folder, expected, same):
    """What tells verdict and objective from the program's; None: nothing."""
    if (expected is None) != (verdict == "infeasible"):
        return f"{verdict}, the linear program {'has no motion' if expected is None else expected}"
    if expected is None:
        return None
    found = json.loads((folder / "result.json").read_text())["objective"]
    if verdict != "optimal" or abs(found - expected) > same * abs(expected):
        return f"{verdict} {found}, expected {expected}"
    return None


def run(things, seed, scene_of, judged, most_undecided=0.0):
    """`judged(module, camopt, folder, scene)`: what is wrong; None: nothing. The exit code."""
    parser = argparse.ArgumentParser()
    parser.add_argument("camopt")
    parser.add_argument("--count", type=int, default=40)
    parser.add_argument("--seed", type=int, default=seed)
    options = parser.parse_args()
    module, faults, verdicts = checker.load(), [], {"optimal": 0, "infeasible": 0}
    left_out = {SKIPPED: 0, UNDECIDED: 0}
    with tempfile.TemporaryDirectory() as place:
        for index in range(options.count):
            scene, folder = scene_of(random.Random(options.seed * 1000 + index), index), Path(place) / f"scene{index}"
            fault = judged(module, options.camopt, folder, scene)
            if fault in left_out:
                left_out[fault] += 1
            elif fault:
                faults.append(f"scene {index}: {fault}\n{scene.text()}")
            else:
                verdicts[json.loads((folder / "result.json").read_text())["verdict"]] += 1
    print(f"{options.count} {things}: {verdicts}, {left_out[UNDECIDED]} infeasible without a proof, "
          f"{left_out[SKIPPED]} that HiGHS does not solve, {len(faults)} faults")
    if left_out[UNDECIDED] > most_undecided * options.count:
        faults.append("too many infeasible ones without a proof")
    if left_out[SKIPPED] > MOST_SKIPPED * options.count:
        faults.append("too many programs that HiGHS does not solve")
    if options.count >= 20 and min(verdicts.values()) == 0:
        faults.append("every scene has the same verdict")
    return checker.end(faults)
