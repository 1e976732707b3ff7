# SPDX-License-Identifier: MIT
"""report_test.py PROGRAM SCENES SOLVED FOLDER: what a person reads of every example scene (SOLVED: solve_examples.py).

The report names every key that the key table knows and the scene sets, with its value. Peaks are those of motion.csv
to the printed digits. With a speed the motion stands in mm/s and m/s² (swinging: deg/s, deg/s²) first; a scene written in
inches comes back in inches. Forces stand in profile.csv as their formulas say."""

import csv
import json
import math
import pathlib
import re
import shutil
import subprocess
import sys
import tomllib
import xml.dom.minidom

PROGRAM = sys.argv[1]
SCENES, SOLVED, FOLDER = (pathlib.Path(word) for word in sys.argv[2:5])
SECONDS = 300
INCH = 25.4
IN_TIME = {"mm/s", "m/s²", "m/s³", "deg/s", "deg/s²", "deg/s³", "in/s", "in/s²", "in/s³"}
BY_ANGLE = re.compile(r"(?:mm|in)/rad|deg/deg")
faults = []


def check(holds, *words):
    if not holds:
        faults.append(" ".join(str(word) for word in words))


def solve(scene, name, *options):
    """The folder and what the console said."""
    folder = FOLDER / name
    run = subprocess.run([PROGRAM, "solve", scene, "--out", folder, *options], capture_output=True, text=True,
                         timeout=SECONDS, check=False)
    check(run.returncode in (0, 3), name, "ended with", run.returncode, run.stderr)
    return folder, run.stdout


def short(value, digits=6):
    """As people read a number: significant digits without trailing zeros, no power of ten below 1e7, a typographic minus."""
    if not math.isfinite(value):
        return "–"
    text = f"{value:.{digits}g}"
    if "e+" in text and abs(float(text)) < 1e7:
        text = f"{float(text):.0f}"
    text = re.sub(r"e([+-])0*", lambda sign: "e" + sign[1].strip("+"), text)
    return re.sub("^-", "−", text) if value else "0"


def section(report, title):
    found = re.search(rf"^## {re.escape(title)}\n(.*?)(?=^## |\Z)", report, re.M | re.S)
    return found.group(1) if found else ""


def rows_of(text):
    """The cells of a Markdown table, without its head."""
    rows = [re.split(r"(?<!\\)\|", line)[1:-1] for line in text.splitlines() if line.startswith("|")]
    return [[cell.strip().replace("\\|", "|") for cell in row] for row in rows[2:]]


def known_keys():
    """(table, key) → type, of the key table."""
    listed = json.loads(subprocess.run([PROGRAM, "list", "keys", "--json"], capture_output=True, text=True,
                                       check=True, timeout=SECONDS).stdout)
    return {(row["table"] or "", spelling["key"]): row["type"] for row in listed if row["file"] == "scene"
            for spelling in row["keys"]}


def leaves(values, known, table="", path=""):
    """(path, value) of every key that holds a value, by the key table."""
    for name, value in values.items():
        where, key = ".".join(filter(None, (path, name))), ".".join(filter(None, (table, name)))
        kind = known.get((table, name))
        check(kind is not None, "the key table does not know", where)
        if kind == "options":
            yield from ((f"{where}.{option}", held) for option, held in value.items())
        elif kind == "tables" or kind == "array of tables" or (isinstance(value, list) and value
                                                              and isinstance(value[0], dict)):
            for index, item in enumerate(value):
                yield from leaves(item, known, key, f"{where}[{index}]")
        elif isinstance(value, dict) and set(value) != {"min", "max"}:
            yield from leaves(value, known, key, where)
        else:
            yield where, value


def check_keys(name, scene_text, report, known):
    scene = tomllib.loads(scene_text)
    listed = {row[0].strip("`"): row[1].strip("`") for row in rows_of(section(report, "The scene, key by key"))}
    found = dict(leaves(scene, known))
    check(found.keys() == listed.keys(), name, "keys set and keys listed differ:", found.keys() ^ listed.keys())
    for key, value in found.items():
        check(key in listed and tomllib.loads("value = " + listed[key])["value"] == value, name, key, value,
              "stands as", listed.get(key))
    code = re.search(r"^(`{3,})toml\n(.*?)\n\1$", report, re.M | re.S)
    check(code and tomllib.loads(code.group(2)) == scene, name, "does not repeat its scene")


def motion_cells(folder, column):
    """Of the output's motion where it is prescribed, whose columns are those in mm and seconds."""
    with open(folder / "motion.csv", newline="", encoding="utf-8") as file:
        rows = list(csv.DictReader(file))
    if "output_s_mm" not in rows[0]:
        return [row[column] for row in rows]
    order = {"v": 1, "a": 2, "j": 3, "ds": 1, "dds": 2, "ddds": 3}[column.split("_")[0]]
    pace = math.radians(float(rows[-1]["theta_deg"]) - float(rows[0]["theta_deg"])) / float(rows[-1]["t_s"])
    factor = pace**-order if column.startswith("d") else 1e-3 if "_m_" in column else 1.0
    own = ("output_v_mm_s", "output_a_mm_s2", "output_j_mm_s3")[order - 1]
    return [factor * float(row[own]) for row in rows]


def largest(folder, column):
    """The first cell of the largest magnitude, with its sign; None where a cell is empty: infinite."""
    cells = motion_cells(folder, column)
    if "" in cells:
        return None
    values = [float(cell) for cell in cells]
    most = max(map(abs, values))
    return next(value for value in values if abs(value) >= most * (1 - 1e-7))


def check_peaks(name, folder, report, swings, inches):
    """What the table of peaks says first and beside is what the CSV holds."""
    length = ("deg", "deg") if swings else ("mm", "m")
    first = {"velocity": (f"v_{length[0]}_s", f"{length[0]}/s"),
             "acceleration": (f"a_{length[1]}_s2", f"{length[1]}/s²"),
             "jerk": (f"j_{length[1]}_s3", f"{length[1]}/s³")}
    beside = {"velocity": "ds_deg_deg" if swings else "ds_mm_rad",
              "acceleration": "dds_deg_deg2" if swings else "dds_mm_rad2",
              "jerk": "ddds_deg_deg3" if swings else "ddds_mm_rad3"}
    rows = {row[0].split()[0]: row for row in rows_of(section(report, "Peaks"))}
    for peak, (column, unit) in first.items():
        value, value_beside = largest(folder, column), largest(folder, beside[peak])
        if value is None:
            continue
        if inches:
            value, unit = value / (INCH if peak == "velocity" else INCH / 1000), unit.replace("mm", "in").replace(
                "m/", "in/")
            value_beside /= INCH
        check(rows[peak][1] == f"{short(value)} {unit}", name, peak, "is", rows[peak][1], "and in motion.csv",
              short(value), unit)
        check(rows[peak][2].split()[0] == short(value_beside), name, peak, "beside is", rows[peak][2],
              "and in motion.csv", short(value_beside))


def check_order(name, text):
    """Where the motion is told by the cam angle, it is told in time before, on the same line; what names a key or a set point keeps
    its unit."""
    for line in text.splitlines():
        found = BY_ANGLE.search(line)
        if found and not re.search(r"_(?:mm|in|m)_rad2?\b|of set point \d", line):
            before = line[:found.start()]
            check(any(unit in before for unit in IN_TIME), name, "says", found.group(), "first:", line)


def check_pictures(name, folder, inches):
    for picture in sorted(folder.glob("*.svg")):
        texts = [node.firstChild.data for node in xml.dom.minidom.parse(str(picture)).getElementsByTagName("text")
                 if node.firstChild]
        for text in texts:
            if BY_ANGLE.search(text):
                beside = re.search(r"\((?:peak )?[−\d.e+]+ [^()]+\)$", text)
                check(beside, name, picture.name, "tells it by the cam angle:", text)
            if inches:
                check(not re.search(r"\bmm\b", text), name, picture.name, "speaks of mm:", text)


def is_swinging(scene):
    return any(key.startswith("lift_") and key.endswith(("deg", "rad")) for key in scene["motion"])


def check_scenes(known):
    timed = 0
    for path in sorted(SCENES.glob("*.toml")):
        text = path.read_text(encoding="utf-8")
        scene = tomllib.loads(text)
        folder, console = SOLVED / path.stem, (SOLVED / f"{path.stem}.console").read_text(encoding="utf-8")
        report = (folder / "report.md").read_text(encoding="utf-8")
        kept = (folder / "scene.toml").read_text(encoding="utf-8")
        if "measured" not in scene:  # whose table stands in the kept scene
            check(tomllib.loads(kept) == scene, path.stem, "is not the scene that the folder keeps")
        check_keys(path.stem, kept, report, known)
        inches = "lift_in" in scene["motion"]
        check_pictures(path.stem, folder, inches) if any(key.startswith("speed_") for key in scene["motion"]) else None
        if not any(key.startswith("speed_") for key in scene["motion"]) or not (folder / "motion.csv").exists():
            continue
        timed += 1
        check_peaks(path.stem, folder, report, is_swinging(scene), inches)
        check_order(path.stem, console)
        check_order(path.stem, report)
    check(timed >= 8, "only", timed, "example scenes have a speed")


def in_inches(text):
    """The same scene with every length in inches."""
    def converted(match):
        return f"{match.group(1)}_in = {float(match.group(2)) / INCH!r}"
    return re.sub(r"\b(\w+)_mm = ([\d.]+)", converted, text)


def check_inches():
    scene = FOLDER / "inches.toml"
    scene.write_text(in_inches((SCENES / "cam_forces.toml").read_text(encoding="utf-8").replace(
        "spring_rate_n_mm = 12", "spring_rate_n_m = 12000")), encoding="utf-8")
    folder, console = solve(scene, "inches")
    report = (folder / "report.md").read_text(encoding="utf-8")
    told = report[:report.index("## The scene, key by key")]
    for name, text in (("console", console), ("report", told)):
        metric = r"\bmm\b|\d (?:N|N m|N/mm|MPa|GPa|kg)(?= |,|$)"
        written = "limit|cap|<=|>="  # in the unit of their keys
        check(not any(re.search(metric, line) for line in text.splitlines() if not re.search(written, line, re.I)),
              name, "of a scene in inches speaks of metric units:",
              *[line for line in text.splitlines() if re.search(metric, line)])
        check("lbf" in text, name, "of a scene in inches has no lbf")
        check("in/s²" in text, name, "of a scene in inches has no in/s²")
    check_pictures("inches", folder, True)
    check_peaks("inches", folder, report, False, True)
    # And asked for: the same words of the scene in mm.
    shown, _ = solve(SCENES / "cam_forces.toml", "shown_in_inches", "--units", "in")
    peaks = section((shown / "report.md").read_text(encoding="utf-8"), "Peaks")
    check([row[1].split()[1:] for row in rows_of(peaks)][:3] == [["in/s"], ["in/s²"], ["in/s³"]],
          "--units in shows", peaks)


def run_words(*words):
    run = subprocess.run([PROGRAM, *map(str, words)], capture_output=True, text=True, timeout=SECONDS, check=False)
    check(run.returncode == 0, words, "ended with", run.returncode, run.stderr)
    return run.stdout


def check_units_asked_for():
    """What people read follows --units; what machines read does not."""
    def files(which, *words):
        folders = {}
        for units in ("mm", "in"):
            folder = FOLDER / f"{which}_{units}"
            text = run_words(*words, "--out", folder, "--units", units)
            other = {"mm": "in/s", "in": "mm/s"}[units]
            check(f"{units}/s²" in text or units == "mm" and "m/s²" in text, which, "--units", units, "says", text)
            check(f" {other}" not in text, which, "--units", units, "says", other, text)
            folders[units] = folder
        return folders

    scene = SCENES / "cam_smallest.toml"
    speed = ("--set", "motion.speed_rpm=200")
    made = files("export", "export", scene, *speed, "--csv")
    for name in ("table.csv", "profile.csv"):
        check((made["mm"] / name).read_bytes() == (made["in"] / name).read_bytes(), name, "differs by --units")
    made = files("sweep", "sweep", scene, *speed, "--vary", "objective.base_radius=0.2,0.6")
    first = {units: (folder / "sweep.csv").read_text(encoding="utf-8").splitlines()[0] for units, folder in made.items()}
    check(first["mm"] == first["in"] and "_mm" in first["in"], "sweep.csv names", first)
    for units, folder in made.items():
        check(f"base radius ({units})" in (folder / "sweep.html").read_text(encoding="utf-8"), "sweep.html of", units)
    made = files("front", "sweep", scene, *speed, "--pareto", "base_radius,acceleration", "--points", "3")
    for units, folder in made.items():
        check("base_radius_mm" in (folder / "pareto.csv").read_text(encoding="utf-8").splitlines()[0], "pareto.csv of", units)
        check(f"base radius ({units})" in (folder / "pareto.html").read_text(encoding="utf-8"), "pareto.html of", units)
        check(f"base radius ({units})" in (folder / "pareto.svg").read_text(encoding="utf-8"), "pareto.svg of", units)


def check_swinging():
    folder, console = solve(SCENES / "cam_arm_roller.toml", "swinging", "--set", "motion.speed_rpm=200")
    report = (folder / "report.md").read_text(encoding="utf-8")
    check(" deg/s² " in console, "a swinging follower has no deg/s² on the console:", console)
    check_peaks("swinging", folder, report, True, False)
    check_order("swinging", console)
    check_order("swinging", report)


def check_other_commands():
    for words in (["compare"], ["sweep", "--vary", "motion.rise_deg=80,100", "--out", str(FOLDER / "sweep")],
                  ["sweep", "--pareto", "velocity,acceleration", "--points", "3", "--out", str(FOLDER / "front")]):
        run = subprocess.run([PROGRAM, words[0], str(SCENES / "drd_spline_12.toml"), *words[1:]], capture_output=True,
                             text=True, timeout=SECONDS, check=False)
        check(run.returncode == 0, words, "ended with", run.returncode, run.stderr)
        check_order(" ".join(words), run.stdout)
        if "motion.rise_deg=80,100" not in words:
            check("mm/s" in run.stdout and "m/s²" in run.stdout, words, "says nothing in time:", run.stdout)


def check_forces():
    """At the breakpoints, which both tables have: F = m a + c s + preload, T = F s'."""
    folder = SOLVED / "cam_forces"
    forces = tomllib.loads((SCENES / "cam_forces.toml").read_text(encoding="utf-8"))["forces"]
    with open(folder / "motion.csv", newline="", encoding="utf-8") as file:
        motion = {round(float(row["theta_deg"]), 9): row for row in csv.DictReader(file)}  # the last is from the right
    with open(folder / "profile.csv", newline="", encoding="utf-8") as file:
        profile = list(csv.DictReader(file))
    common = 0
    for row in profile:
        if (at := motion.get(round(float(row["theta_deg"]), 9))) is None:
            continue
        common += 1
        force = (forces["mass_kg"] * float(at["a_m_s2"]) + forces["spring_rate_n_mm"] * float(at["s_mm"])
                 + forces["preload_n"])
        check(math.isclose(float(row["force_n"]), force, rel_tol=1e-6), "force", row["force_n"], "for", force)
        torque = force * float(at["ds_mm_rad"]) / 1000
        check(math.isclose(float(row["torque_nm"]), torque, rel_tol=1e-6, abs_tol=1e-6), "torque", row["torque_nm"],
              "for", torque)
        normal = force / math.cos(math.radians(float(row["pressure_angle_deg"])))
        check(math.isclose(float(row["normal_force_n"]), normal, rel_tol=1e-6), "normal force", row["normal_force_n"],
              "for", normal)
        stiffness = 210e9 / (2 * (1 - 0.3 ** 2))  # steel on steel
        curvature = 1000 * (1 / float(row["cam_radius_mm"]) + 1 / 10) if row["cam_radius_mm"] else 100.0
        pressure = math.sqrt(normal * stiffness * curvature / (math.pi * forces["contact_width_mm"] / 1000)) / 1e6
        check(math.isclose(float(row["hertz_pressure_mpa"]), pressure, rel_tol=1e-6), "pressure",
              row["hertz_pressure_mpa"], "for", pressure)
    check(common >= 15, "only", common, "angles stand in both tables")
    report = (folder / "report.md").read_text(encoding="utf-8")
    check("(forces.svg)" in report, "the report shows no forces.svg")
    figures = {row[0]: row[1].split()[0] for row in rows_of(section(report, "The cam"))}
    picture = (folder / "forces.svg").read_text(encoding="utf-8")
    for column, figure, symbol in (("torque_nm", "largest camshaft torque", "T"),
                                   ("hertz_pressure_mpa", "largest Hertz pressure", "p"),
                                   ("normal_force_n", "largest force along the normal", "N")):
        most = max(abs(float(row[column])) for row in profile)
        told = float(figures[figure])
        check(math.isclose(most, told, rel_tol=2e-3), figure, told, "and in the table", most)
        check(re.search(rf">−?{re.escape(figures[figure])} ", picture), "forces.svg does not name", symbol, told)


def main():
    shutil.rmtree(FOLDER, ignore_errors=True)
    FOLDER.mkdir(parents=True)
    check_scenes(known_keys())
    check_inches()
    check_units_asked_for()
    check_swinging()
    check_other_commands()
    check_forces()
    for fault in faults:
        print(fault)
    print(len(faults), "faults")
    return 1 if faults else 0


sys.exit(main())
