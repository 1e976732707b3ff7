# SPDX-License-Identifier: MIT
"""Electronic-cam files read as the controllers read them. Shares no code with camopt; numbers are exact fractions of
the floats that the controller holds, so that no digit is lost here.

A piece is (begin, end, [c0, c1, …]): slave = Σ c_k (master − begin)^k, master in degrees, slave in mm or degrees.
"""

import re
import struct
from fractions import Fraction

ELEMENT = re.compile(r"\w+(?:\.\w+)*\[(\d+)\]\.(\w+)\s*:=\s*([^;]+);")
FIELD = re.compile(r"(?<![\w\]])(\w+\.\w+)\s*:=\s*([^;]+);")
# Columns: what one unit of s0, s1, v0·h, v1·h, a0·h², a1·h² gives to c0 … c5 over u = t / h.
QUINTIC = [[1, 0, 0, -10, 15, -6], [0, 0, 0, 10, -15, 6], [0, 1, 0, -6, 8, -3], [0, 0, 0, -4, 7, -3],
           [0, 0, Fraction(1, 2), Fraction(-3, 2), Fraction(3, 2), Fraction(-1, 2)],
           [0, 0, 0, Fraction(1, 2), -1, Fraction(1, 2)]]


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
        assert field not in elements.setdefault(int(index), {}), (index, field)
        elements[int(index)][field] = value.strip()
    return elements, {field: value.strip() for field, value in FIELD.findall(code)}


def quintic(start, end):
    """Of two states (x, s, v, a)."""
    h = end[0] - start[0]
    ends = [start[1], end[1], start[2] * h, end[2] * h, start[3] * h * h, end[3] * h * h]
    scaled = [sum(weight * row[k] for weight, row in zip(ends, QUINTIC)) for k in range(6)]
    return start[0], end[0], [c / h**k for k, c in enumerate(scaled)]


def lines(points):
    return [(a[0], b[0], [a[1], (b[1] - a[1]) / (b[0] - a[0])]) for a, b in zip(points, points[1:])]


def codesys(text, _):
    elements, fields = assignments(text)
    assert fields["Cam.byType"] == "SMC_CAM_TYPE.XYVA" and int(fields["Cam.nElements"]) == len(elements)
    knots = [[lreal(elements[i][name]) for name in ("dX", "dY", "dV", "dA")] for i in range(len(elements))]
    assert lreal(fields["Cam.xStart"]) == knots[0][0] and lreal(fields["Cam.xEnd"]) == knots[-1][0]
    return [quintic(a, b) for a, b in zip(knots, knots[1:])]


def codesys_ascii(text, _):
    knots = [[lreal(cell) for cell in line.split(";")] for line in text.splitlines()]
    return [quintic(a, b) for a, b in zip(knots, knots[1:])]


def twincat(text, _):
    elements, fields = assignments(text)
    count = int(fields["Cam.NoOfRows"])
    assert sorted(elements) == list(range(1, count + 1))
    for index, element in elements.items():
        assert int(element["PointIndex"]) == index
        assert element["FunctionType"] == "MOTIONFUNCTYPE_POLYNOM5_MM"
        assert int(element["RelIndexNextPoint"]) == (0 if index == count else 1)
    names = ("MasterPos", "SlavePos", "SlaveVelo", "SlaveAcc")
    knots = [[lreal(elements[i + 1][name]) for name in names] for i in range(count)]
    return [quintic(a, b) for a, b in zip(knots, knots[1:])]


def siemens(text, _):
    elements, _ = assignments(text)
    pieces = []
    for index in sorted(elements):
        one = elements[index]
        start, end = ([lreal(one[name + side]) for name in ("leadingValue", "followingValue", "geoVelo", "geoAccel")]
                      for side in ("Start", "End"))
        if int(one["camProfileType"]) == 2:
            assert start[1:] == [start[1], 0, 0] and end[1] == start[1]
            pieces.append((start[0], end[0], [start[1]]))
        else:
            assert int(one["camProfileType"]) == 5 and start[1] != end[1]
            pieces.append(quintic(start, end))
    return pieces


def br(text, units):
    elements, fields = assignments(text)
    assert int(fields["Cam.PolynomialNumber"]) == len(elements) <= 128
    master, slave = lreal(units["master_deg"]), lreal(units["slave"])
    pieces, begin = [], Fraction(0)
    for index in range(len(elements)):
        end = real(elements[index]["x"]) * master
        pieces.append((begin, end, [real(elements[index][name]) * slave / master**k
                                    for k, name in enumerate("abcdefg")]))
        begin = end
    assert pieces[0][2][0] == 0 and begin == int(fields["Cam.MasterPeriod"]) * master
    last = pieces[-1]
    reached = sum(c * (last[1] - last[0])**k for k, c in enumerate(last[2])) / slave
    assert abs(reached - int(fields["Cam.SlavePeriod"])) < 1
    return pieces


def rockwell(text, _):
    elements, _ = assignments(text)
    pieces = []
    for index in range(len(elements) - 1):
        one = elements[index]
        assert one["Slave"] == one["C0"] and one["Status"] == "2" and one["SegmentType"] == "1"
        pieces.append((lreal(one["Master"]), lreal(elements[index + 1]["Master"]),
                       [lreal(one[f"C{k}"]) for k in range(4)]))
    return pieces


def omron(text, _):
    """The points that MC_GenerateCamTable makes of the nodes, and straight lines between them."""
    elements, fields = assignments(text)
    cycle, whole = real(fields["CamProperty.CycleTime"]), real(elements[len(elements) - 1]["Phase"])
    before, d0, v0 = Fraction(0), Fraction(0), real(fields["CamProperty.InitVel"])
    points = [(before, d0)]
    for index in range(len(elements)):
        node = elements[index]
        assert node["Curve"] == "_mcPolynomic3" and node["ConnectingVelEnable"] == "TRUE"
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
    assert rows[0] == "from_deg,to_deg,s,v,a,j,c0,c1,c2,c3,c4,c5", rows[0]
    cells = [[lreal(cell) for cell in row.split(",")] for row in rows[1:]]
    assert all(abs(row[2 + k] - (1, 1, 2, 6)[k] * row[6 + k]) <= 1e-12 for row in cells for k in range(4))
    return [(row[0], row[1], row[6:]) for row in cells]


READERS = {"codesys": codesys, "twincat": twincat, "siemens": siemens, "br": br, "rockwell": rockwell, "omron": omron,
           "lenze": lenze, "csv": coefficients}
TEXT_READERS = {"codesys": codesys_ascii}
