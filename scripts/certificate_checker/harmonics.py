# SPDX-License-Identifier: MIT
"""Harmonics of the lift over one revolution, by the definition of docs/cams.md (spring surge).

Theorem. With y in lifts, b = rad of a unit of x and w = k b the amplitude of harmonic k is |E|, E = b / pi times the integral of y exp(i w x) dx.
Repeated integration by parts makes that, for polynomials, a sum over the ends of their pieces; E is affine in the control points, and
`amplitude` encloses its coefficients. Assumption: laws along the motion are polynomials; others are not verified.
"""

from .enclosures import Complex, PI, fraction
from .exact import KEPT, Refuted, Unverified, derivative, number, root, value_at
from .laws import constant, polynomial_of
from .phase_rows import Amplitude
from .rational import Fraction
from .units import in_unit


class Harmonics:
    def __init__(self, problem, scene):
        self.problem = problem
        self.most = problem.in_lifts(problem.limits, "spring_harmonic")
        self.unit = in_unit(problem.unit_angle, "deg")
        self.length = problem.stretches[-1].end
        given = problem.limits.get("spring_harmonics")
        if given is None:
            turns = problem.turns_per_second() * self.unit / 360
            nearest = max(1, int(number(scene["forces"]["spring_frequency_hz"]) / turns + Fraction(1, 2)))
            given = {"min": max(1, nearest - 1), "max": nearest + 1}
        self.orders = range(given["min"], given["max"] + 1) if isinstance(given, dict) else [given]
        self.memory = {}

    def turned(self, order, x):
        """exp(i w x)."""
        part = order * x * self.unit / 360
        part -= round(part)
        sine, cosine = (PI * (2 * part)).sine_and_cosine()
        return Complex(cosine, sine)

    def along(self, polynomial, begin, end, powers, ends):
        """The integral of polynomial(x - begin) exp(i w x) between two places, whose exponentials are given."""
        total = Complex(constant(0), constant(0))
        for power in powers:
            if not any(polynomial):
                break
            high, low = value_at(polynomial, end - begin), polynomial[0]
            total = total + power * (ends[1].scaled(constant(high)) - ends[0].scaled(constant(low)))
            polynomial = derivative(polynomial)
        return total

    def amplitude(self, order):
        if order in self.memory:
            return self.memory[order]
        problem, wave = self.problem, PI * (order * self.unit / 180)
        inverse = Complex(constant(0), -wave.inverse())  # 1 / (i w)
        powers = [inverse]
        for _ in range(problem.degree + 8):
            powers.append(powers[-1] * Complex(-inverse.re, -inverse.im))
        factor = Complex(constant(0), constant(0))  # all copies, and b / pi
        for copy in range(problem.copies):
            factor = factor + self.turned(order, copy * self.length)
        factor = factor.scaled(constant(self.unit / 180))
        known = Complex(constant(0), constant(0))
        for s in problem.stretches:
            if s.kind != "spline":
                if s.kind == "law" and polynomial_of(s.law) is None:
                    raise Unverified(f"harmonics of the law {s.law}")
                known = known + self.along(self.polynomial(s), s.begin, s.end, powers,
                                           [self.turned(order, x) for x in (s.begin, s.end)])
        rows = []
        for run in problem.runs:
            own = {}
            for i in range(run.space.segments):
                left, width = run.space.breakpoints[i], run.space.width(i)
                turns = [self.turned(order, x) for x in (left, left + width)]
                for j, basis in enumerate(run.cam_space.basis(i), run.space.first(i)):
                    part = self.along(basis, left, left + width, powers, turns)
                    own[j] = own[j] + part if j in own else part
            rows.append({j: whole * factor for j, whole in own.items()})
        parts = [[{j: self.middle(getattr(whole, part)) for j, whole in row.items()} for row in rows] for part in ("re", "im")]
        known = known * factor
        self.memory[order] = Amplitude(*parts, tuple(self.middle(part)[0] for part in (known.re, known.im)))
        return self.memory[order]

    @staticmethod
    def middle(part):
        """(number, its error)."""
        low, high = part.value
        return fraction((low + high) // 2), fraction(high - low + 1)

    def polynomial(self, stretch):
        """y by x from the stretch's beginning; the cam's where that of the output is prescribed."""
        if stretch.kind == "dwell":
            return [self.problem.cam_at_rest(stretch.start)]
        rise, length = stretch.to - stretch.start, stretch.end - stretch.begin
        own = [rise * c / length**m for m, c in enumerate(polynomial_of(stretch.law))]
        return [own[0] + stretch.start] + own[1:]

    def keep(self, curve):
        for order in self.orders:
            values, error = self.amplitude(order).values(curve)
            if root(values[0]**2 + values[1]**2)[1] + error > self.most * (1 + KEPT):
                raise Refuted(f"harmonic {order} of the lift is larger than its limit")
