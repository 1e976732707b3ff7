#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""sweep_workers.py CAMOPT SCENE: `camopt sweep` over lattice weights with one worker and with two, in turns.

CSV on the standard output: workers, rows, repeats, median and least wall seconds of the whole command, and whether
sweep.csv is that of the first run but for its columns of seconds. The last line is one run of some 10,000 weights. Python's
standard library only.
"""

import csv
import pathlib
import shutil
import statistics
import subprocess
import sys
import tempfile
import time

REPEATS = 5
DIVISIONS = 77  # 3,081 weights
MANY_DIVISIONS = 140  # 10,011 weights
SETTINGS = ("--set", 'objective.tie_break="none"', "--set", "spline.segments=32")


def run(camopt, scene, folder, divisions, workers):
    """Wall seconds of one sweep."""
    shutil.rmtree(folder, ignore_errors=True)
    begin = time.perf_counter()
    subprocess.run([camopt, "sweep", scene, "--weights", f"simplex:{divisions}", "--out", str(folder), "--workers",
                    str(workers), *SETTINGS], check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    return time.perf_counter() - begin


def untimed(folder):
    """Every row of sweep.csv without its columns of seconds."""
    with open(folder / "sweep.csv", newline="") as file:
        rows = list(csv.reader(file))
    kept = [k for k, name in enumerate(rows[0]) if "seconds" not in name]
    return [[row[k] for k in kept] for row in rows]


def main():
    camopt, scene = sys.argv[1:3]
    place = pathlib.Path(tempfile.mkdtemp())
    try:
        seconds, same, first = {1: [], 2: []}, {1: True, 2: True}, None
        for _ in range(REPEATS):
            for workers, times in seconds.items():
                times.append(run(camopt, scene, place / "sweep", DIVISIONS, workers))
                found = untimed(place / "sweep")
                first = first or found
                same[workers] = same[workers] and found == first
        print("workers,rows,repeats,seconds_median,seconds_min,same_rows")
        for workers, times in seconds.items():
            print(workers, len(first) - 1, len(times), f"{statistics.median(times):.6g}", f"{min(times):.6g}",
                  "yes" if same[workers] else "no", sep=",")
        spent = run(camopt, scene, place / "many", MANY_DIVISIONS, 2)
        print(2, len(untimed(place / "many")) - 1, 1, f"{spent:.6g}", f"{spent:.6g}", "", sep=",")
    finally:
        shutil.rmtree(place)


main()
