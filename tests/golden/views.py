# SPDX-License-Identifier: MIT
"""Every file that camopt writes as lines to be read and compared: all its words, its numbers thinned where they are many.

Of lines with the same words, numbers apart, the first, the last and each N-th stay (KEPT of them), with how many there are."""

import csv
import html
import io
import json
import re
import struct
import xml.etree.ElementTree
import zlib

KEPT = 4  # of lines with the same words, and of the items of a list
FEW = 6  # up to so many are kept all
WIDE = 12  # numbers in a line that are kept all
DIGITS = 8  # of a number, significant
SHORT_LINE = 130  # letters of a table that stands in one line

NUMBER = re.compile(r"(?<![a-zàµµ_\d.])[-+−]?(?:\d+(?:\.\d*)?|\.\d+)(?:[eE][-+]?\d+)?|~0")

COLOUR = re.compile(r"#[0-9a-f]{6}\b")

# What differs between two runs or two machines: name, pattern, what stands instead.
RULES = [(name, re.compile(pattern), instead) for name, pattern, instead in (
    ("version", r"\bcamopt \d+\.\d+\.\d+", "camopt <version>"),
    ("version", r'("camopt": )"[^"]*"', r'\1"<version>"'),
    ("date", r"\b20\d\d-\d\d-\d\d([T ]\d\d:\d\d:\d\d(\.\d+)?(Z|[-+]\d\d:?\d\d)?)?", "<date>"),
    ("seconds", r"(exchange rounds:? \d+\)?|starts:? \d+\)?|iterations:? \d+\)?|solving:|speeds tried|prescribed|not used)([,;]?) "
                r"[\d.e-]+ s\b", r"\1\2 <seconds> s"),
    ("seconds", r'("[a-z_]*seconds": )[\d.e+-]+', r"\1<seconds>"),
    ("seconds", r"(search for changes [a-z ]+) [\d.e-]+ s\b( of [\d.]+ s)?", r"\1 <seconds> s"),
    ("seconds", r"[\d.e-]+ s in all\b", "<seconds> s in all"),
    ("effort", r"(\b(?:iterations|exchange rounds|evaluations|starts|speeds tried|bound passes|nodes))(:?) \d+", r"\1\2 <n>"),
    ("effort", r"\b\d+ (speeds tried|solves)", r"<n> \1"),
    ("effort", r'("(iterations|exchange_rounds|rounds|passes|nodes|starts_run|[a-z_]*evaluations|profile_points|[a-z_]*_calls)": )\d+',
     r"\1<n>"),
    ("solvers", r'("auto", "structured")(, "[a-z._]+")+', r"\1, <solvers>"),
    ("multipliers", r'("multipliers?": ).*?(,?)$', r"\1<multipliers>\2"),
    ("round-off", r'("(gap|stationarity|worst_violation|relative|primal|dual|complementarity)": )-?(\d\.?\d*e-(0[7-9]|[1-9]\d)|0\.0)',
     r"\1~0"),
)]


def cleaned(line):
    for _, pattern, instead in RULES:
        line = pattern.sub(instead, line)
    return NUMBER.sub(lambda found: shortened(found[0]), line).rstrip()


def shortened(text):
    """A number without digits that say nothing; of one that is round-off only this."""
    if 0.0 < abs(value_of(text)) < 1e-7:
        return "~0"
    if len(text) > DIGITS and "." in text and "−" not in text:
        return f"{float(text):.{DIGITS}g}"
    return text


def value_of(text):
    return 0.0 if text == "~0" else float(text.replace("−", "-"))


def words_of(line):
    return NUMBER.sub("#", line)


def alike(line):
    """What lines with the same words have in common, however many numbers stand in a list."""
    return re.sub(r"#( #)+|#-(?=\")|#[0-9a-f]{6}\b", "#", words_of(COLOUR.sub("#", line)))


def kept_places(count):
    """Of `count` alike things: all of a few, else the first, the last and each N-th."""
    if count <= FEW:
        return list(range(count))
    step = -(-(count - 1) // (KEPT - 1))
    return sorted({*range(0, count, step), count - 1})


def thinned(lines, key=alike, sums=False):
    """Lines, or blocks of them, of which those that are alike are thinned; each group's number stands at the end, with `sums` the sum
    of all their numbers too."""
    def sum_of(places):
        numbers = (NUMBER.findall(COLOUR.sub("", lines[place])) for place in places) if sums else ()
        return f", sum {sum(value_of(text) for found in numbers for text in found):.6g}" if sums else ""

    groups = {}
    for place, line in enumerate(lines):
        groups.setdefault(key(line), []).append(place)
    kept = sorted(places[i] for places in groups.values() for i in kept_places(len(places)))
    counts = [f"… {len(places)} alike{sum_of(places)}: {name.strip()[:100]}" for name, places in groups.items() if len(places) > FEW]
    return [lines[place] for place in kept] + counts


def number_list(numbers):
    kept = [str(numbers[place]) for place in (range(len(numbers)) if len(numbers) <= WIDE else kept_places(len(numbers)))]
    return f"[#{len(numbers)}] " + " ".join(kept)


def without_effort(text):
    """A table without the numbers of its columns of seconds and of effort."""
    rows = list(csv.reader(io.StringIO(text)))
    left_out = {i for i, name in enumerate(rows[0] if rows else []) if EFFORT.search(name)}
    if not left_out:
        return text.splitlines()
    return [",".join("<n>" if i in left_out and row is not rows[0] and cell else f'"{cell}"' if "," in cell else cell
                     for i, cell in enumerate(row)) for row in rows]


EFFORT = re.compile(r"^seconds|_seconds$|^iterations$|^exchange_rounds$|_evaluations$|^profile_points$")


def is_number(value):
    return isinstance(value, (int, float)) and not isinstance(value, bool)


def timeless(value):
    """Without the seconds of the parts of a solve."""
    if isinstance(value, dict):
        return {key: dict.fromkeys(item, "<seconds>") if key == "seconds" and isinstance(item, dict) else timeless(item)
                for key, item in value.items()}
    return [timeless(item) for item in value] if isinstance(value, list) else value


def of_json(value, key="", indent="", kinds=False):
    """A line for each scalar and each list of numbers; of lists of alike tables some. With `kinds` of such lists one table of each
    kind, without its numbers, in alphabetical order."""
    head = indent + (json.dumps(key, ensure_ascii=False) + ": " if key else "")
    short = json.dumps(value, ensure_ascii=False) if key or not indent else ""
    if len(head + short) <= SHORT_LINE and short:
        return [head + short]
    inner = indent + " "
    if isinstance(value, dict):
        return [head + "{", *(line for name, item in value.items() for line in of_json(item, name, inner, kinds)), indent + "}"]
    if isinstance(value, list):
        if value and all(is_number(item) or item is None for item in value):
            return [head + number_list(["null" if item is None else item for item in value])]
        blocks = ["\n".join(of_json(item, "", inner, kinds)) for item in value]
        if kinds and len(value) > FEW:
            return [head + "[", *(line for block in sorted({alike(block) for block in blocks}) for line in block.split("\n")), indent + "]"]
        return [head + f"[{len(value)}", *(line for block in thinned(blocks) for line in block.split("\n")), indent + "]"]
    if isinstance(value, str) and value.startswith("<svg"):  # written as a file too
        value = [word for word in re.findall(r">([^<>\n]+)</text>", value) if not NUMBER.fullmatch(word)]
        return [head + "the picture's words:", *(inner + word for word in thinned(value))]
    return [head + json.dumps(value, ensure_ascii=False)]


def long_lists(text):
    """Words with the numbers of a path or of points in one list."""
    numbers = NUMBER.findall(text)
    if len(numbers) <= WIDE:
        return text
    commands = re.sub(r"[^A-Za-z]", "", text)
    return re.sub(r"(.)\1+", lambda run: f"{run[1]}{len(run[0])}", commands) + number_list(numbers)


def of_xml(text):
    """One element a line; of alike ones some."""
    lines = []

    def walk(element, indent):
        name = element.tag.rpartition("}")[2]
        attributes = "".join(f' {key.rpartition("}")[2]}="{long_lists(item)}"' for key, item in element.attrib.items())
        inside = (element.text or "").strip()
        lines.extend(f"{indent}<{name}{attributes}> {inside}".rstrip().split("\n") if name != "style" else
                     [f"{indent}<style> {rule}" for rule in re.findall(r"[^{}]+\{[^{}]*\}|.+$", inside)])
        for child in element:
            walk(child, indent + " ")
            if (child.tail or "").strip():
                lines.append(indent + " " + child.tail.strip())

    walk(xml.etree.ElementTree.fromstring(text), "")
    return thinned(lines, sums=True)


def of_page(text):
    """The data of a page, and the words of its body; its style, its scripts and its licences are sources."""
    data = re.search(r'<script type="application/json" id="page-data">(.*?)</script>', text, re.DOTALL)
    words = re.sub(r"<(script|style)\b.*?</\1>", "", text, flags=re.DOTALL)
    words = [html.unescape(line).strip() for line in re.sub(r"<[^>]*>", "\n", words).split("\n")]
    return [*filter(None, words), *(of_json(json.loads(data[1])) if data else [])]


def of_dxf(text):
    """One entity a line: its group codes and values."""
    lines = text.splitlines()
    entities = []
    for code, value in zip(lines[::2], lines[1::2]):
        if code.strip() in HANDLES:
            continue
        if code.strip() in ("0", "9") or not entities:
            entities.append("")
        entities[-1] += f" {code.strip()}={value.strip()}"
    return thinned([entity.strip() for entity in entities], sums=True)


HANDLES = ("5", "105", "330", "340", "360", "390")  # numbers of entities of DXF


def of_step(text):
    """The head; how many entities of each kind, and the least and greatest coordinates: the numbers of entities differ between
    versions of Open CASCADE."""
    head, _, data = text.partition("DATA;")
    words = [word for word in re.findall(r"'([^']*)'", head) if word]
    kinds = {}
    for kind in re.findall(r"^#\d+ ?= ?\(?\s*([A-Z_0-9]+)", data, re.M):
        kinds[kind] = kinds.get(kind, 0) + 1
    points = [tuple(map(float, point.split(","))) for point in re.findall(r"CARTESIAN_POINT\('[^']*',\(([^()]*)\)\)", data)]
    points = [point for point in points if len(point) == 3]
    ends = [f"{name} {round(least(p[axis] for p in points), 6)}" for axis in range(3) for name, least in
            ((f"{'xyz'[axis]} from", min), (f"{'xyz'[axis]} to", max))] if points else []
    return [text.partition("\n")[0], *(word for word in words if "Open CASCADE" not in word), *(f"{kind} {count}" for kind, count in sorted(kinds.items())
                                                                      if kind in KINDS_OF_STEP), *ends]


KINDS_OF_STEP = {"ADVANCED_FACE", "B_SPLINE_SURFACE_WITH_KNOTS", "CLOSED_SHELL", "CYLINDRICAL_SURFACE", "MANIFOLD_SOLID_BREP", "PLANE",
                 "PRODUCT", "OPEN_SHELL", "SHELL_BASED_SURFACE_MODEL"}


def of_stl(data):
    """Of a binary solid: the triangles, the box, the volume."""
    count = struct.unpack_from("<I", data, 80)[0]
    volume, low, high = 0.0, [float("inf")] * 3, [-float("inf")] * 3
    for at in range(count):
        corner = struct.unpack_from("<9f", data, 84 + 50 * at + 12)
        a, b, c = corner[0:3], corner[3:6], corner[6:9]
        volume += (a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0]) + a[2] * (b[0] * c[1] - b[1] * c[0])) / 6.0
        for axis in range(3):
            low[axis] = min(low[axis], a[axis], b[axis], c[axis])
            high[axis] = max(high[axis], a[axis], b[axis], c[axis])
    head = data[:80].rstrip(b"\0 ").decode("ascii", "replace")
    return [head, f"triangles {count}", f"volume {volume:.6g}", *(f"{'xyz'[axis]} {low[axis]:.7g} to {high[axis]:.7g}" for axis in range(3))]


def of_pdf(data):
    """The sheets, and what is drawn on them, without positions: cairo's, compressed."""
    streams = []
    for found in re.finditer(rb"stream\r?\n(.*?)\r?\nendstream", data, re.DOTALL):
        try:
            streams.append(zlib.decompress(found[1]))
        except zlib.error:
            pass
    boxes = re.findall(rb"/MediaBox \[([^\]]*)\]", data)
    return [f"sheet {' '.join(box.decode().split())}" for box in boxes] + [f"something is drawn: {any(b' re' in s or b' l' in s for s in streams)}"]


def lines_of(name, data):
    """Of a file by the end of its name; of the console ("") and of Markdown every line."""
    end = name.rpartition(".")[2].lower() if "." in name else ""
    if end == "stl" and not data.startswith(b"solid "):
        lines = of_stl(data)
    elif end == "pdf":
        lines = of_pdf(data)
    else:
        text = data.decode("utf-8").replace("\r\n", "\n")
        if end == "json":  # rows of proofs: scripts/verify-certificate holds their numbers
            lines = of_json(timeless(json.loads(text)), kinds=name.endswith(("certificate.json", "impossible.json")))
        elif end in ("svg", "xml", "l5x"):
            lines = of_xml(text)
        elif end == "html":
            lines = of_page(text)
        elif end == "dxf":
            lines = of_dxf(text)
        elif end in ("step", "stp"):
            lines = of_step(text)
        elif end in ("", "md", "toml", "txt"):  # a paragraph whose breaks depend on seconds in one line
            lines = re.sub(r"The search for changes[^\n]*(?:\n  (?:[a-z0-9]|Not )[^\n]*)*", lambda found: " ".join(found[0].split()),
                           text).splitlines()
        else:
            lines = thinned(without_effort(text) if end == "csv" else text.splitlines())
    return [cleaned(part) for line in lines for part in line.split("\n")]
