# SPDX-License-Identifier: MIT
"""scripts/export_checker on programs of three-dimensional cams: export_spatial_test.py CAMOPT [--quick] [TEST ...].

--quick: of fewer cams.

Bounds are compared with samples in doubles (spatial_samples.py). Programs with one spoiled block must be refuted at its line.
"""
import importlib
import json
import math
import subprocess
import sys
import tempfile
import tomllib
import unittest
from pathlib import Path

import checker
from spatial_samples import SampledRoller, last_passes, last_turn, positions

QUICK = "--quick" in sys.argv
CAMOPT = sys.argv.pop(1) if __name__ == "__main__" and len(sys.argv) > 1 else None
if QUICK:
    sys.argv.remove("--quick")
SAMPLING = 1e-7  # mm
OTHER_AXES = """name = "other axes"
linear_decimals = 5
[axes.x]
sign = -1
offset_mm = 12.5
letter = "U"
[axes.z]
offset_mm = -300
[axes.rotary]
letter = "W"
sign = -1
offset_deg = 90
"""
# Name: (the example, what is replaced in it, options of the export, letters of the axes).
CAMS = {
    "slide": ("cylinder_slide", [], ["--full-depth"], "XYZA"),
    "indexing": ("ocrf_indexing", [], ["--full-depth"], "XYZCB"),
    "slide_smaller": ("cylinder_slide", [('type = "DRD"', 'type = "RR"\nreturn_deg = 140'), ("mm = 60", 'mm = 60\nrotation = "clockwise"')],
                      ["--cutter-mm", "12"], "XYZA"),
    "barrel": ("barrel_paper_cup", [('type = "barrel"', 'type = "barrel"\nrotation = "clockwise"\naxial_offset_mm = 11')], [], "XYZA"),
    "barrel_smaller": ("barrel_paper_cup", [], ["--cutter-mm", "40", "--rough-step-down-mm", "20"], "XYZA"),
    "indexing_smaller": ("ocrf_indexing", [('rotation = "clockwise"', "axial_offset_mm = -3\nstart_angle_deg = -20")],
                         ["--cutter-mm", "10", "--rough-step-down-mm", "12"], "XYZCB"),
    "lever": ("ocrf_indexing", [('type = "DRD"', 'type = "RR"\nreturn_deg = 120'), ("lift_deg = 45", "lift_deg = 30")], ["--full-depth"], "XYZCB"),
}
NAMES = list(CAMS)[:3 if QUICK else None]


class ExportOfSpatialCams(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        checker.load()
        cls.nc = importlib.import_module("export_checker.nc")
        exact = importlib.import_module("certificate_checker.exact")
        cls.refusals, cls.gaps = exact.Refuted, exact.Unverified
        cls.place, cls.cases = tempfile.TemporaryDirectory(), {}

    @classmethod
    def tearDownClass(cls):
        cls.place.cleanup()

    def folder(self, name):
        """Solved without limits, which take time and have no part in the program."""
        folder = Path(self.place.name) / name
        if not folder.exists():
            example, replaced, _, _ = CAMS[name]
            text = (checker.ROOT / "scenes" / (example + ".toml")).read_text().split("[limits]")[0]
            for before, after in replaced:
                self.assertIn(before, text)
                text = text.replace(before, after)
            checker.solve(CAMOPT, text, folder, ["spline.segments=8"])
        return folder

    def exported(self, folder, asked, to="files"):
        """(scene, result, program)."""
        subprocess.run([CAMOPT, "export", folder, "--out", folder / to, "--nc", *asked], check=True, capture_output=True, timeout=300)
        return tomllib.loads((folder / "scene.toml").read_text()), json.loads((folder / "result.json").read_text()), \
            (folder / to / "cam.nc").read_text()

    def case(self, name):
        if name not in self.cases:
            self.cases[name] = self.exported(self.folder(name), CAMS[name][2])
        return self.cases[name]

    def assert_confirmed(self, outcome):
        self.assertEqual(([], []), (outcome.faults, outcome.unverified))
        self.assertLess(outcome.bounds["path_mm"], 0.0013)
        self.assertLess(outcome.bounds["gouge_mm"], 0.0112)

    def test_bounds(self):
        """No bound is below the largest sample, and that of the path is not far above."""
        for name in NAMES:
            scene, result, program = self.case(name)
            with self.subTest(name):
                outcome, cam = self.nc.verify(program, scene, result), SampledRoller(scene, result)
                self.assert_confirmed(outcome)
                moves = positions(program, CAMS[name][3])
                radius, is_slot = self.radius_of(program), not name.endswith("smaller")
                most = 0.0
                for moved in last_passes(moves, 1 if is_slot else 2):
                    run = [values for _, _, values in last_turn(moved)]
                    fits = ((cam.off_path(run[len(run) // 2:len(run) // 2 + 2], turns, offset), turns, offset)
                            for turns in range(-40, 41) for offset in ((0,) if is_slot else (cam.roller - radius, radius - cam.roller)))
                    _, turns, offset = min(fits)
                    if not is_slot and abs(cam.pitch) < 1e-9:  # without the leads of a closed groove
                        closest = min(range(len(run)), key=lambda k: abs(math.remainder(cam.theta(run[k]), 2 * math.pi)) + (k > len(run) / 2))
                        run = run[closest:]
                        run = [v for v in run if abs(v[3] - run[0][3]) < 360 + 1e-6]
                    most = max(most, cam.off_path(run, turns, offset))
                    depth = max(cam.depth([(a + b) / 2 for a, b in zip(*own)], turns, radius) for own in zip(run, run[1:]))
                    self.assertGreaterEqual(outcome.bounds["gouge_mm"], depth - SAMPLING)
                self.assertGreaterEqual(outcome.bounds["path_mm"], most - SAMPLING)
                self.assertLess(outcome.bounds["path_mm"], 1.1 * most)

    @staticmethod
    def radius_of(program):
        return float(program.split("diameter ")[1].split()[0]) / 2

    def spoiled(self, name, letter, by, count=1):
        """(line, outcome) of the program with a number in the middle of its last passes changed."""
        scene, result, program = self.case(name)
        lines, passes = program.split("\n"), last_passes(positions(program, CAMS[name][3]), count)
        run = last_turn(passes[0])
        for number, _, _ in run[len(run) // 5:]:  # not in a dwell
            words = lines[number - 1].split()
            k = next((k for k, word in enumerate(words) if word[0] == letter), None)
            following = any(word[0] == letter for word in lines[number].split())
            if k is not None and following:
                words[k] = f"{letter}{float(words[k][1:]) + by:.5f}"
                lines[number - 1] = " ".join(words)
                return number, self.nc.verify("\n".join(lines), scene, result)
        self.fail(f"no block with {letter}")

    def test_moved_blocks(self):
        """By 0.05 mm or 0.05 degrees of the table or its tilt."""
        for name in NAMES:
            for letter in set(CAMS[name][3]) - {"Z"} - ({"Y"} if name == "slide" or CAMS[name][0].startswith("ocrf") else set()):
                with self.subTest(name, letter=letter):
                    line, outcome = self.spoiled(name, letter, 0.05, 2 if name.endswith("smaller") else 1)
                    self.assertGreater(outcome.bounds["path_mm"], 0.008)
                    self.assertRegex(outcome.places["path_mm"], rf"^line ({line}|{line + 1}),")
                    if not name.endswith("smaller"):
                        self.assertRegex(outcome.places["gouge_mm"], rf"^line ({line}|{line + 1}),")

    def changed(self, name, find, line_of):
        """(line, outcome) with the first line that `find` accepts replaced."""
        scene, result, program = self.case(name)
        lines = program.split("\n")
        k = next(k for k, line in enumerate(lines) if find(line))
        lines[k] = line_of(lines[k])
        return k + 1, self.nc.verify("\n".join(lines), scene, result)

    def test_rapids_and_clamps(self):
        for name in NAMES:
            with self.subTest(name):
                scene, result, program = self.case(name)
                lines = program.split("\n")
                k = [k for k, line in enumerate(lines) if line.startswith("G0 Z")][1]  # down to the blank
                lowered = float(lines[k].split("Z")[1]) - 2.5
                line, outcome = self.changed(name, lambda own: own == lines[k], lambda _: f"G0 Z{lowered:.4f}")
                self.assertIn(f"line {line}: a rapid that may enter the blank", outcome.faults)
                plane = lines[k - 2]
                self.assertTrue(plane.startswith("G0 Z"))
                line, outcome = self.changed(name, lambda own: own == plane, lambda own: f"G0 Z{float(own[4:]) - 25:.4f}")
                self.assertIn(f"line {line + 1}: a rapid that may enter the blank", outcome.faults)
                if len(CAMS[name][3]) == 5:  # above the blank at any tilt, but not above the clamps
                    line, outcome = self.changed(name, lambda own: own == plane, lambda own: f"G0 Z{float(own[4:]) - 3:.4f}")
                    self.assertEqual([f"line {k}: enters the room for clamps" for k in (line, line + 1)], outcome.faults)
                run = last_turn(last_passes(positions(program, CAMS[name][3]), 1)[0])
                line, outcome = self.changed(name, lambda own: own == lines[run[len(run) // 2][0] - 1], lambda _: "G1 Z1")
                self.assertIn(f"line {line}: enters the room for clamps", outcome.faults)
                self.assertGreater(outcome.bounds["gouge_mm"], 1)

    def test_what_is_left_out(self):
        """Blocks of the finishing pass removed, a second pass missing, an arc, an axis that is not stated."""
        for name in NAMES:
            scene, result, program = self.case(name)
            lines, (blocks, *_) = program.split("\n"), last_passes(positions(program, CAMS[name][3]), 1)
            with self.subTest(name):
                cut = [line for k, line in enumerate(lines, 1) if not blocks[len(blocks) // 3][0] < k <= blocks[-2][0]]
                with self.assertRaisesRegex(self.refusals, "the finishing pass, lines [0-9]+ to [0-9]+, does not"):
                    self.nc.verify("\n".join(cut), scene, result)
                bent = int(self.nc.verify(program, scene, result).places["path_mm"].split(",")[0].removeprefix("line "))
                outcome = self.nc.verify("\n".join(lines[:bent - 25] + lines[bent + 25:]), scene, result)
                self.assertGreater(outcome.bounds["path_mm"], 0.1)
                self.assertIn(f"line {bent - 24}, ", outcome.places["path_mm"])
        scene, result, program = self.case("slide")
        for before, after, kind, why in (("G1 ", "G2 I1 ", self.gaps, "line [0-9]+: an arc"), ("A = rotary", "A = turn", self.gaps, "axes"),
                                         ("G1 X", "G1 C5 X", self.refusals, "C is not known"), ("(blank", "(block", self.gaps, "blank")):
            with self.subTest(after), self.assertRaisesRegex(kind, why):
                self.nc.verify(program.replace(before, after), scene, result)
        for stated in "A = rotary + 0.00001 in deg", "A = rotary - 0.00001 in deg":
            with self.subTest(stated), self.assertRaisesRegex(self.gaps, "printed digits"):
                self.nc.verify(program.replace("A = rotary in deg", stated), scene, result)
        with self.assertRaisesRegex(self.gaps, "another machine"):
            self.nc.verify(program, *self.case("indexing")[:2])
        if not QUICK:
            scene, result, program = self.case("slide_smaller")
            outcome = self.nc.verify(program[:program.index("(pass: flank -1")] + "M30\n", scene, result)
            self.assertGreater(outcome.bounds["path_mm"], 0.2)  # what roughing left on the other flank

    def test_stock_that_is_left(self):
        folder = self.folder("slide")
        scene, result, program = self.exported(folder, ["--cutter-mm", "16", "--stock-mm", "0.2", "--full-depth"], "stock")
        outcome = self.nc.verify(program, scene, result)
        self.assertEqual(([], []), (outcome.faults, outcome.unverified))
        self.assertLess(outcome.bounds["path_mm"], 0.02)
        self.assertIn("0.2 mm left as stock", outcome.stated)
        told = next(line for line in program.splitlines() if "stock: 0.2" in line)
        self.assertGreater(self.nc.verify(program.replace(told, ""), scene, result).bounds["path_mm"], 0.19)

    def test_another_cam(self):
        for name, key in (("slide", "axial_offset_mm"), ("indexing", "center_distance_mm"), ("barrel", "lateral_offset_mm"))[:2 if QUICK else None]:
            scene, result, program = self.case(name)
            other = scene | {"cam": scene["cam"] | {key: scene["cam"].get(key, 0) + 0.02}}
            with self.subTest(name):
                self.assertGreater(self.nc.verify(program, other, result).bounds["path_mm"], 0.015)

    def test_post_processors(self):
        """Other letters, signs, origins and units; then one of them stated wrongly."""
        posts = checker.ROOT / "docs" / "posts"
        made = [("slide", OTHER_AXES, ["--full-depth"]), ("indexing", (posts / "table_tilting_inch.toml").read_text(), ["--full-depth", "--z-offset-mm", "120"]),
                ("slide", (posts / "rotary_table_mm.toml").read_text(), ["--full-depth"])]
        for name, post, asked in made:
            folder = self.folder(name)
            (folder / "post.toml").write_text(post)
            scene, result, program = self.exported(folder, [*asked, "--post", folder / "post.toml"], "post")
            with self.subTest(post.split("name = ")[1][:20]):
                outcome = self.nc.verify(program, scene, result)
                self.assertEqual(([], []), (outcome.faults, outcome.unverified))
                self.assertLess(outcome.bounds["path_mm"], json.loads((folder / "post" / "cam.check.json").read_text())["departure"]["path_mm"])
                for before, after in (("-x + 12.5", "x + 12.5"), ("z - 300", "z - 301"), ("offset: 120", "offset: 119")):
                    if before in program:
                        self.assertGreater(self.nc.verify(program.replace(before, after), scene, result).bounds["path_mm"], 0.9)

    def test_script(self):
        """The script confirms what camopt wrote, and refuses a claim that is too good."""
        self.case("slide")
        folder = self.folder("slide")
        command = [sys.executable, checker.ROOT / "scripts/verify-export", folder / "files" / "cam.nc", folder / "scene.toml"]
        run = subprocess.run(command, capture_output=True, text=True, timeout=100, check=False)
        self.assertEqual((0, "CONFIRMED"), (run.returncode, run.stdout.splitlines()[-1]), run.stdout + run.stderr)
        self.assertIn("set up as stated: cutter of diameter 20 mm, blank", run.stdout)
        path = folder / "files" / "cam.check.json"
        claims = json.loads(path.read_text())
        path.write_text(json.dumps(claims | {"departure": claims["departure"] | {"path_mm": 9e-4}}))
        run = subprocess.run(command, capture_output=True, text=True, timeout=100, check=False)
        self.assertEqual(1, run.returncode, run.stdout)
        self.assertRegex(run.stdout.splitlines()[-1], r"REFUTED: line [0-9]+, .*: path_mm is .*, 0.0009 is claimed")


if __name__ == "__main__":
    unittest.main()
