# SPDX-License-Identifier: MIT
"""An elastic follower of one mass, by the definitions of docs/theory/elastic_follower.md.

With the spring k and the damper c to the cam, the return spring k_r with the preload P, the damper c_g to ground, K = k + k_r, in lifts and
with the time in units of x (T seconds each):

    x'' + 2 q w x' + w^2 x = s w^2 y + 2 z w y' - P / K w^2 / lift,
    w = sqrt(K / m) T,  z = c / (2 sqrt(K m)),  q = (c + c_g) / (2 sqrt(K m)),  s = k / K.

The mass follows y by x = s y - P / (K lift) + e, and from rest

    e'' + 2 q w e' + w^2 e = f = (z - s q) 2 w y' - s y''.

With L = -q w + i v, v = w sqrt(1 - q^2), and E(x) = integral over t from 0 to x of exp(L (x - t)) f(t) this is

    e = Im E / v,   e' + q w e = Re E,   amplitude of the free vibration = |E| / v.

Let J(x) be the same integral of y''; that of y' is (J - y') / L. By parts, with the jumps of y^(r) at the breakpoints b (at the start: from 0),

    J(x) = sum over b <= x of exp(L (x - b)) sum over r >= 2 of jump_r / L^(r - 1) - sum over r >= 2 of y^(r)(x) / L^(r - 1).

After the last breakpoint, at rest, nothing of the second sum is left: there E = ((z - s q) 2 w / L - s) J.

The force on the cam in units of K lift:  s P / (K lift) + s (1 - s) y + 2 z / w (1 - s) y' - s e - 2 z / w e'.

Theorem. `residual` encloses the largest amplitude of the free vibration after the motion over all speeds of the range, `keep_force` proves that
the force on the cam is at or above its limit at every instant and speed. Assumptions: one mass, damped below critical, at rest before each
run of splines.
"""
import itertools

from . import enclosures
from .enclosures import Complex, Jet, PI
from .exact import KEPT, STATED, Refuted, Unverified, derivative, number, root, value_at
from .laws import constant, harmonic
from .rational import Fraction
from .runs import Peak
from .units import in_unit

SAME_PEAK = Fraction(1, 10**11)  # a largest amplitude is enclosed to this part of it
HIGHEST = 8                      # derivatives below this one may jump: the degree is 7 at most
PLACES = 64                      # speeds at which the largest one is looked for
KNOWN = ("mass_kg", "natural_frequency_hz", "natural_frequency_rad_s", "stiffness", "damping_ratio", "damping_n_s_m",
         "return_spring", "preload_n", "ground_damping_n_s_m", "speed_range_rpm", "prescribe")


class Train:
    """Masses in kg, rates in N/m, amplitudes in lifts."""

    def __init__(self, problem):
        self.problem, given = problem, problem.scene["dynamics"]
        for key in given:
            if not key.startswith(KNOWN):
                raise Unverified(f"dynamics.{key}")
        # What is between two dwells starts from rest: each run is one such event.
        if any(s.kind == "law" for s in problem.stretches) or any(run.raised or run.is_ring() or run.states[0][0] or run.states[1][0]
                                                                  for run in problem.runs):
            raise Unverified("an elastic follower along laws, or that is not at rest at the ends of its splines")
        self.lift = in_unit(problem.lift, "rad")
        mass, back = number(given["mass_kg"]), number(given.get("return_spring_n_m", 0))
        self.frequency = self.frequency_of(given, mass, back)
        square = self.frequency.square()
        self.stiffness = mass * square                       # K
        self.share = 1 - back * self.stiffness.inverse()  # s
        self.damping = constant(number(given.get("damping_ratio", 0)))
        if "damping_n_s_m" in given:
            self.damping = (number(given["damping_n_s_m"]) / (2 * mass)) * self.frequency.inverse()
        to_ground = number(given.get("ground_damping_n_s_m", 0)) / (2 * mass)
        self.whole_damping = self.damping + to_ground * self.frequency.inverse()  # q
        if self.whole_damping.value[1] >= enclosures.ONE:
            raise Unverified("an elastic follower that is damped above critical")
        self.ring = (1 - self.whole_damping.square()).root()  # sqrt(1 - q^2)
        self.dragged = self.damping - self.share * self.whole_damping  # z - s q
        self.preload = (number(given.get("preload_n", 0)) / self.lift) * self.stiffness.inverse()
        self.times = self.times_of(given)
        self.memory = {}

    def frequency_of(self, given, mass, back):
        """sqrt(K / m), rad/s."""
        if "natural_frequency_hz" in given:
            return PI * (2 * number(given["natural_frequency_hz"]))
        if "natural_frequency_rad_s" in given:
            return constant(number(given["natural_frequency_rad_s"]))
        return constant((number(given["stiffness_n_m"]) + back) / mass).root()

    def times_of(self, given):
        """Seconds of a unit of x, (shortest, longest)."""
        if "speed_range_rpm" not in given:
            time = 1 / self.problem.turns_per_second()
            return time, time
        low, high = (self.time_at(number(speed)) for speed in given["speed_range_rpm"])
        return high, low

    def time_at(self, rpm):
        return in_unit(self.problem.unit_angle, "deg") / (6 * rpm)

    # -- the response

    def exponent(self, time):
        """L, w and v."""
        w = self.frequency * time
        v = w * self.ring
        return Complex(-self.whole_damping * w, v), w, v

    def powers(self, exponent, count):
        inverse = exponent.inverse()
        found = [inverse]
        while len(found) < count:
            found.append(found[-1] * inverse)
        return found

    @staticmethod
    def jumps_of(pieces):
        """[(width up to the breakpoint, [(r, jump of y^(r))])], from pieces (polynomial of y, width)."""
        found, before, width = [], [], Fraction(0)
        for polynomial, own in [*pieces, ([Fraction(0)], Fraction(0))]:
            after = [derivative(polynomial, r)[0] for r in range(2, HIGHEST)]
            jumps = [b - a for a, b in zip(before or [Fraction(0)] * (HIGHEST - 2), after)]
            found.append((width, [(r + 2, constant(jump)) for r, jump in enumerate(jumps) if jump]))
            before = [value_at(derivative(polynomial, r), own) for r in range(2, HIGHEST)]
            width = own
        return found

    def rung(self, jumps, time):
        """The first sum of J at every breakpoint."""
        exponent = self.exponent(time)[0]
        powers, gone, totals = self.powers(exponent, HIGHEST - 2), {}, []
        total = Complex(constant(0), constant(0))
        for width, own in jumps:
            if width and width not in gone:
                gone[width] = exponent.scaled(constant(width)).exponential()
            total = total * gone[width] if width else total
            for r, jump in own:
                total = total + powers[r - 2].scaled(jump)
            totals.append(total)
        return totals

    def after_rest(self, whole, time):
        """E from J."""
        exponent, w, _ = self.exponent(time)
        factor = exponent.inverse().scaled(2 * self.dragged * w) - Complex(self.share, constant(0))
        return factor * whole

    def amplitude_square(self, whole, time):
        return self.after_rest(whole, time).square() * self.exponent(time)[2].square().inverse()

    def largest(self, formula):
        """(low, high) around the largest root of a formula of the time, over the speeds of the range."""
        squares = enclosures.largest([(*self.times, formula)], PLACES, SAME_PEAK, "amplitude over the speeds")
        return root(squares[0])[0], root(squares[1])[1]

    def residual(self, curve):
        """(low, high) around the largest amplitude after the motion, over the speeds of the range."""
        own = [self.residual_after(curve, k) for k in range(len(curve.cam_pieces()))]
        return max(low for low, _ in own), max(high for _, high in own)

    def residual_after(self, curve, k):
        """The same after one run."""
        if k not in self.memory:
            jumps = self.jumps_of([(p, w) for p, w, _, _ in curve.cam_pieces()[k]])
            self.memory[k] = self.largest(lambda time: self.amplitude_square(self.rung(jumps, time)[-1], time))
        return self.memory[k]

    def residual_of_law(self, law):
        """The same of one rise by a law of the catalogue. y'' = a + b sin g t + c cos g t: with h = exp(i g t) the integral of
        exp(L (t - u)) exp(i g u) is (h - exp(L t)) / (i g - L), its real and its imaginary part by +g and -g."""
        parts, half = harmonic(law), constant(Fraction(1, 2))

        def formula(time):
            exponent = self.exponent(time)[0]
            total = Complex(constant(0), constant(0))
            for width, a, waves, _ in parts:
                t = constant(width)
                gone = exponent.scaled(t * Fraction(1, 4)).exponential()
                gone = gone * gone
                gone = gone * gone
                own = (gone - Complex(constant(1), constant(0))) * exponent.inverse().scaled(a)
                for sign, (g, b, c) in itertools.product((1, -1), waves):
                    turn = Complex(constant(0), sign * g)
                    spun = (turn.scaled(t).exponential() - gone) * (turn - exponent).inverse()
                    own = own + spun * Complex(c * half, -sign * b * half)
                total = total * gone + own
            return self.amplitude_square(total, time)
        return self.largest(formula)

    def residual_functions(self, run, time):
        """(real, imaginary) part of E / v as rows {control point: (number, its error)}, at one speed."""
        time = constant(time)
        exponent, _, v = self.exponent(time)
        powers, rows, gone = self.powers(exponent, HIGHEST - 2), {}, Complex(constant(1), constant(0))
        for i in range(run.space.segments - 1, -1, -1):
            width, after = run.space.width(i), gone
            gone = gone * exponent.scaled(constant(width)).exponential()
            for j, function in enumerate(run.cam_space.basis(i)):
                place = run.space.first(i) + j
                for r, power in enumerate(powers):
                    bent = derivative(function, r + 2)
                    own = power * (gone.scaled(constant(bent[0])) - after.scaled(constant(value_at(bent, width))))
                    rows[place] = rows[place] + own if place in rows else own
        found = ({}, {})
        for place, whole in rows.items():
            value = self.after_rest(whole, time).scaled(v.inverse())
            for row, part in zip(found, (value.re, value.im)):
                middle = sum(part.value) // 2
                row[place] = enclosures.fraction(middle), enclosures.fraction(part.value[1] - middle + 1)
        return found

    # -- limits of the delivered motion

    def keep_force(self, curve, least, k):
        """The force on the cam, N, along a run at every speed, and in the dwells beside it."""
        wanted = (least * (1 - KEPT) / self.lift) * self.stiffness.inverse()
        rest, two = 1 - self.share, constant(2)
        ends = [enclosures.interval(self.times[0])[0], enclosures.interval(self.times[1])[1]]
        jumps, known = self.jumps_of([(p, w) for p, w, _, _ in curve.cam_pieces()[k]]), {}

        def begun(i, time):
            key = time.value, bool(time.slopes)
            if key not in known:
                known[key] = self.rung(jumps, time)
            return known[key][i]

        for i, (p, width, _, _) in enumerate(curve.cam_pieces()[k]):
            orders = [[constant(c) for c in derivative(p, order)] for order in range(HIGHEST)]

            def room(z, i=i, orders=orders):
                t, time = z
                exponent, w, v = self.exponent(time)
                states = [value_at(c, t) for c in orders]
                powers = self.powers(exponent, HIGHEST - 2)
                driven = begun(i, time) * exponent.scaled(t).exponential()
                for power, state in zip(powers, states[2:]):
                    driven = driven - power.scaled(state)
                slow = (driven - Complex(states[1], constant(0))) * powers[0]
                moved = slow.scaled(two * self.dragged * w) - driven.scaled(self.share)
                e = moved.im * v.inverse()
                rate = moved.re - self.whole_damping * w * e
                damper = two * self.damping * w.inverse()
                return self.share * (self.preload + rest * states[0] - e) + damper * (rest * states[1] - rate) - wanted
            if enclosures.least(room, [enclosures.interval(Fraction(0), width), tuple(ends)], 0) is None:
                raise Refuted("limits.dynamic_contact_force_min_n is passed")
        # At rest, and while it rings: |e| <= amplitude, |e'| <= w amplitude.
        still = self.share * self.preload - wanted
        amplitude = Jet.number(Fraction(0), self.residual_after(curve, k)[1])
        begin, end = (self.share * rest * self.problem.cam_at_rest(level)
                      for level in self.problem.runs[k].ends())
        ringing = still + end - amplitude * (self.share + two * self.damping)
        if (still + begin).value[0] < 0 or ringing.value[0] < 0:
            raise Refuted("limits.dynamic_contact_force_min_n is passed in a dwell")

    def keep_limits(self, curve):
        """Names of the limits that are kept; what is not looked at."""
        kept, missing = [], []
        for key, value in self.problem.limits.items():
            if key == "dynamic_contact_force_min_n":
                for k in range(len(curve.cam_pieces())):
                    self.keep_force(curve, number(value), k)
                kept.append("limits." + key)
            elif key.startswith("dynamic_"):
                missing.append("limits." + key)
        return kept, missing

    def residual_limit(self):
        """In lifts, None: there is none."""
        return self.problem.in_lifts(self.problem.limits, "residual")

    def residual_reference(self, stated):
        """What the objective divides the residual by."""
        asked = self.problem.objective.get("reference", "modified_sine")
        if isinstance(asked, dict):
            if "residual" not in asked:
                raise Unverified("objective.reference without residual")
            return number(asked["residual"])
        low, high = self.residual_of_law(asked)
        found = next((number(t["reference"]) for t in stated["terms"] if t["name"] == "residual"), low)
        if not low * (1 - STATED) <= found <= high * (1 + STATED):
            raise Refuted(f"the reference of the residual is {float(found)}, but that of the law is {float(low)}")
        return found

    def residual_term(self, stated):
        """The term of the objective and its limit, or None."""
        weight, cap = number(self.problem.objective.get("residual", 0)), self.residual_limit()
        if not weight and cap is None:
            return []
        return [Peak("residual", 0, weight, self.residual_reference(stated) if weight else Fraction(1), cap)]
