# SPDX-License-Identifier: MIT
"""plc_read_back.py CAMOPT SCENES SOLVED [--all]: every electronic-cam format of solved scenes against scripts/verify-export: the claimed
departure is proved, at least the largest of many samples of the motion and at most twice that; lossless is lossless; spoiled rows are refused with
their place; what a format cannot hold is refused by name, and a result folder is not solved. SOLVED: solve_examples.py; scenes with other
settings are solved here. --all (nightly): 100,000 samples, five times the spoiled rows, and the formats that take longest to prove with every scene."""

import bisect
import csv
import json
import pathlib
import random
import re
import subprocess
import sys
import tempfile
import tomllib

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[3] / "scripts"))
from certificate_checker.exact import Refuted, derivative  # noqa: E402
from certificate_checker.rational import Fraction, parsed  # noqa: E402
from export_checker import plc, plc_tables, table  # noqa: E402

ALL = list(plc_tables.READERS)
LONG = {"omron", "lenze"}  # thousands of rows
EVERYTHING = "--all" in sys.argv
JUMPS = [key for key in ALL if key != "twincat7"]  # whose points hold a jerk that jumps
QUINTIC = {"codesys", "twincat", "siemens", "csv"}  # lossless for quintic and cubic splines
SEPTIC = ["spline.degree=7", "spline.end_jerk=\"zero\"", "spline.segments=10"]
# What rounding of float64 leaves of s … j, as parts of their peaks: below it samples show nothing.
NOISE = (1e-14, 1e-13, 1e-12, 1e-11)
# Scene, settings, formats, options, which of them are lossless.
CASES = [
    ("drd_quintic_12", [], JUMPS, [], QUINTIC),
    ("drd_quintic_12", SEPTIC, ["codesys", "twincat7", "br", "csv"], [], {"twincat7", "csv"}),
    ("drd_quintic_end_jerk", [], ["codesys", "siemens"], [], QUINTIC),
    ("drd_cubic_12", [], JUMPS, [], QUINTIC | {"rockwell"}),
    ("rr_unequal_return", [], JUMPS, [], QUINTIC | {"rockwell"}),
    ("cam_arm_roller", ["spline.segments=10", "solver.starts=1"], JUMPS, [], QUINTIC | {"rockwell"}),
    ("swing_limits", [], JUMPS, [], QUINTIC),
    ("cam_drdrd", ["spline.segments=6", "solver.starts=1"], JUMPS, [], QUINTIC | {"rockwell"}),
    ("cam_laws_and_splines", ["spline.segments=8", "solver.starts=1"], JUMPS, [], set()),
    ("drd_cubic_64", [], ["codesys", "br", "siemens"], ["--points", "51"], set()),
]
REFUSALS = [
    ("drd_cubic_64", ["codesys", "twincat"], [], None),
    ("drd_cubic_64", ["siemens"], [], "65 segments, a technology object TO_Cam holds 50"),
    ("drd_cubic_64", ["codesys"], ["--points", "300"], "300 points, a cam read from a file"),
    ("drd_cubic_64", ["br"], ["--points", "200"], "199 polynomials, an MC_CAMPROFILE_TYP holds 128 (64 in older libraries)"),
    ("drd_cubic_64", ["omron"], ["--points", "400"], "399 nodes, CamNodes holds 360"),
    ("drd_cubic_64", ["bosch"], [], "'bosch'"),
    ("drd_cubic_64", ["twincat7"], [], "has one jerk for both sides; allowed: codesys, twincat, siemens"),
]


SOLVED = pathlib.Path(sys.argv[3])


def run(camopt, *words):
    return subprocess.run([camopt, *map(str, words)], capture_output=True, text=True, check=False)


def exported_table(camopt, folder, out, *options):
    return run(camopt, "export", folder, "--out", out, "--csv", *options)


def exported(camopt, what, formats, options, out):
    return run(camopt, "export", what, "--out", out, "--plc", ",".join(formats), *options)


def solved(camopt, scene, settings, folder):
    if not settings and (SOLVED / scene.stem).is_dir():
        return SOLVED / scene.stem
    words = [word for setting in settings for word in ("--set", setting)]
    found = run(camopt, "solve", scene, *words, "--out", folder)
    assert found.returncode == 0, found.stderr
    return folder


class Samples:
    """The motion that camopt itself writes: s … s''' by degrees, at places that are no joints."""

    def __init__(self, camopt, folder, work):
        scene = tomllib.loads((folder / "scene.toml").read_text(), parse_float=parsed)
        self.scene, unit = scene, "deg" if any(key in scene["motion"] for key in ("lift_deg", "lift_rad", "stops")) else "mm"
        self.columns = [f"s_{unit}", f"ds_{unit}_deg", f"dds_{unit}_deg2", f"ddds_{unit}_deg3"]
        ran = exported_table(camopt, folder, work / "samples", "--points", 100_000 if EVERYTHING else 20_000,
                             "--columns", ",".join(["theta_deg", *self.columns]))
        assert ran.returncode == 0, ran.stderr
        with open(work / "samples/table.csv", newline="", encoding="utf-8") as file:
            rows = list(csv.reader(line for line in file if not line.startswith("#")))
        self.rows = [[float(cell) for cell in row] for row in rows[1:]]
        self.peaks = [max(abs(row[1 + r]) for row in self.rows) for r in range(4)]

    def largest(self, pieces, orders):
        """Of |motion − table| away from joints, where either side may be meant."""
        begins = [float(begin) for begin, _, _ in pieces]
        own = [[[float(part) for part in derivative(c, r)] for r in range(orders)] for _, _, c in pieces]
        worst = [0.0] * orders
        for theta, *values in self.rows:
            i = max(0, bisect.bisect_right(begins, theta) - 1)
            t = theta - begins[i]
            if min(abs(t), abs(float(pieces[i][1]) - theta)) < 1e-6:
                continue
            for r in range(orders):
                value = 0.0
                for c in reversed(own[i][r]):
                    value = value * t + c
                worst[r] = max(worst[r], abs(values[r] - value))
        return worst


def check_claims(name, claims, text, samples, second=False):
    """The claims are proved, no smaller than the samples, and at most twice as large."""
    outcome = plc.verify(text, claims, samples.scene, second)
    assert not outcome.faults and not outcome.unverified, f"{name}: {outcome.faults or outcome.unverified}"
    found = samples.largest(plc.pieces_of(text, claims, second), len(outcome.bounds))
    for row, is_, peak, noise in zip(claims["loss"], found, samples.peaks, NOISE):
        said = row["per_degree"]
        assert is_ <= said + noise * peak, f"{name}: {row['quantity']} is off by {is_}, claimed {said}"
        # Beside a joint that a float32 moves the largest one lies between two samples.
        largest = max(is_, outcome.bounds[row["quantity"]]) + noise * peak
        assert second or said <= 2 * largest, f"{name}: {row['quantity']} is off by {largest}, claimed {said}"
    if claims["verdict"] == "lossless":
        assert found[0] <= 1e-12 * samples.peaks[0] and len(found) == 4, (name, found)
    return found


def check_spoiled(name, claims, text, scene, chance):
    """One digit of one number of the table changed."""
    numbers = [match for match in re.finditer(r"-?\d+\.\d+(?:e-?\d+)?", text)
               if not text[text.rfind("\n", 0, match.start()) + 1:match.start()].lstrip().startswith(("//", "#")) and
               "//" not in text[text.rfind("\n", 0, match.start()) + 1:match.start()]]
    for _ in range(50):
        chosen = chance.choice(numbers)
        place = next((at for at in range(chosen.start(), chosen.end()) if text[at] in "123456789"), None)
        if place is not None and abs(float(chosen.group())) > 1e-3 and "Jerk" not in text[chosen.start() - 30:chosen.start()]:
            break
    changed = text[:place] + str(int(text[place]) % 9 + 1) + text[place + 1:]
    try:
        faults = plc.verify(changed, claims, scene).faults
    except Refuted as fault:
        faults = [str(fault)]
    line = text.count("\n", 0, place) + 1
    assert faults, f"{name}: {chosen.group()} in line {line} was spoiled and not noticed"
    assert re.search(r"row|element|point|polynomial|node|master|Cam\.", faults[0]), f"{name}: no place is named: {faults[0]}"


def check_table(camopt, folder, samples, work, chance):
    """table.csv joined by straight lines: bounds at least the samples and at most twice that; a spoiled cell or a missing row is refused."""
    for columns in ([], ["--columns", ",".join(["theta_deg", *samples.columns])]):
        ran = exported_table(camopt, folder, work / "table", "--step-deg", "1", "--digits", "7", *columns)
        assert ran.returncode == 0 and "straight lines between rows depart by at most s_" in ran.stdout, ran.stdout + ran.stderr
        claims, text = json.loads((work / "table/table.check.json").read_text()), (work / "table/table.csv").read_text()
        outcome, numbers = table.verify(text, claims, samples.scene), table.read(text)
        assert not outcome.faults and outcome.unverified == claims["left_out"] and len(outcome.bounds) == 4, outcome
    for order, (key, said) in enumerate(claims["departure"].items()):
        found = samples.largest(list(table.lines(numbers["theta_deg"], numbers[key], order)), 4)[order]
        assert found <= said * (1 + 1e-6), f"{folder.name} {key}: off by {found}, claimed {said}"
        assert said <= 2 * outcome.bounds[key] and outcome.bounds[key] <= 2 * found, f"{folder.name} {key}: {said}, {found}"
    rows = text.splitlines()
    row = chance.randrange(1, len(rows))
    cells = rows[row].split(",")
    cells[1] = str(float(cells[1]) + 2.5 * claims["departure"][rows[0].split(",")[1]])
    for changed in (rows[:row] + [",".join(cells)] + rows[row + 1:], rows[:-1]):
        try:
            faults = table.verify("\n".join(changed), claims, samples.scene).faults
        except Refuted as fault:
            faults = [str(fault)]
        assert faults and "row" in faults[0], f"{folder.name} table.csv: a spoiled row was not noticed"
    print(f"{folder.name} table.csv: " + ", ".join(f"{key} {said:.2e}" for key, said in claims["departure"].items()), flush=True)


def check_header(name, row, text):
    if row["format"] not in ("lenze",):
        assert f"the whole cycle, {row['verdict']}: s " in text, f"{name}: the header does not say {row['verdict']}"
    assert f"{row['count']} {row['element']}" in text, name


def check_case(camopt, scenes, case, work):
    scene, settings, formats, options, lossless = case
    if not EVERYTHING and scene not in ("rr_unequal_return", "cam_laws_and_splines"):
        formats = [key for key in formats if key not in LONG]
    folder = solved(camopt, scenes / f"{scene}.toml", settings, work / "result")
    ran = exported(camopt, folder, formats, options, work / "plc")
    assert ran.returncode == 0, ran.stderr
    said = json.loads((work / "plc" / "plc.json").read_text())
    assert [row["format"] for row in said["formats"]] == formats
    samples, chance = Samples(camopt, folder, work), random.Random(scene)
    for row in said["formats"]:
        name = f"{scene} {row['format']}"
        claims = json.loads((work / "plc" / f"{row['file'].split('.')[0]}.check.json").read_text())
        assert all(claims[key] == row[key] for key in row), name
        assert (row["verdict"] == "lossless") == (row["format"] in lossless), f"{name}: {row['verdict']}"
        assert row["limit"] is None or row["count"] <= row["limit"], name
        text = (work / "plc" / row["file"]).read_text()
        found = check_claims(name, claims, text, samples)
        check_header(name, row, text)
        if row["format"] not in LONG:
            for _ in range(5 if EVERYTHING else 1):
                check_spoiled(name, claims, text, samples.scene, chance)
        if row["text_file"]:
            check_claims(f"{name} text", claims, (work / "plc" / row["text_file"]).read_text(), samples, True)
        assert f"{row['file']}" in ran.stdout and row["verdict"] in ran.stdout, ran.stdout
        print(f"{name}: {row['count']} {row['element']}, {row['verdict']}, "
              + ", ".join(f"{symbol} {value:.2e}" for symbol, value in zip("svaj", found)), flush=True)
    check_table(camopt, folder, samples, work, chance)


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
