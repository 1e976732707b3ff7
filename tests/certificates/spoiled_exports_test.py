# SPDX-License-Identifier: MIT
"""Exported files spoiled at random, all of which scripts/verify-export must refute: spoiled_exports_test.py CAMOPT [--seed 20] [--count 200].

Every file is confirmed first. Then one number of it, a row, its claims, the design beside it or the scene is changed so far that a claim
is false.
"""
import argparse
import copy
import json
import random
import re
import subprocess
import sys
import tempfile
from pathlib import Path

import checker
from plane_samples import outline_of

ALL = "codesys,twincat,siemens,br,rockwell,csv"
# Scene, settings, options of camopt export, sizes of its scene that its files depend on.
CASES = [
    ("rr_unequal_return", [], ["--plc", ALL, "--csv"], ["lift_mm", "rise_deg"]),
    ("drd_quintic_12", [], ["--plc", "codesys,siemens,br,csv", "--csv"], []),
    ("cam_drdrd", ["spline.segments=6", "solver.starts=1"], ["--plc", "codesys,twincat,rockwell", "--dxf"], ["lift_mm"]),
    ("cam_roller", [], ["--dxf", "--nc"], ["base_radius_mm", "roller_radius_mm", "lift_mm"]),
    ("cam_flat", [], ["--dxf", "--nc"], ["base_radius_mm", "lift_mm"]),
    ("barrel_paper_cup", ["spline.segments=8", "solver.starts=1"], ["--nc"], ["center_distance_mm", "lift_deg"]),
    ("cylinder_slide", ["spline.segments=8", "solver.starts=1"], ["--nc", "--cutter-mm", "12"], ["cylinder_radius_mm", "lift_mm"]),
]
MOVED = 0.05              # mm
NUMBER = re.compile(r"(?<![\w.])-?\d+\.\d+(?:e-?\d+)?")


def is_data(line):
    return not line.lstrip().startswith(("#", "(*")) and "//" not in line


def away(x, y, chance):
    """A place moved from the centre of the cam or to it: across every outline, if not at right angles."""
    return 1 + chance.choice((-MOVED, MOVED)) / abs(complex(x, y))


class Export:
    """A file with its claims and its scene. Ways to spoil it return False where it has nothing for them."""

    def __init__(self, file, scene, sizes):
        self.file, self.scene, self.sizes = file, scene, sizes
        self.text, self.stated = file.read_text(), scene.read_text()
        self.claims_file = file.with_name(file.name.split(".")[0] + ".check.json")
        self.claims, self.proved = json.loads(self.claims_file.read_text()), {}

    def written_to(self, folder):
        folder.mkdir(parents=True, exist_ok=True)
        (folder / self.file.name).write_text(self.text)
        (folder / self.claims_file.name).write_text(json.dumps(self.claims))
        (folder / "scene.toml").write_text(self.stated)
        return folder / self.file.name, folder / "scene.toml"

    # -- the file

    def number(self, chance):
        """The first digit of a number of a table; a corner of a drawing or a block of the finishing pass moved aside."""
        lines = self.text.split("\n")
        if self.claims["kind"] == "nc":
            begin = max(i for i, line in enumerate(lines) if "(pass:" in line)
            blocks = [(i, found) for i, line in enumerate(lines) if i > begin and (found := re.search(r"X(\S+) Y(\S+)", line))]
            i, found = chance.choice(blocks[len(blocks) // 8:-len(blocks) // 8])
            x, y = map(float, found.groups())
            along = away(x, y, chance)
            lines[i] = lines[i].replace(found[0], f"X{x * along:.4f} Y{y * along:.4f}")
        elif self.claims["kind"] == "dxf":
            line, x, y, _ = chance.choice(outline_of(self.text)[1:-1])
            along = away(x, y, chance)
            lines[line - 1], lines[line + 1] = f"{x * along:.8f}", f"{y * along:.8f}"
        else:
            cells = [(i, found) for i, line in enumerate(lines) if is_data(line) for found in NUMBER.finditer(line)
                     if abs(float(found[0])) > (1e-6 if "Jerk" in line[:found.start()][-30:] else 1e-3)]
            if self.claims["kind"] == "table":  # a jerk that jumps between two rows departs by as much as that
                cells = [(i, found) for i, found in cells if lines[i].count(",", 0, found.start()) < 3]
            i, found = chance.choice(cells)
            digit = re.search("[1-9]", found[0])
            other = chance.choice([d for d in "123456789" if d != digit[0]])
            lines[i] = lines[i][:found.start() + digit.start()] + other + lines[i][found.start() + digit.end():]
        self.text = "\n".join(lines)

    def row_removed(self, chance):
        if self.claims["kind"] in ("dxf", "nc"):
            return False
        lines = self.text.split("\n")
        rows = [i for i, line in enumerate(lines) if is_data(line) and len(NUMBER.findall(line)) > 1]
        if len(rows) < 3:
            return False
        del lines[chance.choice(rows[1:-1])]
        self.text = "\n".join(lines)

    # -- what is said of it

    def claim(self, chance):
        """A departure that is too small."""
        name = chance.choice([name for name, bound in self.proved.items() if bound and name != "gouge_mm"])
        less = self.proved[name] * chance.uniform(0.1, 0.4)
        if "loss" in self.claims:
            row = next(row for row in self.claims["loss"] if row["quantity"] == name)
            row["per_degree"] = less
        else:
            self.claims["departure"][name] = less

    def design(self, chance):
        """The displacement where a piece of the motion begins."""
        rows = [row for curve in self.claims["design"]["motion"]["curves"] for row in curve["pieces"] if row[0] > 0.1]
        chance.choice(rows)[0] *= 1 + chance.choice((-1, 1)) * chance.uniform(1e-3, 1e-2)

    def size(self, chance):
        """A length or an angle of the scene."""
        if not self.sizes:
            return False
        key = chance.choice(self.sizes)
        by = 1 + chance.choice((-1, 1)) * chance.uniform(2e-3, 1e-2)
        changed = re.sub(rf"^({key} *= *)([\d.]+)", lambda found: f"{found[1]}{float(found[2]) * by:.6f}", self.stated, count=1, flags=re.M)
        assert changed != self.stated, f"{self.scene}: no {key}"
        self.stated = changed


WAYS = Export.number, Export.number, Export.row_removed, Export.claim, Export.design, Export.size


def exports(camopt, place):
    for name, settings, options, sizes in CASES:
        folder = place / name
        checker.solve(camopt, checker.ROOT / "scenes" / f"{name}.toml", folder, settings)
        subprocess.run([camopt, "export", str(folder), "--out", str(folder / "files"), *options], check=True, capture_output=True, timeout=300)
        for claims in sorted((folder / "files").glob("*.check.json")):
            yield Export(folder / "files" / json.loads(claims.read_text())["file"], folder / "scene.toml", sizes)


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("camopt")
    parser.add_argument("--seed", type=int, default=20)
    parser.add_argument("--count", type=int, default=200)
    asked = parser.parse_args()
    chance, faults, tried = random.Random(asked.seed), [], 0
    with tempfile.TemporaryDirectory() as place:
        judge, found = checker.load_exports(), []
        for export in exports(asked.camopt, Path(place)):
            code, lines = judge.outcome_of(*export.written_to(Path(place) / "judged"))
            if code == 2 and export.claims["kind"] == "table":  # columns that are none of the motion are named
                code = 0
            if code:
                faults.append(f"{export.scene.parent.name} {export.file.name}: not confirmed: {lines[-1]}")
            export.proved = {name: float(bound) for name, bound in re.findall(r"^  (\w+): departs by at most (\S+)", "\n".join(lines), re.M)}
            found.append(export)
        while tried < asked.count and found and not faults:
            export, way = copy.deepcopy(found[tried % len(found)]), chance.choice(WAYS)
            if way(export, chance) is False:
                continue
            tried += 1
            code, lines = judge.outcome_of(*export.written_to(Path(place) / "judged"))
            print(f"{export.scene.parent.name} {export.file.name} {way.__name__}: {lines[-1][:120]}", flush=True)
            if code != 1:
                faults.append(f"{export.scene.parent.name} {export.file.name}, {way.__name__}: {lines[-1]}")
    print(f"{tried} spoiled files of {len(found)}, {len(faults)} not refuted")
    print("\n".join(faults))
    return 1 if faults or tried < asked.count else 0


if __name__ == "__main__":
    sys.exit(main())
