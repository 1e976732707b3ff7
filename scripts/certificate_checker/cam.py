# SPDX-License-Identifier: MIT
"""Cams whose limits are judged.

Theorem. `keep_limits`: each limit that it names is satisfied, to within KEPT, at every cam angle of the delivered motion, splines, laws and
dwells, and for every choice of ends of the tolerances; others are named as missing. `row`: the row is satisfied by every motion whose
derivatives are within `Bound.supremum` and that satisfies the limit: it is the limit where that is linear (slopes that do not vary over the
box of states), else a plane that lies below the limit's formula wherever a motion can be.
"""
import itertools

from . import enclosures
from .dimensions import corners_of, largest_of, middle_size, parts_of
from .inverse_rules import InverseRules
from . import linear_rules
from .rational import Fraction
from .remote_rules import RemoteRules
from .spatial_rules import SpatialRules
from .tolerance import MadeRules, Tolerances
from .disk_rules import LOADED, DiskRules, Side, TwoSides
from .exact import KEPT, ORDERS, STATED, Refuted, Unverified, add_to, derivative, largest_magnitude, middle_of, number, root, value_at
from .forces import Forces
from .harmonics import Harmonics
from .enclosures import ends_of
from .laws import constant, parts_along
from .motion_bounds import keeps
from .origins import rows_of
from .runs import Row
from .units import angle_of, dimension_of, enclosed, in_unit


DIMENSIONS = {"translating_knife": ("base_radius", "offset"), "translating_flat": ("base_radius",),
              "translating_roller": ("base_radius", "roller_radius", "offset"),
              "oscillating_roller": ("base_radius", "roller_radius", "center_distance", "arm_length"),
              "oscillating_flat": ("base_radius", "center_distance", "face_offset")}


STRAIGHT = Fraction(1, 10**25)  # slopes that differ by less do so by rounding
OTHER_RULES = {"barrel": SpatialRules, "cylindrical": SpatialRules, "remote": RemoteRules, "inverse": InverseRules}


class Cam:
    """A disk or a linear cam. Lengths in m; of translating followers u = s' - sense * offset, D = start + s, start the follower's
    height at displacement 0. Of other cams the motion alone is judged."""

    def __init__(self, problem, scene, result):
        cam, self.problem, self.scene = scene["cam"], problem, scene
        self.tolerances = Tolerances(problem, scene)
        self.kind, self.follower = cam.get("type", "disk"), cam.get("follower")
        self.direct = self.kind in ("disk", "linear")  # it touches the output itself
        self.judged, self.swings = self.direct, (self.follower or "").startswith("oscillating")
        self.fixed, self.searched, self.weights, self.rules, self.forces, self.sizes = Fraction(0), {}, {}, None, None, {}
        self.lift = problem.lift[0]
        weights = {n: number(problem.objective.get(n, 0)) for n in
                   ("base_radius", "roller_radius", "offset", "center_distance", "arm_length", "face_offset")}
        self.cost = Fraction(0), Fraction(0)  # of the dimensions as they were found
        if not self.direct:
            return self.be_other(scene, result, weights)
        slides = self.kind == "linear"
        self.sense = linear_rules.sense_of(cam) if slides else -1 if cam.get("rotation", "counterclockwise") == "clockwise" else 1
        given = {name: dimension_of(cam, name) for name in (linear_rules.DIMENSIONS if slides else DIMENSIONS)[self.follower]}
        if slides and any(weights.values()):
            raise Unverified("dimensions of a linear cam in the objective")
        self.forces = Forces(problem, scene) if "forces" in scene else None
        spring = {name: self.forces.ranges[name] for name in ("forces.preload", "forces.spring_rate") if name in self.forces.ranges} \
            if self.forces else {}
        given |= spring
        weights |= dict.fromkeys(spring, Fraction(0))
        self.searched = {name: size for name, size in given.items() if isinstance(size, tuple)}
        unit = self.lift
        if self.swings and not slides:  # times the centre distance, the middle of its range
            unit = in_unit(problem.lift, "rad") * middle_size(given["center_distance"])
        self.weights = dict.fromkeys(given, Fraction(0)) | {name: weight / unit for name, weight in weights.items()}
        self.sizes = given | self.found(result, dict.fromkeys(given, "m"))
        self.fixed = sum((self.weights[name] * abs(given[name]) for name in given if name not in self.searched),
                         Fraction(0))
        self.cost = (self.fixed + sum((self.weights[name] * abs(self.sizes[name]) for name in self.searched
                                       if self.sizes[name] is not None), Fraction(0)),) * 2
        if any(key.startswith("spring_harmonic_") for key in problem.limits):
            problem.harmonics = Harmonics(problem, scene)
        self.beta = ends_of(enclosed(problem.unit_angle))
        self.width = self.width_of(cam, scene)
        self.pressure = self.pressure_limits()
        self.form = cam.get("form", "open")
        self.given = given
        self.rules = self.rules_of(scene, given, Fraction(0))
        self.as_found = self.rules_of(scene, self.sizes, 4 * KEPT)

    def made(self, corner, sizes, room):
        """The rules of a cam with these numbers at a choice of the ends of its tolerances."""
        if not self.direct:
            searched = {name: size for name, size in self.rules.searched.items() if name not in sizes}
            if foreign := self.tolerances.searched_under_other_names(self.scene, self.rules.searched):
                raise Unverified(f"the tolerance of {foreign}, which is searched")
            found = {name: size + corner.numbers.get(name, Fraction(0)) for name, size in sizes.items()}
            own = OTHER_RULES[self.kind](self.problem, self.tolerances.scene_of(self.scene, corner), room, found)
            return MadeRules(own, corner, searched)
        for name in ("forces.preload", "forces.spring_rate"):
            if name in corner.numbers and name not in sizes:
                sizes = sizes | {name: self.forces.preload if name.endswith("preload") else self.forces.rate}
        searched = {name: size for name, size in sizes.items() if isinstance(size, tuple)}
        moved = {name: size if name in searched else size + corner.numbers.get(name, Fraction(0)) for name, size in sizes.items()}
        return MadeRules(self.rules_of(self.scene, moved, room), corner, searched)

    def be_other(self, scene, result, weights):
        """A cam of another kind: its limits are formulas of its own. Of dimensions in the objective, which are divided by the lift (of
        what turns: times the centre distance, the middle of its range), the lower end of the enclosed cost is taken for bounds."""
        make = OTHER_RULES.get(self.kind)
        if make is None:
            return
        self.judged, self.swings, self.width, self.form = True, True, None, "open"
        self.rules = make(self.problem, scene)
        self.searched = self.rules.searched
        self.forces = getattr(self.rules, "forces", None)
        found = self.found(result, self.rules.units)
        sizes, unit = self.rules.sizes | found, ends_of(self.rules.cost_unit())
        used = {name: weight for name, weight in weights.items() if weight}
        if not set(used) <= set(sizes):
            raise Unverified("dimensions of this kind of cam in the objective")
        self.sizes = found
        self.weights = {name: used.get(name, Fraction(0)) / unit[1] for name in set(used) | set(self.searched)}
        self.fixed = sum((self.weights[name] * abs(sizes[name]) for name in used if name not in self.searched), Fraction(0))
        if None not in found.values():
            self.as_found = make(self.problem, scene, 4 * KEPT, found)
            low = sum((self.weights[name] * abs(sizes[name]) for name in used), Fraction(0))
            self.cost = low, low * unit[1] / unit[0]

    def rules_of(self, scene, sizes, room):
        """The rules of the cam's one side or of its two."""
        if self.kind == "linear":
            inclination = angle_of(scene["cam"], "inclination") or (Fraction(0), "deg")
            return linear_rules.LinearRules(self.problem, scene, self.follower, self.sense, inclination, sizes, room)

        def make(side, more=()):
            return DiskRules(self.problem, scene, self.follower, self.sense, sizes | dict(more), room, side)

        cam = scene["cam"]
        if self.form == "open":
            return make(Side())
        if self.searched or self.follower not in ("translating_roller", "oscillating_roller"):
            raise Unverified(f'cam.form = "{self.form}" with dimensions that are searched, or without a roller')
        if self.form == "grooved":
            wider = dimension_of(cam, "groove_clearance") / 2
            return TwoSides(make(Side(1, wider)), make(Side(-1, wider, None, -1)))
        if self.form != "conjugate":
            raise Unverified(f'cam.form = "{self.form}"')
        turn = constant(dimension_of(cam, "roller_distance"))
        if self.swings:
            turn = enclosed(angle_of(cam, "arm_angle"))
        second = {"second_" + name: dimension_of(cam, "second_" + name) or sizes.get(name, Fraction(0))
                  for name in ("roller_radius", "arm_length", "offset")}
        if "second_offset_mm" in cam or "second_offset_m" in cam or "second_offset_in" in cam:
            second["second_offset"] = dimension_of(cam, "second_offset")
        return TwoSides(make(Side()), make(Side(1, Fraction(0), turn, -1), second))

    def found(self, result, units):
        """What was found of the dimensions that are searched, m or rad (None: nothing)."""
        if not result.get("cam"):
            return dict.fromkeys(self.searched)
        design = dict(zip(result["design"]["names"], result["design"]["values"]))
        found = {name: number(design[name] if name.startswith("forces.") else
                              result["cam"]["dimensions"][f"{name}_{'m' if units[name] == 'm' else 'rad'}"]) for name in self.searched}
        for name, (low, high) in self.searched.items():
            size, room = found[name] if units[name] == "m" else in_unit((found[name], "rad"), units[name]), STATED * largest_of((low, high))
            if not low - room <= size <= high + room:
                raise Refuted(f"the {name} is outside its range")
        return found

    def pressure_limits(self):
        """(upper side, lower side): the largest pressure angle of rises and of returns, in degrees."""
        found = []
        for name in ("pressure_angle", "rise_pressure_angle", "return_pressure_angle"):
            value = angle_of(self.problem.limits, name)
            found.append(value and value[0])
        general, up, down = found
        return up if up is not None else general, down if down is not None else general

    @staticmethod
    def width_of(cam, scene):
        """(low, high) around half the width of a flat face, of a round one that of its chord beside the contact line; or None."""
        half, radius = dimension_of(cam, "face_half_width"), dimension_of(cam, "face_radius")
        contact = number(scene.get("forces", {}).get("contact_width_m", 0))
        return root(radius**2 - contact**2 / 4) if radius else (half, half) if half else None

    def found_parts(self):
        """What was found of the dimensions that are searched, as rules take them."""
        return [enclosures.interval(self.sizes[name] / largest_of(ends))[0] for name, ends in self.searched.items()]

    def reach(self):
        """[{dimension: sign}]: sums that are below 0 where a disk cam reaches its follower. An arm a - l < p, l - a < p, p < a + l; its
        face |base + offset| < a; a pushed roller or edge |offset| < p. p: base and roller radius. An arm over a plate |h + r - p| < l."""
        if self.kind == "linear":
            height = {"base_height": 1, "roller_radius": 1, "pivot_height": -1}
            return [{name: way * sign for name, sign in height.items()} | {"arm_length": -1} for way in (1, -1)] if self.swings else []
        prime = {name: -1 for name in ("base_radius", "roller_radius") if name in self.sizes}
        if self.follower == "oscillating_roller":
            return [prime | {"center_distance": 1, "arm_length": -1}, prime | {"center_distance": -1, "arm_length": 1},
                    {name: 1 for name in prime} | {"center_distance": -1, "arm_length": -1}]
        if self.follower == "oscillating_flat":
            return [{"base_radius": sign, "face_offset": sign, "center_distance": -1} for sign in (1, -1)]
        return [prime | {"offset": sign} for sign in (1, -1)] if "offset" in self.sizes else []

    def least_cost(self):
        return self.fixed + sum((self.weights[name] * min(map(abs, corners_of(ends))) for name, ends in self.searched.items()), Fraction(0))

    def least(self, leaning, cost):
        """What the dimensions add to a bound: cost and multipliers, at their best."""
        total = self.fixed if cost else Fraction(0)
        for name, ends in self.searched.items():
            weight, lean = self.weights[name] if cost else Fraction(0), leaning.get(name, Fraction(0))
            total += min(weight * abs(end) + lean * end for end in corners_of(ends))
        return total

    # -- rows of the bound

    def row(self, bound, k, run, name, origin, at):
        """(the row, factor of its multiplier), or None where this checker does not use it. Irrational numbers are taken
        at their middle, and what that can change is added to what the row may reach."""
        rule, sign, side = origin.key, origin.sign, origin.side or "right"
        if not self.judged or bound.relaxed:
            return None
        if rule in ("cam.face_half_width", "cam.face_radius") and origin.order == 1 and sign and self.width:
            function = {j: sign * w for j, w in run.cam_space.functional(at, 1, side).items()}
            return Row(name, k, function, self.width[1] * self.beta[1] / self.lift), \
                self.lift / self.width[1] / number(float(self.beta[0]))
        if self.kind in ("remote", "inverse") and self.searched:
            return None
        for formula in self.formulas_at(origin, at)[:1]:
            row = self.linear_row(bound, k, run, name, formula, at, side)
            return (row, 1 / self.row_size()) if row is not None else self.row_of_arm(bound, k, run, name, origin, at, formula)
        return None

    def linear_row(self, bound, k, run, name, formula, at, side):
        """A rule whose slopes are the same all over a box is linear; None where they differ."""
        box = [enclosures.interval(Fraction(-1), Fraction(1))] * 3 + [(0, 0)] + [(-enclosures.ONE, enclosures.ONE)] * len(self.searched)
        if self.direct and self.searched and self.rules.dimensions.get("offset"):
            base, roller, offset = (self.tangent_size(size) for size in ("base_radius", "roller_radius", "offset"))
            self.rules.tangent_at = base + roller, offset
            if None in self.sizes.values():
                bound.left_out.setdefault(name.partition(" at x")[0], Fraction(0))  # another tangent could say more
        try:
            found = enclosures.over_box(formula, box)
            still = enclosures.at_place(formula, [0] * len(box))
        except Unverified:
            return None
        finally:
            self.rules.tangent_at = None
        slopes = {i: middle_of(tuple(enclosures.fraction(end) for end in ends)) for i, ends in found.slopes.items()}
        if any(half > STRAIGHT * max(1, abs(middle)) for middle, half in slopes.values()):
            return None
        function, searched, most = {}, {}, -enclosures.fraction(still.value[0])
        for i, (middle, half) in slopes.items():
            if i > 3:
                dimension = list(self.searched)[i - 4]
                searched[dimension] = middle / largest_of(self.searched[dimension])
            else:
                add_to(function, run.cam_space.functional(at, i, side), middle)
            most += half * (bound.cam_supremum(k)[i] if i < 4 else 1)
        return Row(name, k, function, most, None, searched)

    def tangent_size(self, name):
        """Where tangents are taken: at what was found of a dimension; without a motion at the largest cam. Any place will do."""
        size = self.sizes.get(name, Fraction(0))
        return size if size is not None else sum(self.searched[name]) / 2 if name == "offset" else self.searched[name][1]

    # -- limits of the delivered motion

    def keep_limits(self, curve):
        """Names of the limits that are kept, by exact arithmetic; what is not looked at is named in `missing`."""
        kept, missing = [], []
        if not self.judged:
            return [], [f"limits.{key} of a {self.kind} cam" for key in self.problem.limits if key not in ORDERS]
        laws = [s for s in self.problem.stretches if s.kind == "law"]
        rests = [s for s in self.problem.stretches if s.kind == "dwell"]
        for key in self.problem.limits:
            if key.removeprefix("cam_").split("_")[0] in ORDERS or key == "spring_harmonics":
                continue
            if key.startswith("spring_harmonic_"):
                self.problem.harmonics.keep(curve)
                kept.append("limits." + key)
                continue
            keep = self.keeper_of(key)
            if keep is None:
                missing.append("limits." + key)
                continue
            loaded = rests if laws or (self.forces and not self.forces.is_constant() and key in LOADED) else []
            if laws + loaded and not self.keep_along_laws(key, laws + loaded):
                missing.append(f"limits.{key} on segments with a law")
                continue
            for drawn in self.every_made():
                self.keeper_of(key)(curve) if drawn else keep(curve)
            kept.append("limits." + key)
        if self.width:
            most = self.width[0] * (1 + KEPT) * self.beta[0] / self.lift
            if largest_magnitude([(derivative(p), w) for run in curve.cam_pieces() for p, w, _, _ in run])[1] > most or \
                    not all(keeps(law, 1, sign, most, law.begin, law.end) for law in laws for sign in (1, -1)):
                raise Refuted(f"the contact leaves the face, {float(self.width[0])} m from the axis")
            kept.append("the width of the face")
        return kept, missing

    def every_made(self):
        """False for the cam of the drawing, then True for every choice of ends of its tolerances, which is what was found meanwhile."""
        yield False
        if not self.tolerances.given:
            return
        drawn = self.as_found
        try:
            for corner in self.tolerances.corners():
                self.as_found = self.made(corner, self.sizes, 4 * KEPT)
                yield True
        finally:
            self.as_found = drawn

    def keeper_of(self, key):
        """What looks at a limit along the delivered motion; None: nothing here does."""
        if not self.direct:
            formulas, more = self.as_found.kept(key)
            return (lambda curve: self.keep_formulas(curve, key, formulas, more)) if formulas else None
        if key.endswith("pressure_angle_deg"):
            return (lambda curve: None) if self.follower == "translating_flat" else lambda curve: self.keep_pressure(curve, key)
        if key in LOADED and self.form != "open" and self.forces and not self.forces.is_constant():
            return None
        formulas = self.formulas_along(key)
        return (lambda curve: self.keep_formulas(curve, key, formulas)) if formulas else None

    def formulas_along(self, key, part=""):
        """Formulas of a limit that any stretch of a motion can be held against; none: there are none here."""
        if key in LOADED and self.form != "open" and self.forces and not self.forces.is_constant():
            return []
        return [f for origin in rows_of(key, part) for f in self.as_found.formulas(origin)]

    def keep_along_laws(self, key, stretches):
        """Along laws and dwells. False: nothing here looks at the limit there."""
        formulas = self.formulas_along(key)
        for copy, stretch in itertools.product(range(self.problem.copies), stretches):
            by, length = copy * self.problem.stretches[-1].end, stretch.end - stretch.begin
            for begin, end, motion in parts_along(stretch, 3):
                self.keep_along(key, formulas, motion, stretch.begin + by + begin * length, length, end - begin)
        return bool(formulas)

    def keep_formulas(self, curve, key, formulas, more=()):
        """Formulas of one cam angle along the splines. `more`: ranges of further numbers of a formula."""
        loaded = key in LOADED and self.forces and not self.forces.is_constant()
        for copy, (run, own) in itertools.product(range(self.problem.copies if loaded else 1), zip(self.problem.runs, curve.cam_pieces())):
            for p, width, left, stretch in own:
                orders = [[constant(c) for c in derivative(p, order)] for order in range(3)]
                place = left - run.begin_of(stretch) + stretch.begin + copy * self.problem.stretches[-1].end
                self.keep_along(key, formulas, lambda v, orders=orders: [value_at(c, v) for c in orders], place, Fraction(1), width, more)

    def keep_along(self, key, formulas, motion, place, scale, width, more=()):
        """Nowhere above 0 along a motion of 0 <= v <= width, x = place + scale v; what moves beside the motion is told x too."""
        moves, more = not self.direct and self.as_found.moves, [enclosures.interval(*ends) for ends in more]
        whole = place, place + scale * width
        lines = self.forces.lines(*whole) if self.forces and key in LOADED else [(*whole, Fraction(0), Fraction(0))]
        for (begin, end, load, slope), formula in itertools.product(lines, formulas):
            def room(numbers, load=load, slope=slope, formula=formula):
                x = place + scale * numbers[0]
                self.as_found.load = load + slope * x
                state = motion(numbers[0]) + numbers[1:]
                return -(formula(state, x) if moves else formula(state))
            if enclosures.least(room, [enclosures.interval((begin - place) / scale, (end - place) / scale), *more], 0) is None:
                raise Refuted(f"limits.{key} is passed")

    def formulas_at(self, origin, at):
        """What a row's limit may mean at a place."""
        if self.rules is None:
            return []
        rules = self.rules
        if origin.made:
            rules = self.made(self.tolerances.made(origin.made), self.given if self.direct else {}, Fraction(0))
        if self.forces and not self.forces.is_constant():
            if self.form != "open":
                raise Unverified("a load over the cam angle on a cam of two sides")
            rules.load = constant(self.forces.load_at(at, origin.side or "right"))
        return rules.formulas(origin, at) if not self.direct and rules.moves else rules.formulas(origin)

    def keep_pressure(self, curve, key):
        """Both sides along the motion, and at rest the least of all limits."""
        self.keep_formulas(curve, key, self.formulas_along(key))
        least = min(limit for limit in self.pressure if limit is not None)
        levels = {level for s in self.problem.stretches for level in (s.start, s.to)}
        for level in levels | ({Fraction(1)} if self.problem.type == "RR" else set()):
            for sign in (1, -1):
                rest = [enclosures.interval(self.problem.cam_at_rest(level))[0], 0, 0]
                if any(enclosures.at_place(f, rest).value[1] > 0 for f in self.as_found.pressures(least, sign)):
                    raise Refuted("the pressure angle at rest passes its limit")

    def row_of_arm(self, bound, k, run, name, origin, at, formula):
        """Rows of an arm. Where a rule is convex, camopt's rows are its tangents: here the tangent at the delivered motion,
        lowered as far as it must be to lie under the rule wherever a motion can be."""
        side = origin.side or "right"
        if not origin.key.endswith("pressure_angle_deg") or origin.order != 1 or bound.curve is None or self.problem.free or \
                self.kind in ("remote", "inverse"):
            return None
        values = [bound.curve.value_at(k, at, side, order, bound.curve.cam_pieces()) for order in range(2)]
        place = [enclosures.interval(v)[0] for v in values] + self.found_parts()
        ranges = [self.displacements(bound, k, at), (-bound.cam_supremum(k)[1], bound.cam_supremum(k)[1])]
        ranges += [parts_of(ends) for ends in self.searched.values()]

        def pressure(numbers):
            return formula(numbers[:2] + [constant(0), constant(0)] + numbers[2:])

        found = enclosures.tangent_at(pressure, place)
        slopes = [enclosures.fraction(sum(found.slopes.get(i, (0, 0))) // 2) for i in range(len(place))]

        def leaning(by):
            return self.row_under(pressure, [slopes[0] + by, *slopes[1:]], place, ranges, (name, k, run, at, side))
        row = leaning(Fraction(0))
        if row is None:
            return None
        row.leaning = leaning
        return row, 1 / self.row_size()

    def row_under(self, rule, slopes, place, ranges, where):
        """slopes . (y, y') + constant <= rule in these ranges as a row; None where the slopes fit too badly."""
        name, k, run, at, side = where
        factors = [constant(s) for s in slopes]

        def above(numbers):
            return rule(numbers) - sum((f * z for f, z in zip(factors, numbers)), constant(0))
        ends = [enclosures.interval(*r) for r in ranges]
        touching, lowest = enclosures.at_place(above, place).value[0], None
        for below in (Fraction(1, 10**12), Fraction(1, 10**9), Fraction(1, 10**6)):
            enough = touching - enclosures.interval(below)[0]
            lowest = lowest if lowest is not None else enclosures.least(above, ends, enough)
        if lowest is None:
            return None
        function = {}
        for order, slope in enumerate(slopes[:2]):
            add_to(function, run.cam_space.functional(at, order, side), slope)
        searched = {name: slope / largest_of(ends) for slope, (name, ends) in zip(slopes[2:], self.searched.items())}
        return Row(name, k, function, -enclosures.fraction(lowest), None, searched)

    def row_size(self):
        """What rows of arms and of cams in space are divided by beyond the formulas here."""
        return Fraction(1) if self.direct else middle_size(self.rules.sizes["center_distance"])

    def displacements(self, bound, k, at):
        """What the cam's displacement can be at a place."""
        low, high = bound.displacements_at(k, at)
        if self.problem.to_cam:
            by_y, *others = self.problem.to_cam
            beside = sum(w * bound.supremum[k][order] for order, w in enumerate(others, 1) if w)
            low, high = by_y * low - beside, by_y * high + beside
        return self.kept_within(low, high)

    def kept_within(self, low, high):
        """What the limits leave of a range of y."""
        own = self.rules.displacements() if self.rules and self.problem.type == "DRD" else None
        return (max(low, own[0]), min(high, own[1])) if own else (low, high)
