# SPDX-License-Identifier: MIT
"""Lines and arcs of a file, and how far a point of the designed curve lies from them.

A segment from A to B lies on a circle (or line) with the normal N at A. With p = X - A and k = 1 / (2 R), signed,

    F(X) = k |p|^2 - N p + c

equals D (1 + |k| D) up to its sign, D the distance of X from the circle, negative inside: |D| <= |F| / (1 - 2 |k F|), for a
line |D| = |F|. X projects onto the segment itself where T_A (X - A) >= 0 and T_B (B - X) >= 0, T the directions of travel.
"""
import math

from certificate_checker.enclosures import ONE, ZERO, Jet, interval, inverted, multiplied, negative, rooted
from certificate_checker.exact import Refuted, root

from certificate_checker.rational import Fraction

MOST_BULGE = Fraction(9, 10)  # tan(angle / 4): below half a circle
ALMOST_HALF = Fraction(1, 100)


class Segment:
    """`line`: of the file; `start_line`, `end_line`: those that state the ends; `band`: the controller's path lies within it of the
    circle, mm."""

    def __init__(self, line, start, end):
        self.line, self.start_line, self.end_line, self.start, self.end, self.band = line, line, line, start, end, 0.0
        dx, dy = end[0] - start[0], end[1] - start[1]
        self.square = dx * dx + dy * dy
        self.length = math.sqrt(self.square)
        self.at_start, self.at_end = tuple(Jet.number(z) for z in start), tuple(Jet.number(z) for z in end)
        self.constant = Jet(ZERO)

    def set_circle(self, curvature, start_direction, end_direction):
        """`curvature`: k, enclosed. The normal is the direction turned by 90 degrees to the left."""
        self.k, self.first, self.last = curvature, start_direction, end_direction
        self.normal = negative(start_direction[1]), start_direction[0]
        self.k_size = max(abs(curvature[0]), abs(curvature[1])) / ONE
        return self

    def distance(self, x, y):
        """F of a point, as a Jet."""
        px, py = x - self.at_start[0], y - self.at_start[1]
        value = self.constant - px.scaled(self.normal[0]) - py.scaled(self.normal[1])
        return value if self.k == ZERO else value + (px.square() + py.square()).scaled(self.k)

    def ahead(self, x, y):
        """(T_A (X - A), T_B (B - X)), both at least 0 where the point projects onto the segment."""
        px, py, qx, qy = x - self.at_start[0], y - self.at_start[1], self.at_end[0] - x, self.at_end[1] - y
        return px.scaled(self.first[0]) + py.scaled(self.first[1]), qx.scaled(self.last[0]) + qy.scaled(self.last[1])

    def from_circle(self, value):
        """|D| of |F|, rounded up."""
        loss = 2 * self.k_size * value
        return value / (1 - loss) * (1 + 1e-14) if loss < 0.5 else 2 * value


def direction(start, end):
    """The unit vector, enclosed."""
    dx, dy = end[0] - start[0], end[1] - start[1]
    inverse = inverted(rooted(interval(dx * dx + dy * dy)))
    return multiplied(interval(dx), inverse), multiplied(interval(dy), inverse)


def turned(vector, sine, cosine):
    """Counterclockwise."""
    x, y = Jet(vector[0]), Jet(vector[1])
    s, c = Jet(interval(sine)), Jet(interval(cosine))
    return (x * c - y * s).value, (x * s + y * c).value


def straight(line, start, end):
    along = direction(start, end)
    return Segment(line, start, end).set_circle(ZERO, along, along)


def bulged(line, start, end, bulge):
    """An arc as DXF writes it: bulge = tan(angle / 4), above 0 counterclockwise."""
    if not bulge:
        return straight(line, start, end)
    if abs(bulge) > MOST_BULGE:
        raise Refuted(f"line {line}: an arc of {float(bulge):g} bulge, almost half a circle or more")
    segment, along = Segment(line, start, end), direction(start, end)
    sine, cosine = 2 * bulge / (1 + bulge**2), (1 - bulge**2) / (1 + bulge**2)  # of half the arc's angle
    k = multiplied(interval(sine), inverted(rooted(interval(segment.square))))
    return segment.set_circle(k, turned(along, -sine, cosine), turned(along, sine, cosine))


def around(line, start, end, center, counterclockwise):
    """An arc as G2 and G3 write it. Printed digits make both ends lie at slightly different radii: the path is taken to lie
    between both, which covers every control that interpolates."""
    sign = 1 if counterclockwise else -1
    arms = [(z[0] - center[0], z[1] - center[1]) for z in (start, end)]
    if not any(arms[0]) or not any(arms[1]):
        raise Refuted(f"line {line}: an arc whose centre is one of its ends")
    cross, dot = arms[0][0] * arms[1][1] - arms[0][1] * arms[1][0], arms[0][0] * arms[1][0] + arms[0][1] * arms[1][1]
    squares = [a * a + b * b for a, b in arms]
    if cross * sign <= 0 or (dot < 0 and cross * cross < ALMOST_HALF**2 * squares[0] * squares[1]):
        raise Refuted(f"line {line}: an arc of almost half a circle or more")
    segment = Segment(line, start, end)
    (low, high), (least, most) = root(squares[0]), root(squares[1])
    radius = (low + least) / 2
    segment.band = float(abs(low - least) / 2 + (high - low) + (most - least)) * (1 + 1e-15)
    directions = [(multiplied(interval(-sign * b), inverted(interval(*ends))), multiplied(interval(sign * a), inverted(interval(*ends))))
                  for (a, b), ends in zip(arms, ((low, high), (least, most)))]
    segment.set_circle(interval(sign / (2 * radius)), *directions)
    # F = (|X - c|^2 - R^2) / (2 R): the normal is not quite of length 1.
    segment.normal = interval(-sign * arms[0][0] / radius), interval(-sign * arms[0][1] / radius)
    segment.constant = Jet(interval(sign * (squares[0] - radius**2) / (2 * radius)))
    return segment
