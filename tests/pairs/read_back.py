# SPDX-License-Identifier: MIT
"""Reads the files of a result back, each as the program that it is for would: read(path, result) raises AssertionError where it is
broken, and returns nothing. `result`: the folder of the solved scene, whose motion tables and controllers must have."""

import csv
import html.parser
import json
import math
import re
import struct
import xml.etree.ElementTree as ElementTree

# Text of others that a reader would obey; each file has it, if at all, escaped.
ACTIVE = "<script>alert(1)</script>"


def finite(value):
    assert math.isfinite(value), value
    return value


def rows_of(path):
    """Header and rows of a CSV file; numbers are finite, and every row has as many cells as the header."""
    with open(path, encoding="utf-8", newline="") as file:
        lines = [line for line in csv.reader(line for line in file if not line.startswith("#")) if line]
    header, rows = lines[0], lines[1:]
    assert len(set(header)) == len(header), header
    for row in rows:
        assert len(row) == len(header), (path.name, header, row)
        for cell in row:
            assert cell.lower() not in ("nan", "inf", "-inf", "infinity"), (path.name, cell)
    return header, rows


def curve_of(path):
    """[(angle in degrees, displacement)] of a table with the columns theta_deg and s_…, and the displacement's unit."""
    header, rows = rows_of(path)
    s = next(i for i, name in enumerate(header) if re.fullmatch(r"s_\w+", name))
    theta = header.index("theta_deg")
    return [(float(row[theta]), float(row[s])) for row in rows], header[s]


def value_at(curve, angle):
    for (a, s), (b, t) in zip(curve, curve[1:]):
        if a <= angle <= b:
            return s if b == a else s + (t - s) * (angle - a) / (b - a)
    return curve[-1][1]


def table_has_motion(path, result):
    wanted, unit = curve_of(result / "motion.csv")
    found, own = curve_of(path)
    if (own, unit) == ("s_in", "s_mm"):  # files keep the units of their columns: motion.csv is in mm
        found = [(angle, 25.4 * s) for angle, s in found]
    else:
        assert own == unit, (own, unit)
    size = max(abs(s) for _, s in wanted) or 1.0
    assert len(found) > 10
    for angle, s in found:
        assert abs(s - value_at(wanted, angle)) < 2e-3 * size, (path.name, angle, s, value_at(wanted, angle))


def read_csv(path, result):
    header, rows = rows_of(path)
    assert rows, path.name
    for row in rows:
        for cell in row:
            assert not cell.startswith(("=", "+1+", "@")), (path.name, cell)
    if path.name == "table.csv":
        table_has_motion(path, result)


def read_json(path, _):
    def refuse(word):
        raise AssertionError(f"{path.name}: {word} is no JSON")
    json.loads(path.read_text(encoding="utf-8"), parse_constant=refuse)


class Elements(html.parser.HTMLParser):
    def __init__(self):
        super().__init__()
        self.inside, self.text, self.headings = None, {}, []

    def handle_starttag(self, tag, attributes):
        self.inside = dict(attributes).get("id") if tag == "script" else tag
        if tag == "script":
            self.text.setdefault(self.inside, "")

    def handle_endtag(self, tag):
        self.inside = None

    def handle_data(self, data):
        if self.inside in self.text:
            self.text[self.inside] += data
        assert "alert(1)" not in data or self.inside in ("page-data", "title"), (self.inside, data[:80])


def read_html(path, _):
    page = Elements()
    page.feed(path.read_text(encoding="utf-8"))
    data = json.loads(page.text["page-data"])
    for curve in data.get("curves", []):
        assert len(curve["values"]) == len(data["angle"]["values"]), curve["key"]
    for table in data.get("tables", []):
        if "items" in table:
            rows = len(table["items"]["names"])
            assert rows and all(len(column["values"]) == rows for column in table["columns"]), table["key"]
            continue
        assert table["rows"], table["key"]
        for row in table["rows"]:
            assert len(row) == len(table["columns"]), (table["key"], row)


LINES = ("optimum", "row-line", "reference", "measured", "limit-line", "limit", "segment", "set-region", "optimum-line", "l0", "l1")


def read_svg(path, _):
    text = path.read_text(encoding="utf-8")
    root = ElementTree.fromstring(text)
    assert root.tag.endswith("}svg"), root.tag
    for element in root.iter():
        assert not element.tag.endswith("}script")
        for name, value in element.attrib.items():
            assert not name.startswith("on") and "href" not in name, (name, value)
            assert not re.search(r"\b(nan|inf)\b", value), (path.name, name, value[:60])
    style = "".join(element.text or "" for element in root.iter() if element.tag.endswith("}style"))
    for element in root.iter():
        css = element.get("class", "").split()
        if element.tag.endswith("}path") and any(name in LINES for name in css):
            ruled = [rule for name in css for rule in re.findall(r"(?:^|[},])\." + re.escape(name) + r"[^{]*\{([^}]*)", style)]
            assert re.search(r"(^|})path\{fill:none", style) or any("fill:none" in rule for rule in ruled), (path.name, css, "is filled")


def read_dxf(path, _):
    lines = path.read_text(encoding="utf-8").splitlines()
    assert len(lines) % 2 == 0 and lines[-1].strip() == "EOF", path.name
    entities = 0
    for code, value in zip(lines[::2], lines[1::2]):
        number = int(code)
        if 10 <= number < 60:
            finite(float(value))
        entities += number == 0 and value.strip() in ("LINE", "ARC", "CIRCLE", "LWPOLYLINE", "POLYLINE", "SPLINE")
    assert entities, path.name


def read_pdf(path, _):
    text = path.read_bytes()
    assert text.startswith(b"%PDF-") and text.rstrip().endswith(b"%%EOF"), path.name
    at = int(re.search(rb"startxref\s+(\d+)\s+%%EOF", text).group(1))
    assert text[at:at + 4] == b"xref", path.name
    assert b"/JavaScript" not in text and b"/URI" not in text


def read_step(path, _):
    text = path.read_text(encoding="utf-8")
    assert text.startswith("ISO-10303-21;") and text.rstrip().endswith("END-ISO-10303-21;"), path.name
    data = re.sub(r"'(?:[^']|'')*'", "''", text)
    defined = set(re.findall(r"^#(\d+)\s*=", data, re.MULTILINE))
    used = set(re.findall(r"#(\d+)", data))
    assert defined and used <= defined, sorted(used - defined)[:5]


def read_stl(path, _):
    data = path.read_bytes()
    count = struct.unpack_from("<I", data, 80)[0]
    assert count > 0 and len(data) == 84 + 50 * count, (path.name, count, len(data))
    for i in range(count):
        for value in struct.unpack_from("<12f", data, 84 + 50 * i):
            finite(value)


def read_nc(path, _):
    text = path.read_text(encoding="ascii")
    assert re.search(r"\bM30\b|\bM2\b|\bM02\b", text), path.name
    moves = 0
    for line in text.splitlines():
        code = re.sub(r"\([^()]*\)", "", line)
        assert "(" not in code and ")" not in code, line
        moves += bool(re.search(r"[XYZ]-?\d", code))
    assert moves > 10, moves


def read_md(path, _):
    text = path.read_text(encoding="utf-8")
    assert text.startswith("# "), text[:40]
    fenced = re.sub(r"^(`{3,})[^\n]*\n.*?^\1$", "", text, flags=re.DOTALL | re.MULTILINE)
    spoken = re.sub(r"(?<!\\)(`+)(?!`).*?(?<!`)\1(?!`)", "", fenced)
    assert not re.search(r"(?<!\\)<[A-Za-z/!?]", spoken), re.search(r"(?<!\\)<[A-Za-z/!?].{0,40}", spoken).group(0)
    for target in re.findall(r"(?<!\\)\]\(([^)]*)\)", spoken):
        assert re.fullmatch(r"[A-Za-z0-9_./-]+\.(svg|png|md)", target), target
        assert target.endswith((".svg", ".png")) or (path.parent / target).is_file(), target


def read_controller(path, _):
    text = path.read_text(encoding="utf-8")
    assert not re.search(r"\b(nan|inf)\b", text, re.IGNORECASE), path.name
    if path.suffix in (".st", ".scl"):
        # A comment ends where its writer ended it.
        assert not re.search(r"\*\)", re.sub(r"\(\*.*?\*\)", "", re.sub(r"//[^\n]*", "", text), flags=re.DOTALL)), path.name
    assert len(re.findall(r"\d+\.\d+", text)) > 4, path.name


def read_any(path, _):
    assert path.stat().st_size > 0, path.name


READERS = {".csv": read_csv, ".json": read_json, ".html": read_html, ".svg": read_svg, ".dxf": read_dxf, ".pdf": read_pdf,
           ".step": read_step, ".stl": read_stl, ".nc": read_nc, ".md": read_md, ".st": read_controller, ".scl": read_controller,
           ".txt": read_any, ".toml": read_any}


def read(path, result):
    READERS[path.suffix](path, result)
