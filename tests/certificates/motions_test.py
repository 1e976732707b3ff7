# SPDX-License-Identifier: MIT
"""Ends in motion, bounds, lost area, prescribed motions and loads: motions_test.py CAMOPT [NAME ... | --loads | --half K].

Every scene of motion_scenes.py (--loads: its longest ones, those of load_scenes.py and dimension_scenes.py, and the laws) is solved and
must be confirmed. With a changed scene.toml, whose optimum is another one, with another lost area, or with the row of a limit that holds
elsewhere, the same files must be refuted.
"""
import json
import shutil
import subprocess
import sys
import tempfile
from fractions import Fraction
from pathlib import Path

import checker
import dimension_scenes
import load_scenes
import motion_scenes
from motion_scenes import UNKNOWN

LONG = "free_within", "free_drive", "free_area", "free_cam", "angles_side"  # how their names begin
LONGEST = {name: text for name, text in motion_scenes.TEXTS.items() if name.startswith(LONG)}
LONGER = LONGEST | load_scenes.TEXTS | dimension_scenes.TEXTS
TEXTS, CHANGES = motion_scenes.TEXTS | LONGER, motion_scenes.CHANGES + load_scenes.CHANGES + dimension_scenes.CHANGES


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
    rows = [r for r in certificate["proof"]["rows"] if r["origin"].get("key", "").startswith("motion.corridor")]
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


def lighter_row(scene, certificate, result):
    """The heaviest row of a proof, of cases that of the least bound, is taken half as often."""
    proof = certificate["proof"]
    if certificate["cases"]:
        least = min((case for case in certificate["cases"] if case["bound"] is not None), key=lambda case: case["bound"])
        proof = certificate["cases"][least["proof_of_case"]]["proof"]
    row = max((r for r in proof["rows"] if "at" in r["origin"]), key=lambda r: abs(r["multiplier"]))
    row["multiplier"] /= 2
    return scene


def other_direction(scene, certificate, result):
    part = certificate["cases"][0]["parts"][0]
    part["rises"] = not part["rises"]
    return scene


def case_removed(scene, certificate, result):
    """One that another does not rest on."""
    used = [case["proof_of_case"] for case in certificate["cases"]]
    del certificate["cases"][next(k for k in reversed(range(len(used))) if used[k] == k and used.count(k) == 1)]
    return scene


def wider_region(scene, certificate, result):
    """A case is said to hold for any direction of its first stroke, whose rows then are none of the scene's."""
    next(case for case in certificate["cases"] if len(case["parts"]) > 1)["parts"].pop(0)
    return scene


def raised_bound(scene, certificate, result):
    """The stated objective and bound are larger."""
    certificate["lower_bound"] = certificate["objective"] = result["objective"] = certificate["objective"] * (1 + 1e-6)
    certificate["gap"] = result["bound"]["gap"] = 0.0
    result["bound"]["lower"] = certificate["lower_bound"]
    return scene


def smaller_box(scene, certificate, result):
    """A box of angles ends earlier than it was proved to."""
    certificate["cases"][-1]["parts"][0]["angle_deg"][1] -= 0.01
    return scene


def claimed_empty(scene, certificate, result):
    """The case of the best motion is said to hold none, by its proof of a bound."""
    least = min((case for case in certificate["cases"] if case["bound"] is not None), key=lambda case: case["bound"])
    certificate["cases"][least["proof_of_case"]]["proof"]["statement"] = "least_common_violation"
    return scene


def other_row(scene, certificate, result):
    """The heaviest row of the table is said to be the one after it."""
    rows = [r for r in certificate["proof"]["rows"] if r["origin"].get("key") == "deviation"]
    origin = max(rows, key=lambda r: r["multiplier"])["origin"]
    origin["which"]["row"] = (origin["which"]["row"] + 1) % 10
    return scene


def smaller_reference(scene, certificate, result):
    """The objective is then larger by as much."""
    for term in result["own_terms"]:
        term["reference"] *= 0.999
    return scene


EDITS = [("lobe", smaller_area), ("area", smaller_area), ("each", other_reference), ("corridor", row_elsewhere),
         ("prescribed_no", row_of_prescribed), ("prescribed_steep", row_of_prescribed), ("prescribed_base", higher_bound),
         ("prescribed", law_of_another_height), ("lines", law_of_another_height), ("drive_rms_term", smaller_reference),
         ("drive_prescribed", smaller_reference), ("nearest", lighter_row), ("nearest", other_row), ("nearest_lobe", other_row),
         ("nearest_lobe", smaller_area), ("nearest_lobe_rms", smaller_area), ("nearest_rms", smaller_reference)]
EDITS += [(name, edit) for name in ("free_cases", "free_within") for edit in (lighter_row, other_direction, case_removed, claimed_empty)]
EDITS += [("angles", edit) for edit in (lighter_row, case_removed, claimed_empty, smaller_box)]
EDITS += [("angles_one", lighter_row), ("angles_no", case_removed), ("angles_no", smaller_box)]
EDITS += [("curve", raised_bound), ("curve_jerk", raised_bound), ("free", lighter_row), ("free_cases", wider_region),
          ("free_law", law_of_another_height)]
EDITS += [("drive_curve", other_figure(name)) for name in ("peak_torque_nm", "rms_torque_nm", "peak_speed_rpm", "peak_power_w",
                                                           "share_of_curve", "inertia_ratio")]
EDITS += [("drive_range", other_figure("transmission_mm_per_rev"))]


def not_named(module, folder, place, name):
    """Of tables and keys that the checker does not know."""
    faults = []
    for scene, before, after, named in UNKNOWN:
        if scene == name:
            found, why = outcome_with(module, folder, place, lambda toml, *_, b=before, a=after: toml.replace(b, a))
            if found != "not verified" or named not in why:
                faults.append(f"{name}, {after!r}: {found}: {why}")
    return faults


FLAT = {("freudenstein_135", "acceleration")}  # a maximum of the sixth order, which takes the checker half a minute


def laws(camopt):
    """Every figure of every law of the catalogue, enclosed by the checker and printed by camopt."""
    from certificate_checker.laws import law_peak
    listed = json.loads(subprocess.run([camopt, "list", "laws", "--json"], capture_output=True, text=True, check=True).stdout)
    names = ("velocity", "acceleration", "jerk", "torque", "rms_velocity", "rms_acceleration", "rms_jerk")
    wrong = [f"{name} of {law['key']}: {law[name]}" for law in listed for name in names if law[name] and (law["key"], name) not in FLAT
             and not all(abs(end / Fraction(law[name]) - 1) < Fraction(1, 10**8) for end in law_peak(law["key"], name))]
    return wrong + ([] if len(listed) > 25 else ["the catalogue is short"])


def main():
    module, refuted = checker.load(), 0
    if sys.argv[2:] == ["--loads"]:  # with the laws, the longer half
        chosen, faults = list(LONGER), laws(sys.argv[1])
    elif sys.argv[2:3] == ["--half"]:  # 0 or 1, of the others
        chosen, faults = [name for name in motion_scenes.TEXTS if name not in LONGEST][int(sys.argv[3])::2], []
    else:
        chosen, faults = sys.argv[2:] or [name for name in motion_scenes.TEXTS if name not in LONGEST], []
    with tempfile.TemporaryDirectory() as place:
        for name in chosen:
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
    return checker.end(faults)


if __name__ == "__main__":
    sys.exit(main())
