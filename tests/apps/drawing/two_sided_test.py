#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""two_sided_test.py CAMOPT SCENES FOLDER [--volume STEP_VOLUME]

Drawings, solids and NC programs of a grooved and of conjugate disk cams, by the program, against the points of
profile.csv and second_profile.csv alone: volumes of STL and, read by STEP_VOLUME, of STEP; layers, diameters and the
table of the drawings; where the cutter goes.

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

THICKNESS, DEPTH, BORE = 18.0, 7.5, 20.0
DRAWING = f"""
[drawing]
bore_mm = {BORE}
thickness_mm = {THICKNESS}
"""
QUICK = ["--set", "solver.max_seconds=20", "--set", "solver.starts=1", "--set", "spline.segments=12"]


def area(points):
    return 0.5 * abs(sum(ax * by - bx * ay for (ax, ay), (bx, by) in zip(points, points[1:] + points[:1])))


def distances(path, points):
    """From places of the cutter to the nearest point of a side, mm."""
    cells = {}
    for point in points:
        cells.setdefault((int(point[0] // 4), int(point[1] // 4)), []).append(point)
    for x, y in path:
        i, j = int(x // 4), int(y // 4)
        near = [point for a in range(i - 5, i + 6) for b in range(j - 5, j + 6) for point in cells.get((a, b), [])]
        yield min(math.dist((x, y), point) for point in near or points)


def cuts(program):
    """(x, y, z) at the end of every feed, modal words and all."""
    place, mode, found = {}, None, []
    for line in program.splitlines():
        for letter, value in re.findall(r"([A-Z])(-?[0-9.]+)", re.sub(r"\(.*?\)", "", line)):
            if letter == "G" and float(value) in (0, 1, 2, 3):
                mode = float(value)
            if letter in "XYZ":
                place[letter] = float(value)
        if mode and len(place) == 3 and (not found or found[-1] != (place["X"], place["Y"], place["Z"])):
            found.append((place["X"], place["Y"], place["Z"]))
    return found


def overlap(one, other):
    return one[0] < other[2] and other[0] < one[2] and one[1] < other[3] and other[1] < one[3]


class Test:
    def __init__(self, options):
        self.options = options
        self.folder = pathlib.Path(options.folder)
        self.folder.mkdir(parents=True, exist_ok=True)

    def run(self, *words, status=0):
        done = subprocess.run([self.options.camopt, *map(str, words)], capture_output=True, text=True)
        assert done.returncode == status, (words, done.returncode, done.stdout, done.stderr)
        return done.stdout + done.stderr

    def solve(self, name, more=""):
        scene = self.folder / f"{name}.toml"
        text = (pathlib.Path(self.options.scenes) / f"{name}.toml").read_text(encoding="utf-8")
        scene.write_text(text + DRAWING + more, encoding="utf-8")
        self.result, self.out = self.folder / name, self.folder / f"{name}_out"
        self.run("solve", scene, "--out", self.result, "--points", 40000, *QUICK)
        return [self.points(file) for file in ("profile.csv", "second_profile.csv")]

    def points(self, name):
        with open(self.result / name, newline="") as file:
            return [(float(row["cam_x_mm"]), float(row["cam_y_mm"])) for row in csv.DictReader(file)]

    def check_volume(self, name, expected):
        meshed = mesh_volume(self.out / f"{name}.stl")
        assert abs(meshed / expected - 1) < 1e-3, (meshed, expected)
        if not self.options.volume:
            print("the STEP is NOT WRITTEN: this build has no Open CASCADE")
            return
        read = float(subprocess.run([self.options.volume, self.out / f"{name}.step"], capture_output=True, text=True,
                                    check=True).stdout)
        assert abs(read / expected - 1) < 1e-6, (read, expected)

    def check_layers(self, name, wanted):
        try:
            import ezdxf
        except ImportError:
            print("the DXF is NOT READ: ezdxf is not installed (python3-ezdxf)")
            return []
        drawing = ezdxf.readfile(self.out / name)
        auditor = drawing.audit()
        assert not auditor.has_errors and not auditor.has_fixes, auditor.errors
        layers = {layer.dxf.name for layer in drawing.layers}
        assert wanted <= layers, layers
        return [one.get_measurement() for one in drawing.modelspace().query("DIMENSION")]

    def export(self, *more):
        step = ["--step"] if self.options.volume else []
        self.run("export", self.result, "--out", self.out, "--drawing", "dxf", "--stl", *step, *more)
        self.run("export", self.result, "--out", self.out, "--drawing", "svg")

    def words(self, name):
        """Texts with their boxes, mm, by an upper bound of their width."""
        root = xml.etree.ElementTree.parse(self.out / name).getroot()
        found = []
        for element in root.iter("{http://www.w3.org/2000/svg}text"):
            height, anchor = float(element.get("font-size")), element.get("class").split()[-1]
            width = 0.62 * height * len(element.text)
            x, y = float(element.get("x")), float(element.get("y"))
            left = x - width if anchor == "end" else x - width / 2 if anchor == "middle" else x
            found.append((element.text, (left, y - 0.75 * height, left + width, y)))
        return found

    def grooved(self):
        inner, outer = self.solve("cam_grooved", f"groove_depth_mm = {DEPTH}\n")
        self.export()
        rim = max(math.hypot(*point) for point in outer) + 9.0
        bore = math.pi * BORE ** 2 / 4
        self.check_volume("cam", (math.pi * rim ** 2 - bore) * THICKNESS - (area(outer) - area(inner)) * DEPTH)
        found = self.check_layers("drawing.dxf", {"CAM", "INNER_FLANK", "OUTER_FLANK", "PITCH", "SECTION"})
        for length in (2 * rim, DEPTH, THICKNESS, BORE):
            assert not found or any(abs(one - length) < 1e-3 for one in found), (length, found)
        assert "Groove: 20.05 wide, 7.5 deep in the upper face." in (self.out / "drawing.svg").read_text(encoding="utf-8")
        # As wide as the groove: one pass. Smaller: along either flank.
        for cutter in (20.05, 12.0):
            self.run("export", self.result, "--out", self.out, "--nc", "--cutter-mm", cutter)
            program = (self.out / "cam.nc").read_text()
            moves = cuts(program)
            assert min(z for _, _, z in moves) == -DEPTH, "not to the floor"
            path = [(x, y) for x, y, z in moves if z == -DEPTH]
            nearest = [min(pair) for pair in zip(distances(path, inner), distances(path, outer))]
            assert min(nearest) > cutter / 2 - 0.012, (cutter, min(nearest))
            for side in (inner, outer):
                touching = sum(gap < cutter / 2 + 0.012 for gap in distances(path, side))
                assert touching > 100, (cutter, touching)
            assert "REFUSED" not in (self.out / "cam_nc.svg").read_text(encoding="utf-8")
        said = self.run("export", self.result, "--out", self.out, "--nc", "--cutter-mm", 21, status=2)
        assert "cutter" in said, said
        print("grooved: made")

    def conjugate(self):
        sides = self.solve("cam_conjugate")
        self.export("--nc", "--cutter-mm", 16)
        for name, sheet, points in zip(("cam", "cam_second"), ("drawing", "drawing_second"), sides):
            self.check_volume(name, (area(points) - math.pi * BORE ** 2 / 4) * THICKNESS)
            found = self.check_layers(f"{sheet}.dxf", {"CAM", "PITCH", "BASE_CIRCLE", "SECTION"})
            assert not found or any(abs(one - max(math.hypot(*point) for point in points)) < 1e-3 for one in found), found
            path = [(x, y) for x, y, z in cuts((self.out / f"{name}.nc").read_text()) if z < -THICKNESS]
            gaps = list(distances(path, points))
            assert min(gaps) > 8 - 0.012, min(gaps)
            assert sum(gap < 8 + 0.012 for gap in gaps) > 100, "it does not go round"
            words = self.words(f"{sheet}.svg")
            (datum,) = [box for text, box in words if text.startswith("datum")]
            over = [text for text, box in words if box != datum and overlap(box, datum)]
            assert not over, f"{sheet}: {over} over the word of the datum"
        assert "second disk" in (self.out / "drawing_second.svg").read_text(encoding="utf-8")
        print("conjugate: made")


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("camopt")
    parser.add_argument("scenes")
    parser.add_argument("folder")
    parser.add_argument("--volume")
    test = Test(parser.parse_args())
    test.grooved()
    test.conjugate()


main()
