# SPDX-License-Identifier: MIT
"""Cams whose limits are checked."""
import math
from fractions import Fraction

from .bound import Row
from .exact import (
    KEPT, ORDERS, PI, ROUNDED, Refuted, Unverified, bernstein, combination, derivative, exactly, halves,
    largest, largest_magnitude, middle_of, number, on_grid, product, root, tangent, times)
from .problem import LENGTHS, angle_of


class Cam:
    """A disk cam with a translating follower. Lengths in m; u = s' - sense * offset, D = start + s, start the
    follower's height at displacement 0."""

    def __init__(self, problem, scene, result):
        cam, self.problem, self.scene = scene["cam"], problem, scene
        self.kind, self.follower = cam.get("type", "disk"), cam.get("follower")
        self.constant, self.judged = Fraction(0), True
        self.lift = problem.lift[0]
        weights = {n: number(scene["objective"].get(n, 0)) for n in
                   ("base_radius", "roller_radius", "offset", "center_distance", "arm_length", "face_offset")}
        if self.kind != "disk" or not self.follower.startswith("translating"):
            if any(weights.values()) or any(isinstance(v, dict) for v in cam.values()):
                raise Unverified("dimensions of this kind of cam in the objective, or searched")
            self.judged, self.free = False, None
            self.fixed = self.weight = self.base = Fraction(0)
            return
        self.sense = -1 if cam.get("rotation", "counterclockwise") == "clockwise" else 1
        self.base, self.free = self.dimension(cam, "base_radius"), None
        if isinstance(self.base, tuple):
            self.free = self.base
            found = result.get("cam") and result["cam"]["dimensions"]["base_radius_m"]
            self.base = number(found) if found else None
            if self.base is not None and not self.free[0] <= self.base <= self.free[1]:
                raise Refuted("the base radius is outside its range")
        self.roller = self.dimension(cam, "roller_radius") if self.follower == "translating_roller" else Fraction(0)
        self.offset = self.dimension(cam, "offset") if self.follower != "translating_flat" else Fraction(0)
        if isinstance(self.roller, tuple) or isinstance(self.offset, tuple):
            raise Unverified("a dimension that is searched, other than the base radius")
        self.weight = weights.pop("base_radius") / self.lift
        if self.free and self.offset:
            raise Unverified("a searched base radius beside an offset")
        self.constant = (weights["roller_radius"] * self.roller + weights["offset"] * abs(self.offset)) / self.lift
        self.fixed = self.constant
        if self.base is not None:
            self.constant += self.weight * self.base
        unit = problem.unit_angle
        self.beta = exactly(unit[0]) if unit[1] == "rad" else times(exactly(unit[0] / 180), PI)
        self.width = self.dimension(cam, "face_half_width") or None
        self.pressure = self.pressure_limits()

    def dimension(self, cam, name):
        for unit, size in LENGTHS.items():
            value = cam.get(f"{name}_{unit}")
            if isinstance(value, dict):
                return number(value["min"]) * size, number(value["max"]) * size
            if value is not None:
                return number(value) * size
        return Fraction(0)

    def pressure_limits(self):
        """(upper side, lower side): the largest pressure angle of rises and of returns, in degrees."""
        found = []
        for name in ("pressure_angle", "rise_pressure_angle", "return_pressure_angle"):
            value = angle_of(self.problem.limits, name)
            if value and value[1] != "deg":
                raise Unverified("a pressure angle in radians")
            found.append(value and value[0])
        general, up, down = found
        return up if up is not None else general, down if down is not None else general

    def start(self, base):
        square = (base + self.roller)**2 - self.offset**2
        return root(square) if self.offset else exactly(base + self.roller)

    def least_cost(self):
        return self.fixed + self.weight * (self.free[0] if self.free else self.base)

    def least(self, leaning, cost):
        """What the base radius adds to a bound: cost and multipliers, at its best."""
        fixed = self.fixed if cost else Fraction(0)
        weight = self.weight if cost else Fraction(0)
        if not self.free:
            return fixed + weight * self.base
        return fixed + min((weight + leaning) * end for end in self.free)

    # -- rows of the bound

    def row(self, bound, k, run, row, at):
        """(the row, factor of its multiplier), or None where this checker does not use it. Irrational numbers are taken
        at their middle, and what that can change is added to what the row may reach."""
        origin = row["origin"]
        rule, order, sign = origin["rule"], origin.get("order"), origin.get("sign", 0)
        side = origin.get("side", "right")
        if not self.judged or bound.relaxed:
            return None
        most_y, space = bound.supremum[k][0], run.space
        function = {}

        def add(derivative_order, weight):
            for j, w in space.functional(at, derivative_order, side).items():
                function[j] = function.get(j, Fraction(0)) + weight * w

        if rule.endswith("pressure_angle_deg") and order == 1 and sign:
            limit = self.pressure[0 if sign > 0 else 1]
            if limit is None or self.follower == "translating_flat":
                return None
            # sign (s' - sense e) <= tan (start + s), times beta / lift.
            steep = times(tangent(limit), self.beta)
            middle, half = middle_of(steep)
            add(1, Fraction(sign))
            add(0, -middle)
            lean = max(sign * self.sense * self.offset * b for b in self.beta) / self.lift
            nominal = float(self.free[0] + self.free[1]) / 2 if self.free else float(self.base)
            angle = math.radians(float(limit))
            factor = math.cos(angle) * float(self.lift) / (nominal + float(self.roller)) / float(self.beta[0])
            if self.free:
                most = steep[1] * self.roller / self.lift + half * most_y + half * self.free[1] / self.lift
                return Row(row["name"], k, function, most, None, -middle / self.lift), number(factor)
            most = steep[1] * self.start(self.base)[1] / self.lift + lean + half * most_y
            return Row(row["name"], k, function, most), number(factor)
        if rule == "cam.face_half_width" and order == 1 and sign and self.width:
            add(1, Fraction(sign))
            return Row(row["name"], k, function, self.width * self.beta[1] / self.lift), \
                self.lift / self.width / number(float(self.beta[0]))
        if rule.startswith("limits.cam_radius_min") and self.follower == "translating_flat" and not self.free:
            # -(base + s + s'') <= -least, times beta^2 / lift.
            square = times(self.beta, self.beta)
            middle, half = middle_of(square)
            add(2, Fraction(-1))
            add(0, -middle)
            room = (self.base - self.dimension(self.problem.limits, "cam_radius_min")) / self.lift
            most = max(room * b for b in square) + half * most_y
            return Row(row["name"], k, function, most), number(float(self.lift / self.base / square[0]))
        if rule.startswith("limits.contact_force_min"):
            mass, rate, preload, least = self.forces()
            speed = self.problem.turns_per_second()
            unit = max(abs(least), preload, mass * speed**2 * self.lift, Fraction(1, 1000))
            add(2, -mass * speed**2 * self.lift / unit)
            add(0, -rate * self.lift / unit)
            return Row(row["name"], k, function, (preload - least) / unit), Fraction(1)
        return None

    def forces(self):
        forces, limits = self.scene["forces"], self.problem.limits
        rate = number(forces.get("spring_rate_n_mm", 0)) * 1000 + number(forces.get("spring_rate_n_m", 0))
        return number(forces["mass_kg"]), rate, number(forces.get("preload_n", 0)), \
            number(limits.get("contact_force_min_n", 0))

    # -- limits of the delivered motion

    def keep_limits(self, curve):
        """Names of the limits that are kept, by exact arithmetic; what is not looked at is named in `missing`."""
        kept, missing = [], []
        if not self.judged:
            return [], [f"limits.{key} of a {self.kind} cam" for key in self.problem.limits if key not in ORDERS]
        laws = any(s.kind == "law" for s in self.problem.stretches)
        for key in self.problem.limits:
            if key.split("_")[0] in ORDERS:
                continue
            if laws:
                missing.append(f"limits.{key} on segments with a law")
            elif key.endswith("pressure_angle_deg"):
                self.keep_pressure(curve)
                kept.append("limits." + key)
            elif key.startswith("cam_radius_min"):
                self.keep_radius(curve, self.dimension(self.problem.limits, "cam_radius_min"))
                kept.append("limits." + key)
            elif key.startswith("concave_radius_min") and self.follower != "translating_flat":
                self.keep_concave(curve, self.dimension(self.problem.limits, "concave_radius_min"))
                kept.append("limits." + key)
            elif key == "undercut_margin" and self.follower == "translating_roller":
                self.keep_bend(curve, self.roller / (1 - number(self.problem.limits[key])), "undercut")
                kept.append("limits." + key)
            elif key == "contact_force_min_n":
                self.keep_force(curve)
                kept.append("limits." + key)
            elif key == "hertz_pressure_max_mpa" and self.follower == "translating_roller":
                self.keep_hertz(curve, number(self.problem.limits[key]) * 10**6)
                kept.append("limits." + key)
            elif key == "torque_max_nm":
                self.keep_torque(curve, number(self.problem.limits[key]))
                kept.append("limits." + key)
            else:
                missing.append("limits." + key)
        if self.width:
            slope = largest_magnitude(curve.along(1))[1] * self.lift / self.beta[0]
            if slope > self.width * (1 + KEPT):
                raise Refuted(f"cam.face_half_width: the contact moves {float(slope)} m from the axis")
            kept.append("cam.face_half_width")
        return kept, missing

    def keep_pressure(self, curve):
        if self.follower == "translating_flat":
            return
        start = self.start(self.base)[0]
        for sign, limit in zip((1, -1), self.pressure):
            if limit is None:
                continue
            steep = tangent(limit)
            pieces = []
            for run in curve.pieces:
                for p, w, _, _ in run:
                    # sign (s' - sense e) - tan (start + s), in parts of tan start; beta at its lower end.
                    slope = [c * self.lift / self.beta[0] for c in derivative(p)]
                    height = [c * self.lift for c in p]
                    constant = [-sign * self.sense * self.offset - steep[0] * start]
                    pieces.append((combination((sign / (steep[0] * start), slope), (-1 / start, height),
                                               (1 / (steep[0] * start), constant)), w))
            worst = largest(pieces)[1]
            if worst > KEPT * 10:
                raise Refuted(f"the pressure angle passes {float(limit)} deg: "
                              f"by {float(worst):.1e} of its tangent at rest")
        still = min([s.start for s in self.problem.stretches] + [s.to for s in self.problem.stretches])
        least = min(limit for limit in self.pressure if limit is not None)
        if abs(self.offset) > tangent(least)[0] * (start + still * self.lift) * (1 + KEPT):
            raise Refuted("the pressure angle at rest passes its limit")

    def keep_radius(self, curve, least):
        """1 / pitch curvature - roller >= least: (least + roller) N <= (D^2 + u^2)^(3/2), N = D^2 + u (2u + sense e) -
        D q with q = s''. Stretch by stretch, halved until it is decided."""
        beta, lift = middle_of(self.beta)[0], self.lift
        if self.follower == "translating_flat":
            pieces = [(combination((-lift, p), (-lift / beta**2, derivative(p, 2)), (1, [least - self.base])), w)
                      for run in curve.pieces for p, w, _, _ in run]
            if largest(pieces, Fraction(1, 10**15))[1] > KEPT * self.base:
                raise Refuted("the cam's radius passes its limit")
            return
        for run in curve.pieces:
            for p, w, _, _ in run:
                high, _, square, bent = self.geometry(p)
                root_of = product(square, product(square, square))
                self.decide([(least + self.roller) * c for c in bent], root_of, w, "the cam's radius passes its limit")

    def geometry(self, p):
        """D, u, D^2 + u^2 and N = D^2 + u (2u + sense e) - D s'' along a piece; pi is taken to 35 digits, far below
        what a limit is kept to."""
        beta, offset = middle_of(self.beta)[0], self.sense * self.offset
        high = combination((self.lift, p), (1, [middle_of(self.start(self.base))[0]]))
        slope = combination((self.lift / beta, derivative(p)), (1, [-offset]))
        bend = [c * self.lift / beta**2 for c in derivative(p, 2)]
        square = combination((1, product(high, high)), (1, product(slope, slope)))
        bent = combination((1, product(high, high)), (2, product(slope, slope)), (offset, slope),
                           (-1, product(high, bend)))
        return high, slope, square, bent

    def decide(self, side, root_of, width, fault):
        """side <= sqrt(root_of), to within 2 KEPT: where side is positive, root_of - side^2 is not
        negative."""
        room = combination((1 + 4 * KEPT, root_of), (-1, product(side, side)))
        size = max(abs(c) for c in bernstein(room, width))  # brought near 1 for the grid
        scale = max(abs(c) for c in bernstein(side, width))
        stack = [(on_grid([c / scale for c in bernstein(side, width)]),
                  on_grid([c / size for c in bernstein(room, width)]), 0)]
        while stack:
            sides, rooms, depth = stack.pop()
            if max(sides) <= -ROUNDED or min(rooms) >= ROUNDED:
                continue
            if depth > 60 or any(sides[end] > 0 and rooms[end] < 0 for end in (0, -1)):
                raise Refuted(fault)
            stack += [(a, b, depth + 1) for a, b in zip(halves(sides), halves(rooms))]

    def force(self, p):
        mass, rate, preload, _ = self.forces()
        speed = self.problem.turns_per_second()
        return combination((mass * speed**2 * self.lift, derivative(p, 2)), (rate * self.lift, p), (1, [preload]))

    def keep_force(self, curve):
        least, unit = self.forces()[3], max(abs(self.forces()[3]), self.forces()[2], Fraction(1, 1000))
        pieces = [([-c / unit for c in self.force(p)], w) for run in curve.pieces for p, w, _, _ in run]
        if largest(pieces)[1] > -least / unit + KEPT * 10:
            raise Refuted("the contact force passes its limit")

    def keep_torque(self, curve, most):
        pieces = [(product(self.force(p), [c * self.lift / self.beta[0] / most for c in derivative(p)]), w)
                  for run in curve.pieces for p, w, _, _ in run]
        if largest_magnitude(pieces)[1] > 1 + KEPT * 10:
            raise Refuted("the torque passes its limit")

    def keep_hertz(self, curve, most):
        """p^2 = F_n / (pi b C) (1/cam radius + 1/roller), F_n = F sqrt(Q) / D, Q = D^2 + u^2, C = sum of (1 - nu^2) /
        E, and 1/cam radius + 1/roller = 1 / (r (1 - r N / Q^(3/2))): with K = 1 / (pi b C r most^2) it is kept where
        K F Q^2 + r N D <= sqrt(D^2 Q^3), D > 0."""
        forces = self.scene["forces"]
        compliance = sum((1 - number(forces.get(f"{side}_poisson", Fraction(3, 10)))**2) /
                         (number(forces.get(f"{side}_modulus_gpa", 210)) * 10**9) for side in ("cam", "follower"))
        if any(key.startswith(("cam_modulus", "follower_modulus")) and not key.endswith("_gpa") for key in forces):
            raise Unverified("moduli of elasticity in another unit than GPa")
        width = self.dimension(forces, "contact_width")
        pressed = 1 / (sum(PI) / 2 * width * compliance * self.roller * most**2)
        for run in curve.pieces:
            for p, w, _, _ in run:
                high, _, square, bent = self.geometry(p)
                if min(bernstein(high, w)) <= 0:
                    raise Unverified("limits.hertz_pressure where the contact may lie below the cam's centre")
                side = combination((pressed, product(self.force(p), product(square, square))),
                                   (self.roller, product(bent, high)))
                root_of = product(product(high, high), product(square, product(square, square)))
                self.decide(side, root_of, w, "the Hertz pressure passes its limit")
