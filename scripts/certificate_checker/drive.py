# SPDX-License-Identifier: MIT
"""A motor that follows the motion through a transmission, by the definitions of docs/servo.md.

    torque = r (m a + c v + F + R sgn v) + J a / r,   speed n = v / r,   r: the output's travel a radian of the motor.

With y in lifts h and a unit of x lasting T seconds these are, of y(x),

    torque = Ka y'' + Kv y' + K0 + Kf sgn y',   Ka = (m r + J / r) h / T^2,  Kv = c r h / T,  K0 = F r,  Kf = R r,   n = h / (T r) y'.

Dry friction is a constant of each stroke, 0 in dwells. As the speed approaches 0 only K0 + Kf sgn y' is left of the torque.
Root mean squares are over the cycle, outside of which the axis rests:

    mean square = (integral of torque^2 dx + (C - L) K0^2) / C,   C: the cycle, L: the motion, in x.

Theorem. `largest` and `mean_square_of` enclose the largest value of a formula of torque and speed and the mean square of the torque of the
delivered motion, laws and dwells included. `largest_at_rest` and `square_at_rest` are lower bounds of these at every speed above 0.
"""
import math

from .drive_laws import Span, largest_along, square_along
from .enclosures import PI_ITSELF, ends_of
from .exact import KEPT, STATED, Refuted, Unverified, combination, derivative, integral, largest, number, product, root, shifted
from .laws import ends_of_law
from .motion_bounds import SIDES
from .prescribed import state_at
from .rational import Fraction
from .runs import Peak, Stretch
from .units import FORCE, LENGTHS, MOMENTS, POUND, angle_of, in_unit

SPEEDS = {"rpm": PI_ITSELF / 30, "rad_s": Fraction(1)}
TRAVELS = {f"{unit}_per_rev": size for unit, size in (*LENGTHS.items(), ("deg", PI_ITSELF / 180), ("rad", Fraction(1)))}
UNITS = {"load_mass": {"kg": Fraction(1), "lb": POUND}, "load_inertia": {"kg_m2": Fraction(1)},
         "motor_inertia": {"kg_m2": Fraction(1)}, "transmission": TRAVELS,
         "viscous": {"n_s_m": Fraction(1), "nm_s_rad": Fraction(1)}, "force": FORCE, "moment": MOMENTS,
         "friction": {**FORCE, **MOMENTS}, "cycle": {"deg": 1, "rad": 1, "crank_deg": 1}}
LIMITS = {"motor_torque": MOMENTS, "motor_torque_rms": MOMENTS, "motor_speed": SPEEDS}
TERMS = {"motor_torque": "motor", "motor_torque_rms": "motor_rms"}
TYPICAL_BEND = 6  # y'' of a good motion: what a torque limit near 0 is measured by


def written(table, units, name):
    """(the key of a quantity, SI of one in its unit), or (None, None)."""
    return next(((f"{name}_{unit}", Fraction(size)) for unit, size in units.items() if f"{name}_{unit}" in table), (None, None))


def with_transmission_found(scene, result):
    """The scene with the transmission that was found in place of its range, in which it lies."""
    given = scene.get("drive", {})
    key = next((name for name, value in given.items() if name.startswith("transmission_") and isinstance(value, dict)), None)
    if key is None or not result.get("drive"):
        return scene
    stated = next((name for name in result["drive"] if name.startswith("transmission_")), None)
    if stated is None:
        raise Refuted("the result does not say which transmission was found")
    sizes = [Fraction(TRAVELS[name.removeprefix("transmission_")]) for name in (stated, key)]
    found, (least, most) = number(result["drive"][stated]) * sizes[0] / sizes[1], (number(given[key][end]) for end in ("min", "max"))
    if not least * (1 - STATED) <= found <= most * (1 + STATED):
        raise Refuted(f"a transmission of {float(found)} is outside its range")
    return scene | {"drive": given | {key: found}}


class Rule:
    """by_torque * torque + by_speed * n <= most (and the peak `peak`, where there is one); `scale`: a violation of 100 %."""

    def __init__(self, key, sign, by_torque, by_speed, most, scale, which=None, peak=None):
        self.key, self.sign, self.by_torque, self.by_speed, self.most, self.scale = key, sign, by_torque, by_speed, most, scale
        self.which, self.peak = which or {}, peak

    def is_meant(self, origin):
        return self.key == origin.key and (not self.sign or origin.sign == self.sign) and self.which.items() <= origin.which.items()


def slope_at_ends(stretch):
    """y' at both ends of a dwell or a law; of a spline, which begins and ends as what is beside it, None."""
    if stretch.kind == "spline":
        return None, None
    return tuple(Fraction(end) * (stretch.to - stretch.start) / (stretch.end - stretch.begin)
                 for end in (ends_of_law(stretch.law, 1) if stretch.kind == "law" else (0, 0)))


class Drive:
    def __init__(self, problem, result, at_rest=False):
        """`at_rest`: as the speed approaches 0."""
        self.at_rest = at_rest
        self.problem, given = problem, problem.scene["drive"]
        for key in given:
            if not any(key == f"{name}_{unit}" for name, units in UNITS.items() for unit in units):
                raise Unverified(f"drive.{key}")
        if "cam" in problem.scene:
            raise Unverified("a motor together with a [cam]")
        turns = problem.lift[1] != "m"
        for name, own in (("load_mass", not turns), ("load_inertia", turns), ("force", not turns), ("moment", turns)):
            if written(given, UNITS[name], name)[0] and not own:
                raise Unverified(f"drive.{name} where the lift is {'an angle' if turns else 'a length'}")
        lift = in_unit(problem.lift, "rad")
        travel, rate = self.quantity("transmission") / (2 * PI_ITSELF), Fraction(0) if at_rest else problem.turns_per_second()
        mass = self.quantity("load_mass") + self.quantity("load_inertia")
        inertia = (mass * travel + self.quantity("motor_inertia") / travel) * lift
        self.acceleration = inertia * rate**2
        self.velocity = self.quantity("viscous") * travel * lift * rate
        self.constant = (self.quantity("force") + self.quantity("moment")) * travel
        self.friction = self.quantity("friction") * travel
        self.speed = lift * rate / travel
        self.inertia_ratio = mass * travel**2 / self.quantity("motor_inertia") if self.quantity("motor_inertia") else None
        if inertia <= 0 or self.quantity("viscous") < 0 or self.friction < 0:
            raise Unverified("a motor that nothing resists")
        self.spans = self.spans_of(problem.stretches)
        self.length = problem.stretches[-1].end
        self.cycle = self.cycle_of(given) / problem.copies
        self.rules, self.rms_limit = self.limits_of(problem.limits)
        self.terms = self.terms_of(problem.objective, result)

    def quantity(self, name):
        key, size = written(self.problem.scene["drive"], UNITS[name], name)
        return number(self.problem.scene["drive"][key]) * size if key else Fraction(0)

    def spans_of(self, stretches):
        """Of these stretches; DRD and RR: of their strokes."""
        if self.friction and any(s.kind == "spline" for s in stretches) and not self.problem.motion.get("monotone", False):
            raise Unverified("friction in a motion that may reverse within a stroke")
        found = []
        for s in stretches:
            if self.problem.type == "RR" and s.kind == "spline":
                found += [Span(s, Fraction(0), Fraction(1), 1, self.constant + self.friction),
                          Span(s, Fraction(1), s.end, -1, self.constant - self.friction)]
                continue
            if None in (s.start, s.to) and self.friction:
                raise Unverified("friction next to displacements that are free")
            way = 0 if s.kind == "dwell" or None in (s.start, s.to) else (s.to > s.start) - (s.to < s.start)
            found.append(Span(s, s.begin, s.end, way, self.constant + way * self.friction))
        return found

    def cycle_of(self, given):
        """x of the cycle; of a motion that closes its own."""
        whole = self.length * self.problem.copies
        if self.problem.type == "program" and self.problem.wraps:
            return whole
        angle = angle_of(given, "cycle") or (Fraction(360), "deg")
        cycle = in_unit(angle, self.problem.unit_angle[1]) / self.problem.unit_angle[0]
        if cycle < whole * (1 - STATED):
            raise Unverified("a cycle shorter than the motion")
        return max(cycle, whole)

    # -- limits and terms

    def limits_of(self, limits):
        """(the rules at each place, the limit of the root mean square or None)."""
        for key in limits:
            if key.startswith("motor_") and key != "motor_curve" and \
                    not any(key == f"{name}_{unit}" for name, units in LIMITS.items() for unit in units):
                raise Unverified(f"limits.{key}")
        rules = []
        key, unit = written(limits, MOMENTS, "motor_torque")
        if key and isinstance(limits[key], dict):
            for side, value in limits[key].items():
                most = SIDES[side] * number(value) * unit
                rules.append(Rule(f"limits.{key}.{side}", SIDES[side], Fraction(SIDES[side]), Fraction(0), most,
                                  TYPICAL_BEND * self.acceleration or max(abs(most), Fraction(1))))
        elif key:
            most = number(limits[key]) * unit
            rules += [Rule("limits." + key, sign, Fraction(sign), Fraction(0), most, most) for sign in (1, -1)]
        key, unit = written(limits, SPEEDS, "motor_speed")
        if key:
            most = number(limits[key]) * unit
            rules += [Rule("limits." + key, sign, Fraction(0), Fraction(sign), most, most) for sign in (1, -1)]
        points = [(number(n) * SPEEDS["rpm"], number(t)) for n, t in limits.get("motor_curve", [])]
        curve = self.curve_of(points)
        if curve and self.at_rest:  # it never rises: no torque is above the one at speed 0
            most = points[0][1]
            curve = [Rule("limits.motor_curve", sign, Fraction(sign), Fraction(0), most, most) for sign in (1, -1)]
        rules += curve
        key, unit = written(limits, MOMENTS, "motor_torque_rms")
        return rules, number(limits[key]) * unit if key else None

    @staticmethod
    def curve_of(points):
        """|torque| + fall |n| <= most along every edge of the polygon, |n| <= the last speed: convex where it never rises and
        falls ever more steeply."""
        rules, before, key, none = [], Fraction(0), "limits.motor_curve", Fraction(0)
        for i, ((n, torque), (further, lower)) in enumerate(zip(points, points[1:])):
            fall = (torque - lower) / (further - n)
            if points[0][0] or points[0][1] <= 0 or further <= n or lower < 0 or fall < before * (1 - STATED) - STATED**2:
                raise Unverified("limits.motor_curve that is not concave")
            before, most = fall, torque + fall * n
            for sign in (1, -1):
                for way in (1, -1)[:2 if fall else 1]:
                    rules.append(Rule(key, 0, sign / most, way * fall / most, Fraction(1), Fraction(1),
                                      {"pair": i, "torque": sign, "speed": way}))
        for sign in (1, -1) if points else ():
            rules.append(Rule(key, 0, none, sign / points[-1][0], Fraction(1), Fraction(1), {"speed": sign}))
        return rules

    def terms_of(self, objective, result):
        terms, self.peak_rules = [], []
        for name, kind in TERMS.items():
            weight = number(objective.get(name, 0))
            if not weight:
                continue
            reference = self.reference_of(objective.get("reference", "modified_sine"), name, result)
            terms.append(Peak(kind, 2, weight, reference))
            if kind == "motor":
                place = len(self.problem.terms) + len(terms) - 1
                self.peak_rules = [Rule(name, 0, sign / reference, Fraction(0), Fraction(0), Fraction(1), {"torque": sign}, place)
                                   for sign in (1, -1)]
        return terms

    def reference_of(self, asked, name, result):
        """The scene's number, or the reference law's own in the place of the splines: what camopt states is checked, and then is
        the definition of the objective."""
        if isinstance(asked, dict):
            if name not in asked:
                raise Unverified(f"objective.reference without {name}")
            return number(asked[name])
        own = next((t for t in result.get("own_terms") or [] if t["name"] == name), None)
        chain = self.spans_of([law for s in self.problem.stretches_of_reference() for law in self.in_place_of(s, asked)])
        if name == "motor_torque":
            found = self.largest_of(chain, lambda torque, n: torque)
        else:
            found = tuple(root(self.mean_square([self.square(span) for span in chain])[i])[i] for i in (0, 1))
        if own is None:
            return number(float(sum(found) / 2))
        stated = number(own["reference"])
        if not found[0] * (1 - STATED) <= stated <= found[1] * (1 + STATED):
            raise Refuted(f"the reference {name} is {float(stated)}, but that of the law is {float(found[0])}")
        return stated

    def in_place_of(self, stretch, law):
        if stretch.kind != "spline":
            return [stretch]
        own = [stretch]
        if self.problem.type == "RR":
            own = [Stretch("law", Fraction(0), Fraction(1), Fraction(0), Fraction(1)),
                   Stretch("law", Fraction(1), stretch.end, Fraction(1), Fraction(0))]
        laws = []
        for s in own:
            laws.append(Stretch("dwell" if s.to == s.start else "law", s.begin, s.end, s.start, s.to))
            laws[-1].law = law
        return laws

    # -- figures of a motion

    def square(self, span):
        """(low, high) around the integral of torque^2 over a law or a dwell."""
        return square_along(span, self.acceleration, self.velocity)

    def mean_square(self, squares):
        """From the integrals of torque^2 over all parts."""
        rest = (self.cycle - self.length) * self.constant**2
        return tuple((sum((s[i] for s in squares), Fraction(0)) + rest) / self.cycle for i in (0, 1))

    def pieces_of(self, curve, k):
        """[(the piece's number, y as a polynomial, where it begins in its own t, width, span)] of spline k, cut where friction
        turns."""
        run, found = self.problem.runs[k], []
        for i, (p, width, left, stretch) in enumerate(curve.pieces[k]):
            x = left - run.begin_of(stretch) + stretch.begin
            for span in self.spans:
                begin, end = max(x, span.begin), min(x + width, span.end)
                if span.stretch.begin == stretch.begin and begin < end:
                    found.append((i, shifted(p, begin - x), begin - x, end - begin, span))
        return found

    def along_splines(self, curve):
        """[(torque, speed, width)]: polynomials."""
        return [(self.torque(p, span), [self.speed * c for c in derivative(p)], width)
                for k in range(len(self.problem.runs)) for _, p, _, width, span in self.pieces_of(curve, k)]

    def torque(self, polynomial, span):
        return combination((self.acceleration, derivative(polynomial, 2)), (self.velocity, derivative(polynomial)), (1, [span.constant]))

    def largest_of(self, spans, formula, signs=(1, -1)):
        """(low, high) around the largest of sign * formula(torque, n) along laws and dwells."""
        own = [largest_along(span, self, formula, sign) for span in spans if span.stretch.kind != "spline" for sign in signs]
        return (max(low for low, _ in own), max(high for _, high in own)) if own else (None, None)

    def largest(self, curve, formula, signs=(1, -1)):
        """The same along the delivered motion. `formula` takes numbers and polynomials."""
        low, high = self.largest_of(self.spans, formula, signs)
        pieces = [(Polynomial(torque), Polynomial(n), width) for torque, n, width in self.along_splines(curve)]
        if pieces:
            own = largest([([sign * c for c in formula(torque, n).own], width) for torque, n, width in pieces for sign in signs])
            low, high = (own[0], own[1]) if low is None else (max(low, own[0]), max(high, own[1]))
        return low, high

    # -- as the speed approaches 0

    def largest_at_rest(self, sign):
        """The largest sign * (K0 + Kf sgn y') that sign * torque reaches at any speed, or None. It does in dwells, and where the mean of
        Ka y'' + Kv y' times the sign is not below 0 along all that has the same constant: y' is the same at both ends, and y goes with
        the sign."""
        returns, damped = self.returns_to_its_speed(), self.quantity("viscous")
        left = [sign * span.constant for span in self.spans if span.stretch.kind == "dwell" or
                (returns and (not damped or sign * (span.way if self.friction else self.net()) >= 0))]
        return max(left, default=None)

    def is_square_left(self):
        """The same of the root mean square: integral of (c + g)^2 >= that of c^2 + 2 c g, g = Ka y'' + Kv y'."""
        moved = sum((abs(span.stretch.to - span.stretch.start) for span in self.spans), Fraction(0))
        return self.returns_to_its_speed() and (self.constant * self.net() + self.friction * moved >= 0 or not self.quantity("viscous"))

    def net(self):
        return self.problem.stretches[-1].to - self.problem.stretches[0].start

    def returns_to_its_speed(self):
        """Whether y' does not jump, and is 0 wherever friction changes (between splines that reverse: both are monotone)."""
        if self.problem.type != "program" or not self.problem.wraps or self.problem.continuity < 1:
            return False
        for before, after in zip(self.spans, self.spans[1:] + self.spans[:1]):
            slopes = {slope_at_ends(before.stretch)[1], slope_at_ends(after.stretch)[0]} - {None}
            turns = not slopes and before.way * after.way < 0
            if len(slopes) > 1 or (before.constant != after.constant and slopes != {0} and not turns):
                return False
        return True

    def square_at_rest(self):
        return self.mean_square([(span.constant**2 * (span.end - span.begin),) * 2 for span in self.spans])[0]

    def squares_beside(self):
        return [self.square(span) for span in self.spans if span.stretch.kind != "spline" and span not in self.free_laws()]

    def free_laws(self):
        """Spans whose mean square depends on displacements that are free."""
        return [span for span in self.spans if span.stretch.kind == "law" and None in (span.stretch.start, span.stretch.to)]

    def mean_square_of(self, curve):
        """(low, high)."""
        own = [integral(product(torque, torque), width) for torque, _, width in self.along_splines(curve)]
        return self.mean_square([(s, s) for s in own] + self.squares_beside())

    def term(self, curve, term):
        """(low, high) around a term's own figure."""
        if term.kind == "motor":
            return self.largest(curve, lambda torque, n: torque)
        squares = self.mean_square_of(curve)
        return root(squares[0])[0], root(squares[1])[1]

    # -- the delivered motion

    def keep_limits(self, curve, relaxed):
        """Names of the limits that it keeps at every place, laws and dwells included."""
        kept, room = set(), KEPT + relaxed
        for rule in self.rules:
            reached = self.largest(curve, lambda torque, n, r=rule: torque * r.by_torque + n * r.by_speed, (1,))[1]
            if reached > rule.most + rule.scale * room:
                raise Refuted(f"{rule.key}: the motion reaches {float(reached)}, allowed are {float(rule.most)}")
            kept.add(rule.key)
        if self.rms_limit is not None:
            reached = self.mean_square_of(curve)[1] / self.rms_limit**2
            if reached > (1 + room)**2:
                raise Refuted(f"limits.motor_torque_rms: the motion reaches {math.sqrt(reached)} of it")
            kept.add("limits.motor_torque_rms")
        return sorted(kept)

    def check_figures(self, curve, result):
        """What the files say of the motor is so."""
        stated = result["drive"]
        found = {"peak_torque_nm": self.largest(curve, lambda torque, n: torque),
                 "rms_torque_nm": tuple(root(s)[i] for i, s in enumerate(self.mean_square_of(curve))),
                 "peak_speed_rpm": [v / SPEEDS["rpm"] for v in self.largest(curve, lambda torque, n: n)],
                 "peak_power_w": self.largest(curve, lambda torque, n: torque * n)}
        curves = [r for r in self.rules if r.key == "limits.motor_curve"]
        if curves:
            own = [self.largest(curve, lambda torque, n, r=r: torque * r.by_torque + n * r.by_speed, (1,)) for r in curves]
            found["share_of_curve"] = max(low for low, _ in own), max(high for _, high in own)
        if self.inertia_ratio is not None:
            found["inertia_ratio"] = self.inertia_ratio, self.inertia_ratio
        elif stated["inertia_ratio"] is not None:
            raise Refuted("drive.inertia_ratio without an inertia of the motor")
        for name, (low, high) in found.items():
            room = STATED * max(abs(low), abs(high), abs(number(stated[name])))
            if not low - room <= number(stated[name]) <= high + room:
                raise Refuted(f"drive.{name} is {float(low)}, not {stated[name]}")
        for term in self.terms:
            name = next(n for n, kind in TERMS.items() if kind == term.kind)
            own = next(t for t in result["own_terms"] if t["name"] == name)
            same = number(own["value"]) == number(stated["peak_torque_nm" if term.kind == "motor" else "rms_torque_nm"])
            if not same or abs(number(own["weight"]) - term.weight) > STATED * term.weight or \
                    abs(number(own["reference"]) - term.reference) > STATED * term.reference:
                raise Refuted(f"objective.{name}: its weight, reference or value is not that of the scene and its motion")

    def span_at(self, at, side):
        """At a place of the part of the turn that is repeated."""
        at = self.problem.folded(at, side)
        stretch = self.problem.stretch_at(at, side)
        own = [span for span in self.spans if span.stretch is stretch]
        if len(own) > 1:
            own = own[:1] if at < own[0].end or (at == own[0].end and side == "left") else own[1:]
        return own[0] if own else None

    def passes(self, rule, at, side):
        """Whether a limit is certainly passed at a place where the motion is prescribed."""
        if rule.startswith("limits.motor_torque_rms"):
            return self.mean_square(self.squares_beside())[0] > self.rms_limit**2
        state, span = state_at(self.problem, at, side)[0], self.span_at(at, side)
        slope, bend = ends_of(state[1]), ends_of(state[2])
        for own in self.rules:
            if own.key == rule:
                factors = own.by_torque * self.velocity + own.by_speed * self.speed, own.by_torque * self.acceleration
                least = sum(min(f * e for e in ends) for f, ends in zip(factors, (slope, bend)))
                if least + own.by_torque * span.constant > own.most:
                    return True
        return False


class Polynomial:
    """With the arithmetic of the enclosures of formulas."""

    def __init__(self, own):
        self.own = own

    def __add__(self, other):
        return Polynomial(combination((1, self.own), (1, other.own)))

    def __mul__(self, other):
        return Polynomial(product(self.own, other.own if isinstance(other, Polynomial) else [other]))
