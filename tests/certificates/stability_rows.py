# SPDX-License-Identifier: MIT
"""Rows of the stability table, judged: stability_rows.py FOLDER [SECONDS], FOLDER as stability_table FOLDER --results writes it.

A row that says optimal or infeasible is confirmed, not judged (by name: what the checker has no proof for, or no time:
SECONDS a row, 120) or refuted, of which there must be none. Other rows must not be refuted either.
"""
import collections
import json
import subprocess
import sys
from pathlib import Path

import checker

CODES = {0: "confirmed", 1: "refuted", 2: "not judged"}


def judged(folder, seconds):
    """(outcome, why)."""
    if not (folder / "scene.toml").exists():
        return "not judged", "a scene that is no scene file"
    command = [sys.executable, "-B", str(checker.ROOT / "scripts" / "verify-certificate"), str(folder), "--quiet"]
    try:
        run = subprocess.run(command, capture_output=True, text=True, timeout=seconds)
    except subprocess.TimeoutExpired:
        return "not judged", f"more than {seconds} s"
    return CODES.get(run.returncode, "refuted"), (run.stdout.strip() or run.stderr.strip()).splitlines()[-1]


def main():
    rows = sorted((Path(sys.argv[1]) / "results").iterdir(), key=lambda folder: int(folder.name))
    seconds = int(sys.argv[2]) if len(sys.argv) > 2 else 120
    counts, faults = collections.Counter(), 0
    for folder in rows:
        verdict = json.loads((folder / "result.json").read_text())["verdict"]
        outcome, why = judged(folder, seconds)
        claims = verdict in ("optimal", "infeasible")
        if claims:
            counts[outcome] += 1
        faults += outcome == "refuted"
        if not claims or outcome != "confirmed":
            print(f"{(folder / 'row.txt').read_text().strip()}: {verdict}: {outcome}: {why}", flush=True)
    print(f"{sum(counts.values())} rows say optimal or infeasible: " +
          ", ".join(f"{counts[name]} {name}" for name in CODES.values()))
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
