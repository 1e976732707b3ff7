#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""perturbed_boxes.py CAMOPT SCENES TABLE [--count 20] [--only SCENE ...]: does a bound over boxes depend on the last digit?

Solves every scene whose bound is proved over boxes as it is (trial 0) and with perturbed numbers: trial k multiplies the
weights of the objective and the limits by 1 ± k 1e-12, the signs in turn. TABLE (CSV: scene, trial, verdict, proof, gap,
processor seconds) grows by a row a solve; rows that it has are not solved again, so that a run may be stopped and continued.
Seconds are the processor's (user): other work on the machine changes them little. Prints for each scene the verdicts, the
median, the slowest and their ratio. Exit status 1: a verdict differs from that of trial 0, a scene is not proved, or the
slowest takes more than 3 times the median. Python's standard library only.
"""

import argparse
import collections
import csv
import pathlib
import statistics
import sys
import tempfile
import tomllib

from measured_command import measured

MOST_RATIO = 3.0
FIELDS = ("scene", "trial", "verdict", "proof", "gap", "seconds")


def settings(scene, trial):
    """--set of the perturbed numbers of a scene."""
    numbers = []
    for table in ("objective", "limits"):
        for key, value in scene.get(table, {}).items():
            if isinstance(value, (int, float)) and not isinstance(value, bool):
                sign = 1 if len(numbers) % 2 == 0 else -1
                numbers.append(f"{table}.{key}={value * (1 + sign * trial * 1e-12)!r}")
    return [word for number in numbers for word in ("--set", number)] if trial else []


def solve(camopt, path, trial):
    """A row of the table."""
    with tempfile.TemporaryDirectory() as folder:
        command = [camopt, "solve", str(path), "--json", *settings(tomllib.loads(path.read_text()), trial)]
        _, seconds, _, result, done = measured(command, cwd=folder)
    if result is None:
        result = {"verdict": f"exit {done.returncode}"}
    bound = result.get("bound") or {}
    return {"scene": path.stem, "trial": trial, "verdict": result["verdict"], "proof": bound.get("proof", ""),
            "gap": bound.get("gap", ""), "seconds": f"{seconds:.2f}"}


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("camopt")
    parser.add_argument("scenes", type=pathlib.Path)
    parser.add_argument("table", type=pathlib.Path)
    parser.add_argument("--count", type=int, default=20, help="perturbations of each scene")
    parser.add_argument("--only", nargs="+", help="these scenes alone")
    asked = parser.parse_args()
    rows = {}
    if asked.table.exists():
        with asked.table.open(newline="") as file:
            rows = {(row["scene"], int(row["trial"])): row for row in csv.DictReader(file)}
    with asked.table.open("a", newline="") as file:
        table = csv.DictWriter(file, FIELDS)
        if not rows:
            table.writeheader()
        for trial in range(asked.count + 1):
            for path in sorted(asked.scenes.resolve().glob("*.toml")):
                whole = rows.get((path.stem, 0))
                if asked.only and path.stem not in asked.only or whole and whole["proof"] != "boxes":
                    continue
                if (path.stem, trial) not in rows:
                    row = rows[path.stem, trial] = solve(asked.camopt, path, trial)
                    table.writerow(row)
                    file.flush()
    return 1 if summary(rows) else 0


def summary(rows):
    """Prints the table of the scenes; the number of scenes that depend on the last digit."""
    faults = 0
    print(f"{'scene':<20}{'trials':>7}{'median':>8}{'slowest':>9}{'ratio':>7}  verdicts")
    for scene in sorted({scene for (scene, _), row in rows.items() if row["proof"] == "boxes"}):
        of_scene = [row for (name, _), row in rows.items() if name == scene]
        seconds = [float(row["seconds"]) for row in of_scene]
        median, slowest = statistics.median(seconds), max(seconds)
        verdicts = collections.Counter(row["verdict"] for row in of_scene)
        fault = set(verdicts) not in ({"optimal"}, {"infeasible"}) or slowest > MOST_RATIO * median
        faults += fault
        words = ", ".join(f"{count} {verdict}" for verdict, count in verdicts.items())
        note = "  depends on the last digit" if fault else ""
        print(f"{scene:<20}{len(of_scene):>7}{median:>8.2f}{slowest:>9.2f}{slowest / median:>7.2f}  {words}{note}")
    return faults


if __name__ == "__main__":
    sys.exit(main())
