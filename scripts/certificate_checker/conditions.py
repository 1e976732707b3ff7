# SPDX-License-Identifier: MIT
"""Linear conditions on the control points, solved exactly.

Theorem. The splines that satisfy the conditions are those with c_pivot = value - row . c for each pivot in `rows`, the other control points
free; if `contradiction` is set there is none (a row 0 . c = value with |value| above STATED).
"""

from .exact import STATED, add_to, number
from .rational import Fraction


REST, AT_LIMIT = "rest between strokes of one direction", "a set point at a limit"
IMPLIED = REST, AT_LIMIT  # these follow from inequalities alone; camopt leaves them out where a spline has little freedom


class Conditions:
    """The conditions of a run solved for as many control points: each is then a function of the others. Redundant ones
    drop out, and so does what differs from others by rounding (camopt leaves it out too, and no bound is the worse for it);
    contradictions are the proof that there is no motion. `errors`: to what each control point is known, where they differ."""

    def __init__(self, rows, errors=None):
        self.rows = {}  # control point: (row of the others, value)
        self.contradiction = self.rounding = None  # (name, by how much)
        for row, value, name in rows:
            row, value = self.reduced(dict(row), value)
            row = {j: w for j, w in row.items() if w}
            if not row:
                if abs(value) > STATED and abs(value) > (self.contradiction[1] if self.contradiction else 0):
                    self.contradiction = (name, abs(value))
                elif value and abs(value) <= STATED:
                    self.rounding = (name, abs(value))
                continue
            pivot = max(row, key=lambda j: abs(row[j]) * (errors[j] if errors and j >= 0 else 1))
            weight = row.pop(pivot)
            row, value = {j: w / weight for j, w in row.items()}, value / weight
            for other in self.rows:  # nothing solved for stands in another's row
                theirs, their_value = self.rows[other]
                if pivot in theirs:
                    factor = theirs.pop(pivot)
                    add_to(theirs, row, -factor)
                    self.rows[other] = (theirs, their_value - factor * value)
            self.rows[pivot] = (row, value)

    def reduced(self, row, value):
        """The same function of the control points that are not solved for: row . c = value."""
        for pivot in [j for j in row if j in self.rows]:
            weight = row.pop(pivot)
            theirs, their_value = self.rows[pivot]
            add_to(row, theirs, -weight)
            value -= weight * their_value
        return row, value

    def completed(self, control):
        """The control points that are solved for, from the others."""
        control = list(control)
        for pivot, (row, value) in self.rows.items():
            control[pivot] = value - sum((w * control[j] for j, w in row.items()), Fraction(0))
        return control


def eliminated(a):
    """The solutions of linear equations, rows with their right sides last, of fractions or of doubles; None: there is none or many."""
    for i in range(len(a)):
        pivot = max(range(i, len(a)), key=lambda r: abs(a[r][i]))
        if not a[pivot][i]:
            return None
        a[i], a[pivot] = a[pivot], a[i]
        for r in range(len(a)):
            factor = a[r][i] / a[i][i]
            if r != i and factor:
                a[r] = [x - factor * y for x, y in zip(a[r], a[i])]
    return [[x / a[i][i] for x in a[i][len(a):]] for i in range(len(a))]


def solved(a):
    """The solution with one right side, rounded; or None."""
    found = eliminated(a)
    return found and [number(float(x)) for x, in found]
