# SPDX-License-Identifier: MIT
"""Certificates spoiled at random, all of which must be refuted: spoiled_test.py CAMOPT [SEED].

A spoiled file must claim something false or leave it unproved. Any multipliers prove some bound, and a weaker one can
still be enough: so a multiplier is spoiled only as far as it takes to break the proof (it is one of the heaviest, and
it changes by a tenth of itself or more), and what is false is checked against the unspoiled files, which must be
confirmed first.
"""
import copy
import json
import random
import shutil
import sys
import tempfile
from pathlib import Path

import checker

SCENES = ("drd_cubic_8", "drd_cubic_12", "drd_via_points", "drd_quintic_12", "drd_capped_velocity",
          "drd_physical_limits", "drd_symmetric", "drd_rms_jerk", "rr_unequal_return", "infeasible_velocity_cap",
          "pusher_set_points", "cam_knife", "drd_free_knots")
COUNT = 200


class Spoiled:
    """The two files of a folder, and what is done to them. Every way returns False where the files have nothing for
    it."""

    def __init__(self, random_numbers, certificate, result):
        self.random, self.certificate, self.result = random_numbers, certificate, result
        self.proof = certificate["proof"]
        self.motion = result["motion"]

    def heavy_row(self, placed=True):
        """One of the ten rows with the largest multipliers (placed: of a rule at an angle)."""
        rows = [r for r in self.proof["rows"] if "at" in r["origin"] or not placed] if self.proof else []
        rows.sort(key=lambda r: -abs(r["multiplier"]))
        return self.random.choice(rows[:10]) if rows else None

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
        if row["origin"]["rule"][0] in "+-":
            row["origin"]["rule"] = {"+": "-", "-": "+"}[row["origin"]["rule"][0]] + row["origin"]["rule"][1:]
        return True

    def coefficient(self):
        """A number of a row that carries the stored proof."""
        row = self.heavy_row(placed=False)
        if row is None:
            return False
        k = self.random.randrange(len(row["values"]))
        row["values"][k] += self.random.choice((-1, 1)) * max(1.0, abs(row["values"][k]))
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


WAYS = ("multiplier", "place", "rule", "coefficient", "side", "box", "bound", "objective", "verdict", "knot", "curve",
        "reference")


def main():
    camopt, seed = sys.argv[1], int(sys.argv[2]) if len(sys.argv) > 2 else 20
    module, faults, tried = checker.load(), [], dict.fromkeys(WAYS, 0)
    numbers = random.Random(seed)
    with tempfile.TemporaryDirectory() as place:
        files = {}
        for scene in SCENES:
            folder = Path(place) / scene
            checker.solve(camopt, checker.ROOT / "scenes" / (scene + ".toml"), folder)
            found, why = checker.outcome(module, folder)
            if found != "confirmed":
                faults.append(f"{scene} as it was written: {why}")
            files[scene] = [json.loads((folder / name).read_text()) for name in ("certificate.json", "result.json")]
        spoiled = Path(place) / "spoiled"
        spoiled.mkdir()
        done = 0
        while done < COUNT:
            scene, way = numbers.choice(SCENES), WAYS[done % len(WAYS)]
            certificate, result = copy.deepcopy(files[scene])
            if not getattr(Spoiled(numbers, certificate, result), way)():
                continue
            done += 1
            tried[way] += 1
            shutil.copy(Path(place) / scene / "scene.toml", spoiled / "scene.toml")
            (spoiled / "certificate.json").write_text(json.dumps(certificate))
            (spoiled / "result.json").write_text(json.dumps(result))
            found, why = checker.outcome(module, spoiled)
            if found != "refuted":
                faults.append(f"{done}: {scene}, {way}: {why}")
                keep = Path("spoiled") / str(done)
                if len(sys.argv) > 3:
                    shutil.copytree(spoiled, keep, dirs_exist_ok=True)
    print(f"{done} spoiled, {done - len(faults)} refuted: " + ", ".join(f"{way} {n}" for way, n in tried.items()))
    for fault in faults:
        print("FAULT:", fault)
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
