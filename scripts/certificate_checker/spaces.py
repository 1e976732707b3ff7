# SPDX-License-Identifier: MIT
"""Spline spaces.

Theorem. The piecewise polynomials of a degree on the breakpoints, with so many continuous derivatives, are the combinations of the basis
(Cox and de Boor), exactly. A spline's values at the means of its knots are A c, A those of the basis and c its control points. For any
matrix B, near the inverse of A, |c| <= |B| max |value| / (1 - r), where r = |1 - B A| < 1 in the norm of row sums: `spread` times the largest
value.
"""
import math

from .conditions import eliminated
from .exact import Refuted, SAME_PLACE, add_to, combination, derivative, product, value_at
from .rational import Fraction

FAR = Fraction(10**9)  # a bound that says nothing
TINY = 2.0**-70        # what is left out of B: rounding


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
        self.known, self.derivatives, self.functionals = {}, {}, []
        self.norm = None  # `spread`

    def first(self, segment):
        """The first of the degree + 1 control points that a segment feels."""
        return segment * self.fold

    def width(self, segment):
        return self.breakpoints[segment + 1] - self.breakpoints[segment]

    def steepest(self, order, below):
        """The largest derivative of this order, from that of the one below it. Markov: a polynomial of degree d within B over a width h has a
        slope within 2 d^2 B / h."""
        return 2 * max(0, self.degree - order + 1)**2 * below / min(self.width(i) for i in range(self.segments))

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

    def reach(self, j):
        """The segments that feel a control point."""
        return [i for i in range(self.segments) if 0 <= j - self.first(i) <= self.degree]

    def middle_pieces(self):
        """[segment]: in the middle of each control point's reach."""
        return [own[len(own) // 2] for own in map(self.reach, range(self.size))]

    def best_pieces(self, order):
        """[(error, segment)]: from which piece each control point of a derivative of this order is best known, and to what, where the motion
        itself is known to 1. Over a width h the derivative is known to 1 / h^order, which a blossom multiplies by (what the knots are away /
        h)^degree; of equals the middle one."""
        found = []
        for j, middle in enumerate(self.middle_pieces()):
            errors = []
            for i in self.reach(j):
                away = max([self.width(i)] + [abs(knot - self.breakpoints[i]) for knot in self.knots[j + 1:j + 1 + self.degree]])
                errors.append((away**self.degree / self.width(i)**(self.degree + order), abs(i - middle), i))
            error, _, i = min(errors)
            found.append((error, i))
        return found

    def control_points(self, breakpoints, polynomials, pieces=None):
        """Of a motion given by polynomials of t = x - breakpoint on nearly the same breakpoints: the blossom of one of the pieces of each
        control point's reach, rounded to 2^-110."""
        control = []
        for j, i in enumerate(pieces or self.middle_pieces()):
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

    def of_derivative(self, order):
        """The space of the derivatives of this order, whose control points they have."""
        if order not in self.derivatives:
            self.derivatives[order] = Space(self.degree - order, self.continuity - order, self.breakpoints)
        return self.derivatives[order]

    def at_breakpoints(self):
        """[(order, row)] of a spline and three derivatives at every breakpoint, from both sides where one may jump."""
        if not self.functionals:
            last = self.breakpoints[-1]
            self.functionals = [(order, self.functional(x, order, side)) for x in self.breakpoints for order in range(4)
                                for side in ("left", "right") if order > self.continuity or side == ("left" if x == last else "right")]
        return self.functionals

    def spread(self):
        """How much larger than the largest value a control point can be."""
        if self.norm is None:
            numbers, matrix = range(self.size), []
            for j in numbers:
                own = self.knots[j + 1:j + self.degree + 1] or self.knots[j:j + 2]
                x = sum(own) / len(own)
                matrix.append(self.functional(x, 0, "right" if x == self.knots[j] else "left"))
            nearly = eliminated([[float(row.get(j, 0)) for j in numbers] + [float(i == j) for j in numbers] for i, row in enumerate(matrix)])
            norm, rest = Fraction(0), Fraction(0 if nearly else 1)
            for j, row in enumerate(nearly or []):
                exact, left = [Fraction(w) if abs(w) > TINY else 0 for w in row], {j: Fraction(-1)}
                for weight, own in zip(exact, matrix):
                    if weight:
                        add_to(left, own, weight)
                norm, rest = max(norm, sum(map(abs, exact))), max(rest, sum(map(abs, left.values())))
            self.norm = norm / (1 - rest) if rest < 1 else FAR
        return self.norm


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
