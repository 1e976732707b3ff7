# SPDX-License-Identifier: MIT
"""Random scenes of every kind of cam, of searched dimensions and angles, and machines: CLASSES maps a name to a function that draws the
files of one, {name: text}, the first of which is solved.

They are the example scenes, and those of the tests of the exact checker, with other numbers; dimensions and angles that are searched are
given instead, or the other way round. Not every draw exists (a linkage may not close), so `size` makes the changes smaller."""
import re
import sys
import tomllib
from pathlib import Path

TESTS = Path(__file__).resolve().parents[1]
SCENES = TESTS.parent / "scenes"
sys.path.append(str(TESTS / "certificates"))
import dimension_scenes  # noqa: E402
import load_scenes  # noqa: E402
import motion_scenes  # noqa: E402

NUMBER = r"(?<![\w.])-?\d+(?:\.\d+)?(?:e-?\d+)?"
GIVEN = re.compile(rf"(\w+)( *= *)({NUMBER})( *(?:#.*)?)")
BOUNDS = re.compile(r"(?!spring_harmonics)\w+ *= *\{.*\b(?:min|max)\b.*")
RANGE = re.compile(rf"\{{ *min *= *({NUMBER}), *max *= *({NUMBER}) *\}}")
ANGLE = re.compile(r"\bangle_deg *= *(\d+(?:\.\d+)?)\b")  # of a segment
STROKE = re.compile(r"(lift|rise|return|speed)_")
# By how much of itself a number changes, by its table.
SPREADS = {"motion": 0.1, "cam": 0.04, "linkage": 0.004, "forces": 0.2, "drive": 0.1, "dynamics": 0.1, "limits": 0.1, "objective": 0.4,
           "tolerance": 0.3, "clearance": 0.03}
WIDTHS = {"cam": 0.1, "linkage": 0.01}  # of the range of a dimension that is searched
DIMENSIONED = *WIDTHS, "forces", "drive"
DIMENSIONS, ANGLES, MACHINE, SMOOTH = "searched dimensions", "searched angles", "machine", "degree 7"

CHAIN = 'lever_arm_mm = 240\nlever_angle_deg = -10\nlever_branch = "right"\ncoupler_mm = 351.3\n'
ROCKER = 'rocker_pivot_x_mm = 260\nrocker_pivot_y_mm = 400\nrocker_input_arm_mm = 220\nrocker_branch = "left"\n'
LIMITS = "[limits]\npressure_angle_deg = 45\ncam_radius_min_mm = 5\n"
# The linkages that no example has: what stands in the place of that of the tappet, and its lift.
LINKAGES = {"lever": ("output_angle_deg = -5\n", "lift_deg = 11"),
            "lever_coupler_lever": (CHAIN + ROCKER + "output_angle_deg = 185\n", "lift_deg = 11"),
            "lever_coupler_slider": (CHAIN + "slider_x_mm = 110\nslider_y_mm = 350\n", "lift_mm = 60")}


def is_range(value):
    return isinstance(value, dict) and {"min", "max"} <= set(value)


def class_of(scene):
    """By what is searched, else by the degree, else by the cam."""
    segments = scene["motion"].get("segments", [])
    if scene.get("spline", {}).get("knots") == "free" or any(is_range(value) for own in segments for value in own.values()):
        return ANGLES
    if any(is_range(value) for name in DIMENSIONED for value in scene.get(name, {}).values()):
        return DIMENSIONS
    if scene.get("spline", {}).get("degree") == 7:
        return SMOOTH
    cam = scene.get("cam")
    if cam is None:
        return "motion"
    if cam["type"] in ("disk", "cylindrical"):
        return cam.get("form") or cam["follower"].replace("_", " ") + (" on a cylinder" if cam["type"] == "cylindrical" else "")
    return cam["type"]


def linkage_texts():
    before, _ = (SCENES / "tappet_75.toml").read_text().split("[linkage]")
    return [before.replace("lift_mm = 80", lift) + f'[linkage]\ntype = "{name}"\n' + linkage + LIMITS
            for name, (linkage, lift) in LINKAGES.items()]


def examples():
    """{class: texts} of what needs no other file; cams that are given have no numbers to change that would still fit each other."""
    texts = [path.read_text() for path in sorted(SCENES.glob("*.toml")) if not path.stem.startswith("given_")]
    texts += linkage_texts()
    texts += [text for module in (motion_scenes, load_scenes, dimension_scenes) for text, _ in module.TEXTS.values()]
    found = {}
    for text in texts:
        scene = tomllib.loads(text)
        if "table" in scene.get("measured", {}):
            continue
        found.setdefault(class_of(scene), []).append(text)
        if class_of(scene) == DIMENSIONS:  # and of the class it has where they are given
            found.setdefault(class_of(tomllib.loads(with_given(text, lambda ends: ends[1]))), []).append(text)
    return found


def lines_of(text):
    """(table, line)."""
    table = ""
    for line in text.splitlines():
        if header := re.fullmatch(r"\[+([\w.]+)\]+.*", line.strip()):
            table = header[1]
        yield table, line


def with_given(text, chosen):
    """Dimensions that are searched are given: `chosen` of a range."""
    return "".join((RANGE.sub(chosen, line) if table in DIMENSIONED else line) + "\n" for table, line in lines_of(text))


def changed_line(r, table, line, size, strokes):
    def moved(found):
        return f"{float(found) * (1 + size * SPREADS[table] * r.uniform(-1, 1)):.6g}"
    given = GIVEN.fullmatch(line)
    if table not in SPREADS or (given and table == "motion" and not (strokes and STROKE.match(given[1]))):
        return line
    if given:
        return given[1] + given[2] + moved(given[3]) + given[4]
    return re.sub(NUMBER, lambda found: moved(found[0]), line) if table == "limits" and BOUNDS.fullmatch(line) else line


def shifted_angles(r, text, size):
    """A part of the angle of one segment is given to another: their sum stays."""
    found = list(ANGLE.finditer(text))
    if len(found) < 2:
        return text
    first, second = sorted(r.sample(found, 2), key=lambda one: one.start())
    by = round(size * 0.1 * min(float(first[1]), float(second[1])) * r.uniform(-1, 1), 1)
    for one, other in ((second, -by), (first, by)):
        text = text[:one.start(1)] + f"{float(one[1]) + other:.10g}" + text[one.end(1):]
    return text


def changed(r, text, size):
    """Strokes of a program keep their lift, which other numbers depend on."""
    strokes = not re.search(r"\bto_|\bvia\b|corridor|\[measured\]|closed", text)
    lines = [changed_line(r, table, line, size, strokes) for table, line in lines_of(text)]
    text = shifted_angles(r, "\n".join(lines) + "\n", size)
    return re.sub(r"^segments = (\d+)\b", lambda found: f"segments = {min(int(found[1]), r.choice((8, 10, 12, 40)))}", text, flags=re.M) \
        if size > 0.5 else text


def with_dimension(r, text):
    """A dimension that is given is searched."""
    lines = list(lines_of(text))
    given = [i for i, (table, line) in enumerate(lines) if table in WIDTHS and (found := GIVEN.fullmatch(line)) and float(found[3])]
    at = r.choice(given)
    table, line = lines[at]
    found = GIVEN.fullmatch(line)
    value, width = float(found[3]), abs(float(found[3])) * WIDTHS[table]
    lines[at] = table, f"{found[1]} = {{ min = {value - width * r.random():.6g}, max = {value + width * r.uniform(0.1, 1.5):.6g} }}"
    return "\n".join(line for _, line in lines) + "\n"


def with_angles(r, text):
    """Two angles that are given are searched."""
    for one in sorted(r.sample(list(ANGLE.finditer(text)), 2), key=lambda found: -found.start()):
        value = float(one[1])
        text = f"{text[:one.start(1)]}{{ min = {0.9 * value:.6g}, max = {1.1 * value:.6g} }}{text[one.end(1):]}"
    return text


EXAMPLES = examples()
GIVEN_ALL = [text for texts in EXAMPLES.values() for text in texts if class_of(tomllib.loads(text)) not in (DIMENSIONS, ANGLES)]
CAMS = [text for text in GIVEN_ALL if "[cam]" in text]
PROGRAMS = [text for text in GIVEN_ALL if len(ANGLE.findall(text)) > 1 and not re.search("repeat|corridor", text)]
MACHINES = [*((SCENES / "machines" / f"{name}.toml") for name in ("cartoner", "knife", "shed")), TESTS / "cases/55c_press.toml",
            *sorted((TESTS / "cases").glob("machine_*/machine.toml"))]


def of_class(r, name, size):
    text = changed(r, r.choice(EXAMPLES[name]), size)
    return {"scene.toml": with_given(text, lambda ends: f"{r.uniform(float(ends[1]), float(ends[2])):.6g}")}


def searched_dimension(r, size):
    known = r.random() < 0.5
    text = changed(r, r.choice(EXAMPLES[DIMENSIONS] if known else CAMS), size)
    return {"scene.toml": text if known else with_dimension(r, text)}


def searched_angles(r, size):
    known = r.random() < 0.5
    text = changed(r, r.choice(EXAMPLES[ANGLES] if known else PROGRAMS), size)
    return {"scene.toml": text if known else with_angles(r, text)}


def machine(r, size):
    path = r.choice(MACHINES)
    text = path.read_text()
    axes = dict.fromkeys(re.findall(r'^scene = "(.*)"', text, re.M))
    return {"machine.toml": changed(r, text, size)} | {name: changed(r, (path.parent / name).read_text(), size) for name in axes}


CLASSES = {name: lambda r, size, name=name: of_class(r, name, size) for name in EXAMPLES if name not in (DIMENSIONS, ANGLES)}
CLASSES |= {DIMENSIONS: searched_dimension, ANGLES: searched_angles, MACHINE: machine}
