# SPDX-License-Identifier: MIT
"""Spline spaces.

Theorem. The piecewise polynomials of a degree on the breakpoints, with so many continuous derivatives, are the combinations of the basis
(Cox and de Boor), exactly. A control point of the derivative r is at most `spread(r)` times the largest value of that derivative.
"""
import math

from .conditions import eliminated
from .exact import Refuted, SAME_PLACE, combination, derivative, product, value_at
from .rational import Fraction

FAR = Fraction(10**9)  # a bound that says nothing


class Space:
    """Piecewise polynomials of a degree on exact breakpoints, with a number of continuous derivatives; a spline is
    its control points over the clamped knots (ends degree + 1 fold, inside degree - continuity fold). `period`: places before
    or beyond it are meant so much further or nearer."""

    def __init__(self, degree, continuity, breakpoints, period=None):
        self.period = period
        self.degree, self.continuity, self.breakpoints = degree, continuity, breakpoints
        fold = degree - continuity
        self.knots = [breakpoints[0]] * (degree + 1)
        for x in breakpoints[1:-1]:
            self.knots += [x] * fold
        self.knots += [breakpoints[-1]] * (degree + 1)
        self.size = len(self.knots) - degree - 1
        self.segments = len(breakpoints) - 1
        self.fold = fold
        self.known, self.spreads = {}, {}

    def first(self, segment):
        """The first of the degree + 1 control points that a segment feels."""
        return segment * self.fold

    def width(self, segment):
        return self.breakpoints[segment + 1] - self.breakpoints[segment]

    def basis(self, segment):
        """Cox and de Boor: the polynomials of t = x - left end that the control points are multiplied by."""
        if segment not in self.known:
            p, first, left_end = self.degree, self.first(segment), self.breakpoints[segment]
            u = [self.knots[first + 1 + k] - left_end for k in range(2 * p)]
            functions = [[Fraction(1)]]
            for d in range(1, p + 1):
                raised = [[Fraction(0)] for _ in range(d + 1)]
                for j, function in enumerate(functions):
                    left, right = u[p - d + j], u[p + j]
                    part = [c / (right - left) for c in function]
                    raised[j] = combination((1, raised[j]), (1, product(part, [right, Fraction(-1)])))
                    raised[j + 1] = combination((1, raised[j + 1]), (1, product(part, [-left, Fraction(1)])))
                functions = raised
            self.known[segment] = functions
        return self.known[segment]

    def segment_of(self, x, side):
        """The segment of x, and x; a double that is meant as a breakpoint becomes it."""
        x = self.folded(x)
        for i, point in enumerate(self.breakpoints):
            if abs(point - x) <= SAME_PLACE:
                i = i - 1 if (side == "left" and i > 0) or i == self.segments else i
                return i, point
        for i in range(self.segments):
            if self.breakpoints[i] < x < self.breakpoints[i + 1]:
                return i, x
        raise Refuted(f"a row speaks of x = {float(x)}, outside the motion")

    def folded(self, x):
        while self.period and x < self.breakpoints[0] - SAME_PLACE:
            x += self.period
        while self.period and x > self.breakpoints[-1] + SAME_PLACE:
            x -= self.period
        return x

    def functional(self, x, order, side="right"):
        """The derivative at x as a row {control point: weight}."""
        segment, x = self.segment_of(x, side)
        t = x - self.breakpoints[segment]
        row = {}
        for k, function in enumerate(self.basis(segment)):
            weight = value_at(derivative(function, order), t)
            if weight:
                row[self.first(segment) + k] = weight
        return row

    def pieces(self, control):
        """One polynomial of t a segment."""
        return [combination(*((control[self.first(i) + k], f) for k, f in enumerate(self.basis(i))))
                for i in range(self.segments)]

    def control_points(self, breakpoints, polynomials):
        """Of a motion given by polynomials of t = x - breakpoint on nearly the same breakpoints: the blossom of a piece
        in the middle of each control point's reach, rounded to 2^-110."""
        control = []
        for j in range(self.size):
            spans = [i for i in range(self.segments) if 0 <= j - self.first(i) <= self.degree]
            i = spans[len(spans) // 2]
            u = [knot - breakpoints[i] for knot in self.knots[j + 1:j + 1 + self.degree]]
            control.append(Fraction(round(blossom(polynomials[i], u) * 2**110), 2**110))
        return control

    def raised(self, weights, order):
        """Summation by parts: sum w_j c_j, c the control points of the derivative `order` - 1, as start * c_0 + sum
        v_i d_i with those of the derivative `order`, d_i = degree (c_(i+1) - c_i) / (difference of knots). Returns
        start, v."""
        above, tail = [], Fraction(0)
        for w in reversed(weights[1:]):
            tail += w
            above.append(tail)
        return tail + weights[0], [a * step for a, step in zip(reversed(above), self.steps(order))]

    def steps(self, order):
        """c_(i+1) - c_i over d_i."""
        p = self.degree - order + 1
        return [(self.knots[order + i + p] - self.knots[order + i]) / p for i in range(self.size - order)]

    def spread(self, order):
        """How much larger than the largest value a control point of the derivative of this order can be: the least of two bounds."""
        if order not in self.spreads:
            q = self.degree - order
            bounds = [Fraction(1)] if q <= 1 else [self.spread_on_segments(order)]
            if q >= 4 and self.continuity >= order:
                bounds.append(Space(q, self.continuity - order, self.breakpoints).spread_over_all())
            self.spreads[order] = min(bounds)
        return self.spreads[order]

    def spread_on_segments(self, order):
        """A control point is the blossom at its knots of the polynomial on one segment, a combination of values there."""
        q, largest_sum = self.degree - order, Fraction(0)
        knots = self.knots[order:len(self.knots) - order]
        parts = [Fraction(math.sin(math.pi * i / (2 * q))**2) for i in range(q + 1)]  # Chebyshev's extrema
        for j in range(len(knots) - q - 1):
            own = knots[j + 1:j + q + 1]
            options = [(a, b) for a, b in zip(own, own[1:]) if b > a] or \
                      [(a, b) for a, b in zip(knots[j:], knots[j + 1:j + q + 2]) if b > a]
            if not options:
                continue
            a, b = max(options, key=lambda ab: ab[1] - ab[0])
            nodes = [a + (b - a) * part for part in parts]
            total = Fraction(0)
            for i, node in enumerate(nodes):
                lagrange = [Fraction(1)]
                for other in nodes[:i] + nodes[i + 1:]:
                    lagrange = product(lagrange, [-other / (node - other), 1 / (node - other)])
                total += abs(blossom(lagrange, own))
            largest_sum = max(largest_sum, total)
        return largest_sum

    def spread_over_all(self):
        """The control points interpolate the values at the means of their knots: the largest row sum of the inverse of that matrix
        A. For any B with |1 - B A| = r < 1 in that norm it is at most |B| / (1 - r)."""
        p, n = self.degree, self.size
        places = [sum(self.knots[j + 1:j + p + 1]) / p for j in range(n)]
        matrix = [self.functional(x, 0, "left" if x == self.breakpoints[-1] else "right") for x in places]
        nearly = eliminated([[float(row.get(j, 0)) for j in range(n)] + [float(i == j) for j in range(n)] for i, row in enumerate(matrix)])
        norm, rest = Fraction(0), Fraction(0)
        for i, row in enumerate(nearly):
            exact = [Fraction(value) for value in row]
            left = [Fraction(-(i == j)) for j in range(n)]
            for weight, own in zip(exact, matrix):
                for j, value in own.items():
                    left[j] += weight * value
            norm, rest = max(norm, sum(map(abs, exact))), max(rest, sum(map(abs, left)))
        return norm / (1 - rest) if rest < 1 else FAR


class CamSpace(Space):
    """What the cam of a prescribed output does, by the control points of the output: its basis functions are
    w_0 B + w_1 B' + w_2 B''."""

    def __init__(self, space, weights):
        super().__init__(space.degree, space.continuity, space.breakpoints, space.period)
        self.weights = weights

    def basis(self, segment):
        if segment not in self.known:
            self.known[segment] = [cam_of(function, self.weights) for function in Space.basis(self, segment)]
        return self.known[segment]


def cam_of(polynomial, weights):
    """w_0 y + w_1 y' + w_2 y''."""
    return combination(*((w, derivative(polynomial, order)) for order, w in enumerate(weights) if w))


def output_of(polynomial, weights):
    """The y of which this is the combination, from the highest power down."""
    found = list(polynomial)
    for m in range(len(found) - 1, -1, -1):
        for order in (1, 2):
            if m + order < len(found):
                found[m] -= weights[order] * found[m + order] * math.perm(m + order, order)
        found[m] /= weights[0]
    return found


def blossom(polynomial, places):
    """The symmetric multi-affine form: coefficient m times the mean product of m of the places."""
    sums = [Fraction(1)] + [Fraction(0)] * len(places)
    for place in places:
        for m in range(len(places), 0, -1):
            sums[m] += place * sums[m - 1]
    return sum((c * sums[m] / math.comb(len(places), m) for m, c in enumerate(polynomial)), Fraction(0))
