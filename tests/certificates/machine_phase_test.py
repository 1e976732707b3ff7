# SPDX-License-Identifier: MIT
"""machine_phase_test.py CAMOPT: the tables of a machine's axes are loaded as written, on one master. The clearance that is proved holds for
every format, for table.csv and for motion.csv; scripts/verify-export confirms each table, and refutes it without its phase."""
import csv
import json
import subprocess
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "scripts"))
from export_checker import plc  # noqa: E402

CASE = ROOT / "tests/cases/machine_phase/machine.toml"
FORMATS = "codesys", "twincat", "br", "rockwell", "omron", "lenze", "csv"
PHASES = {"lift": 0, "push": 10, "gate": 0}
LEAST, ROOM = -130.0, 1e-3  # mm
PLACES = [k / 4 for k in range(1440)]


def run(command):
    done = subprocess.run([str(word) for word in command], capture_output=True, text=True, timeout=600)
    assert done.returncode == 0, f"{command}: {done.returncode}: {done.stderr}"


def verified(table, scene):
    command = [sys.executable, "-B", str(ROOT / "scripts/verify-export"), str(table), str(scene)]
    return subprocess.run(command, capture_output=True, text=True, timeout=600).stdout


def value(pieces, place):
    for begin, end, c in pieces:
        if begin <= place <= end:
            return float(sum(part * (place - float(begin))**k for k, part in enumerate(map(float, c))))
    raise AssertionError(f"no piece at {place} deg")


def clearance_kept(lift, push, what):
    worst = min(lift(place) - push(place) for place in PLACES)
    assert worst >= LEAST - ROOM, f"{what}: lift - push reaches {worst:.6f} mm"
    assert worst < LEAST + 1, f"{what}: the clearance is not active: {worst:.6f} mm"


def between_rows(path):
    rows = list(csv.DictReader(path.read_text().splitlines()))
    angles, values = ([float(row[key]) for row in rows] for key in ("theta_deg", "s_mm"))
    assert angles == sorted(angles) and angles[0] == 0 and angles[-1] == 360, f"{path}: {angles[0]} to {angles[-1]} deg"

    def at(place):
        k = next(k for k, angle in enumerate(angles) if angle >= place)
        if not k or angles[k] == angles[k - 1]:
            return values[k]
        part = (place - angles[k - 1]) / (angles[k] - angles[k - 1])
        return values[k - 1] + part * (values[k] - values[k - 1])
    return at


def tables_of(folder, name):
    written = next(row for row in json.loads((folder / "plc.json").read_text())["formats"] if row["format"] == name)
    check = json.loads((folder / (written["file"].rsplit(".", 1)[0] + ".check.json")).read_text())
    return (folder / check["file"]).read_text(), check


def test(camopt, out):
    run([camopt, "machine", str(CASE), "--out", str(out), *(word for name in FORMATS for word in ("--plc", name))])
    machine = json.loads((out / "machine.json").read_text())
    assert machine["verdict"] == "optimal" and abs(machine["speed_rpm"] / 105.84 - 1) < 2e-3, machine["speed_rpm"]
    for name in FORMATS:
        pieces = {}
        for axis in ("lift", "push"):
            text, check = tables_of(out / axis, name)
            pieces[axis] = plc.pieces_of(text, check)
            found = verified(out / axis / check["file"], out / axis / "scene.toml")
            assert "CONFIRMED" in found, f"{axis}, {name}: {found}"
        clearance_kept(*(lambda place, own=pieces[axis]: value(own, place) for axis in ("lift", "push")), name)
    for axis, phase in PHASES.items():
        written = json.loads((out / axis / "plc.json").read_text())["master"]
        assert written["phase"] == phase, written
        words = f"the motion begins at {phase} deg of the master"
        assert (words in (out / axis / "codesys.st").read_text()) == (phase != 0), axis
        assert (f"the motion begins at {phase} deg" in (out / axis / "report.md").read_text()) == (phase != 0), axis
    clearance_kept(*(between_rows(out / axis / "motion.csv") for axis in ("lift", "push")), "motion.csv")
    for axis in ("lift", "push"):  # from the folder of the axis alone
        run([camopt, "export", str(out / axis), "--csv", "--points", "3601", "--out", str(out / axis / "again")])
        found = verified(out / axis / "again/table.csv", out / axis / "scene.toml")
        assert "CONFIRMED" in found, f"{axis}: {found}"
    clearance_kept(*(between_rows(out / axis / "again/table.csv") for axis in ("lift", "push")), "table.csv")
    scene = out / "push/scene.toml"
    scene.write_text("\n".join(line for line in scene.read_text().splitlines() if "phase_deg" not in line))
    found = verified(out / "push/codesys.st", scene)
    assert "REFUTED" in found, found


if __name__ == "__main__":
    with tempfile.TemporaryDirectory() as folder:
        test(sys.argv[1], Path(folder))
    print("the tables of a machine keep its clearance as they are written")
