# SPDX-License-Identifier: MIT
"""plc_read_back.py CAMOPT SCENES SOLVED: every electronic-cam format of solved scenes, read by readers.py, evaluated as the
controller does and compared with the exact motion: the stated loss is right within 10 % and never exceeded, lossless is
lossless, a spoiled digit is noticed, what a format cannot hold is refused by name, and a result folder is not solved.
SOLVED: solve_examples.py; scenes with other settings are solved here."""

import json
import pathlib
import re
import subprocess
import sys
import tempfile
from fractions import Fraction

import exact_motion
import readers

ALL = list(readers.READERS)
QUINTIC = {"codesys", "twincat", "siemens", "csv"}  # lossless for quintic and cubic splines
# What rounding of float64 leaves of s, s', s'', s''', as parts of their peaks.
NOISE = (1e-12, 1e-11, 1e-10, 1e-9)
# Scene, settings, formats, options, which of them are lossless.
CASES = [
    ("drd_quintic_12", [], ALL, [], QUINTIC),
    ("drd_quintic_end_jerk", [], ["codesys", "siemens"], [], QUINTIC),
    ("drd_cubic_12", [], ALL, [], QUINTIC | {"rockwell"}),
    ("rr_unequal_return", [], ALL, [], QUINTIC | {"rockwell"}),
    ("cam_arm_roller", ["spline.segments=10", "solver.starts=1"], ALL, [], QUINTIC | {"rockwell"}),
    ("swing_limits", [], ALL, [], QUINTIC),
    ("cam_drdrd", ["spline.segments=6", "solver.starts=1"], ALL, [], QUINTIC | {"rockwell"}),
    ("cam_laws_and_splines", ["spline.segments=8", "solver.starts=1"], ALL, [], set()),
    ("drd_cubic_64", [], ["codesys", "br", "siemens"], ["--points", "51"], set()),
]
REFUSALS = [
    ("drd_cubic_64", ["codesys", "twincat"], [], None),
    ("drd_cubic_64", ["siemens"], [], "65 segments, a technology object TO_Cam holds 50"),
    ("drd_cubic_64", ["codesys"], ["--points", "300"], "300 points, a cam read from a file"),
    ("drd_cubic_64", ["br"], ["--points", "200"], "199 polynomials, an MC_CAMPROFILE_TYP holds 128 (64 in older libraries)"),
    ("drd_cubic_64", ["omron"], ["--points", "400"], "399 nodes, CamNodes holds 360"),
    ("drd_cubic_64", ["bosch"], [], "'bosch'"),
]


SOLVED = pathlib.Path(sys.argv[3])


def run(camopt, *words):
    return subprocess.run([camopt, *map(str, words)], capture_output=True, text=True, check=False)


def exported(camopt, what, formats, options, out):
    return run(camopt, "export", what, "--out", out, "--plc", ",".join(formats), *options)


def solved(camopt, scene, settings, folder):
    if not settings and (SOLVED / scene.stem).is_dir():
        return SOLVED / scene.stem
    words = [word for setting in settings for word in ("--set", setting)]
    found = run(camopt, "solve", scene, *words, "--out", folder)
    assert found.returncode == 0, found.stderr
    return folder


def table_of(row, text, reader):
    pieces = reader(text, row["units"])
    start = Fraction(row["slave_at_start"])
    return [(begin, end, [c[0] + start, *c[1:]]) for begin, end, c in pieces]


def check_loss(name, row, found, peaks):
    """The loss of one file against what plc.json says of it."""
    stated = [entry["per_degree"] for entry in row["loss"]][:len(found)]
    for symbol, is_, said, peak, noise in zip("svaj", found, stated, peaks, NOISE):
        assert is_ <= said + noise * peak, f"{name}: {symbol} is off by {is_}, stated {said}"
        if row["verdict"] == "lossy":
            assert said <= 1.1 * is_ + noise * peak, f"{name}: {symbol} is off by {is_}, stated {said}"
    if row["verdict"] == "lossless":
        assert found[0] <= 1e-12 * peaks[0] and len(found) == 4, (name, found)


def check_spoiled(name, row, text, reader, stretches, found):
    """The slave position nearest to half the lift, its third digit changed."""
    numbers = [match for match in re.finditer(r"-?\d+\.\d+(?:e-?\d+)?", text)
               if not text[text.rfind("\n", 0, match.start()) + 1:match.start()].lstrip().startswith(("//", "#"))]
    half = float(max(abs(c[0]) for _, _, c in reader(text, row["units"]))) / 2 / row["units"]["slave"]
    positions = [float(c[0]) / row["units"]["slave"] for _, _, c in reader(text, row["units"])]
    position = min(positions, key=lambda one: abs(one - half))
    chosen = min(numbers, key=lambda match: abs(float(match.group()) - position))
    digits = [place for place in range(chosen.start(), chosen.end()) if text[place].isdigit()]
    place = digits[min(2, len(digits) - 1)]
    changed = text[:place] + str((int(text[place]) + 5) % 10) + text[place + 1:]
    try:
        worse = exact_motion.loss(stretches, table_of(row, changed, reader), len(found))
    except (AssertionError, ZeroDivisionError, KeyError, ValueError):
        return
    assert any(now > 1.1 * before + 1e-9 for now, before in zip(worse, found)), f"{name}: spoiled and not noticed"


def check_header(name, row, text):
    if row["format"] not in ("lenze",):
        assert f"the whole cycle, {row['verdict']}: s " in text, f"{name}: the header does not say {row['verdict']}"
    assert f"{row['count']} {row['element']}" in text, name


def check_case(camopt, scenes, case, work):
    scene, settings, formats, options, lossless = case
    folder = solved(camopt, scenes / f"{scene}.toml", settings, work / "result")
    ran = exported(camopt, folder, formats, options, work / "plc")
    assert ran.returncode == 0, ran.stderr
    said = json.loads((work / "plc" / "plc.json").read_text())
    assert [row["format"] for row in said["formats"]] == formats
    stretches, lift = exact_motion.motion_of(folder)
    peaks = [float(lift), *exact_motion.peaks(stretches)[1:]]
    for row in said["formats"]:
        name = f"{scene} {row['format']}"
        assert (row["verdict"] == "lossless") == (row["format"] in lossless), f"{name}: {row['verdict']}"
        assert row["limit"] is None or row["count"] <= row["limit"], name
        orders = 2 if row["loss"][2]["per_degree"] is None else 4
        text = (work / "plc" / row["file"]).read_text()
        reader = readers.READERS[row["format"]]
        found = exact_motion.loss(stretches, table_of(row, text, reader), orders)
        check_loss(name, row, found, peaks)
        check_header(name, row, text)
        check_spoiled(name, row, text, reader, stretches, found)
        if row["text_file"]:
            other = (work / "plc" / row["text_file"]).read_text()
            found = exact_motion.loss(stretches, table_of(row, other, readers.TEXT_READERS[row["format"]]), orders)
            check_loss(f"{name} text", row, found, peaks)
        assert f"{row['file']}" in ran.stdout and row["verdict"] in ran.stdout, ran.stdout
        print(f"{name}: {row['count']} {row['element']}, {row['verdict']}, "
              + ", ".join(f"{symbol} {value:.2e}" for symbol, value in zip("svaj", found)))


def check_refusals(camopt, scenes, work):
    folder = solved(camopt, scenes / "drd_cubic_64.toml", [], work / "many")
    for number, (_, formats, options, words) in enumerate(REFUSALS):
        out = work / f"refused{number}"
        ran = exported(camopt, folder, formats, options, out)
        if words is None:
            assert ran.returncode == 0, ran.stderr
            continue
        assert ran.returncode == 2 and (words in ran.stderr or words.strip("'") in ran.stderr), ran.stderr
        assert not out.exists() or not list(out.iterdir()), "a refused export wrote files"
        print(f"refused: {ran.stderr.strip()}")


def check_jump(camopt, work):
    """Constant acceleration: its acceleration jumps."""
    scene = work / "jump.toml"
    segments = [("dwell", 60, ""), ("law", 90, 'law = "parabolic"\nto = 1.0'), ("dwell", 60, ""),
                ("spline", 150, "to = 0.0")]
    scene.write_text('title = "A jump"\n[motion]\ntype = "program"\nlift_mm = 20\n' + "".join(
        f'[[motion.segments]]\nkind = "{kind}"\nangle_deg = {angle}\n{more}\n' for kind, angle, more in segments)
        + "[spline]\nsegments = 8\n[objective]\nacceleration = 1.0\n")
    folder = solved(camopt, scene, [], work / "jump")
    for one in ("codesys", "twincat"):
        ran = exported(camopt, folder, [one], [], work / "no")
        assert ran.returncode == 2 and f"--plc {one}: the acceleration jumps at 60 deg" in ran.stderr, ran.stderr
        assert "siemens, br, rockwell, csv" in ran.stderr, ran.stderr
    ran = exported(camopt, folder, ["siemens", "br", "rockwell", "csv"], [], work / "yes")
    assert ran.returncode == 0, ran.stderr
    for row in json.loads((work / "yes" / "plc.json").read_text())["formats"]:
        assert row["format"] == "br" or row["verdict"] == "lossless", row


def check_solves_nothing(camopt, scenes, work):
    """A folder whose scene could not be solved in its time is exported all the same."""
    folder = solved(camopt, scenes / "drd_cubic_12.toml", [], work / "kept")
    ran = exported(camopt, folder, ["codesys"], ["--set", "spline.segments=4"], work / "none")
    assert ran.returncode == 2 and "used unchanged" in ran.stderr, ran.stderr
    of_folder = exported(camopt, folder, ["codesys"], [], work / "a")
    of_scene = exported(camopt, scenes / "drd_cubic_12.toml", ["codesys"], [], work / "b")
    assert of_folder.returncode == of_scene.returncode == 0
    assert (work / "a" / "codesys.st").read_text() == (work / "b" / "codesys.st").read_text()


def main():
    camopt, scenes = sys.argv[1], pathlib.Path(sys.argv[2])
    for case in CASES:
        with tempfile.TemporaryDirectory() as work:
            check_case(camopt, scenes, case, pathlib.Path(work))
    with tempfile.TemporaryDirectory() as work:
        check_refusals(camopt, scenes, pathlib.Path(work))
        check_jump(camopt, pathlib.Path(work))
        check_solves_nothing(camopt, scenes, pathlib.Path(work))
    print("every format of every case agrees with what is stated of it")


if __name__ == "__main__":
    main()
