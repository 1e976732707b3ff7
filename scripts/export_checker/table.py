# SPDX-License-Identifier: MIT
"""table.csv: how far straight lines between its rows are from the designed motion and its derivatives."""
import csv
import math
import re

from certificate_checker.exact import Refuted, Unverified, number
from certificate_checker.rational import Fraction
from certificate_checker.units import LENGTHS, RADIAN

from .outcome import Outcome
from .plc import judge, problem_of, scales_of
from .plc_tables import demand
from .plc_turn import SAME_JOINT, Departure, whole_turn

SYMBOLS = {"s": 0, "ds": 1, "dds": 2, "ddds": 3, "v": 1, "a": 2, "j": 3}
NORMALISED = {"y": 0, "dy": 1, "ddy": 2, "dddy": 3}
COLUMN = re.compile(r"(s|d{1,3}s|[vaj])_(mm|m|in|deg|rad)(?:_(rad|deg|s)[23]?)?")


def column_of(key, problem, per_x, lift):
    """(order, what 1 mm or 1 degree by degreeʳ is in the unit of the column)."""
    if key in NORMALISED:
        return NORMALISED[key], per_x**NORMALISED[key] / lift
    found = COLUMN.fullmatch(key)
    demand(found, key, "is no column of the motion")
    symbol, unit, per = found.groups()
    swings = problem.lift[1] != "m"
    demand((unit in ("deg", "rad")) == swings, key, "is no unit of this motion")
    own = {"deg": Fraction(1), "rad": RADIAN}[unit] if swings else LENGTHS[unit] * 1000
    by = {"deg": 1, "rad": RADIAN, None: 1}[per] if per != "s" else problem.turns_per_second() * per_x
    return SYMBOLS[symbol], by**SYMBOLS[symbol] / own


def lines(angles, values, order):
    """Polynomials whose derivative of that order is the line between two rows; what lies below is not looked at."""
    for a, b, first, second in zip(angles, angles[1:], values, values[1:]):
        yield a, b, [Fraction(0)] * order + [first / math.factorial(order), (second - first) / (b - a) / math.factorial(order + 1)]


def read(text):
    """{column: numbers}."""
    header, *rows = csv.reader(text.splitlines())
    for i, row in enumerate(rows):
        demand(len(row) == len(header), f"row {i + 1}", f"has {len(row)} cells of {len(header)}")
    return {key: [Fraction(row[i]) if row[i] else None for row in rows] for i, key in enumerate(header)}


def angles_of(table, end):
    """Degrees from 0 to the end of the motion."""
    angles = table["theta_deg"]
    demand(len(angles) > 1 and angles[0] == 0, "row 1", "does not begin at 0 deg")
    for i, (a, b) in enumerate(zip(angles, angles[1:])):
        demand(b > a, f"row {i + 2}", f"{float(b)} deg follows {float(a)} deg")
    demand(abs(end - angles[-1]) < (angles[-1] - angles[-2]) / 2, f"row {len(angles)}",
           f"the table ends at {float(angles[-1])} deg, the motion at {float(end)} deg")
    return angles


def verify(text, claims, scene):
    design, outcome = claims["design"], Outcome(limits="not judged: rows joined by straight lines have no acceleration")
    table, problem = read(text), problem_of(scene, design)
    if "theta_deg" not in table:
        raise Unverified("a table without theta_deg")
    lift, per_x = scales_of(problem)
    stretches = whole_turn(design["motion"], problem, per_x, lift)
    end = number(design["motion"]["parts"][-1]["end"]) * per_x
    angles = angles_of(table, Fraction(360) if problem.type == "RR" or abs(end - 360) < SAME_JOINT else end)
    outcome.unverified += [key for key in table if key != "theta_deg" and key not in claims["departure"]]
    for key, claimed in claims["departure"].items():
        if key not in table or None in table[key]:
            raise Refuted(f"{key}: a cell is missing")
        order, size = column_of(key, problem, per_x, lift)
        pieces = list(lines(angles, [value / size for value in table[key]], order))
        judge(outcome, key, Departure(stretches, pieces, angles[-1]), order, number(claimed), size)
    return outcome
