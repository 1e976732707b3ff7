# SPDX-License-Identifier: MIT
"""cases_test.py PROGRAM ROOT FOLDER: scenes of tests/cases that earlier versions answered wrongly, with answers computed independently of
camopt. A case is a row here, or another test names it."""

import json
import pathlib
import re
import shutil
import subprocess
import sys

PROGRAM, ROOT, FOLDER = sys.argv[1], pathlib.Path(sys.argv[2]), pathlib.Path(sys.argv[3])
CASES = ROOT / "tests/cases"

CONFIRMED, NOT_JUDGED = 0, 2  # exit codes of verify-certificate

# (words of the command after camopt, exit code, fields of the result file: value and tolerance or text, texts found, texts not found)
ROWS = [
    ("solve 40c_seam.toml", 2, {}, ["40c_lift.csv", "s_m = 0.06 in line 362 and s_m = 0.044082 in line 2"], []),
    ("solve 59_isg_table.toml --set measured.scale=[1e-4,1e-4]", 0,
     {"verdict": "optimal", "measured.rows": 37, "measured.nearest_laws.0.law": "Cycloidal"}, ["59_cam.tab: 37 rows"], []),
    ("solve measured_lobe.toml", 0, {"measured.register.start_deg": (81.14, 0.05), "measured.rms_error_mm": (0.00015 * 25.4, 1e-4)},
     ["cam.face_radius_mm 16 mm"], ["cam.face_radius_in"]),
    ("solve very_unequal_return.toml", 0, {"verdict": "optimal", "objective": (2.5467998, 2e-7), "solver.name": "structured"}, [], []),
    ("solve weak_27378_instead_of_13.toml", 0, {"verdict": "optimal", "objective": (13.2778, 1e-4)}, [], []),
    # Ipopt's 0.879431 to its own tolerance.
    ("solve weak_auto_6x_worse_than_ipopt.toml", 0, {"verdict": "optimal", "objective": (0.879431, 2e-5)}, [], []),
    ("solve 55_die.toml", 0, {"physical_peaks.a_m_s2": (2.89424, 1e-5)}, [], []),
    ("solve 45c_respecify.toml", 3, {"verdict": "infeasible"}, ["increase the preload to 8.8771 N", "the spring rate to 227.04 N/m"], []),
    ("solve 43_laws.toml", 3, {}, [], ["curve of this spline", "More segments", "weights"]),
    ("solve contradicting_verdicts.toml", 3, {"verdict": "infeasible"}, [], []),
    # Rounding hides its least violation, which took 13 s; that it has no motion is found at once.
    ("solve infeasible_degree_seven.toml --set solver.max_seconds=4 --set solver.explain_seconds=0", 3, {"verdict": "infeasible"}, [], []),
    ("solve infeasible_constant_velocity.toml --set solver.explain_seconds=0", 3, {"verdict": "infeasible"}, [], []),
    ("solve constant_velocity_degree_seven.toml --set solver.name=structured", 0,
     {"verdict": "optimal", "objective": (0.73194831076764277, 1e-9)}, [], []),
    ("solve constant_velocity_program.toml --set solver.explain_seconds=0", 3, {"verdict": "infeasible"}, ["found for B-spline coefficients"], []),
    ('solve tiny_stroke.toml --set spline.design="coefficients"', 1, {"verdict": "failed", "reason": "breakpoints_too_close"},
     ["so narrow that double precision gives its width to"], []),
    ("machine machine_seam/machine.toml", 0, {"verdict": "optimal", "objective": (0.45882117063255179, 1e-8)}, [], []),
    ("machine machine_dear_repair/machine.toml", 0, {"verdict": "optimal", "objective": (0.31809762916107315, 1e-9)}, [], []),
    ("solve dear_repair.toml", 0, {"verdict": "optimal", "objective": (1.6161616637182394, 2e-9)}, [], []),
    ("solve dear_violation.toml", 0, {"objective": (2.523430594648711, 2e-7)}, [], []),
    ("solve dear_violation.toml --set solver.name=structured", 0, {"verdict": "optimal", "objective": (2.523430594648711, 5e-9)}, ["settled for B-spline"], []),
    ("solve corridor_of_nanometres.toml", 0, {"verdict": "optimal"}, ["limits that lie within rounding of infeasible"], []),
    ("solve torque_beside_breakpoint.toml", 0, {"verdict": "optimal", "objective": (1.1077729751978131, 2e-9)}, [], []),
    ("solve cam_out_of_reach.toml", 0, {"verdict": "optimal", "objective": (1.81859163578785, 1e-9)}, ["whose cam can be built"], []),
    ("solve cam_out_of_reach.toml --set objective.velocity=0 --set objective.acceleration=1", 0, {"verdict": "local", "objective": (2.94134796, 1e-7)}, ["whose cam can be built"], []),
    ("solve cam_of_smoothest_optimum.toml", 0, {"verdict": "optimal", "objective": (4.8068241249061563, 3e-9)}, [], []),
    ("machine machine_out_of_reach/machine.toml", 0, {"verdict": "optimal", "objective": (0.95280696773758022, 1e-9)}, ["whose cams can be built"], []),
    ("solve infeasible_narrow_piece.toml --set solver.explain_seconds=0", 3, {"verdict": "infeasible"}, ["settled for B-spline coefficients"], []),
    ("solve cam_of_first_optimum.toml", 0, {"verdict": "optimal", "objective": (3.0734684505975918, 2e-9)}, ["tie-break by jerk"], []),
    ("solve infeasible_nearly_dependent.toml --set solver.explain_seconds=0", 3, {"verdict": "infeasible"}, [], []),
    ("solve infeasible_unbounded_motion.toml --set solver.explain_seconds=0", 3, {"verdict": "infeasible"}, [], []),
    ("machine machine_wide_boxes/machine.toml", 3, {"verdict": "infeasible"}, ["No motions exist at 38 rpm: proved"], []),
    # The die alone: 60 rpm at 2.89424 m/s^2, thus 111.528 rpm at 10 m/s^2.
    ("machine 55c_press.toml", 0, {"verdict": "optimal", "speed_rpm": (111.528, 0.06), "impossible_above_rpm": (111.528, 0.06)}, [], []),
    # Its clearance begins 1 deg later than the corridor of 55c_press.
    ("machine machine_indexing/55_press.toml", 0,
     {"verdict": "optimal", "speed_rpm": (113.595, 0.06), "impossible_above_rpm": (113.595, 0.06)}, [], []),
    ("solve inch_lobe.toml", 0, {"verdict": "optimal"}, ["0.004 in", "0.006 in", "0.020 in", "0.050 in"],
     ["0.0039370", "0.00393701", "mm/deg", " mm "]),
]


def value_at(document, path):
    for name in path.split("."):
        document = document[int(name) if name.isdigit() else name]
    return document


def answer(row, out):
    words, code, fields, found, absent = row
    command, scene, *settings = words.split()
    done = subprocess.run([PROGRAM, command, str(CASES / scene), *settings, "--out", str(out)], capture_output=True, text=True, timeout=120,
                          check=False)
    assert done.returncode == code, (words, done.returncode, done.stderr)
    if (out / "certificate.json").exists():
        judged = subprocess.run([sys.executable, "-B", str(ROOT / "scripts/verify-certificate"), str(out), "--quiet"], capture_output=True, text=True,
                                timeout=120, check=False)
        assert judged.returncode in (CONFIRMED, NOT_JUDGED), (words, judged.stdout, judged.stderr)
    text = " ".join((done.stdout + done.stderr).split())
    if fields:
        document = json.loads((out / ("machine.json" if command == "machine" else "result.json")).read_text(encoding="utf-8"))
    for path, right in fields.items():
        is_at = value_at(document, path)
        fits = abs(is_at - right[0]) <= right[1] if isinstance(right, tuple) else is_at == right
        assert fits, (words, path, is_at, right)
    for words_found in found:
        assert words_found in text, (words, words_found, text)
    for words_absent in absent:
        assert words_absent not in text, (words, words_absent, text)


def every_case_has_a_test():
    rows = " ".join(words for words, *_ in ROWS)
    tests = [path.read_text(encoding="utf-8") for folder in (ROOT / "tests").iterdir() if folder.is_dir() and folder.name != "cases"
             for path in folder.rglob("*") if path != pathlib.Path(__file__)
             and (path.suffix in {".py", ".cpp"} or path.parent == ROOT / "tests/golden/cases")]
    scenes = "".join(path.read_text(encoding="utf-8") for path in CASES.rglob("*.toml"))
    for case in CASES.iterdir():
        name = case.stem if case.suffix == ".toml" else case.name
        used = re.search(rf'"{re.escape(case.name)}"', scenes)  # of another case
        assert used or re.search(rf"\b{re.escape(name)}\b", rows) or any(name in text for text in tests), f"no test reads {case}"


def main():
    every_case_has_a_test()
    shutil.rmtree(FOLDER, ignore_errors=True)
    for i, row in enumerate(ROWS):
        answer(row, FOLDER / str(i))
    print(f"{len(ROWS)} cases have their right answer")


main()
