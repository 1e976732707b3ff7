# SPDX-License-Identifier: MIT
"""Certificates spoiled at random, all of which must be refuted: spoiled_test.py CAMOPT [--seed 20] [--count 200] [--boxes 120] [--keep].

A spoiled file must claim something false or leave it unproved. Any multipliers prove some bound, and a weaker one can
still be enough: so a multiplier is spoiled only as far as it takes to break the proof (it is one of the heaviest, and
it changes by a tenth of itself or more), and what is false is checked against the unspoiled files, which must be
confirmed first.
"""
import argparse
import copy
import json
import random
import shutil
import sys
import tempfile
from pathlib import Path

import checker
import dimension_scenes
import load_scenes
import motion_scenes

checker.load()
from certificate_checker.exact import Refuted  # noqa: E402
from certificate_checker.stored import stored_bound  # noqa: E402

SCENES = ("drd_cubic_8", "drd_cubic_12", "drd_via_points", "drd_quintic_12", "drd_capped_velocity",
          "drd_physical_limits", "drd_symmetric", "drd_rms_jerk", "rr_unequal_return", "infeasible_velocity_cap",
          "pusher_set_points", "cam_knife", "drd_free_knots", "ends_drd", "ring", "seam", "repeat", "across", "lobe", "corridor",
          "corridor_no", "load", "tappet", "drive_rms_limit", "drive_rms_no", "arm_moment", "harmonic", "harmonic_no", "finger",
          "elastic_program", "beside_sine", "long_region", "arm_searched", "offset_searched", "offset_weighed", "output_caps",
          "output_no", "output_rings")
# Bounds over boxes; the torque peak's has two parts.
BOX_SCENES = ("cam_undercut", "cam_arm_flat", "torque", "margin", "arm_torque", "offset_margin", "face_arm_offset", "contact_point",
              "lever_searched")
TEXTS = {
    "torque": """
[motion]
type = "DRD"
[spline]
segments = 10
[objective]
velocity = 0.1
acceleration = 0.2
jerk = 0.2
torque = 0.5
""",
    "margin": """
[motion]
type = "DRD"
lift_mm = 15
rise_deg = 50
[spline]
segments = 14
[objective]
velocity = 0.4
acceleration = 0.4
jerk = 0.2
[cam]
type = "disk"
follower = "translating_roller"
base_radius_mm = 22
roller_radius_mm = 12
[limits]
undercut_margin = 0.4
""",
}


class Spoiled:
    """The two files of a folder, and what is done to them. Every way returns False where the files have nothing for
    it."""

    def __init__(self, random_numbers, certificate, result):
        self.random, self.certificate, self.result = random_numbers, certificate, result
        self.proof = certificate["proof"]
        self.motion = result["motion"]

    def heavy_row(self, placed=True):
        """One of the ten rows with the largest multipliers (placed: of a rule at an angle), of which more than rounding is left."""
        rows = [r for r in self.proof["rows"] if "at" in r["origin"] or not placed] if self.proof else []
        rows.sort(key=lambda r: -abs(r["multiplier"]))
        rows = [r for r in rows[:10] if abs(r["multiplier"]) > 1e-6 * abs(rows[0]["multiplier"])]
        return self.random.choice(rows) if rows else None

    def multiplier(self):
        row = self.heavy_row()
        if row is None:
            return False
        # A contradiction stays one with many other multipliers, but never with one below 0.
        proves_more = self.certificate["verdict"] == "infeasible"
        row["multiplier"] *= self.random.choice((-1.0,) if proves_more else (-1.0, 0.0, 0.5, 0.9, 1.1, 2.0))
        return True

    def place(self):
        """A row at another cam angle, its numbers left as they are."""
        row = self.heavy_row()
        if row is None or row["origin"]["at"] < 0.05 or self.certificate["verdict"] == "infeasible":
            return False
        row["origin"]["at"] = row["origin"]["at"] * self.random.uniform(0.9, 0.98)
        return True

    def rule(self):
        """A row of the other side: what was a largest value is a least one."""
        row = self.heavy_row()
        if row is None or row["origin"].get("sign") not in (-1, 1) or self.certificate["verdict"] == "infeasible":
            return False
        row["origin"]["sign"] = -row["origin"]["sign"]
        return True

    def coefficient(self):
        """A number of a row that carries the stored proof."""
        row = self.heavy_row(placed=False)
        if row is None:
            return False
        k = self.random.randrange(len(row["values"]))
        row["values"][k] += self.random.choice((-1, 1)) * max(1.0, abs(row["values"][k]))
        try:  # one that only helps spoils nothing
            return stored_bound(self.proof) < self.proof["bound"]
        except Refuted:
            return True

    def side(self):
        row = self.heavy_row(placed=False)
        if row is None:
            return False
        key = "upper" if row["multiplier"] > 0 else "lower"
        row[key] += (1 if row["multiplier"] > 0 else -1) * self.random.uniform(0.1, 1.0)
        return True

    def box(self):
        """A box that does not hold the delivered motion."""
        if not self.motion or not self.proof:
            return False
        names = dict(zip(self.result["design"]["names"], self.result["design"]["values"]))
        j = self.random.randrange(len(self.proof["variables"]))
        if self.proof["variables"][j] not in names:
            return False
        self.proof["box"]["lower"][j] = 2.0 + self.random.random() + 10 * abs(names[self.proof["variables"][j]])
        self.proof["box"]["upper"][j] = self.proof["box"]["lower"][j] + 1.0
        return True

    def bound(self):
        if self.certificate["lower_bound"] is None:
            return False
        higher = self.certificate["lower_bound"] + self.random.uniform(0.001, 0.5)
        self.certificate["lower_bound"] = self.result["bound"]["lower"] = higher
        if self.proof:
            self.proof["bound"] = higher
        return True

    def objective(self):
        if not self.motion:
            return False
        change = self.random.choice((-1, 1)) * 10 ** self.random.uniform(-6, -1)
        self.certificate["objective"] += change
        self.result["objective"] = self.certificate["objective"]
        return True

    def verdict(self):
        other = "infeasible" if self.certificate["verdict"] == "optimal" else "optimal"
        self.certificate["verdict"] = self.result["verdict"] = other
        return True

    def knot(self):
        if not self.motion:
            return False
        points = self.random.choice(self.motion["curves"])["breakpoints"]
        k = self.random.randrange(1, len(points) - 1)
        points[k] += self.random.choice((-0.3, 0.3)) * (points[k + 1] - points[k - 1]) / 2
        return True

    def curve(self):
        """A coefficient of the motion: it jumps, or leaves its conditions."""
        if not self.motion:
            return False
        piece = self.random.choice(self.random.choice(self.motion["curves"])["pieces"])
        m = self.random.randrange(len(piece))
        piece[m] += self.random.choice((-1, 1)) * (1e-3 + abs(piece[m]) * 10 ** self.random.uniform(-3, 0))
        return True

    def reference(self):
        """The objective divided by other peaks than the scene's."""
        if not self.motion or not self.proof or self.result["reference"]["law"] is None:
            return False
        costs = dict(zip(self.proof["variables"], self.proof["cost"]))
        used = [name for name in ("velocity", "acceleration", "jerk") if costs.get("peak " + name)]
        if not used:
            return False
        self.result["reference"][self.random.choice(used)] *= self.random.uniform(1.01, 2.0)
        return True


class SpoiledBoxes:
    """A bound over boxes, in the same way. Planes have room below their rules, and what a box says is often not needed:
    so planes are lifted by all that they fall over their box, and boxes lose half."""

    def __init__(self, random_numbers, certificate, result):
        self.random, self.certificate, self.result = random_numbers, certificate, result
        self.proof = certificate["boxes"]
        self.steps, self.parts = self.proof["steps"], self.proof["parts"]

    def step(self, *kinds):
        found = [step for step in self.steps if step["kind"] in kinds]
        return self.random.choice(found) if found else None

    def multiplier(self):
        """The heaviest of a step or part: what it gives is then more than is stated."""
        claims = [step for step in self.steps if step["kind"] == "derived"] + self.parts
        heaviest = max(self.random.choice(claims)["multipliers"], key=lambda m: abs(m[1]), default=None)
        if heaviest is None or heaviest[1] < 1e-6:
            return False
        heaviest[1] *= self.random.choice((-1.0, 0.0, 0.5, 0.9, 1.1, 2.0))
        return True

    def derived_side(self):
        step = self.step("derived")
        step["side"] -= 10 ** self.random.uniform(-6, -1) * max(1.0, abs(step["side"]))
        return True

    def plane_constant(self):
        step = self.step("plane")
        ends = list(zip(step["slope"], step["box"]["lower"], step["box"]["upper"]))
        lifted = sum(abs(s) * (high - low) for s, low, high in ends if s) + 0.1 * abs(step["constant"]) + 1e-6
        step["constant"] += lifted
        step["side"] -= lifted
        return True

    def plane_slope(self):
        step = self.step("plane")
        i = max(range(3), key=lambda i: abs(step["slope"][i]))
        if not step["slope"][i] or not step["indices"]:
            return False
        step["slope"][i] *= self.random.choice((-1.0, 0.5, 1.5))
        return True

    def box_end(self):
        step = self.step("plane")
        orders = [i for i in range(3) if min(step["ends"][i]) >= 0 and
                  step["box"]["upper"][i] - step["box"]["lower"][i] > 1e-3]
        if not orders:
            return False
        i, end = self.random.choice(orders), self.random.choice(("lower", "upper"))
        step["box"][end][i] = (step["box"]["lower"][i] + step["box"]["upper"][i]) / 2
        return True

    def place(self):
        """Elsewhere; a cubic's jerk is the same along a segment."""
        step = self.step("plane", "linear")
        if step["origin"].get("at", 0) < 0.05 or len(step["indices"]) < 2 or "jerk" in step["origin"]["key"]:
            return False
        step["origin"]["at"] *= self.random.uniform(0.9, 0.98)
        return True

    def linear_side(self):
        step = self.step("linear", "cost")
        step["side"] -= 10 ** self.random.uniform(-4, -1) * max(1.0, abs(step["side"]))
        return True

    def rule(self):
        """A plane of another rule, or a row of the other side."""
        step = self.step("plane", "linear")
        origin = step["origin"]
        if origin["limit"] or not origin.get("sign") or len(step["indices"]) < 2:
            return False
        origin["sign"] = -origin["sign"]
        return True

    def split(self):
        """A gap between two parts."""
        step = self.step("split")
        if step is None:
            return False
        step["side"] -= self.random.uniform(0.01, 0.5) * max(1.0, abs(step["side"]))
        return True

    def part(self):
        """One part removed, its assumption dropped, or that of another part taken."""
        if len(self.parts) < 2:
            return False
        i = self.random.randrange(len(self.parts))
        if self.random.random() < 0.5:
            del self.parts[i]
        elif self.random.random() < 0.5:
            self.parts[i]["splits"] = []
        else:
            self.parts[i]["splits"] = self.parts[1 - i]["splits"]
        return True

    def part_bound(self):
        part = self.random.choice(self.parts)
        if part["infeasible"]:
            return False
        if self.random.random() < 0.5:
            part["infeasible"], part["bound"] = True, None
        else:
            part["bound"] += self.random.uniform(1e-3, 0.1)
        return True

    def bound(self):
        higher = self.certificate["lower_bound"] + self.random.uniform(0.001, 0.5)
        self.certificate["lower_bound"] = self.result["bound"]["lower"] = self.proof["bound"] = higher
        return True

    def order(self):
        """A step that follows from itself."""
        k = self.random.randrange(len(self.steps))
        if not self.steps[k].get("multipliers"):
            return False
        self.steps[k]["multipliers"].append([k, 1.0])
        return True


WAYS = ("multiplier", "place", "rule", "coefficient", "side", "box", "bound", "objective", "verdict", "knot", "curve",
        "reference")


BOX_WAYS = ("multiplier", "derived_side", "plane_constant", "plane_slope", "box_end", "place", "linear_side", "rule", "split",
            "part", "part_bound", "bound", "order")


class Spoiling:
    """Scenes as they were written, then spoiled one after another."""

    def __init__(self, camopt, seed, place, keep):
        self.camopt, self.place, self.numbers, self.keep = camopt, Path(place), random.Random(seed), keep
        self.module, self.faults = checker.load(), []

    def written(self, scene):
        """[certificate, result] of a scene, which must be confirmed."""
        folder = self.place / scene
        text = TEXTS.get(scene) or (motion_scenes.TEXTS | load_scenes.TEXTS | dimension_scenes.TEXTS).get(scene, (None,))[0]
        checker.solve(self.camopt, text or checker.ROOT / "scenes" / (scene + ".toml"), folder)
        found, why = checker.outcome(self.module, folder)
        if found != "confirmed":
            self.faults.append(f"{scene} as it was written: {why}")
        return [json.loads((folder / name).read_text()) for name in ("certificate.json", "result.json")]

    def run(self, scenes, spoiler, ways, count):
        files = {scene: self.written(scene) for scene in scenes}
        spoiled, tried, done, faults = self.place / "spoiled", dict.fromkeys(ways, 0), 0, len(self.faults)
        spoiled.mkdir(exist_ok=True)
        while done < count:
            scene, way = self.numbers.choice(scenes), ways[done % len(ways)]
            certificate, result = copy.deepcopy(files[scene])
            if not getattr(spoiler(self.numbers, certificate, result), way)():
                continue
            done += 1
            tried[way] += 1
            shutil.copy(self.place / scene / "scene.toml", spoiled / "scene.toml")
            (spoiled / "certificate.json").write_text(json.dumps(certificate))
            (spoiled / "result.json").write_text(json.dumps(result))
            found, why = checker.outcome(self.module, spoiled)
            if found != "refuted":
                self.faults.append(f"{done}: {scene}, {way}: {why}")
                if self.keep:
                    shutil.copytree(spoiled, Path("spoiled") / str(done), dirs_exist_ok=True)
        print(f"{done} spoiled, {done - len(self.faults) + faults} refuted: " +
              ", ".join(f"{way} {n}" for way, n in tried.items()), flush=True)


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("camopt")
    parser.add_argument("--seed", type=int, default=20)
    parser.add_argument("--count", type=int, default=200, help="spoiled files whose bound is a duality proof")
    parser.add_argument("--boxes", type=int, default=120, help="spoiled files whose bound is over boxes")
    parser.add_argument("--keep", action="store_true", help="those not refuted, in the folder spoiled")
    arguments = parser.parse_args()
    with tempfile.TemporaryDirectory() as place:
        spoiling = Spoiling(arguments.camopt, arguments.seed, place, arguments.keep)
        spoiling.run(SCENES, Spoiled, WAYS, arguments.count)
        spoiling.run(BOX_SCENES, SpoiledBoxes, BOX_WAYS, arguments.boxes)
    for fault in spoiling.faults:
        print("FAULT:", fault)
    return 1 if spoiling.faults else 0


if __name__ == "__main__":
    sys.exit(main())
