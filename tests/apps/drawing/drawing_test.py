#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""drawing_test.py CAMOPT SCENES FOLDER [--pdf] [--volume STEP_VOLUME]

Workshop drawings and solids of disk cams, by the program, against figures taken from profile.csv and the scene alone:
DXF opened by ezdxf without an audit error, every dimension as it measures it; the table of radii; the volume of STL
and, read by STEP_VOLUME, of STEP; what is refused. --pdf: this build has cairo.

Without ezdxf (Debian: python3-ezdxf) the DXF is not read, and a line says so.
"""

import argparse
import csv
import math
import pathlib
import re
import subprocess
import xml.etree.ElementTree

from solids import mesh_volume

DRAWING = """
[drawing]
bore_mm = {bore}
keyway = {{ width_mm = 6, depth_mm = 2.8, at_deg = {at} }}
thickness_mm = 12.5
datum_deg = {datum}
density_kg_m3 = 7850
projection = "third_angle"
[drawing.title_block]
part = "Cam <1>"
material = "16MnCr5"
tolerance = "ISO 2768-m"
drawn_by = "N. N."
organisation = "Cam Works"
number = "4711"
revision = "C"
date = "2026-11-26"
surface_finish = "Ra 0.8"
profile_tolerance = "0.02"
bore_fit = "H7"
keyway_tolerance = "JS9"
"""
CASES = [("cam_drdrd", 20, 60, 0), ("cam_clockwise", 14, -30, 45), ("cam_flat", 12, 0, 0),
         ("cam_arm_roller", 18, 90, -90)]
QUICK = ["--set", "solver.max_seconds=6", "--set", "solver.starts=1"]


class Test:
    def __init__(self, options):
        self.options = options
        self.folder = pathlib.Path(options.folder)
        self.folder.mkdir(parents=True, exist_ok=True)

    def run(self, *words, status=0):
        done = subprocess.run([self.options.camopt, *map(str, words)], capture_output=True, text=True)
        assert done.returncode == status, (words, done.returncode, done.stdout, done.stderr)
        return done.stdout + done.stderr

    def case(self, name, bore, at, datum):
        self.bore, self.at, self.datum = bore, at, datum
        scene = self.folder / f"{name}.toml"
        text = (pathlib.Path(self.options.scenes) / f"{name}.toml").read_text(encoding="utf-8")
        scene.write_text(text + DRAWING.format(bore=bore, at=at, datum=datum), encoding="utf-8")
        self.result, self.out = self.folder / name, self.folder / f"{name}_out"
        self.run("solve", scene, "--out", self.result, "--points", 40000, *QUICK)
        self.sense = -1 if 'rotation = "clockwise"' in text else 1
        self.base = float(re.search(r"base_radius_mm = ([\d.]+)", text).group(1))
        roller = re.search(r"roller_radius_mm = ([\d.]+)", text)
        self.roller = float(roller.group(1)) if roller else None
        with open(self.result / "profile.csv", newline="") as file:
            self.points = [(float(row["cam_x_mm"]), float(row["cam_y_mm"])) for row in csv.DictReader(file)]
        step = ["--step"] if self.options.volume else []
        text = self.run("export", self.result, "--out", self.out, "--drawing", "dxf", "--stl", *step)
        self.run("export", self.result, "--out", self.out, "--drawing", "svg")
        self.check_dxf()
        self.check_table()
        self.check_solids(text)
        print(f"{name}: drawn")

    def ray(self, cam_angle_deg):
        turn = math.radians(self.sense * cam_angle_deg)
        return math.sin(turn), math.cos(turn)

    def check_dxf(self):
        try:
            import ezdxf
        except ImportError:
            print("the DXF is NOT READ: ezdxf is not installed (python3-ezdxf)")
            return
        drawing = ezdxf.readfile(self.out / "drawing.dxf")
        auditor = drawing.audit()
        assert not auditor.has_errors, [error.message for error in auditor.errors]
        assert not auditor.has_fixes, [error.message for error in auditor.fixes]
        layers = {layer.dxf.name for layer in drawing.layers}
        assert {"CAM", "BASE_CIRCLE", "BORE", "SECTION", "DATUM", "ROTATION", "DIMENSIONS"} <= layers, layers
        found = {"linear": [], "diameter": [], "radius": [], "angle": []}
        kinds = {0: "linear", 3: "diameter", 4: "radius", 5: "angle"}
        for dimension in drawing.modelspace().query("DIMENSION"):
            measured, block = dimension.get_measurement(), dimension.get_geometry_block()
            kind = kinds[dimension.dimtype]
            assert block is not None and block.query("TEXT") and block.query("SOLID"), "a dimension without its picture"
            stated = dimension.dxf.actual_measurement
            assert abs((math.degrees(stated) if kind == "angle" else stated) - measured) < 1e-9
            words = re.sub(r"\\U\+[0-9A-F]{4}", "", block.query("TEXT")[0].dxf.text)
            shown = float(re.sub(r"[^\d.]", "", words.split(" ")[0]))  # without its fit
            assert abs(shown - measured) < 0.006, (shown, measured)
            found[kind].append(measured)
        linear = [12.5, self.bore, self.bore + 2.8, 6]
        assert_same(found["linear"], linear)
        assert_same(found["diameter"], [2 * self.base] + ([2 * (self.base + self.roller)] if self.roller else []))
        assert_same(found["radius"], [max(math.hypot(*point) for point in self.points)], 1e-4)
        between = abs((self.at - self.datum + 180) % 360 - 180)
        assert_same(found["angle"], [between] if between else [])

    def radius_along(self, x, y):
        """Of the polygon through the points, the outermost."""
        outermost = 0.0
        for (ax, ay), (bx, by) in zip(self.points, self.points[1:] + self.points[:1]):
            before, after = x * ay - y * ax, x * by - y * bx
            if (before > 0) == (after > 0):
                continue
            part = before / (before - after)
            outermost = max(outermost, x * (ax + part * (bx - ax)) + y * (ay + part * (by - ay)))
        return outermost

    def check_table(self):
        root = xml.etree.ElementTree.parse(self.out / "drawing.svg").getroot()
        elements = root.iter("{http://www.w3.org/2000/svg}text")
        texts = [(float(element.get("y")), float(element.get("x")), element.text) for element in elements]
        words = {text for _, _, text in texts}
        for word in ("Cam <1>", "16MnCr5", "ISO 2768-m", "N. N.", "Cam Works", "4711", "C", "2026-11-26", "Ra 0.8", "0.02",
                     f"⌀{self.bore} H7", "6 JS9"):
            assert word in words, (word, words)
        mass = next(float(word[:-3]) for word in words if word.endswith(" kg"))
        assert abs(mass / (7850e-9 * 12.5 * self.area()) - 1) < 5e-3, mass
        assert any(re.fullmatch(r"\d+:\d+", word) for word in words), words
        rows = 0
        for y, x, text in texts:
            if not re.fullmatch(r"\d+°", text) or not float(root.get("viewBox").split()[2]) * 0.6 < x:
                continue
            radii = sorted((other, word) for height, other, word in texts if height == y and 0 < other - x < 25)
            if not radii:
                continue
            rows += 1
            expected = self.radius_along(*self.ray(self.datum + float(text[:-1])))
            assert abs(float(radii[0][1]) - expected) < 1e-3, (text, radii, expected)
        assert rows == 72, rows

    def area(self):
        """Of the outline less bore and keyway, mm²."""
        around = zip(self.points, self.points[1:] + self.points[:1])
        outline = 0.5 * abs(sum(ax * by - bx * ay for (ax, ay), (bx, by) in around))
        radius, half = 0.5 * self.bore, 3.0
        angle = math.asin(half / radius)
        # The slot from its floor down to the chord, and the bore without the segment that the chord cuts off.
        slot = 2 * half * (radius + 2.8 - radius * math.cos(angle))
        bore = math.pi * radius ** 2 - radius ** 2 * (angle - math.sin(angle) * math.cos(angle))
        return outline - slot - bore

    def check_solids(self, text):
        exact = 12.5 * self.area()
        volume = mesh_volume(self.out / "cam.stl")
        stated = float(re.search(r"mm3, ([\d.e+-]+) of it (?:less|more)", text).group(1))
        assert abs(abs(volume / exact - 1) - stated) < 0.05 * stated + 2e-6, (volume, exact, stated)
        if not self.options.volume:
            print("the STEP is NOT WRITTEN: this build has no Open CASCADE")
            return
        header = (self.out / "cam.step").read_text(encoding="utf-8").split("ENDSEC", 1)[0]
        assert "'Cam <1>'" in header and "('N. N.')" in header and "('Cam Works')" in header, header
        read = float(subprocess.run([self.options.volume, self.out / "cam.step"], capture_output=True, text=True,
                                    check=True).stdout)
        assert abs(read / exact - 1) < 1e-6, (read, exact)

    def refusals(self):
        scenes = pathlib.Path(self.options.scenes)
        result = self.folder / "smallest"
        self.run("solve", scenes / "cam_smallest.toml", "--out", result, *QUICK)
        for wish in ("--stl", "--nc"):
            said = self.run("export", result, "--out", self.folder / "none", wish, status=2)
            assert "no return is given" in said and '"RR"' in said, said
        self.run("export", result, "--out", self.folder / "open", "--drawing", "svg", "--dxf")
        assert "OPEN: no return is given" in (self.folder / "open" / "drawing.svg").read_text(encoding="utf-8")
        assert "OPEN: no return is given" in (self.folder / "open" / "profile.dxf").read_text(encoding="utf-8")
        assert "no return is given" in (result / "profile.svg").read_text(encoding="utf-8")
        none = ["--out", self.folder / "none"]
        said = self.run("export", self.folder / "cam_flat", *none, "--stl", "--bore-mm", 34, status=2)
        assert "allowed: less than 17 mm, the least radius of the cam" in said, said
        said = self.run("export", scenes / "tappet_75.toml", *none, "--drawing", "svg", status=2)
        assert 'allowed: with cam.type = "disk", "barrel", "cylindrical" or "linear"' in said, said
        said = self.run("export", scenes / "linear_press.toml", *none, "--drawing", "svg", "--bore-mm", 20, status=2)
        assert "a bore in a plate that slides" in said, said
        wish = ["export", self.folder / "cam_flat", "--out", self.folder / "pdf", "--drawing", "pdf"]
        if self.options.pdf:
            self.run(*wish)
            first = (self.folder / "pdf" / "drawing.pdf").read_bytes()
            self.run(*wish)
            assert first.startswith(b"%PDF-") and first == (self.folder / "pdf" / "drawing.pdf").read_bytes()
        else:
            said = self.run(*wish, status=2)
            assert "libcairo2-dev" in said, said
        print("refused what cannot be made")


def assert_same(found, expected, tolerance=1e-9):
    assert len(found) == len(expected), (found, expected)
    for one, other in zip(sorted(found), sorted(expected)):
        assert abs(one - other) < tolerance, (found, expected)


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("camopt")
    parser.add_argument("scenes")
    parser.add_argument("folder")
    parser.add_argument("--pdf", action="store_true")
    parser.add_argument("--volume")
    test = Test(parser.parse_args())
    for case in CASES:
        test.case(*case)
    test.refusals()


main()
