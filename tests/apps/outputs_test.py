# SPDX-License-Identifier: MIT
"""outputs_test.py PROGRAM ROOT FOLDER: what outputs show of a motor, of an axis that advances, of a keyway; names that no folder can
have; and a program that is told to end leaves no folder behind."""

import csv
import html
import json
import math
import pathlib
import re
import shutil
import signal
import subprocess
import sys
import time

PROGRAM, ROOT, FOLDER = sys.argv[1], pathlib.Path(sys.argv[2]), pathlib.Path(sys.argv[3])
SERVO = ROOT / "tests/cases/servo_curve.toml"


def run(*words, code=0):
    done = subprocess.run([PROGRAM, *map(str, words)], capture_output=True, text=True, timeout=60, check=False)
    assert done.returncode == code, (words, done.returncode, done.stderr)
    return done


def rows_of(path):
    with open(path, encoding="utf-8", newline="") as file:
        return list(csv.DictReader(file))


def page_of(path):
    return json.loads(re.search(r'id="page-data">(.*?)</script>', path.read_text(encoding="utf-8"), re.DOTALL).group(1))


def torque_of(row):
    """Of the motor of servo_curve.toml, from the acceleration and the velocity alone."""
    radius, mass, inertia, friction = 0.120 / (2.0 * math.pi), 12.0, 6e-4, 25.0
    a, v = float(row["a_mm_s2"]) * 1e-3, float(row["v_mm_s"]) * 1e-3
    return (inertia / radius + mass * radius) * a + (radius * friction * math.copysign(1.0, v) if abs(v) > 1e-6 else 0.0)


def a_motor_is_shown_everywhere():
    run("solve", SERVO, "--out", FOLDER / "servo")
    torque = max(abs(torque_of(row)) for row in rows_of(FOLDER / "servo/motion.csv"))
    picture = page_of(FOLDER / "servo/report.html")["motor"]
    assert "Torque over speed" in picture and "curve of the motor" in picture
    assert "](drive.svg)" in (FOLDER / "servo/report.md").read_text(encoding="utf-8")
    run("sweep", SERVO, "--vary", "motion.speed_rpm=30:40:2", "--out", FOLDER / "sweep")
    at_40 = rows_of(FOLDER / "sweep/sweep.csv")[-1]
    assert abs(float(at_40["motor_torque_nm"]) - torque) < 1e-3 * torque, (at_40["motor_torque_nm"], torque)
    assert abs(float(at_40["motor_torque_rms_nm"]) - 2.2597) < 1e-3 and abs(float(at_40["motor_speed_rpm"]) - 745.62) < 0.1, at_40
    titles = [column["title"] for column in page_of(FOLDER / "sweep/sweep.html")["tables"][0]["columns"]]
    assert {"torque of the motor (N m)", "rms torque of the motor (N m)", "speed of the motor (rpm)"} <= set(titles), titles
    compared = run("compare", SERVO, "--out", FOLDER / "compare").stdout
    assert "Objective: 0.2 J/69.47 + 0.8 motor torque rms/2.189" in compared, compared[-300:]
    optimum = rows_of(FOLDER / "compare/comparison.csv")[0]
    assert abs(float(optimum["motor_torque_nm"]) - torque) < 1e-3 * torque, optimum
    keys = [column["key"] for column in page_of(FOLDER / "compare/comparison.html")["tables"][0]["columns"]]
    assert len(keys) == len(set(keys)), keys
    assert json.loads((FOLDER / "compare/comparison.json").read_text())["rows"][0]["drive"]["rms_torque_nm"] > 2.2


def an_axis_that_advances_does_not_fall_back():
    machine = FOLDER / "knife"
    shutil.copytree(ROOT / "scenes/machines", machine, dirs_exist_ok=True)
    text = (machine / "knife.toml").read_text(encoding="utf-8")
    (machine / "knife.toml").write_text(text.replace('scene = "knife_drum.toml"', 'scene = "knife_drum.toml"\nphase_deg = 100'))
    run("machine", machine / "knife.toml", "--set", "machine.speed_rpm=100", "--out", FOLDER / "timing")
    values = next(curve for curve in page_of(FOLDER / "timing/report.html")["curves"] if curve["key"] == "axis_knife")["values"]
    # By the master: it begins at 100 deg, and before that the revolution before it ends.
    assert values[0] < 0 and abs(values[-1] - values[0] - 360.0) < 1e-6, (values[0], values[-1])
    assert all(b > a - 1e-9 for a, b in zip(values, values[1:]))


def corners(text):
    """Of a text of drawing.svg with its descenders; narrower than any font would make it."""
    found = {name: float(value) for name, value in re.findall(r'\b(x|y|font-size)="([-\d.]+)"', text)}
    words = html.unescape(re.search(r">(.*)</text>", text).group(1))
    width, height, low = 0.5 * found["font-size"] * len(words), 0.75 * found["font-size"], 0.2 * found["font-size"]
    anchor = re.search(r'class="[^"]*\b(middle|end)"', text)
    left = {"middle": -0.5 * width, "end": -width}[anchor.group(1)] if anchor else 0.0
    turned = re.search(r"rotate\(([-\d.]+)", text)
    angle = math.radians(float(turned.group(1))) if turned else 0.0
    return words, [(found["x"] + u * math.cos(angle) - v * math.sin(angle), found["y"] + u * math.sin(angle) + v * math.cos(angle))
                   for u, v in ((left, low), (left + width, low), (left + width, -height), (left, -height))]


def overlap(one, other):
    """Two convex polygons: no edge of either separates them."""
    for shape in (one, other):
        for (x, y), (u, v) in zip(shape, shape[1:] + shape[:1]):
            along = [[(q - y) * (u - x) - (p - x) * (v - y) for p, q in polygon] for polygon in (one, other)]
            if max(along[0]) <= min(along[1]) or max(along[1]) <= min(along[0]):
                return False
    return True


def words_of_a_drawing_lie_apart():
    for angle in (0, 5, 10, 20, 45, 90, 170, 190, 270, 345, 350):
        drawing = f"drawing={{bore_mm=20, keyway={{width_mm=6, depth_mm=2.8, at_deg={angle}}}, thickness_mm=12}}"
        run("export", ROOT / "scenes/cam_roller.toml", "--set", drawing, "--drawing", "svg", "--out", FOLDER / "drawing")
        texts = re.findall(r"<text[^>]*>[^<]*</text>", (FOLDER / "drawing/drawing.svg").read_text(encoding="utf-8"))
        words = [corners(text) for text in texts]
        words = words[:next(i for i, (text, _) in enumerate(words) if text.startswith("datum")) + 1]
        assert ("6" in [text for text, _ in words]) and len(words) >= 8, words
        for i, (text, shape) in enumerate(words):
            for other_text, other in words[:i]:
                assert not overlap(shape, other), (angle, text, other_text)


def a_name_too_long_for_a_folder_is_refused():
    machine = FOLDER / "long"
    shutil.copytree(ROOT / "scenes/machines", machine, dirs_exist_ok=True)
    text = (machine / "knife.toml").read_text(encoding="utf-8").replace('name = "feed"', f'name = "{"f" * 300}"')
    (machine / "knife.toml").write_text(text)
    begin = time.monotonic()
    refused = run("machine", machine / "knife.toml", "--out", FOLDER / "never", code=2).stderr
    assert "axis[1].name: found a name of 300 letters; allowed: at most 64" in refused, refused
    assert time.monotonic() - begin < 5.0 and not (FOLDER / "never").exists()


def termination_leaves_no_folder_behind():
    out = FOLDER / "ended"
    run("solve", ROOT / "scenes/barrel_paper_cup.toml", "--out", FOLDER / "drum")
    words = [PROGRAM, "export", FOLDER / "drum", "--out", out, "--stl", "--nc", "--step", "--sections", "15", "--points", "1000"]
    with subprocess.Popen(list(map(str, words)), stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL) as program:
        end = time.monotonic() + 30
        while not list(out.glob(".camopt-*.tmp")) and program.poll() is None and time.monotonic() < end:
            time.sleep(0.005)
        assert program.poll() is None, "it ended before it could be told to"
        program.send_signal(signal.SIGTERM)
        program.wait(60)
    assert not list(out.glob(".*")), list(out.glob(".*"))


def a_position_is_counted_counter_clockwise():
    """By register and by inspect, of points turned by 5 deg counter-clockwise, whichever way the cam rotates."""
    head = """[motion]
type = "program"
lift_mm = 10
segments = [{ KIND, angle_deg = 80, to = 1 }, { kind = "dwell", angle_deg = 40 }, { KIND, angle_deg = 120, to = 0 },
            { kind = "dwell", angle_deg = 120 }]
[cam]
type = "disk"
follower = "translating_roller"
base_radius_mm = 40
roller_radius_mm = 10
offset_mm = 6
"""
    more = '[measured]\ntable = "points.csv"\ncolumns = ["x_mm", "y_mm"]\nregister = ["angle", "radius"]\nuse = "nearest"\n'
    folder, turned = FOLDER / "turned", complex(math.cos(math.radians(5)), math.sin(math.radians(5)))
    folder.mkdir()
    for rotation in ("counterclockwise", "clockwise"):
        scene = head + f'rotation = "{rotation}"\n'
        (folder / "given.toml").write_text(scene.replace("KIND", 'kind = "law", law = "cycloidal"'))
        run("solve", folder / "given.toml", "--out", folder / "given")
        points = [turned * complex(float(row["cam_x_mm"]), float(row["cam_y_mm"])) for row in rows_of(folder / "given/profile.csv")]
        (folder / "points.csv").write_text("x_mm,y_mm\n" + "".join(f"{p.real},{p.imag}\n" for p in points))
        inspected = run("inspect", folder / "given", folder / "points.csv", "--out", folder / "inspected").stdout
        assert "how far the cam is turned on the table, counter-clockwise" in inspected, inspected
        assert "counter-clockwise" in (folder / "inspected/inspection.html").read_text(encoding="utf-8")
        offset = json.loads((folder / "inspected/inspection.json").read_text())["alignment"][1]["value"]
        (folder / "found.toml").write_text(scene.replace("KIND", 'kind = "spline"') + more)
        found = " ".join(run("solve", folder / "found.toml", "--out", folder / "found").stdout.split())
        assert "the cam is turned by 5 ±" in found and "counter-clockwise on the table" in found, found
        placed = json.loads((folder / "found/result.json").read_text())["measured"]["register"]["start_deg"]
        assert abs(offset - 5) < 1e-6 and abs(placed - 5) < 1e-4, (rotation, offset, placed)


def valves_are_compared_in_one_unit():
    intake, exhaust = (ROOT / f"tests/cases/41_{name}.toml" for name in ("intake", "exhaust"))
    metric = FOLDER / "exhaust.toml"
    metric.write_text(exhaust.read_text(encoding="utf-8").replace("lift_in = 0.327", "lift_mm = 8.3058"))
    assert "(--units)" not in run("valves", intake, exhaust).stdout
    words = run("valves", intake, metric).stdout
    assert "Lengths are in in, as the intake is written; the exhaust is written in mm" in words and " mm\n" not in words, words
    assert "(--units)" not in run("valves", intake, metric, "--units", "mm").stdout


def main():
    shutil.rmtree(FOLDER, ignore_errors=True)
    FOLDER.mkdir(parents=True)
    for check in (a_motor_is_shown_everywhere, an_axis_that_advances_does_not_fall_back, words_of_a_drawing_lie_apart,
                  a_name_too_long_for_a_folder_is_refused, a_position_is_counted_counter_clockwise,
                  valves_are_compared_in_one_unit, termination_leaves_no_folder_behind):
        begin = time.monotonic()
        check()
        print(f"{check.__name__}: {time.monotonic() - begin:.1f} s", flush=True)


main()
