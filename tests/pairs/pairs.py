# SPDX-License-Identifier: MIT
"""Every output times every kind of scene: what is written, and what is refused for which reason.

`OUTPUTS` names each output, the words that ask for it and the files it may write; `KINDS` each kind of scene, what of the sources it
stands for and where it is. A pair that `REFUSED` does not name is written. tests/lint/pairs.py demands a row for every file that report/
and apps/ write, every controller, every command, every type of motion and of cam, every follower and every use of a table;
pairs_test.py runs them all."""

# A title that would be obeyed by a page, a report, a picture, a drawing, a controller or a spreadsheet that does not escape it.
TITLE = 'T <script>alert(1)</script> & [x](javascript:y) ![z](http://z) *) // | `q` {"k": 1} =1+1 äµ'

RESULT = ["certificate.json", "motion.csv", "motion.svg", "report.html", "report.md", "result.json", "scene.toml", "tables.csv"]

# name: (command, words, files that it may write). RESULT stands for the folder of the solved scene, SCENE for its scene and settings,
# TABLE for its own motion as a table that was measured.
OUTPUTS = {
    "result": ("solve", [], [
        *RESULT, "drive.svg", "surge.svg", "profile.csv", "second_profile.csv", "guide.csv", "flanks.csv", "profile.svg", "guide.svg",
        "mechanism.svg", "drum.svg", "developed.svg", "profile_diagrams.svg", "pressure_angle.svg", "curvature.svg", "forces.svg",
        "profile.dxf"]),
    "result in inches": ("solve", ["--units", "in"], []),
    "result as JSON": ("solve", ["--json"], []),
    "reports again": ("report", ["RESULT"], []),
    "table": ("export", ["RESULT", "--csv"], ["table.csv", "profile.csv", "guide.csv", "flanks.csv"]),
    "lobe": ("export", ["RESULT", "--lobe", "mm"], ["lobe.csv"]),
    "lobe in inches": ("export", ["RESULT", "--lobe", "in"], []),
    "codesys": ("export", ["RESULT", "--plc", "codesys"], ["codesys.st", "codesys.txt", "plc.json"]),
    "twincat": ("export", ["RESULT", "--plc", "twincat"], ["twincat.st"]),
    "twincat7": ("export", ["RESULT", "--plc", "twincat7"], ["twincat7.st"]),
    "siemens": ("export", ["RESULT", "--plc", "siemens"], ["siemens.scl"]),
    "br": ("export", ["RESULT", "--plc", "br"], ["br.st"]),
    "rockwell": ("export", ["RESULT", "--plc", "rockwell"], ["rockwell.st"]),
    "omron": ("export", ["RESULT", "--plc", "omron"], ["omron.st"]),
    "lenze": ("export", ["RESULT", "--plc", "lenze"], ["lenze.txt"]),
    "coefficient_csv": ("export", ["RESULT", "--plc", "csv"], ["plc.csv"]),
    "DXF": ("export", ["RESULT", "--dxf"], []),
    "drawing as SVG": ("export", ["RESULT", "--drawing", "svg"], ["drawing.svg"]),
    "drawing as PDF": ("export", ["RESULT", "--drawing", "pdf"], ["drawing.pdf"]),
    "drawing as DXF": ("export", ["RESULT", "--drawing", "dxf"], ["drawing.dxf"]),
    "STEP": ("export", ["RESULT", "--step"], ["cam.step", "flanks.step"]),
    "STL": ("export", ["RESULT", "--stl"], ["cam.stl", "groove.stl"]),
    "picture": ("export", ["RESULT", "--picture"], ["cam.svg"]),
    "NC": ("export", ["RESULT", "--nc"], ["cam.nc", "_nc.svg", "_nc_check.txt"]),
    "check": ("check", ["SCENE"], []),
    "comparison": ("compare", ["SCENE"], ["comparison.csv", "comparison.html", "comparison.json", "comparison.svg",
                                             "report.md", "tables.csv"]),
    "dynamics": ("dynamics", ["SCENE", "--speeds", "100:200:3"], [
        "dynamics.csv", "dynamics.json", "detuned.csv", "history.csv", "residual_over_speed.svg", "acceleration_over_speed.svg", "deflection.svg",
        "acceleration.svg", "force.svg", "dynamics.html", "report.md", "steady.csv", "tables.csv"]),
    "sweep": ("sweep", ["SCENE", "--vary", "spline.segments=8:9:2"], ["report.md", "sweep.csv", "sweep.html", "sweep.json", "sweep.svg"]),
    "inspection": ("inspect", ["RESULT", "TABLE"], ["inspection.csv", "inspection.html", "inspection.json", "inspection.svg", "report.md",
                                                   "tables.csv"]),
    "valves": ("valves", ["RESULT", "RESULT", "--gap-mm", "3"], ["report.html", "report.md", "tables.csv", "valves.csv", "valves.json", "valves.svg"]),
}

# name: (what of the sources it stands for, scene below scenes/ or tests/, settings).
KINDS = {
    "rise": (["DRD"], "scenes/drd_cubic_12.toml", []),
    "rise and return": (["RR"], "scenes/rr_cubic_24.toml", []),
    "program": (["program", "dwell", "spline"], "scenes/program_constant_velocity.toml", []),
    "set points": ([], "scenes/pusher_set_points.toml", []),
    "open program": ([], "tests/pairs/open.toml", []),
    "advancing": (["relative"], "scenes/rotary_knife.toml", []),
    "swing": ([], "scenes/swing_limits.toml", []),
    "measured": (["compare"], "scenes/drd_measured.toml", []),
    "started from a measured motion": (["start"], "scenes/drd_measured.toml", ["measured.use=start"]),
    "elastic train": ([], "scenes/dynamics_fast_slide.toml", []),
    "cam for an output on an elastic train": ([], "scenes/splinedyne_slide.toml", []),
    "program of an output on an elastic train": ([], "tests/pairs/splinedyne.toml", []),
    "motor": ([], "scenes/servo_drd.toml", []),
    "motor with its curve": ([], "tests/cases/servo_curve.toml", ["spline.segments=10"]),
    "degree 7": ([], "scenes/servo_index_table.toml", []),
    "roller at degree 7": ([], "scenes/cam_roller.toml", ["spline.degree=7", "spline.rest=4", "spline.segments=24"]),
    "laws and splines": (["law"], "scenes/cam_laws_and_splines.toml", []),
    "laws on an elastic train": ([], "tests/cases/43e_two_strokes.toml", []),
    "laws that join": ([], "tests/cases/44_eccentric.toml", []),
    "forces at every speed": ([], "tests/cases/hertz_at_speed.toml", []),
    "prescribed": ([], "scenes/prescribed_tappet.toml", []),
    "valve": (["valve"], "scenes/valve_intake.toml", []),
    "valve in inches": ([], "tests/cases/41_intake.toml", []),
    "roller": (["disk", "translating_roller"], "scenes/cam_roller.toml", []),
    "roller in inches": ([], "tests/cases/48_weld.toml", []),
    "clockwise": ([], "scenes/cam_clockwise.toml", []),
    "forces": ([], "scenes/cam_forces.toml", []),
    "undercut": ([], "scenes/cam_undercut.toml", []),
    "flat face": (["translating_flat"], "scenes/cam_flat.toml", []),
    "knife edge": (["translating_knife"], "scenes/cam_knife.toml", []),
    "arm with a roller": (["oscillating_roller"], "scenes/cam_arm_roller.toml", []),
    "arm with a flat face": (["oscillating_flat"], "scenes/cam_arm_flat.toml", []),
    "groove": (["grooved"], "scenes/cam_grooved.toml", ["solver.starts=1"]),
    "conjugate": (["conjugate"], "scenes/cam_conjugate.toml", ["solver.starts=1", "spline.segments=8"]),
    "remote": (["remote"], "scenes/tappet_75.toml", ["solver.starts=1", "spline.segments=6"]),
    "inverse": (["inverse"], "scenes/inverse_feeder.toml", []),
    "plate": (["linear"], "scenes/linear_press.toml", []),
    "edge on a plate": ([], "scenes/linear_knife.toml", []),
    "arm over a plate": ([], "scenes/linear_arm.toml", ["solver.starts=1"]),
    "barrel": (["barrel"], "scenes/barrel_paper_cup.toml", []),
    "cylinder": (["cylindrical", "translating"], "scenes/cylinder_slide.toml", []),
    "drum": ([], "scenes/cylinder_drum.toml", ["solver.starts=1"]),
    "indexing": (["rotating"], "scenes/ocrf_indexing.toml", []),
    "given disk in inches": (["given"], "tests/pairs/given_disk.toml", []),
    "given plate": ([], "scenes/given_wedge.toml", []),
    "given guide": ([], "scenes/given_guide_forward.toml", []),
    "given drum": ([], "scenes/given_drum.toml", []),
    "infeasible": ([], "scenes/cam_infeasible.toml", []),
}

CAMLESS = ["rise", "rise and return", "program", "set points", "open program", "advancing", "swing", "measured",
           "started from a measured motion", "elastic train", "laws on an elastic train",
           "program of an output on an elastic train", "motor", "motor with its curve", "degree 7"]
SPATIAL = ["barrel", "cylinder", "drum", "indexing", "given drum"]
REMOTE = ["remote", "inverse", "given guide"]
# Those of which the jerk is continuous, those refused for another reason too.
SMOOTH = ["degree 7", "roller at degree 7", "laws that join", "given disk in inches", "given drum", "given plate", "given guide", "infeasible"]
VALVES = ["valve", "valve in inches", "forces at every speed"]
OF_CAMS = ["DXF", "drawing as SVG", "drawing as PDF", "drawing as DXF", "STEP", "STL", "picture", "NC"]

# Machines of several axes, at a given speed: with each format of the controllers, written or refused.
MACHINES = {
    "phase": ("tests/cases/machine_phase/machine.toml", ["machine.speed_rpm=60"]),
    "advancing": ("scenes/machines/knife.toml", ["machine.speed_rpm=120"]),
    "three axes": ("scenes/machines/cartoner.toml", ["machine.speed_rpm=40"]),
}
CONTROLLERS = ["codesys", "twincat", "twincat7", "siemens", "br", "rockwell", "omron", "lenze", "csv"]

MACHINES_REFUSED = {(name, "twincat7"): "the jerk jumps at" for name in MACHINES}

# Words of the reason, a regular expression; outputs; kinds of which they are refused.
REFUSED = [
    ("found none: the verdict is infeasible",
     [name for name, (command, _, _) in OUTPUTS.items() if command in ("report", "export", "inspect", "valves")], ["infeasible"]),
    ("the rest is for cams, and this scene has none", OF_CAMS, CAMLESS),
    ("found no valve lobe", ["lobe", "lobe in inches"], [kind for kind in KINDS if kind not in VALVES]),
    ('found no motion of type "valve"', ["valves"], [kind for kind in KINDS if kind not in VALVES]),
    (r"found a scene without a \[dynamics\] table", ["dynamics"], [kind for kind in KINDS if "elastic train" not in kind]),
    ('allowed: with cam.type = "disk", "barrel", "cylindrical" or "linear"', ["drawing as SVG", "drawing as PDF", "drawing as DXF"],
     REMOTE),
    ("export writes --csv, --dxf and --picture", ["STEP", "STL", "NC"], REMOTE),
    ("which is not a plane curve", ["DXF"], SPATIAL),
    (r"--plc siemens: \d+ segments, a technology object TO_Cam holds 50", ["siemens"],
     ["valve", "valve in inches", "laws on an elastic train", "given plate", "given guide"]),
    ("the acceleration jumps at", ["codesys", "twincat", "twincat7"], ["given plate", "given guide"]),
    ("the jerk jumps at", ["twincat7"], [kind for kind in KINDS if kind not in SMOOTH]),
    ("found an open one", ["STEP", "STL", "NC"], ["cam for an output on an elastic train"]),
    (r"found a given cam without \[objective\]", ["comparison"], ["given disk in inches"]),
]

# What the program writes that no scene alone asks for, and the test that reads it back.
ELSEWHERE = {
    "machine": "MACHINES", "machine.json": "", "machine.toml": "", "timing.csv": "", "timing.svg": "", "impossible.json": "",
    "document.json": "",
    "list": "tests/documents",
    "table": "tests/report/paper_report_test.cpp", "table.json": "",
    "studio": "tests/browser/studio_page_test.py", "camopt.html": "tests/apps/studio_offline_test.py",
    "surface.csv": "tests/apps/sweep_test.cpp", "surface.html": "", "surface.json": "", "surface.obj": "", "surface.svg": "",
    "pareto.csv": "tests/studies/pareto/pareto_front_test.cpp", "pareto.html": "", "pareto.json": "", "pareto.svg": "",
    "cam.csv": "tests/report/spatial", "cam.dxf": "tests/report/drawing",
}


def refusal(output, kind):
    """Words of the reason, a regular expression; empty where the pair is written."""
    for words, outputs, kinds in REFUSED:
        if output in outputs and kind in kinds:
            return words
    return ""
