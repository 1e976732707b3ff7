# SPDX-License-Identifier: MIT
"""machines_test.py CAMOPT: what camopt says of machines is confirmed, and refuted after one number is changed: a speed that is possible is
not called impossible, nor a motor that holds its load said to be too weak at any speed, nor a clearance kept that is not."""
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

MOTION = '[motion]\ntype = "program"\nlift_mm = 60\nspeed_rpm = 60\n'
SLIDE = """segments = [
{ kind = "spline", angle_deg = 140, to = 1 }, { kind = "dwell", angle_deg = 20 },
{ kind = "spline", angle_deg = 140, to = 0 }, { kind = "dwell", angle_deg = 60 }]
[spline]
segments = 8
"""
DRIVE = "[drive]\nload_mass_kg = 5\nmotor_inertia_kg_m2 = 2e-4\ntransmission_mm_per_rev = 50\nforce_n = 1000\n"
JERK = "[objective]\njerk = 1\n"
HOLDING = MOTION + SLIDE + DRIVE + "[limits]\nmotor_torque_nm = 4\nmotor_torque_rms_nm = 2\n[objective]\nmotor_torque_rms = 1\n"
RUBBING = MOTION + "monotone = true\n" + SLIDE + DRIVE.replace("1000", "400\nfriction_n = 300") + \
    "[limits]\nmotor_curve = [[0, 4], [3000, 3], [4500, 1]]\n" + JERK
LOWERING = MOTION + 'closed = "relative"\nsegments = [{ kind = "spline", angle_deg = 200, to = -1 }, { kind = "dwell", angle_deg = 160 }]\n' \
    "[spline]\nsegments = 8\n" + DRIVE + "[limits]\nmotor_torque_nm = { min = -40, max = 4 }\n" + JERK
DAMPED = MOTION + SLIDE + DRIVE + "viscous_n_s_m = 900\n[limits]\nmotor_torque_nm = 20\n" + JERK
FOLLOWING = MOTION + SLIDE + "[limits]\nacceleration_m_s2 = 40\n" + JERK
# Advances by its lift in every cycle; counts from the cycle's start.
INDEXING = MOTION + 'closed = "relative"\nsegments = [{ kind = "dwell", angle_deg = 210 }, ' \
    '{ kind = "law", law = "cycloidal", angle_deg = 150, to = 1 }]\n[limits]\nacceleration_m_s2 = 400\n'
BESIDE = """phase_deg = 60
[[clearance]]
between = ["axis1", "axis2"]
factors = [-1, -1]
at_least_mm = -62
"""
# In radians; both strokes are laws.
LEADING = MOTION + """segments = [
{ kind = "law", law = "modified_sine", angle_rad = 2.0944, to = 1 }, { kind = "dwell", angle_rad = 0.35 },
{ kind = "law", law = "polynomial_345", angle_rad = 2.0944, to = 0 }, { kind = "dwell", angle_rad = 1.744385307179586 }]
[limits]
acceleration_m_s2 = 400
[objective]
acceleration = 1
"""
FIXED, RANGE = "speed_rpm = 60", "speed_rad_s = { min = 1, max = 200 }"
CLEARANCE = """phase_rad = 0.09
[[clearance]]
between = ["axis1", "axis2"]
factors = [-1, 1]
at_least_mm = -11
"""
TIGHTER = {"at_least_mm = -11": "at_least_mm = -10.999"}
# A brake holds what the motor cannot, as long as the axis never stands still.
BRAKED = {"200, to": "360, to", ', {kind = "dwell", angle_deg = 160}': "", "force_n = 1000": "force_n = 1000\nviscous_n_s_m = 900"}
# At a higher speed a torque that is damped need not be larger.
FASTER = {"speed_rpm = 900": "speed_rpm = { min = 900, max = 1000 }"}
# (name, speed, axes, more of machine.toml, the verdict and whether it is of any speed, the file that is changed, how, what is said then)
SMALL = [("holding", RANGE, [HOLDING], "", ("infeasible", True), "axis1.toml", {"force_n = 1000": "force_n = 10"}, "refuted"),
         ("rubbing", FIXED, [RUBBING], "", ("infeasible", True), "axis1.toml", {"friction_n = 300": "friction_n = 30"}, "refuted"),
         ("lowering", RANGE, [LOWERING], "", ("infeasible", True), "axis1.toml", BRAKED, "not verified"),
         ("damped", "speed_rpm = 900", [DAMPED], "", ("infeasible", False), "machine.toml", FASTER, "not verified"),
         ("following", RANGE, [LEADING, FOLLOWING], CLEARANCE, ("optimal", False), "machine.toml", TIGHTER, "refuted"),
         ("indexing", RANGE, [INDEXING, FOLLOWING], BESIDE, ("optimal", False), "machine.toml",
          {"at_least_mm = -62": "at_least_mm = -61.999"}, "refuted"),
         ("least", FIXED, [LEADING, FOLLOWING], CLEARANCE, ("optimal", False), "machine.toml", TIGHTER, "refuted")]


def run(camopt, machine, folder):
    ended = subprocess.run([camopt, "machine", str(machine), "--out", str(folder)], capture_output=True, text=True, timeout=600)
    assert ended.returncode in (0, 3), ended.stderr


def expect(module, folder, expected, why):
    outcome, found = checker.outcome(module, folder)
    assert outcome == expected, f"{folder.name}: {outcome}, expected {expected} ({why}): {found}"


def change(file, changes):
    text = file.read_text()
    for number, other in changes.items():
        assert text.count(number) == 1, f"{file}: {number}"
        text = text.replace(number, other)
    file.write_text(text)


def small_machine(camopt, module, place, case):
    name, speed, axes, more, claim, file, changes, expected = case
    folder, text = place / name, f"[machine]\n{speed}\n"
    for i, axis in enumerate(axes, 1):
        (place / f"{name}{i}.toml").write_text(axis)
        text += f'[[axis]]\nname = "axis{i}"\nscene = "{name}{i}.toml"\n'
    (place / f"{name}.toml").write_text(text + more)
    run(camopt, place / f"{name}.toml", folder)
    told = json.loads((folder / "machine.json").read_text())
    assert (told["verdict"], told["at_standstill"]) == claim, name
    expect(module, folder, "confirmed", "as camopt wrote it")
    if told["axes"]:
        (folder / "machine.json").write_text(json.dumps(told | {"speed_rpm": told["speed_rpm"] * (1 + 1e-5)}))
        expect(module, folder, "refuted", "a speed that is not that of the motions")
        (folder / "machine.json").write_text(json.dumps(told))
    change(folder / file, changes)
    expect(module, folder, expected, changes)


def example(camopt, module, place, name):
    run(camopt, place / f"{name}.toml", place / name)
    expect(module, place / name, "confirmed", "as camopt wrote it")
    file = place / name / "machine.json"
    told = json.loads(file.read_text())
    assert told["impossible_above_rpm"] <= told["speed_rpm"] * 1.001 * (1 + 1e-9), told["impossible_above_rpm"]
    told["speed_rpm"] *= 0.97
    told["impossible_above_rpm"] *= 0.98
    file.write_text(json.dumps(told))
    expect(module, place / name, "refuted", "a speed that is possible")


def corridor_to_the_end(camopt, module, place):
    """A corridor that ends with the cycle, in a dwell there, is part of the proof that no speed is larger."""
    for name in ("55c_press", "55_mill", "55c_die"):
        shutil.copy(checker.ROOT / "tests/cases" / f"{name}.toml", place)
    run(camopt, place / "55c_press.toml", place / "press")
    expect(module, place / "press", "confirmed", "as camopt wrote it")
    told = json.loads((place / "press/machine.json").read_text())
    assert told["impossible_above_rpm"] <= told["speed_rpm"] * 1.001 * (1 + 1e-9), told["impossible_above_rpm"]
    change(place / "press/die.toml", {"to_deg = 68": "to_deg = 67"})
    expect(module, place / "press", "refuted", "another corridor than that of the motions")


def clearance_that_touches(camopt, module, place):
    """What is left between two axes that rest is 0: round-off is no proof that they collide."""
    run(camopt, checker.ROOT / "tests/cases/machine_touching/machine.toml", place / "touching")
    assert json.loads((place / "touching/machine.json").read_text())["verdict"] == "optimal"
    expect(module, place / "touching", "confirmed", "as camopt wrote it")


def format_that_does_not_fit(camopt, place):
    """Is refused before the search, and leaves no folder."""
    ended = subprocess.run([camopt, "machine", str(checker.ROOT / "tests/cases/56_shear.toml"), "--plc", "siemens", "--out",
                            str(place / "shear")], capture_output=True, text=True, timeout=600)
    assert ended.returncode == 2 and "a technology object TO_Cam holds 50" in ended.stderr, ended.stderr
    assert not (place / "shear").exists()


def axis_reports(camopt, place):
    """An axis says that it belongs to a machine and what shapes it."""
    folder = place / "indexing" / "axis2"
    for again in (False, True):
        if again:  # from the folder alone
            subprocess.run([camopt, "report", str(folder)], check=True, capture_output=True, timeout=60)
        report, page = ((folder / name).read_text(encoding="utf-8") for name in ("report.md", "report.html"))
        for words in "An axis of a machine", "it begins at 60 deg of the master", "clearance[0].at_least_mm shapes it":
            assert words in report, (again, words)
        for words in "search ended early", "would be no worse":
            assert words not in page, (again, words)


def main():
    camopt, module = sys.argv[1], checker.load()
    with tempfile.TemporaryDirectory() as place:
        place = Path(place)
        for scene in (checker.ROOT / "scenes/machines").glob("*.toml"):
            shutil.copy(scene, place)
        feed = place / "knife_feed.toml"
        feed.write_text(re.sub(r"\{ min = \d+, max = \d+ \}", lambda _: next(GIVEN_ANGLES), feed.read_text()))
        for name in ("cartoner", "knife"):
            example(camopt, module, place, name)
        for case in SMALL:
            small_machine(camopt, module, place, case)
        corridor_to_the_end(camopt, module, place)
        clearance_that_touches(camopt, module, place)
        format_that_does_not_fit(camopt, place)
        axis_reports(camopt, place)
    print(f"{3 + len(SMALL)} machines confirmed, {3 + len(SMALL)} of them changed and then refuted or left open")


if __name__ == "__main__":
    main()
