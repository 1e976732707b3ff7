# SPDX-License-Identifier: MIT
"""The limits of disk cams as formulas of one cam angle.

Theorem. Where the follower's contact is above the cam's centre (D > 0), a limit is satisfied at a cam angle where its formula, of y, y', y'' and
the dimensions that are searched, is at or below 0, and violated where it is above 0: the formula is the limit's excess times a positive number.

With N and D the two parts of the speed of the roller's centre in the cam's frame, tan(pressure angle) = N / D,
v^2 = N^2 + D^2 and curvature (v^2 + drift N - D push) / v^3, push = lever s''. Formulas are used for planes of bounds over boxes, for rows
of bounds by multipliers, and for the delivered motion.
"""

from .dimensions import FollowerMotion, largest_of, middle_size
from .enclosures import PI, tangent
from .exact import middle_of, number
from .forces import Forces
from .laws import constant
from .rational import Fraction
from .units import dimension_of

FACE_TURNS = Fraction(999, 1000)  # a face on an arm is to turn by more than 1/1000 of the cam's turning
LOADED = "contact_force_min_n", "contact_force_max_n", "torque_max_nm", "hertz_pressure_max_mpa"
TOUCHES = Fraction(1, 10**6)      # contact: regularity, and height over the centre in parts of the cam's length


class Side:
    """What one side of a cam is beside an open cam of the same dimensions. `flank`: -1 on the outer flank of a groove, where
    the pitch curve bends the other way; `wider`: what a flank lies beyond the roller's radius; `turn`: of the second disk of a
    conjugate cam, in whose mirror the follower moves the other way: between the arms (rad, enclosed) or the rollers (m);
    `pressed`: the sign of the force that presses on it."""

    def __init__(self, flank=1, wider=Fraction(0), turn=None, pressed=1):
        self.flank, self.wider, self.turn, self.pressed = flank, wider, turn, pressed


def carried_at(most, problem, given):
    """(unit of a force or a moment, pi b C most^2 in parts of it): what a contact carries at this pressure for every metre of radius."""
    compliance = Fraction(0)
    for side in ("cam", "follower"):
        poisson = number(given.get(f"{side}_poisson", Fraction(3, 10)))
        compliance += (1 - poisson**2) / (number(given.get(f"{side}_modulus_gpa", 210)) * 10**9)
    own = Forces(problem, problem.scene)
    swing = own.mass * problem.turns_per_second()**2 * own.lift
    unit = middle_of((max(own.preload, (swing + own.largest_load()) / 100, Fraction(1, 1000)),) * 2)[0]
    return unit, PI * (compliance * number(given["contact_width_m"]) * most**2 / unit)


class DiskRules(FollowerMotion):
    """`dimensions`: of names, the number, or (lowest, highest) where it is searched. Lengths in m, angles in rad. `room`:
    by how much a rule may be passed, in parts of its limit."""

    def __init__(self, problem, scene, follower, sense, dimensions, room=Fraction(0), side=None):
        self.side = side or Side()
        self.tangent_at = None  # (prime radius, offset) at which a tangent is taken in place of the height at displacement 0
        self.problem, self.follower = problem, follower
        self.limits, self.forces = problem.limits, scene.get("forces", {})
        self.sense, self.room = sense, constant(room)
        self.dimensions = dimensions if "roller_radius" in dimensions else dimensions | {"roller_radius": Fraction(0)}
        self.swings = follower.startswith("oscillating")
        self.searched = [name for name, size in dimensions.items() if isinstance(size, tuple)]
        super().__init__(problem)
        self.roller = follower in ("translating_roller", "oscillating_roller")
        # On the follower at the cam angle that is looked at, N: set anew where it is not the same everywhere.
        self.load = constant(0)
        if "forces" in scene:
            self.loaded = Forces(problem, problem.scene)
            self.load = constant(Forces(problem, scene).points[0][1])

    # -- the motion and the cam

    def states(self, numbers):
        """The other way in a mirror."""
        found = super().states(numbers)
        return [-s for s in found] if self.side.turn else found

    def sizes(self, numbers):
        """The dimensions; those searched stand behind y''' in parts of their largest magnitude."""
        searched = {name: numbers[4 + k] * largest_of(self.dimensions[name]) for k, name in enumerate(self.searched)}
        return {name: searched.get(name) or constant(size) for name, size in self.dimensions.items()}

    def pitch(self, numbers):
        """N, D, drift, lever and s'' of the centre of a roller (or of a knife edge)."""
        s, slope, bend = self.states(numbers)
        size = self.sizes(numbers)
        prime = size["base_radius"] + size["roller_radius"]
        sense, second = constant(-self.sense if self.side.turn else self.sense), self.side.turn
        if not self.swings:
            offset = size["offset"]
            start = self.start(prime, offset)
            if second:
                start, offset = second - start, size["second_offset"]
            return slope - offset * sense, start + s, slope, constant(1), bend
        distance, arm = size["center_distance"], size["arm_length"]
        start = (distance.square() + arm.square() - prime.square()) * (2 * distance * arm).inverse()
        rest = (1 - start.square()).root(), start
        if second:
            rest, arm = self.turned(-rest[0], rest[1], second), size["second_arm_length"]
        sine, cosine = self.turned(*rest, s)
        turning = 1 + slope * sense
        end = arm * turning
        return end - distance * cosine, distance * sine, end * slope * sense, arm, bend

    def start(self, prime, offset):
        """sqrt(prime^2 - offset^2), or its tangent, which lies above it (prime prime0 - offset offset0 >= the product of both roots)."""
        if not self.dimensions["offset"]:
            return prime
        if self.tangent_at is None:
            return (prime.square() - offset.square()).root()
        own = [constant(size) for size in self.tangent_at]
        return (own[0] * prime - own[1] * offset) * (own[0].square() - own[1].square()).root().inverse()

    @staticmethod
    def turned(sine, cosine, by):
        more, less = by.sine_and_cosine()
        return sine * less + cosine * more, cosine * less - sine * more

    def own_roller(self, numbers):
        return self.sizes(numbers)["second_roller_radius" if self.side.turn else "roller_radius"]

    def surface(self, numbers):
        """From the roller's centre to the cam's surface."""
        return self.own_roller(numbers) + self.side.wider

    def excess(self, numbers, factor, share):
        """factor * curvature of the side - share, times v^3 / (D lever)."""
        across, along, drift, lever, bend = self.pitch(numbers)
        square = across.square() + along.square()
        inverse = (along * lever).inverse()
        still = (square + drift * across) * inverse - bend
        return self.side.flank * factor * still - (share + self.room) * (square * square.root() * inverse)

    def curvature(self, numbers):
        """Of the side, and v."""
        across, along, drift, lever, bend = self.pitch(numbers)
        square = across.square() + along.square()
        speed = square.root()
        curvature = (square + drift * across - along * lever * bend) * (square * speed).inverse()
        return self.side.flank * curvature, speed

    def face(self, numbers):
        """Of a flat face on an arm: turning, D, and the cam's radius times turning."""
        s, slope, bend = self.states(numbers)
        size = self.sizes(numbers)
        distance, offset = size["center_distance"], size["face_offset"]
        start = (size["base_radius"] + offset) * distance.inverse()
        sine, cosine = self.turned(start, (1 - start.square()).root(), s)
        slope = slope * self.sense
        turning = 1 + slope
        inverse, along = turning.inverse(), distance * cosine
        radius = (distance * sine * (slope + turning) + along * bend * inverse) * inverse - offset * turning
        return turning, along, radius

    # -- the rules

    def formulas(self, origin):
        """The rules that a row of a limit means, or all rows of the limit; none: there is no such here."""
        name = origin.key.removeprefix("limits.")
        if name in LOADED and not origin.part:
            return self.loads(name, origin)
        found = self.formula(name, origin)
        return [found] if found else []

    def loads(self, name, origin):
        corners = origin.chosen("load_speed", self.loaded.corners, 0)
        if name == "torque_max_nm":
            return [self.torque(sign, corner) for corner in corners for sign in origin.signs("torque")]
        if name == "contact_force_min_n":
            return [self.contact(corner) for corner in corners]
        if name == "contact_force_max_n":
            return [self.largest_force(corner) for corner in corners]
        found = [self.hertz(number(self.limits[name]) * 10**6, corner) for corner in corners]
        return [rule for rule in found if rule]

    def formula(self, name, origin):
        sign = origin.sign
        if origin.part == "undercut":
            return self.margin(TOUCHES)
        if origin.part == "contact_height":
            return self.height()
        if origin.part == "face_turn":
            return self.face_turn()
        if origin.order == 0:
            return None
        if name.endswith("pressure_angle_deg") and sign:
            turned = self.sense < 0 if self.swings else self.side.turn is not None
            rises = (sign > 0) != turned
            own = "rise_pressure_angle_deg" if rises else "return_pressure_angle_deg"
            return self.pressure(number(self.limits[name]), sign) if name == (own if own in self.limits else
                                                                              "pressure_angle_deg") else None
        for start, make in (("cam_radius_min_", self.convex_radius), ("concave_radius_min_", self.concave_radius)):
            if name.startswith(start):
                return make(dimension_of(self.limits, start[:-1]))
        if name == "undercut_margin":
            return self.margin(number(self.limits[name]))
        return None

    def pressures(self, limit, sign):
        return [self.pressure(limit, sign)]

    def reach(self):
        """The length by which pressure angles and heights are measured."""
        ends = [self.dimensions[name] for name in (("center_distance",) if self.swings else ("base_radius", "roller_radius"))]
        return sum(map(middle_size, ends), Fraction(0))

    def pressure(self, limit, sign):
        """sign N cos - D sin, in parts of the reach. The upper side is that of the rise; an arm that rises with a clockwise
        cam, and the mirror of a second roller that is pushed, have it below."""
        steep = tangent(limit)
        cosine = (1 + steep.square()).root().inverse()
        sine, inverse = cosine * steep, constant(1 / self.reach())

        def rule(numbers):
            if self.follower == "oscillating_flat":
                turning, along, _ = self.face(numbers)
                across = self.sizes(numbers)["face_offset"] * turning
            else:
                across, along = self.pitch(numbers)[:2]
            return (across * cosine * sign - along * sine) * inverse - self.room
        return rule

    def convex_radius(self, least):
        """(roller + least) curvature <= 1."""
        if self.follower == "oscillating_flat":
            inverse = constant(1 / middle_size(self.dimensions["base_radius"]))

            def rule(numbers):
                turning, _, radius = self.face(numbers)
                return (least - radius * turning.inverse()) * inverse - self.room
            return rule
        if self.follower == "translating_flat":
            inverse = constant(1 / self.reach())

            def flat(numbers):
                s, _, bend = self.states(numbers)
                return (least - self.sizes(numbers)["base_radius"] - s - bend) * inverse - self.room
            return flat
        return lambda numbers: self.excess(numbers, self.surface(numbers) + least, constant(1))

    def concave_radius(self, least):
        """(roller - least) curvature <= 1: where the pitch curve bends the other way, it bends by no less than least."""
        if not self.roller and self.follower != "translating_knife":
            return None
        return lambda numbers: self.excess(numbers, self.surface(numbers) - least, constant(1))

    def margin(self, least):
        """1 - roller curvature >= least; of a flat face its radius in parts of the base radius, which is linear where it slides."""
        if self.follower == "oscillating_flat":
            return lambda numbers: least - self.face(numbers)[2] * self.sizes(numbers)["base_radius"].inverse() - self.room
        if self.follower == "translating_flat":
            least -= 1
            inverse = constant(1 / self.reach())

            def flat(numbers):
                s, _, bend = self.states(numbers)
                return (least * self.sizes(numbers)["base_radius"] - s - bend) * inverse - self.room
            return flat
        if not self.roller:
            return None
        return lambda numbers: self.excess(numbers, self.surface(numbers), constant(1 - least))

    def face_turn(self):
        """A face on an arm goes on turning in the cam's frame."""
        return lambda numbers: -FACE_TURNS - self.states(numbers)[1] * self.sense

    def height(self):
        inverse = constant(1 / self.reach())
        if self.follower == "oscillating_flat":
            return lambda numbers: TOUCHES - self.face(numbers)[1] * inverse
        return lambda numbers: TOUCHES - self.pitch(numbers)[1] * inverse

    def force(self, numbers, corner):
        sizes, own = self.sizes(numbers), self.loaded
        return own.on_follower(numbers, corner, self.load, sizes.get("forces.preload") or own.preload,
                               sizes.get("forces.spring_rate") or own.rate)

    def contact(self, corner):
        """F >= least."""
        inverse = constant(1 / self.loaded.unit(self.problem))
        return lambda numbers: (self.loaded.least - self.force(numbers, corner)) * inverse - self.room

    def largest_force(self, corner):
        """F <= most on the side that it presses on."""
        most = number(self.limits["contact_force_max_n"])
        return lambda numbers: self.force(numbers, corner) * (self.side.pressed / most) - 1 - self.room

    def hertz(self, most, corner):
        """F <= carried * radius * lever, carried = pi b C most^2, in parts of a unit of force (of an arm: of a moment). A roller
        of radius r lies on its side with the radius r (1 - R curvature) / (1 - (R - r) curvature), R to the surface."""
        if self.follower == "translating_knife":
            return None
        unit, carried = carried_at(most, self.problem, self.forces)

        def flat(numbers):
            if self.swings:  # the cam's radius and the lever, the contact's distance from the pivot's foot on the face
                turning, along, radius = self.face(numbers)
                radius, lever = radius * turning.inverse(), along * turning.inverse()
            else:
                s, _, bend = self.states(numbers)
                radius, lever = self.sizes(numbers)["base_radius"] + s + bend, constant(1)
            return self.force(numbers, corner) * (1 / unit) - carried * radius * lever - self.room

        def rule(numbers):
            curvature, speed = self.curvature(numbers)
            along, _, arm = self.pitch(numbers)[1:4]
            radius = (1 - self.surface(numbers) * curvature) * self.own_roller(numbers)
            press = self.force(numbers, corner) * (self.side.pressed / unit)
            if self.side.wider:
                press = press * (1 - self.side.wider * curvature)
            return press - carried * radius * arm * along * speed.inverse() - self.room
        return rule if self.roller else flat

    def torque(self, sign, corner):
        """sign F s' / most - 1."""
        most = number(self.limits["torque_max_nm"])
        return lambda numbers: self.force(numbers, corner) * self.states(numbers)[1] * (sign / most) - 1 - self.room


class TwoSides:
    """The rules of a groove or of a conjugate cam: those of either side. Both flanks of a groove have one normal, so that
    the pressure angle is that of the first alone."""

    searched = ()

    def __init__(self, first, second):
        self.first, self.sides = first, (first, second)

    def displacements(self):
        return None

    def bear(self, load):
        for side in self.sides:
            side.load = load

    load = property(None, bear)

    def formulas(self, origin):
        once = origin.key.endswith("pressure_angle_deg") and not self.sides[1].side.turn
        sides = origin.chosen("side", origin.chosen("station", self.sides))
        return [f for side in (sides[:1] if once else sides) for f in side.formulas(origin)]

    def pressures(self, limit, sign):
        return [side.pressure(limit, sign) for side in (self.sides if self.sides[1].side.turn else self.sides[:1])]

    def reach(self):
        return self.first.reach()
