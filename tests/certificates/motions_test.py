# SPDX-License-Identifier: MIT
"""Ends in motion, bounds, lost area, prescribed motions and loads: motions_test.py CAMOPT [NAME ...].

Every scene of motion_scenes.py is solved and must be confirmed. With a changed scene.toml, whose optimum is another one, with
another lost area, or with the row of a limit that holds elsewhere, the same files must be refuted.
"""
import json
import shutil
import sys
import tempfile
from pathlib import Path

import checker
from motion_scenes import CHANGES, TEXTS, UNKNOWN


def outcome_with(module, folder, place, edit):
    """What the checker says of a folder after `edit` (its scene, certificate and result, changed in place) was done to it."""
    copy = Path(place) / "changed"
    shutil.copytree(folder, copy, dirs_exist_ok=True)
    files = {name: json.loads((copy / name).read_text()) for name in ("certificate.json", "result.json")}
    scene = edit((copy / "scene.toml").read_text(), *files.values())
    (copy / "scene.toml").write_text(scene)
    for name, data in files.items():
        (copy / name).write_text(json.dumps(data))
    return checker.outcome(module, copy)


def smaller_area(scene, certificate, result):
    for term in result["own_terms"]:
        term["value"] -= 1e-6
    return scene


def other_reference(scene, certificate, result):
    for term in result["own_terms"]:
        term["reference"] *= 1.001
    return scene


def row_elsewhere(scene, certificate, result):
    """The heaviest row of a corridor is moved beyond its end."""
    rows = [r for r in certificate["proof"]["rows"] if r["origin"]["rule"].startswith("motion.corridor")]
    max(rows, key=lambda r: abs(r["multiplier"]))["origin"]["at"] = 0.95
    return scene


def row_of_prescribed(scene, certificate, result):
    """The place at which a prescribed motion is said to pass a limit."""
    certificate["proof"]["rows"][0]["origin"]["at"] = 0.01
    return scene


def higher_bound(scene, certificate, result):
    certificate["lower_bound"] = result["bound"]["lower"] = certificate["objective"] * 0.9
    certificate["gap"] = result["bound"]["gap"] = 0.2
    certificate["proof"]["rows"] = []
    return scene


def law_of_another_height(scene, certificate, result):
    next(part for part in result["motion"]["parts"] if part["law"])["y_scale"] *= 1.001
    return scene


def other_figure(name):
    def edit(scene, certificate, result):
        result["drive"][name] *= 1 + 1e-6
        return scene
    return edit


def smaller_reference(scene, certificate, result):
    """The objective is then larger by as much."""
    for term in result["own_terms"]:
        term["reference"] *= 0.999
    return scene


EDITS = [("lobe", smaller_area), ("area", smaller_area), ("each", other_reference), ("corridor", row_elsewhere),
         ("prescribed_no", row_of_prescribed), ("prescribed_steep", row_of_prescribed), ("prescribed_base", higher_bound),
         ("prescribed", law_of_another_height), ("lines", law_of_another_height), ("drive_rms_term", smaller_reference),
         ("drive_prescribed", smaller_reference)]
EDITS += [("drive_curve", other_figure(name)) for name in ("peak_torque_nm", "rms_torque_nm", "peak_speed_rpm", "peak_power_w",
                                                           "share_of_curve", "inertia_ratio")]


def not_named(module, folder, place, name):
    """Of tables and keys that the checker does not know."""
    faults = []
    for scene, before, after, named in UNKNOWN:
        if scene == name:
            found, why = outcome_with(module, folder, place, lambda toml, *_, b=before, a=after: toml.replace(b, a))
            if found != "not verified" or named not in why:
                faults.append(f"{name}, {after!r}: {found}: {why}")
    return faults


def main():
    module, faults, refuted = checker.load(), [], 0
    with tempfile.TemporaryDirectory() as place:
        for name in sys.argv[2:] or TEXTS:
            text, expected = TEXTS[name]
            folder = Path(place) / name
            verdict = checker.solve(sys.argv[1], text, folder)
            found, why = checker.outcome(module, folder)
            print(f"{name}: {verdict}: {why}", flush=True)
            if (verdict, found) != (expected, "confirmed"):
                faults.append(f"{name}: {verdict}: {why}")
            faults += not_named(module, folder, place, name)
            edits = [edit for scene, edit in EDITS if scene == name]
            written = (folder / "scene.toml").read_text()
            for scene, before, after in CHANGES:
                if scene == name and before not in written:
                    faults.append(f"{name}: scene.toml does not say {before}")
                if scene == name:
                    edits.append(lambda toml, *_, before=before, after=after: toml.replace(before, after))
            for k, edit in enumerate(edits):
                found, why = outcome_with(module, folder, place, edit)
                refuted += found == "refuted"
                if found != "refuted":
                    words = [f"{b} -> {a}" for s, b, a in CHANGES if s == name]
                    count = len(edits) - len(words)
                    faults.append(f"{name}, {edit.__name__ if k < count else words[k - count]}: {found}: {why}")
    print(f"{refuted} changed claims refuted")
    for fault in faults:
        print("FAULT:", fault)
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
