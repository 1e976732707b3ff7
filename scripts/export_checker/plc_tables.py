# SPDX-License-Identifier: MIT
"""Electronic-cam files read as the controllers read them. Numbers are exact fractions of the floats that the controller
holds, so that no digit is lost here.

A piece is (begin, end, [c0, c1, …]): slave = Σ c_k (master − begin)^k, master in degrees, slave in mm or degrees. Pieces are in the order
of their rows.
"""
import re
import struct

from certificate_checker.exact import Refuted
from certificate_checker.rational import Fraction

ELEMENT = re.compile(r"\w+(?:\.\w+)*\[(\d+)\]\.(\w+)\s*:=\s*([^;]+);")
FIELD = re.compile(r"(?<![\w\]])(\w+\.\w+)\s*:=\s*([^;]+);")
SAME_END = Fraction(1, 10**6)
SAME_JERK, LAST_DIGITS = Fraction(1, 10**9), Fraction(1, 10**13)  # of the jerk; of the states that it follows from
# Columns: what one unit of s0, s1, v0·h, v1·h, a0·h², a1·h² gives to c0 … c5 over u = t / h.
QUINTIC = [[1, 0, 0, -10, 15, -6], [0, 0, 0, 10, -15, 6], [0, 1, 0, -6, 8, -3], [0, 0, 0, -4, 7, -3],
           [0, 0, Fraction(1, 2), Fraction(-3, 2), Fraction(3, 2), Fraction(-1, 2)],
           [0, 0, 0, Fraction(1, 2), -1, Fraction(1, 2)]]
# The same with j0·h³, j1·h³, and c0 … c7.
SEPTIC = [[Fraction(part) for part in row.split()] for row in (
    "1 0 0 0 -35 84 -70 20", "0 0 0 0 35 -84 70 -20", "0 1 0 0 -20 45 -36 10", "0 0 0 0 -15 39 -34 10", "0 0 1/2 0 -5 10 -15/2 2",
    "0 0 0 0 5/2 -7 13/2 -2", "0 0 0 1/6 -2/3 1 -2/3 1/6", "0 0 0 0 -1/6 1/2 -1/2 1/6")]


def demand(holds, place, what):
    """A table that contradicts itself is refused, naming the place."""
    if not holds:
        raise Refuted(f"{place}: {what}")


def real(text):
    """A REAL: the nearest float32."""
    return Fraction(struct.unpack("f", struct.pack("f", float(text)))[0])


def lreal(text):
    return Fraction(float(text))


def assignments(text):
    """{index: {field: text}}, {"Cam.nElements": text} of structured text."""
    code = "\n".join(line.split("//")[0] for line in text.splitlines())
    elements = {}
    for index, field, value in ELEMENT.findall(code):
        demand(field not in elements.setdefault(int(index), {}), f"element {index}", f"{field} is assigned twice")
        elements[int(index)][field] = value.strip()
    return elements, {field: value.strip() for field, value in FIELD.findall(code)}


def hermite(start, end):
    """Of two states (x, s, v, a) a quintic, of two (x, s, v, a, j) a polynomial of degree 7."""
    h = end[0] - start[0]
    demand(h > 0, f"master {float(start[0])}", f"is followed by {float(end[0])}")
    ends = [own * h**r for r, both in enumerate(zip(start[1:], end[1:])) for own in both]
    scaled = [sum(weight * part for weight, part in zip(ends, column)) for column in zip(*(QUINTIC if len(ends) == 6 else SEPTIC))]
    return start[0], end[0], [c / h**k for k, c in enumerate(scaled)]


def demand_jerk(text, piece, at_end, place, name):
    """A jerk that a file states beside states from which the curve follows: that of the piece at its beginning or its end."""
    begin, end, c = piece
    h = end - begin
    c = [*c, *[Fraction(0)] * (6 - len(c))]
    jerk = 6 * c[3] + (24 * c[4] * h + 60 * c[5] * h**2 if at_end else 0)
    states = 60 * (abs(c[0]) + max(abs(own) * h**k for k, own in enumerate(c))) / h**3
    demand(abs(lreal(text) - jerk) <= SAME_JERK * abs(jerk) + LAST_DIGITS * states, place, f"{name} is {text}, the curve has {float(jerk)}")


def lines(points):
    for a, b in zip(points, points[1:]):
        demand(b[0] > a[0], f"master {float(a[0])}", f"is followed by {float(b[0])}")
    return [(a[0], b[0], [a[1], (b[1] - a[1]) / (b[0] - a[0])]) for a, b in zip(points, points[1:])]


def codesys(text, _):
    elements, fields = assignments(text)
    demand(fields["Cam.byType"] == "SMC_CAM_TYPE.XYVA", "Cam.byType", fields["Cam.byType"])
    demand(int(fields["Cam.nElements"]) == len(elements), "Cam.nElements", f"{fields['Cam.nElements']} of {len(elements)} elements")
    knots = [[lreal(elements[i][name]) for name in ("dX", "dY", "dV", "dA")] for i in range(len(elements))]
    for name, knot in (("Cam.xStart", knots[0]), ("Cam.xEnd", knots[-1])):
        demand(lreal(fields[name]) == knot[0], name, f"{fields[name]}, the point has {float(knot[0])}")
    return [hermite(a, b) for a, b in zip(knots, knots[1:])]


def codesys_ascii(text, _):
    knots = [[lreal(cell) for cell in line.split(";")] for line in text.splitlines()]
    return [hermite(a, b) for a, b in zip(knots, knots[1:])]


def twincat(text, _):
    knots, elements = twincat_points(text, "POLYNOM5_MM")
    pieces = [hermite(a[:4], b[:4]) for a, b in zip(knots, knots[1:])]
    for index, piece in enumerate([*pieces, pieces[-1]], 1):
        demand_jerk(elements[index]["SlaveJerk"], piece, index == len(knots), f"point {index}", "SlaveJerk")
    return pieces


def twincat7(text, _):
    knots, _ = twincat_points(text, "POLYNOM7_MM")
    return [hermite(a, b) for a, b in zip(knots, knots[1:])]


def twincat_points(text, function):
    """States (x, s, v, a, j), and the fields of each point."""
    elements, fields = assignments(text)
    count = int(fields["Cam.NoOfRows"])
    demand(sorted(elements) == list(range(1, count + 1)), "Cam.NoOfRows", f"{count} of {len(elements)} points")
    for index, element in elements.items():
        following = 0 if index == count else 1
        for name, value in (("PointIndex", str(index)), ("FunctionType", "MOTIONFUNCTYPE_" + function),
                            ("PointType", "MOTIONPOINTTYPE_MOTION"), ("RelIndexNextPoint", str(following))):
            demand(element[name] == value, f"point {index}", f"{name} is {element[name]}, not {value}")
    for name, value in (("Cam.TableType", "MC_TABLETYPE_MOTIONFUNCTION"), ("Cam.NoOfColumns", "1")):
        demand(fields[name] == value, name, f"{fields[name]}, not {value}")
    names = ("MasterPos", "SlavePos", "SlaveVelo", "SlaveAcc", "SlaveJerk")
    return [[lreal(elements[i + 1][name]) for name in names] for i in range(count)], elements


def siemens(text, _):
    elements, _ = assignments(text)
    pieces = []
    for index in sorted(elements):
        one = elements[index]
        start, end = ([lreal(one[name + side]) for name in ("leadingValue", "followingValue", "geoVelo", "geoAccel")]
                      for side in ("Start", "End"))
        if int(one["camProfileType"]) == 2:
            demand(start[2:] == end[2:] == [0, 0] and end[1] == start[1], f"element {index}", "a dwell that moves")
            pieces.append((start[0], end[0], [start[1]]))
        else:
            demand(int(one["camProfileType"]) == 5, f"element {index}", f"camProfileType {one['camProfileType']}")
            demand(start[1] != end[1], f"element {index}", "ends where it begins, which the block refuses")
            pieces.append(hermite(start, end))
        for name, at_end in (("geoJerkStart", False), ("geoJerkEnd", True)):
            demand_jerk(one[name], pieces[-1], at_end, f"element {index}", name)
    return pieces


def br(text, units):
    elements, fields = assignments(text)
    count = int(fields["Cam.PolynomialNumber"])
    demand(count == len(elements) <= 128, "Cam.PolynomialNumber", f"{count} of {len(elements)} polynomials")
    master, slave = lreal(units["master_deg"]), lreal(units["slave"])
    pieces, begin = [], Fraction(0)
    for index in range(len(elements)):
        end = real(elements[index]["x"]) * master
        pieces.append((begin, end, [real(elements[index][name]) * slave / master**k
                                    for k, name in enumerate("abcdefg")]))
        begin = end
    demand(pieces[0][2][0] == 0, "polynomial 0", "does not begin at 0")
    demand(begin == int(fields["Cam.MasterPeriod"]) * master, "Cam.MasterPeriod", f"the last polynomial ends at {float(begin)} deg")
    last = pieces[-1]
    reached = sum(c * (last[1] - last[0])**k for k, c in enumerate(last[2])) / slave
    demand(abs(reached - int(fields["Cam.SlavePeriod"])) < 1, "Cam.SlavePeriod", f"the last polynomial ends at {float(reached)} units")
    return pieces


def rockwell(text, _):
    elements, _ = assignments(text)
    pieces = []
    for index in range(len(elements) - 1):
        one = elements[index]
        for name, value in (("Slave", one["C0"]), ("Status", "2"), ("SegmentType", "1")):
            demand(one[name] == value, f"element {index}", f"{name} is {one[name]}, not {value}")
        pieces.append((lreal(one["Master"]), lreal(elements[index + 1]["Master"]),
                       [lreal(one[f"C{k}"]) for k in range(4)]))
    begin, end, c = pieces[-1]
    reached = sum(part * (end - begin)**k for k, part in enumerate(c))
    for name in ("Slave", "C0"):  # the end point is but a mark
        mark = lreal(elements[len(elements) - 1][name])
        demand(abs(reached - mark) <= SAME_END * max(1, abs(mark)), f"element {len(elements) - 1}", f"{name} is {float(mark)}, "
               f"the last cubic ends at {float(reached)}")
    return pieces


def omron(text, _):
    """The points that MC_GenerateCamTable makes of the nodes, and straight lines between them."""
    elements, fields = assignments(text)
    cycle, whole = real(fields["CamProperty.CycleTime"]), real(elements[len(elements) - 1]["Phase"])
    before, d0, v0 = Fraction(0), Fraction(0), real(fields["CamProperty.InitVel"])
    points = [(before, d0)]
    for index in range(len(elements)):
        node = elements[index]
        for name, value in (("Curve", "_mcPolynomic3"), ("ConnectingVelEnable", "TRUE")):
            demand(node[name] == value, f"node {index}", f"{name} is {node[name]}, not {value}")
        phase, d1, v1, pitch = (real(node[name]) for name in ("Phase", "Distance", "ConnectingVel", "PhasePitch"))
        seconds, place = cycle * (phase - before) / whole, before + pitch
        while place < phase - pitch / 1000:
            t = (place - before) / (phase - before)
            d = (d0 + v0 * seconds * t + (3 * (d1 - d0) - (2 * v0 + v1) * seconds) * t**2
                 + ((v0 + v1) * seconds - 2 * (d1 - d0)) * t**3)
            points.append((real(place), real(d)))
            place += pitch
        points.append((phase, d1))
        before, d0, v0 = phase, d1, v1
    return lines(points)


def lenze(text, _):
    return lines([[lreal(cell) for cell in line.split("//")[0].split()] for line in text.splitlines()])


def coefficients(text, _):
    rows = [line for line in text.splitlines() if not line.startswith("#")]
    demand(rows[0] == "from_deg,to_deg,s,v,a,j,c0,c1,c2,c3,c4,c5,c6,c7", "columns", rows[0])
    cells = [[lreal(cell) for cell in row.split(",")] for row in rows[1:]]
    for i, row in enumerate(cells):
        for k, factor in enumerate((1, 1, 2, 6)):
            demand(abs(row[2 + k] - factor * row[6 + k]) <= Fraction(1, 10**12), f"row {i + 1}", "contradicts its coefficients")
    return [(row[0], row[1], row[6:]) for row in cells]


READERS = {"codesys": codesys, "twincat": twincat, "twincat7": twincat7, "siemens": siemens, "br": br, "rockwell": rockwell, "omron": omron,
           "lenze": lenze, "csv": coefficients}
TEXT_READERS = {"codesys": codesys_ascii}
STRAIGHT = {"omron", "lenze"}  # no acceleration
