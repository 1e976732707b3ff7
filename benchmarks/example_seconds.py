#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""example_seconds.py CAMOPT SCENES [REPEATS]: how long `camopt solve` takes for every example scene, and on what.

CSV on the standard output, a line a scene, of the quickest of REPEATS (3) runs: scene, wall seconds of the command (start of
the program, reading, search, proof, tie-break, audit, the answer as JSON), seconds of the processor, verdict, objective, gap,
and the seconds of each phase as `result.json` has them. Then the machines, by `camopt machine`, without phases.
Python's standard library only.
"""

import csv
import pathlib
import sys

from measured_command import measured

PHASES = ("setup", "solver", "judgement", "proof", "tie_break", "report", "search")


def row_of(camopt, verb, scene, repeats):
    runs = (measured([camopt, verb, str(scene), "--json"]) for _ in range(repeats))
    wall, user, system, answer, _ = min(runs, key=lambda one: one[0])
    answer = answer or {}
    spent, bound = answer.get("seconds"), answer.get("bound") or {}
    spent = spent if isinstance(spent, dict) else {}
    return {"scene": scene.stem, "command": verb, "seconds_wall": f"{wall:.4f}", "seconds_processor": f"{user + system:.4f}",
            "verdict": answer.get("verdict", "none"), "objective": answer.get("objective", ""),
            "gap": bound.get("gap", "")} | {f"seconds_{phase}": spent.get(phase, "") for phase in PHASES}


def main():
    camopt, scenes = sys.argv[1], pathlib.Path(sys.argv[2])
    repeats = int(sys.argv[3]) if len(sys.argv) > 3 else 3
    writer = None
    for verb, folder in (("solve", scenes), ("machine", scenes / "machines")):
        for scene in sorted(folder.glob("*.toml")):
            if verb == "machine" and "[[axis]]" not in scene.read_text():
                continue  # an axis of a machine
            row = row_of(camopt, verb, scene, repeats)
            if writer is None:
                writer = csv.DictWriter(sys.stdout, row, lineterminator="\n")
                writer.writeheader()
            writer.writerow(row)
            sys.stdout.flush()


if __name__ == "__main__":
    main()
