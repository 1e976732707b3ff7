# SPDX-License-Identifier: MIT
"""machines_test.py CAMOPT: what camopt says of the example machines is confirmed, and a speed that is possible is not called impossible."""
import json
import re
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

import checker

# The angles of the feed's strokes, which the example leaves to a search.
GIVEN_ANGLES = iter(("150", "120"))


def run(camopt, machine, folder):
    ended = subprocess.run([camopt, "machine", str(machine), "--out", str(folder)], capture_output=True, text=True, timeout=600)
    assert ended.returncode == 0, ended.stderr


def main():
    camopt, module = sys.argv[1], checker.load()
    with tempfile.TemporaryDirectory() as place:
        place = Path(place)
        for scene in (checker.ROOT / "scenes/machines").glob("*.toml"):
            shutil.copy(scene, place)
        feed = place / "knife_feed.toml"
        feed.write_text(re.sub(r"\{ min = \d+, max = \d+ \}", lambda _: next(GIVEN_ANGLES), feed.read_text()))
        for name in ("cartoner", "knife"):
            run(camopt, place / f"{name}.toml", place / name)
            outcome, why = checker.outcome(module, place / name)
            assert outcome == "confirmed", f"{name}: {outcome}: {why}"
            file = place / name / "machine.json"
            told = json.loads(file.read_text())
            assert told["impossible_above_rpm"] <= told["speed_rpm"] * 1.001 * (1 + 1e-9), told["impossible_above_rpm"]
            told["speed_rpm"] *= 0.97
            told["impossible_above_rpm"] *= 0.98
            file.write_text(json.dumps(told))
            outcome, why = checker.outcome(module, place / name)
            assert outcome == "refuted", f"{name}: a speed that is possible is {outcome} as impossible: {why}"
    print("2 machines confirmed, 2 changed claims refuted")


if __name__ == "__main__":
    main()
