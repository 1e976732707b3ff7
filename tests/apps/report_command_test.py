# SPDX-License-Identifier: MIT
"""report_command_test.py PROGRAM SCENES FOLDER: camopt report writes from a result folder what the solve wrote.

A scene of each sort: both reports come back byte for byte, and no other file is touched. What is no result folder is
refused with exit code 2 and a line that says what is allowed."""

import pathlib
import shutil
import subprocess
import sys

PROGRAM, SCENES, FOLDER = sys.argv[1], pathlib.Path(sys.argv[2]), pathlib.Path(sys.argv[3])
REPORTS = ("report.html", "report.md", "tables.csv")


def run(*words):
    return subprocess.run([PROGRAM, *map(str, words)], capture_output=True, text=True, timeout=300, check=False)


def comes_back(scene):
    folder = FOLDER / scene
    shutil.rmtree(folder, ignore_errors=True)
    solved = run("solve", SCENES / f"{scene}.toml", "--out", folder)
    assert solved.returncode == 0, solved.stderr
    before = {file.name: file.read_bytes() for file in folder.iterdir()}
    for name in REPORTS:
        (folder / name).unlink()
    written = run("report", folder)
    assert written.returncode == 0 and not written.stderr, written.stderr
    after = {file.name: file.read_bytes() for file in folder.iterdir()}
    assert before.keys() == after.keys(), before.keys() ^ after.keys()
    for name, text in before.items():
        assert after[name] == text, f"{scene}: {name} is another one"


def is_refused(folder, words):
    refused = run("report", folder)
    assert refused.returncode == 2, (folder, refused.returncode)
    assert words in refused.stderr, refused.stderr


for one in ("drd_cubic_12", "cam_forces", "cam_drdrd", "cylinder_slide", "drd_physical_limits"):
    comes_back(one)
(FOLDER / "empty").mkdir(parents=True, exist_ok=True)
is_refused(FOLDER / "empty", "allowed: a folder that `camopt solve SCENE --out DIR` wrote")
is_refused(FOLDER / "nowhere", "found no result.json")
print("camopt report: every report came back")
