# SPDX-License-Identifier: MIT
"""A sweep to be solved in several ways, and what is the same about the tables. Python's standard library only."""

import csv
import os
import pathlib
import signal
import time

SKIPPED = 77


def sweep_words(scenes, out, *more):
    """5151 rows in 322 chunks, some 10 ms a chunk: longer than the second that mpirun gives its ranks to end."""
    return ["sweep", str(pathlib.Path(scenes) / "drd_cubic_12.toml"), "--weights", "simplex:100", "--chunk", "16",
            "--out", str(out), *more]


ROWS, CHUNKS = 5151, 322


def timeless_rows(folder):
    """sweep.csv without its columns of seconds, sorted."""
    with open(pathlib.Path(folder) / "sweep.csv", newline="", encoding="utf-8") as file:
        rows = list(csv.reader(file))
    kept = [k for k, name in enumerate(rows[0]) if not name.startswith("seconds")]
    assert len(kept) == len(rows[0]) - 2
    return [rows[0]] + sorted([row[k] for k in kept] for row in rows[1:])


def finished_chunks(folder):
    """The chunks on the disk, and when each was written."""
    return {path.name: path.stat().st_mtime_ns for path in (pathlib.Path(folder) / "chunks").glob("*.csv")}


def wait_for(condition, seconds=60):
    last = time.monotonic() + seconds
    while time.monotonic() < last:
        if condition():
            return True
        time.sleep(0.002)
    return bool(condition())


def children(process):
    """The processes that this one started."""
    found = []
    for thread in pathlib.Path(f"/proc/{process}/task").glob("*/children"):
        try:
            found += map(int, thread.read_text().split())
        except (FileNotFoundError, ProcessLookupError):
            pass
    return found


def descendants(process):
    found = children(process)
    for child in list(found):
        found += descendants(child)
    return found


def is_alive(process):
    try:
        state = pathlib.Path(f"/proc/{process}/stat").read_text().rsplit(")", 1)[1].split()[0]
    except FileNotFoundError:
        return False
    return state not in "ZX"


def kill(process, number=signal.SIGKILL):
    os.kill(process, number)
