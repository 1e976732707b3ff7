# SPDX-License-Identifier: MIT
"""step_read_back.py FOLDER: every NAME.step in the folder, parsed here from its text and evaluated by de Boor's
recurrence, is in mm and passes the points of NAME.csv within 1e-6 mm at their own parameters: u = cam angle, rad;
v = height along the roller, m. Each point lies on a patch of the flank whose name its face carries.

Python's standard library only: nothing of the program that wrote the file. Exit status 77 where there is none.
"""

import csv
import math
import pathlib
import re
import sys

TOLERANCE_MM = 1e-6
ENTITY = re.compile(r"#(\d+)\s*=\s*(.*?);\s*(?=#\d+\s*=|ENDSEC)", re.DOTALL)
TOKEN = re.compile(r"'((?:[^']|'')*)'|(\()|(\))|(,)|([^'(),\s]+)")


def parsed(text):
    """The parameters of an entity as nested lists of strings: [NAME, [parameters], NAME, [parameters] …]."""
    stack = [[]]
    for string, opens, closes, comma, word in TOKEN.findall(text):
        if opens:
            stack.append([])
        elif closes:
            done = stack.pop()
            stack[-1].append(done)
        elif not comma:
            stack[-1].append(word or string)
    assert len(stack) == 1, text[:80]
    return stack[0]


def knots_of(multiplicities, values):
    return [float(value) for count, value in zip(multiplicities, values) for _ in range(int(count))]


class Surface:
    def __init__(self, entities, number):
        parameters = parsed(entities[number])[1]
        (self.name, degree_u, degree_v, poles, _, _, _, _, counts_u, counts_v, values_u, values_v, _) = parameters
        self.degree_u, self.degree_v = int(degree_u), int(degree_v)
        self.knots_u, self.knots_v = knots_of(counts_u, values_u), knots_of(counts_v, values_v)
        self.poles = [[point_of(entities, pole) for pole in row] for row in poles]
        assert len(self.poles) + self.degree_u + 1 == len(self.knots_u)
        assert len(self.poles[0]) + self.degree_v + 1 == len(self.knots_v)

    def holds(self, u, v):
        return self.knots_u[0] <= u <= self.knots_u[-1] and self.knots_v[0] <= v <= self.knots_v[-1]

    def at(self, u, v):
        span = span_of(self.knots_u, self.degree_u, u)
        rows = self.poles[span - self.degree_u:span + 1]
        along = [de_boor(row, self.knots_v, self.degree_v, v) for row in rows]
        return blended(along, self.knots_u, self.degree_u, u, span)


def point_of(entities, reference):
    name, (_, coordinates) = parsed(entities[int(reference[1:])])
    assert name == "CARTESIAN_POINT"
    return tuple(float(x) for x in coordinates)


def span_of(knots, degree, x):
    last = len(knots) - degree - 2
    span = degree
    while span < last and x >= knots[span + 1]:
        span += 1
    return span


def de_boor(poles, knots, degree, x):
    span = span_of(knots, degree, x)
    return blended(poles[span - degree:span + 1], knots, degree, x, span)


def blended(poles, knots, degree, x, span):
    """de Boor's recurrence over the degree + 1 poles that count at x."""
    d = list(poles)
    for r in range(1, degree + 1):
        for j in range(degree, r - 1, -1):
            left = knots[span - degree + j]
            share = (x - left) / (knots[span + 1 + j - r] - left)
            d[j] = tuple((1 - share) * a + share * b for a, b in zip(d[j - 1], d[j]))
    return d[degree]


def check(path):
    text = path.read_text()
    assert text.startswith("ISO-10303-21;") and text.rstrip().endswith("END-ISO-10303-21;")
    assert "AUTOMOTIVE_DESIGN" in text
    entities = {int(number): body for number, body in ENTITY.findall(text)}
    lengths = [body for body in entities.values() if "LENGTH_UNIT" in body and "SI_UNIT" in body]
    assert lengths and all(re.search(r"SI_UNIT\(\.MILLI\.,\.METRE\.\)", body) for body in lengths), lengths
    surfaces = {}  # by the name of the face
    for body in entities.values():
        if body.startswith("ADVANCED_FACE"):
            name, _, surface, _ = parsed(body)[1]
            assert entities[int(surface[1:])].startswith("B_SPLINE_SURFACE_WITH_KNOTS")
            surfaces.setdefault(name, []).append(Surface(entities, int(surface[1:])))
    with open(path.with_suffix(".csv"), newline="") as file:
        rows = list(csv.DictReader(file))
    assert {row["flank"] for row in rows} == {"1", "-1"}
    worst, found = 0.0, 0
    for row in rows:
        u, v = math.radians(float(row["theta_deg"])), float(row["h_mm"]) * 1e-3
        wanted = tuple(float(row[key]) for key in ("x_mm", "y_mm", "z_mm"))
        ends = 1e-12  # degrees to radians and back
        flank = f"flank {int(row['flank']):+d}"
        holding = [s for name, patches in surfaces.items() if name.startswith(flank) for s in patches
                   if s.holds(min(max(u, s.knots_u[0]), s.knots_u[0] + ends) if abs(u - s.knots_u[0]) < ends else
                              s.knots_u[-1] if abs(u - s.knots_u[-1]) < ends else u,
                              s.knots_v[0] if abs(v - s.knots_v[0]) < ends else
                              s.knots_v[-1] if abs(v - s.knots_v[-1]) < ends else v)]
        assert holding, f"{path.name}: no patch of {flank} holds the point {row}"
        for surface in holding:
            u_in = min(max(u, surface.knots_u[0]), surface.knots_u[-1])
            v_in = min(max(v, surface.knots_v[0]), surface.knots_v[-1])
            worst = max(worst, math.dist(surface.at(u_in, v_in), wanted))
            found += 1
    patches = sum(len(group) for group in surfaces.values())
    print(f"{path.name}: {patches} faces, {len(rows)} points, {found} evaluations, largest distance {worst:.3g} mm")
    assert worst <= TOLERANCE_MM, f"{path.name}: {worst} mm"


def main():
    folder = pathlib.Path(sys.argv[1])
    assert list(folder.glob("*.csv")), f"no sample in {folder}"
    files = sorted(folder.glob("*.step"))
    if not files:
        print("this build writes no STEP files")
        sys.exit(77)
    for path in files:
        check(path)


main()
