#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""No label over another, none outside: the boxes of all words in SVG pictures.

A box is as wide as DejaVu Sans draws the words or a little wider (a table of widths, rounded up), as high as its
letters, turned as the picture turns it. Two boxes of one picture must not overlap, and every box must lie in the
view box. Reads the pictures as a browser would: classes and the rules of their <style>, in order.

    text_boxes.py PICTURE.svg …  exit status 1 where a picture has a fault
    text_boxes.py --scenes CAMOPT SCENES SOLVED FOLDER
                                 draws every scene of the folder SCENES from its result in SOLVED (solve_examples.py),
                                 sweeps, traces fronts and compares laws into FOLDER, and looks at every picture there
                                 and in SOLVED
    text_boxes.py --self-test    pictures with a fault are found, those without are not
"""

import math
import pathlib
import re
import shutil
import subprocess
import sys
import xml.etree.ElementTree

# Widths of DejaVu Sans in em, rounded up; what is not listed is WIDEST.
WIDTHS = {}
for letters, width in (
    ("ijl'|", 0.34), (" .,:;", 0.34), ("!", 0.41), ("fIt()[]", 0.41), ("r-/", 0.42), ("sckvxyz", 0.6),
    ("abdeghnopqu", 0.64), ("0123456789", 0.64), ("JL", 0.6), ("FEPSTZKYVXRBC", 0.7), ("AGHDNOQU", 0.8), ("–", 0.51),
    ("−+=<>≤≥±×~", 0.84), ("m", 0.98), ("w", 0.82), ("MW", 0.99), ("°²³", 0.51), ("·", 0.34), ("%", 0.96), ("α", 0.66),
    ("θφβ", 0.64), ("*\"", 0.51), ("_", 0.51), ("″′", 0.38)):
    for letter in letters:
        WIDTHS[letter] = width
WIDEST = 1.0
ASCENT, DESCENT = 0.76, 0.24  # of the size, above and below the baseline: capitals and tails
SLACK = 0.75  # px of a picture of 1000: boxes may touch


def rules_of(style):
    for selectors, body in re.findall(r"([^{}]+)\{([^{}]*)\}", style):
        declared = dict(part.split(":", 1) for part in body.split(";") if ":" in part)
        for selector in selectors.split(","):
            yield selector.strip(), {key.strip(): value.strip() for key, value in declared.items()}


def fits(selector, tag, classes):
    name = re.match(r"[a-z]*", selector).group(0)
    wanted = re.findall(r"\.([\w-]+)", selector)
    if " " in selector or not (name or wanted) or name not in ("", tag):
        return False
    return all(one in classes for one in wanted)


class Looks:
    """What CSS says of an element: later rules of the same weight win, more classes weigh more."""

    def __init__(self, root):
        self.rules = []
        for style in root.iter("{http://www.w3.org/2000/svg}style"):
            self.rules += rules_of(style.text or "")

    def of(self, element):
        look = {key: element.get(key) for key in ("font-size", "text-anchor", "font-weight") if element.get(key)}
        classes = (element.get("class") or "").split()
        matching = [(selector.count("."), at, body) for at, (selector, body) in enumerate(self.rules)
                    if fits(selector, "text", classes)]
        for _, _, body in sorted(matching, key=lambda rule: rule[:2]):
            look |= body
        for part in (element.get("style") or "").split(";"):
            if ":" in part:
                key, value = part.split(":", 1)
                look[key.strip()] = value.strip()
        return look


def width_of(words, size, bold):
    return sum(WIDTHS.get(letter, WIDEST) for letter in words) * size * (1.1 if bold else 1.0)


def corners_of(element, look):
    size = float(re.match(r"[\d.]+", look.get("font-size", "12")).group(0))
    words = "".join(element.itertext())
    width = width_of(words, size, look.get("font-weight", "400") in ("600", "700", "bold"))
    x, y = float(element.get("x", 0)), float(element.get("y", 0))
    left = x - {"start": 0.0, "middle": 0.5, "end": 1.0}[look.get("text-anchor", "start")] * width
    box = [(left, y - ASCENT * size), (left + width, y - ASCENT * size), (left + width, y + DESCENT * size),
           (left, y + DESCENT * size)]
    turn = re.fullmatch(r"rotate\(([-\d.]+)[ ,]+([-\d.]+)[ ,]+([-\d.]+)\)", element.get("transform", ""))
    if element.get("transform") and not turn:
        raise SystemExit(f"cannot read the transform {element.get('transform')!r}")
    if turn:
        angle, cx, cy = (float(part) for part in turn.groups())
        c, s = math.cos(math.radians(angle)), math.sin(math.radians(angle))
        box = [(cx + c * (px - cx) - s * (py - cy), cy + s * (px - cx) + c * (py - cy)) for px, py in box]
    return words, box


def overlap(one, other, slack):
    """How deep two convex quadrilaterals lie in each other, along the axis where it is least; 0: apart."""
    least = math.inf
    for box in (one, other):
        for i in range(4):
            (ax, ay), (bx, by) = box[i], box[(i + 1) % 4]
            length = math.hypot(bx - ax, by - ay)
            if length == 0.0:
                continue
            nx, ny = (by - ay) / length, (ax - bx) / length
            first = [nx * x + ny * y for x, y in one]
            second = [nx * x + ny * y for x, y in other]
            least = min(least, min(max(first), max(second)) - max(min(first), min(second)))
            if least <= slack:  # most are apart along the first or second
                return 0.0
    return least


def faults_of(text):
    root = xml.etree.ElementTree.fromstring(text)
    view = [float(part) for part in root.get("viewBox").split()]
    slack = SLACK * max(view[2], view[3]) / 1000.0
    looks = Looks(root)
    boxes = []
    for element in root.iter("{http://www.w3.org/2000/svg}text"):
        words, box = corners_of(element, looks.of(element))
        if words.strip():
            boxes.append((words, box))
    faults = []
    for at, (words, box) in enumerate(boxes):
        beyond = max(max(view[0] - x, x - view[0] - view[2], view[1] - y, y - view[1] - view[3]) for x, y in box)
        if beyond > slack:
            faults.append(f"{words!r} stands {beyond:.1f} outside")
        for other_words, other in boxes[at + 1:]:
            if depth := overlap(box, other, slack):
                faults.append(f"{words!r} and {other_words!r} overlap by {depth:.1f}")
    return len(boxes), faults


PICTURE = ('<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 1000 500"><style>text{{font-size:20px}}'
           '.end{{text-anchor:end}}</style>{}</svg>')


def self_test():
    word = '<text x="{}" y="{}" class="{}"{}>{}</text>'
    cases = [
        (word.format(100, 100, "", "", "label") + word.format(100, 125, "", "", "label"), False),
        (word.format(100, 100, "", "", "label") + word.format(110, 104, "", "", "x"), True),
        (word.format(100, 100, "", "", "wide words") + word.format(190, 100, "end", "", "end"), True),
        (word.format(990, 100, "", "", "outside"), True),
        (word.format(990, 100, "end", "", "inside"), False),
        (word.format(100, 10, "", "", "high"), True),
        (word.format(100, 300, "", ' transform="rotate(-90 100 300)"', "turned words")
         + word.format(130, 250, "", "", "beside"), False),
        (word.format(100, 300, "", ' transform="rotate(-90 100 300)"', "turned words")
         + word.format(80, 250, "", "", "across"), True),
    ]
    for body, wrong in cases:
        _, faults = faults_of(PICTURE.format(body))
        if bool(faults) != wrong:
            raise SystemExit(f"self test: {body}: {faults}")
    print(f"self test: {len(cases)} pictures judged rightly")


FOUND = (0, 1, 3)  # a scene without an optimum has pictures too
LINKAGES = ("tappet_75", "tappet_90")  # slow to find a motion; without one there is no picture to look at
MILLED = ("cam_forces", "cam_grooved", "cam_conjugate", "barrel_paper_cup", "ocrf_indexing")
STUDIES = (  # folder, command, scene, the rest
    ("weights", "sweep", "drd_cubic_8", ["--weights", "simplex:6"]),
    ("weights_of_a_cam", "sweep", "cam_flat", ["--weights", "simplex:4"]),
    ("one_key", "sweep", "cam_smallest", ["--vary", "objective.base_radius=0.1:0.9:5"]),
    ("two_keys", "sweep", "cam_roller", ["--vary", "cam.base_radius_mm=16:22:4", "--vary", "limits.pressure_angle_deg=28:34:3"]),
    ("three_keys", "sweep", "drd_cubic_8", ["--vary", "spline.segments=8,12", "--vary", "objective.jerk=0.1:0.3:3",
                                            "--vary", "objective.velocity=0.2,0.4"]),
    ("front", "sweep", "drd_cubic_8", ["--pareto", "velocity,acceleration", "--points", "9"]),
    ("front_of_jerk", "sweep", "drd_spline_12", ["--pareto", "acceleration,jerk", "--points", "9"]),
    ("front_of_a_cam", "sweep", "cam_smallest", ["--pareto", "base_radius,acceleration", "--points", "5"]),
    ("laws", "compare", "cam_roller", []),
    ("laws_in_time", "compare", "pusher_set_points", []),
)


def pictures_of(program, scenes, solved, folder):
    """Draws what was solved, and studies; the pictures of all of them."""
    scenes, solved, folder = pathlib.Path(scenes), pathlib.Path(solved), pathlib.Path(folder)
    shutil.rmtree(folder, ignore_errors=True)
    for name in LINKAGES:
        if not (solved / name / "mechanism.svg").exists():
            raise SystemExit(f"{name}: no motion was found, so there is no picture to look at")
    for scene in sorted(scenes.glob("*.toml")):
        if (solved / scene.stem / "profile.svg").exists() and 'type = "linear"' not in scene.read_text():
            drawn = folder / "drawn" / scene.stem
            export = subprocess.run([program, "export", solved / scene.stem, "--out", drawn, "--drawing", "svg"],
                                    capture_output=True, text=True)
            if export.returncode not in FOUND or not (drawn / "drawing.svg").exists():
                raise SystemExit(f"{scene}: no drawing: {export.stderr}")
    for scene in MILLED:
        milled = folder / "milled" / scene
        export = subprocess.run([program, "export", solved / scene, "--out", milled, "--nc", "--cutter-mm", "12"],
                                capture_output=True, text=True)
        if export.returncode not in FOUND or not (milled / "cam_nc.svg").exists():
            raise SystemExit(f"{scene}: no tool path: {export.stderr}")
    for name, command, scene, words in STUDIES:
        result = folder / "studies" / name
        made = subprocess.run([program, command, scenes / f"{scene}.toml", "--out", result] + words,
                              capture_output=True, text=True)
        if made.returncode not in FOUND or not list(result.glob("*.svg")):
            raise SystemExit(f"{command} of {scene}: exit status {made.returncode}, no picture: {made.stderr}")
    return sorted(solved.rglob("*.svg")) + sorted(folder.rglob("*.svg"))


def main():
    if sys.argv[1:] == ["--self-test"]:
        return self_test()
    if sys.argv[1:2] == ["--scenes"]:
        pictures = pictures_of(*sys.argv[2:])
    else:
        pictures = [pathlib.Path(name) for name in sys.argv[1:]]
    wrong = words = 0
    for picture in pictures:
        count, faults = faults_of(picture.read_text(encoding="utf-8"))
        words += count
        wrong += len(faults)
        for fault in faults:
            print(f"{picture}: {fault}")
    print(f"{len(pictures)} pictures, {words} labels, {wrong} faults")
    if wrong or not words:
        sys.exit(1)


main()
