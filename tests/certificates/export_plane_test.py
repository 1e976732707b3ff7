# SPDX-License-Identifier: MIT
"""scripts/export_checker on drawings and programs of plane cams: export_plane_test.py CAMOPT [--quick] [TEST ...].

--quick: of one scene.

Bounds are compared with samples in doubles (plane_samples.py). Bounds of spoiled files must be far larger, at the spoiled
line.
"""
import importlib
import json
import math
import re
import subprocess
import sys
import tempfile
import tomllib
import unittest
from pathlib import Path

import checker
from plane_samples import (SAMPLES, Sampled, SampledGuide, SampledPlate, SampledTappet, arcs_of, contour, finish_of, largest_distance, outline_of,
                           to_arc)

SCENES = ("cam_roller", "cam_flat", "cam_arm_roller")[:1 if "--quick" in sys.argv else None]
TWO_SIDED = "cam_grooved", "cam_conjugate"
LINKED = ("guide", "tappet_rise", "tappet")[:2 if "--quick" in sys.argv else None]
PLATES = ("linear_press", "linear_arm", "linear_knife")[:1 if "--quick" in sys.argv else None]
SAMPLING = 1e-7    # mm: what the sampled profile may be wrong by
POLYLINE = 4e-5    # mm: what chords between samples of the profile may be wrong by
CAMOPT = sys.argv.pop(1) if __name__ == "__main__" and len(sys.argv) > 1 else None
if "--quick" in sys.argv:
    sys.argv.remove("--quick")


class Exported:
    """The files of scenes, made when they are first asked for."""

    def __init__(self, make, names):
        self.make, self.names, self.found = make, names, {}

    def __getitem__(self, name):
        if name not in self.found:
            self.found[name] = self.make(name)
        return self.found[name]

    def items(self):
        return ((name, self[name]) for name in self.names)


def linked_scene(name):
    """Without limits, which take time and have no part in the drawing."""
    text = (checker.ROOT / "scenes" / ("inverse_feeder.toml" if name == "guide" else "tappet_90.toml")).read_text().split("[limits]")[0]
    if name != "tappet_rise":
        return text
    return re.sub(r'"program"(.*?)segments = \[.*?\n\]', r'"DRD"\1rise_deg = 90', text, flags=re.DOTALL)


class ExportOfPlaneCams(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        checker.load()
        cls.dxf, cls.nc = (importlib.import_module("export_checker." + name) for name in ("dxf", "nc"))
        exact = importlib.import_module("certificate_checker.exact")
        cls.refusals, cls.gaps = exact.Refuted, exact.Unverified
        cls.place = tempfile.TemporaryDirectory()
        cls.cases, cls.two_sided = Exported(cls.exported, SCENES), Exported(cls.exported, TWO_SIDED)
        cls.linked = Exported(lambda name: cls.exported(name, linked_scene(name), ["--dxf"]), LINKED)

    @classmethod
    def tearDownClass(cls):
        cls.place.cleanup()

    @classmethod
    def exported(cls, name, scene=None, asked=("--dxf", "--nc")):
        """(scene, result, drawing, program if asked for)."""
        folder = Path(cls.place.name) / name
        checker.solve(CAMOPT, scene or checker.ROOT / "scenes" / (name + ".toml"), folder)
        subprocess.run([CAMOPT, "export", str(folder), "--out", str(folder / "files"), *asked], check=True, capture_output=True, timeout=300)
        scene, result = tomllib.loads((folder / "scene.toml").read_text()), json.loads((folder / "result.json").read_text())
        files = [folder / "files" / file for file in ("profile.dxf", "cam.nc")]
        return scene, result, *(file.read_text() for file in files[:len(asked)])

    def assert_close_above(self, bound, sampled, error):
        self.assertGreaterEqual(bound, sampled - error)
        self.assertLessEqual(bound, 2 * sampled)

    def test_claims_beside_the_files(self):
        """The script confirms what camopt wrote, all of a folder, and refuses a claim that is too good; it refutes no file without claims."""
        files = Path(self.place.name) / SCENES[0] / "files"
        self.assertTrue(self.cases[SCENES[0]])

        def outcome(file, scene):
            run = subprocess.run([sys.executable, checker.ROOT / "scripts/verify-export", file, scene], capture_output=True, text=True,
                                 timeout=200, check=False)
            self.assertEqual("", run.stderr)
            return run.returncode, run.stdout

        code, text = outcome(files, files.parent)
        self.assertEqual((0, ["cam.nc:", "profile.dxf:"], 2), (code, re.findall(r"^\S+:$", text, re.M), text.count("\nCONFIRMED")), text)
        for name, stem in (("profile.dxf", "profile"), ("cam.nc", "cam")):
            with self.subTest(name):
                path = files / (stem + ".check.json")
                claims = json.loads(path.read_text())
                path.write_text(json.dumps(claims | {"departure": {"profile_mm": 1e-4}}))
                code, text = outcome(files / name, files.parent / "scene.toml")
                path.write_text(json.dumps(claims))
                self.assertEqual(1, code, text)
                self.assertIn("line ", text.splitlines()[-1])
        for file, words in ((files / "cam.step", "has the claims of cam.nc"), (files / "drawing.pdf", "is not beside it"),
                            (files.parent, "found no NAME.check.json")):
            with self.subTest(file):
                code, text = outcome(file, files.parent)
                self.assertEqual(2, code, text)
                self.assertIn(words, text)

    def test_stock_that_is_left(self):
        """The finishing pass is judged by the surface that leaves what the program says, every move by the cam."""
        for name in (SCENES[0], TWO_SIDED[0], PLATES[0])[:1 if len(SCENES) == 1 else None]:
            with self.subTest(name):
                folder = Path(self.place.name) / (name + " with stock")
                checker.solve(CAMOPT, checker.ROOT / "scenes" / (name + ".toml"), folder)
                cutter = ["--cutter-mm", "12"] if name == "cam_grooved" else []  # which runs along either flank
                subprocess.run([CAMOPT, "export", folder, "--out", folder / "files", "--nc", "--stock-mm", "0.2", *cutter], check=True,
                               capture_output=True, timeout=300)
                scene, result = tomllib.loads((folder / "scene.toml").read_text()), json.loads((folder / "result.json").read_text())
                program = (folder / "files" / "cam.nc").read_text()
                found = self.nc.verify(program, scene, result)
                self.assertEqual(([], [], "0.2 mm left as stock"), (found.faults, found.unverified, found.stated))
                self.assertLess(found.bounds["profile_mm"], 0.01)
                self.assertLessEqual(found.bounds["gouge_mm"], 0.0)
                told = next(line for line in program.splitlines() if "stock: 0.2" in line)
                self.assertGreater(self.nc.verify(program.replace(told, ""), scene, result).bounds["profile_mm"], 0.19)

    def test_drawings(self):
        for name, (scene, result, drawing, _) in self.cases.items():
            with self.subTest(name):
                found = self.dxf.verify(drawing, scene, result)
                self.assertEqual(([], []), (found.faults, found.unverified))
                sampled = largest_distance(Sampled(scene, result).curve(0), arcs_of(outline_of(drawing)))
                self.assert_close_above(found.bounds["profile_mm"], sampled, SAMPLING)

    def test_cusps(self):
        """Where the outline of an undercut cam turns back, its branches lie within the tolerance of each other."""
        text = (checker.ROOT / "tests/cases/undercut_lobe.toml").read_text()
        scene, result, drawing = self.exported("undercut_lobe", text, ["--dxf"])
        found = self.dxf.verify(drawing, scene, result)
        self.assertEqual(([], []), (found.faults, found.unverified))
        self.assertLess(found.bounds["profile_mm"], 1.1e-3)

    def test_programs(self):
        for name, (scene, result, _, program) in self.cases.items():
            with self.subTest(name):
                found = self.nc.verify(program, scene, result)
                self.assertEqual(([], []), (found.faults, found.unverified))
                cam, radius = Sampled(scene, result), 8.0
                path = contour(program)
                self.assert_close_above(found.bounds["profile_mm"], largest_distance(cam.curve(radius), path), SAMPLING)
                profile = cam.curve(0)
                edges = [(a, b, 0) for a, b in zip(profile, profile[1:] + profile[:1])]
                starts = [own[0] for own in edges]
                deepest = 0.0
                for a, b, bulge in path[::4]:
                    if bulge:
                        continue
                    point = (a[0] + b[0]) / 2, (a[1] + b[1]) / 2
                    i = min(range(SAMPLES), key=lambda k: (starts[k][0] - point[0])**2 + (starts[k][1] - point[1])**2)
                    deepest = max(deepest, radius - min(to_arc(point, *edges[k % SAMPLES]) for k in (i - 1, i)))
                self.assert_close_above(found.bounds["gouge_mm"], deepest, POLYLINE)

    def post_processed(self, post, *asked):
        """The program of the first scene by a post-processor."""
        folder = Path(self.place.name) / SCENES[0]
        (folder / "post.toml").write_text(post)
        subprocess.run([CAMOPT, "export", folder, "--out", folder / "post", "--nc", "--post", folder / "post.toml", *asked], check=True,
                       capture_output=True, timeout=100)
        return (folder / "post" / "cam.nc").read_text()

    def test_compensation(self):
        scene, result, _, _ = self.cases[SCENES[0]]
        program, radius = self.post_processed("", "--compensation", "control"), 8.0
        found = self.nc.verify(program, scene, result)
        self.assertEqual(([], []), (found.faults, found.unverified))
        curve = Sampled(scene, result).curve(radius)
        beside = [((a[0] + b[0]) / 2 - radius * (b[1] - a[1]) / math.dist(a, b), (a[1] + b[1]) / 2 + radius * (b[0] - a[0]) / math.dist(a, b))
                  for a, b, bulge in contour(program) if not bulge]
        chords = [(a, b, 0) for a, b in zip(curve, curve[1:] + curve[:1])]
        self.assert_close_above(found.bounds["profile_mm"], largest_distance(beside, chords), POLYLINE)
        self.assertGreater(self.nc.verify(program.replace("G41", "G42"), scene, result).bounds["gouge_mm"], 10)
        for before, after, kind, why in (("G41 D1", "G41 D2", self.gaps, "register"), ("of 8 mm", "of 7 mm", self.gaps, "register"),
                                         ("G40 G1", "G1", self.refusals, "no G40"),
                                         ("G41 D1", "G41", self.refusals, "register"), ("G41 D1 G1", "G41 D1 G0", self.gaps, "rapid")):
            with self.subTest(after), self.assertRaisesRegex(kind, "line [0-9]+: .*" + why):
                self.nc.verify(program.replace(before, after), scene, result)
        moves, lines = finish_of(program), program.split("\n")
        line, x, y, _ = next(move for move in moves[len(moves) // 3:] if f"X{move[1]:.4f} Y{move[2]:.4f}" in lines[move[0] - 1] and not move[3])
        size = math.hypot(x, y)
        lines[line - 1] = f"G1 X{x * (1 - 0.005 / size):.4f} Y{y * (1 - 0.005 / size):.4f}"
        found = self.nc.verify("\n".join(lines), scene, result)
        for bound in "profile_mm", "gouge_mm":
            self.assertGreater(found.bounds[bound], 0.004)
            self.assertRegex(found.places[bound], rf"^line ({line}|{line + 1}|{line + 2}),")
        lines[line - 1] = f"G1 X{x * (1 - 0.05 / size):.4f} Y{y * (1 - 0.05 / size):.4f}"
        with self.assertRaisesRegex(self.refusals, rf"line ({line}|{line + 1}): the cutter does not fit"):
            self.nc.verify("\n".join(lines), scene, result)

    def test_inner_corners(self):
        """Where the offsets of lines and arcs meet, both are at the cutter's radius."""
        compensation, moves = (importlib.import_module("export_checker." + name) for name in ("compensation", "moves"))
        line, turned = moves.Move(1, 1, (-9, 0, 0), (0, 0, 0)), moves.Move(2, 1, (0, 0, 0), (8, 3, 0))
        for center in ((1, 30), (4, 30), (-12, -30)):
            kind = 3 if center[1] > 0 else 2
            arc = moves.Move(2, kind, (0, 0, 0), (2 * center[0], 0, 0), center)
            for own in (arc, turned):
                elements = [compensation.Element(move, 2.0) for move in (line, own)]
                met, again, turn = compensation.joint(*elements)
                if turn:
                    continue
                self.assertEqual(met, again)
                self.assertAlmostEqual(2, met[1], 12)
                apart = abs(math.dist(met, center) - math.hypot(*center)) if own is arc else abs(8 * met[1] - 3 * met[0]) / math.hypot(8, 3)
                self.assertAlmostEqual(2, apart, 12)

    def test_post_processors(self):
        """Inches with block numbers, other comments; axes that are not the stated ones, or not stated."""
        scene, result, _, _ = self.cases[SCENES[0]]
        inch = self.post_processed('unit = "inch"\nlinear_decimals = 5\nfirst_block = 10\nblock_step = 10\n'
                                   'header = ["%", "O1001 ({title})", "G17 G40 G49 G80", "G54"]\n')
        found = self.nc.verify(inch, scene, result)
        self.assertEqual(([], []), (found.faults, found.unverified))
        path = [((25.4 * a[0], 25.4 * a[1]), (25.4 * b[0], 25.4 * b[1]), bulge) for a, b, bulge in contour(inch)]
        self.assert_close_above(found.bounds["profile_mm"], largest_distance(Sampled(scene, result).curve(8.0), path), SAMPLING)
        found = self.nc.verify(self.post_processed((checker.ROOT / "docs/posts/rotary_table_mm.toml").read_text()), scene, result)
        self.assertEqual(([], []), (found.faults, found.unverified))
        self.assertLess(found.bounds["profile_mm"], 0.0016)
        self.assertGreater(self.nc.verify(inch.replace("(X = x in", "(X = -x in"), scene, result).bounds["profile_mm"], 1)
        for stated in ("(X = x", "(T = x"), ("(X = x in inch", "(X = x in deg"), (", Z = z in inch", ""), ("Y = y", "X = y"):
            with self.subTest(stated), self.assertRaisesRegex(self.gaps, "ax[ie]s"):
                self.nc.verify(inch.replace(*stated), scene, result)
        with self.assertRaisesRegex(self.refusals, "line [0-9]+: G55 changes the origin"):
            self.nc.verify(inch.replace(" G1 ", " G55 G1 ", 1), scene, result)
        spoiled = self.nc.verify(inch.replace("G20 G17", "G21 G17"), scene, result)
        self.assertGreater(spoiled.bounds["profile_mm"], 10)

    def test_other_axes(self):
        """Mirrored programs exchange G2 and G3, and G41 and G42; other letters, signs and origins."""
        scene, result, _, _ = self.cases[SCENES[0]]
        post = '[axes.x]\nsign = -1\noffset_mm = 12.5\n[axes.y]\noffset_mm = -7\n[axes.z]\nletter = "W"\nsign = -1\noffset_mm = 100.25\n'
        for asked in (), ("--compensation", "control"):
            program = self.post_processed(post, *asked)
            self.assertIn("X = -x + 12.5 in mm, Y = y - 7 in mm, W = -z + 100.25 in mm", program)
            with self.subTest(asked):
                found = self.nc.verify(program, scene, result)
                self.assertEqual(([], []), (found.faults, found.unverified))
                self.assertLess(found.bounds["profile_mm"], 0.0011)
                self.assertLess(found.bounds["gouge_mm"], 0.0011)
                wrong = self.nc.verify(program.replace("Y = y - 7", "Y = y - 7.01"), scene, result)
                self.assertGreater(wrong.bounds["profile_mm"], 0.009)
        exchanged = program.replace("G41", "G40x").replace("G42", "G41").replace("G40x", "G42")
        self.assertGreater(self.nc.verify(exchanged, scene, result).bounds["gouge_mm"], 10)
        with self.assertRaisesRegex(self.gaps, "line [0-9]+: an arc or cutter compensation"):
            self.nc.verify(program.replace("X = -x", "U = -x").replace(" X", " U"), scene, result)

    def test_moved_vertex(self):
        for name, (scene, result, drawing, _) in self.cases.items():
            with self.subTest(name):
                corners, lines = outline_of(drawing), drawing.split("\n")
                line, x, y, _ = corners[len(corners) // 3]
                size = math.hypot(x, y)
                lines[line - 1], lines[line + 1] = str(x * (1 + 0.01 / size)), str(y * (1 + 0.01 / size))
                found = self.dxf.verify("\n".join(lines), scene, result)
                self.assertGreater(found.bounds["profile_mm"], 0.008)
                self.assertIn(f"line {line},", found.places["profile_mm"])

    def test_two_sided(self):
        """Both flanks of a groove, both disks of a conjugate cam; then a vertex of the second one is moved."""
        for name, (scene, result, drawing, _) in self.two_sided.items():
            groove = scene["cam"].get("groove_clearance_mm")
            outlines = [("INNER_FLANK", False, -groove / 2), ("OUTER_FLANK", False, 2 * scene["cam"]["roller_radius_mm"] + groove / 2)] \
                if groove else [("CAM", False, 0), ("SECOND_CAM", True, 0)]
            with self.subTest(name):
                found = self.dxf.verify(drawing, scene, result)
                sampled = max(largest_distance(Sampled(scene, result, second).curve(offset), arcs_of(outline_of(drawing, layer)))
                              for layer, second, offset in outlines)
                self.assert_close_above(found.bounds["profile_mm"], sampled, SAMPLING)
                line, x, _, _ = outline_of(drawing, outlines[1][0])[20]
                lines = drawing.split("\n")
                lines[line - 1] = str(x + 0.02)
                self.assertGreater(self.dxf.verify("\n".join(lines), scene, result).bounds["profile_mm"], 0.002)

    def outlines_of_linked(self, name, drawing):
        """[(distance from the path that is sampled, corners)]."""
        radius = 12.7 if name == "guide" else 0
        layers = [("WALLS", 0, radius), ("WALLS", 1, -radius)] if name == "guide" else [("CAM", 0, 0)]
        return [(offset, outline_of(drawing, layer, which)) for layer, which, offset in layers]

    def test_linkages(self):
        """Cams of linkages, closed and open, and both walls of a guide; then vertices are moved."""
        for name, (scene, result, drawing) in self.linked.items():
            cam = (SampledGuide if name == "guide" else SampledTappet)(scene, result)
            with self.subTest(name):
                found, outlines = self.dxf.verify(drawing, scene, result), self.outlines_of_linked(name, drawing)
                self.assertEqual(([], []), (found.faults, found.unverified))
                sampled = max(largest_distance(cam.curve(offset), arcs_of(corners)[:None if name == "tappet" else -1])
                              for offset, corners in outlines)
                self.assert_close_above(found.bounds["profile_mm"], sampled, SAMPLING)
                corners = outlines[-1][1]
                for line, x, y, _ in (corners[0], corners[-1], corners[20])[0 if name == "guide" else 1:][:2]:
                    lines = drawing.split("\n")
                    lines[line - 1], lines[line + 1] = str(x + 0.008), str(y + 0.008)
                    spoiled = self.dxf.verify("\n".join(lines), scene, result)
                    self.assertGreater(spoiled.bounds["profile_mm"], 0.004)
                    self.assertIn(f"line {line},", spoiled.places["profile_mm"])

    def test_programs_of_plates(self):
        """As they are; then a block of the finishing pass is moved into the plate, a rapid lowered, a clamp raised."""
        for name in PLATES:
            with self.subTest(name):
                scene, result, _, program = self.exported(name + "_program", checker.ROOT / "scenes" / (name + ".toml"))
                found = self.nc.verify(program, scene, result)
                self.assertEqual(([], []), (found.faults, found.unverified))
                self.assertLess(found.bounds["profile_mm"], 1.5e-3)
                self.assertLess(found.bounds["gouge_mm"], 1.5e-3)
                lines = program.splitlines()
                finish = next(i for i, line in enumerate(lines) if "pass: along the surface" in line)
                middle = next(i for i, line in enumerate(lines) if i > finish + 60 and " Y" in line)
                spoiled = list(lines)
                spoiled[middle] = re.sub(r"Y(\d+\.\d+)", lambda own: f"Y{float(own[1]) - 0.1:.4f}", lines[middle])
                found = self.nc.verify("\n".join(spoiled), scene, result)
                for bound in ("profile_mm", "gouge_mm"):
                    self.assertAlmostEqual(found.bounds[bound], 0.1, delta=0.03)
                found = self.nc.verify("G0 Z-1.0000\nG0 X".join(program.rsplit("G0 Z20.0000\nG0 X", 1)), scene, result)
                self.assertIn("a rapid through the blank", " ".join(found.faults))
                found = self.nc.verify(re.sub(r"held below y = \d+", "held below y = 60", program), scene, result)
                self.assertIn("enters the room for clamps", " ".join(found.faults))

    def test_plates(self):
        """The surface, closed by sides and bottom; then a vertex of each is moved, and the plate slides the other way."""
        for name in PLATES:
            scene, result, drawing = self.exported(name, None, ["--dxf"])
            with self.subTest(name):
                found = self.dxf.verify(drawing, scene, result)
                self.assertEqual(([], []), (found.faults, found.unverified))
                corners = outline_of(drawing)
                sampled = largest_distance(SampledPlate(scene, result).curve(0), arcs_of(corners[:-2])[:-1])
                self.assert_close_above(found.bounds["profile_mm"], sampled, SAMPLING)
                for line, x, y, _ in (corners[len(corners) // 3], corners[-1]):
                    lines = drawing.split("\n")
                    lines[line - 1], lines[line + 1] = str(x + 0.01), str(y + 0.01)
                    if line == corners[-1][0]:
                        with self.assertRaisesRegex(self.refusals, "not closed by the sides and the bottom"):
                            self.dxf.verify("\n".join(lines), scene, result)
                        continue
                    found = self.dxf.verify("\n".join(lines), scene, result)
                    self.assertGreater(found.bounds["profile_mm"], 0.003)
                    self.assertIn(f"line {line},", found.places["profile_mm"])
                other = scene | {"cam": scene["cam"] | {"travel_mm": -scene["cam"]["travel_mm"]}}
                self.assertGreater(self.dxf.verify(drawing, other, result).bounds["profile_mm"], 1)

    def test_other_linkages(self):
        """Another linkage; an outline that is missing, closed or on the other side."""
        scene, result, drawing = self.linked["guide"]
        first, pitch, second = (part.start() for part in re.finditer("LWPOLYLINE", drawing))  # the pitch curve between the walls
        end = drawing.index("\n  0\n", second) + len("\n  0\n")
        for spoiled in (drawing[:first] + drawing[pitch:], drawing.replace("\n 70\n0\n", "\n 70\n1\n")):
            with self.subTest(len(spoiled)), self.assertRaises(self.refusals):
                self.dxf.verify(spoiled, scene, result)
        swapped = drawing[:first] + drawing[second:end] + drawing[pitch:second] + drawing[first:pitch] + drawing[end:]
        self.assertGreater(self.dxf.verify(swapped, scene, result).bounds["profile_mm"], 20)
        for name, table, key in (("guide", "cam", "feeder_offset_in"), ("tappet_rise", "linkage", "coupler_mm")):
            scene, result, drawing = self.linked[name]
            other = scene | {table: scene[table] | {key: scene[table].get(key, 0) + 0.02}}
            with self.subTest(key):
                self.assertGreater(self.dxf.verify(drawing, other, result).bounds["profile_mm"], 0.003)

    def test_groove(self):
        scene, result, _, program = self.two_sided["cam_grooved"]
        found = self.nc.verify(program, scene, result)
        self.assertEqual(([], []), (found.faults, found.unverified))
        self.assertLess(found.bounds["profile_mm"], 0.0011)  # the chord tolerance and printed digits
        self.assertLess(found.bounds["gouge_mm"], 0.0011)
        lines = program.split("\n")
        line, x, y, _ = finish_of(program)[-60]
        size = math.hypot(x, y)
        lines[line - 1] = f"G1 X{x * (1 + 0.05 / size):.4f} Y{y * (1 + 0.05 / size):.4f}"  # into the outer flank
        found = self.nc.verify("\n".join(lines), scene, result)
        self.assertGreater(found.bounds["gouge_mm"], 0.03)
        self.assertRegex(found.places["gouge_mm"], rf"^line ({line}|{line + 1}),")

    def test_moved_block(self):
        for name in SCENES[::2]:
            scene, result, _, program = self.cases[name]
            with self.subTest(name):
                moves, lines = finish_of(program), program.split("\n")
                k = next(k for k in range(len(moves) // 3, len(moves)) if moves[k][3] is None and moves[k + 1][3] is None)
                line, x, y, _ = moves[k]
                size = math.hypot(x, y)
                lines[line - 1] = f"G1 X{x * (1 - 0.05 / size):.4f} Y{y * (1 - 0.05 / size):.4f} F300."
                if "Y" not in lines[line] or "X" not in lines[line]:  # modal: the next block states both axes
                    lines[line] = f"G1 X{moves[k + 1][1]:.4f} Y{moves[k + 1][2]:.4f} F300."
                found = self.nc.verify("\n".join(lines), scene, result)
                for bound in "profile_mm", "gouge_mm":
                    self.assertGreater(found.bounds[bound], 0.035)
                    self.assertRegex(found.places[bound], rf"^line ({line}|{line + 1}),")

    def test_lowered_rapid(self):
        scene, result, _, program = self.cases["cam_roller"]
        lines = program.split("\n")
        k = [k for k, line in enumerate(lines) if line.startswith("G0 X")][1]
        lines[k] = "G0 X0 Y0 Z-3"
        found = self.nc.verify("\n".join(lines), scene, result)
        self.assertIn(f"line {k + 1}: a rapid through the blank", found.faults)
        lines = program.split("\n")
        lines[k] = "G0 X-70.0 Y-12.0"  # across the cam
        lines[k - 1] = "G0 Z-1.0"
        found = self.nc.verify("\n".join(lines), scene, result)
        self.assertGreater(found.bounds["gouge_mm"], 8)
        self.assertIn(f"line {k + 1}", found.places["gouge_mm"])
        self.assertIn(f"line {k + 1}: a rapid through the blank", found.faults)

    def test_clamps_and_circles(self):
        scene, result, drawing, program = self.cases[SCENES[0]]
        lines = program.split("\n")
        k = next(k for k, line in enumerate(lines) if line.startswith("G0 X"))
        for height, faults in (("17.9", [f"line {k + 3}: enters the room for clamps"]), ("18.1", [])):
            spoiled = [*lines[:k + 1], f"G0 Z{height}", "G0 X0 Y0", "G0 Z20", *lines[k:]]
            found = [fault for fault in self.nc.verify("\n".join(spoiled), scene, result).faults if fault.startswith(f"line {k + 3}:")]
            self.assertEqual(faults, found)
        for layer, radius in (("BASE_CIRCLE", scene["cam"]["base_radius_mm"]), ("PRIME_CIRCLE", None)):
            place = drawing.rindex(layer)
            spoiled = drawing[:place] + re.sub(r"\n 40\n[\d.]+", f"\n 40\n{radius or 1.0:.3f}1", drawing[place:], count=1)
            found = self.dxf.verify(spoiled, scene, result).faults
            self.assertEqual(1, len(found))
            self.assertRegex(found[0], f"line [0-9]+: not the {layer}")

    def test_rim(self):
        scene, result, drawing, _ = self.two_sided["cam_grooved"]
        place = drawing.rindex("RIM")
        radius = float(re.search(r"\n 40\n([\d.]+)", drawing[place:])[1])
        self.assertEqual([], self.dxf.verify(drawing, scene, result).faults)
        spoiled = drawing[:place] + drawing[place:].replace(f"\n 40\n{radius}", f"\n 40\n{radius + 0.002}", 1)
        found = self.dxf.verify(spoiled, scene, result).faults
        self.assertEqual(1, len(found))
        self.assertRegex(found[0], "line [0-9]+: not the RIM")

    def test_another_cam(self):
        scene, result, drawing, program = self.cases["cam_flat"]
        scene = scene | {"cam": scene["cam"] | {"base_radius_mm": scene["cam"]["base_radius_mm"] + 0.02}}
        self.assertGreater(self.dxf.verify(drawing, scene, result).bounds["profile_mm"], 0.0199)
        found = self.nc.verify(program, scene, result)
        self.assertGreater(found.bounds["gouge_mm"], 0.0199)

    def test_unknown_words(self):
        scene, result, drawing, program = self.cases["cam_flat"]
        for word, more in (("G43", "G90 G43"), ("Q1", "G90 Q1")):
            with self.subTest(word), self.assertRaisesRegex(self.refusals, "line [0-9]+: .*is not known"):
                self.nc.verify(program.replace("G90", more, 1), scene, result)
        outline = drawing.index("LWPOLYLINE")
        for before, after in (("\n 70\n1\n", "\n 70\n0\n"), ("\n 43\n0.0\n", "\n 38\n1.0\n"), ("\n 43\n0.0\n", "\n 43\n0.5\n")):
            spoiled = drawing[:outline] + drawing[outline:].replace(before, after, 1)
            with self.subTest(after), self.assertRaisesRegex(self.refusals, "line [0-9]+"):
                self.assertNotEqual(spoiled, drawing)
                self.dxf.verify(spoiled, scene, result)
        line = "  0\nLINE\n  5\nFFF\n  8\nCAM\n 10\n0.0\n 20\n0.0\n 11\n1.0\n 21\n0.0\n"
        spoiled = drawing.replace("  0\nLWPOLYLINE\n", line + "  0\nLWPOLYLINE\n", 1)
        with self.assertRaisesRegex(self.refusals, "line [0-9]+"):
            self.dxf.verify(spoiled, scene, result)


if __name__ == "__main__":
    unittest.main(argv=sys.argv)
