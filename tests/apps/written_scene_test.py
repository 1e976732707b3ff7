# SPDX-License-Identifier: MIT
"""written_scene_test.py PROGRAM SCENES FOLDER: scenes written by `camopt check --write` have the motion of the scene to the last digit,
say what --set changed, and replace no file."""

import pathlib
import shutil
import subprocess
import sys
import tomllib

PROGRAM = sys.argv[1]
SCENES, FOLDER = (pathlib.Path(word) for word in sys.argv[2:4])
SECONDS = 120
SOLVED = ("drd_cubic_12", "rr_cubic_24", "program_constant_velocity", "drd_via_points")


def run(*words):
    return subprocess.run([PROGRAM, *map(str, words)], capture_output=True, text=True, timeout=SECONDS, check=False)


def motion_of(scene, name):
    done = run("solve", scene, "--out", FOLDER / name)
    assert done.returncode == 0, f"{scene}: {done.stderr}"
    return (FOLDER / name / "motion.csv").read_bytes()


shutil.rmtree(FOLDER, ignore_errors=True)
FOLDER.mkdir(parents=True)
for scene in SOLVED:
    written = FOLDER / f"{scene}.toml"
    done = run("check", SCENES / f"{scene}.toml", "--write", written)
    assert done.returncode == 0 and str(written) in done.stdout, f"{scene}: {done.stdout}{done.stderr}"
    assert motion_of(SCENES / f"{scene}.toml", f"{scene}_given") == motion_of(written, f"{scene}_written"), f"{scene}: another motion"

taken = FOLDER / "drd_cubic_12.toml"
before = taken.read_bytes()
refused = run("check", SCENES / "drd_cubic_16.toml", "--write", taken)
assert refused.returncode == 2 and "found a file of this name" in refused.stderr, refused.stderr
assert taken.read_bytes() == before, "a file was replaced"

changed = FOLDER / "changed.toml"
assert run("check", SCENES / "drd_cubic_12.toml", "--set", "motion.lift_in=1.5", "--write", changed).returncode == 0
assert tomllib.loads(changed.read_text(encoding="utf-8"))["motion"]["lift_in"] == 1.5, changed.read_text(encoding="utf-8")
