# SPDX-License-Identifier: MIT
"""solve_examples.py CAMOPT SCENES FOLDER: solves every example scene, each once, for all tests that look at what it gives.

FOLDER/NAME is the result folder of SCENES/NAME.toml, FOLDER/NAME.console what the program printed. Exit status 1 where a
scene ended with another status than 0 (a motion) or 3 (proved infeasible). Two scenes at a time."""

import concurrent.futures
import pathlib
import shutil
import subprocess
import sys

SECONDS = 300
# Begun first, they do not run alone at the end.
LONG = ("tappet_90", "tappet_75", "barrel_smallest")


def solved(program, scene, folder):
    """What is wrong with it; empty: nothing."""
    run = subprocess.run([program, "solve", scene, "--out", folder / scene.stem], capture_output=True, text=True,
                         timeout=SECONDS, check=False)
    (folder / f"{scene.stem}.console").write_text(run.stdout, encoding="utf-8")
    return "" if run.returncode in (0, 3) else f"{scene.stem} ended with {run.returncode}: {run.stdout}{run.stderr}"


def main():
    program, scenes, folder = sys.argv[1], pathlib.Path(sys.argv[2]), pathlib.Path(sys.argv[3])
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    every = sorted(scenes.glob("*.toml"), key=lambda scene: (scene.stem not in LONG, scene.stem))
    with concurrent.futures.ThreadPoolExecutor(2) as pool:
        faults = [fault for fault in pool.map(lambda scene: solved(program, scene, folder), every) if fault]
    for fault in faults:
        print(fault)
    print(f"{len(every)} scenes solved, {len(faults)} faults")
    return 1 if faults or not every else 0


sys.exit(main())
