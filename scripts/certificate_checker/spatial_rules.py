# SPDX-License-Identifier: MIT
"""The limits of barrel and cylindrical cams, as formulas like those of disk_rules.py.

The roller's axis moves across the cam's surface with V_u along its travel and V_b across it; tan(pressure angle) = V_u /
|V_b|. With A the second derivative of a point of the axis, F = V . e along the axis, M = e' . n, W^2 = V_u^2 + V_b^2, a flank
is regular where  1 - R (A . n - 2 F M) / W^2 - (R M / W)^2 = g > 0,  n the flank's normal, one for either side, R half the width of the
groove. A force F on the follower presses with F / (lever |V_b| / W) along the normal, on the flank that pushes it on where F > 0, and over
the width b of the roller with the pressure sqrt(N / (pi b C radius)), radius = r R g q / (r q^2 + (R - r) g), q^2 = 1 + (R M / W)^2.

Theorem. A limit is satisfied at a station (a flank and a part of the roller's length) where its formula is at or below 0; `margin` holds at
every part of the length.
"""

from .dimensions import FollowerMotion, largest_of, middle_size
from .disk_rules import LOADED, TOUCHES, carried_at
from .forces import Forces
from .laws import constant
from .enclosures import ends_of, tangent
from .plane_vectors import sign_of
from .exact import number
from .origins import rows_of
from .rational import Fraction
from .units import angle_of, dimension_of, enclosed

PARTS = (Fraction(0), Fraction(1, 2), Fraction(1))  # of the roller's length
STATIONS = [(flank, part) for part in PARTS for flank in (1, -1)]  # in camopt's order
NAMES = ("roller_radius", "arm_length", "center_distance", "lateral_offset", "roller_length")


class SpatialRules(FollowerMotion):
    """Lengths in m, angles in rad. `found`: of dimensions that are searched what was found; without it they are the numbers
    behind y''' in units of the largest they may be. `room`: by how much a rule may be passed."""

    of_planes = False

    def __init__(self, problem, scene, room=Fraction(0), found=None):
        cam, self.limits, self.room = scene["cam"], problem.limits, constant(room)
        self.sense = -1 if cam.get("rotation", "counterclockwise") == "clockwise" else 1
        self.kind = "barrel" if cam["type"] == "barrel" else cam.get("follower")
        self.sizes = {name: dimension_of(cam, *self.keys(name)) for name in NAMES} | (found or {})
        self.searched, self.units = {name: size for name, size in self.sizes.items() if isinstance(size, tuple)}, dict.fromkeys(NAMES, "m")
        super().__init__(problem)
        self.start = self.units_of_motion[0] * Fraction(-1, 2) if self.kind != "translating" else constant(0)
        given = angle_of(cam, "start_angle")
        if given:
            self.start = enclosed(given)
        self.problem, self.wider = problem, Fraction(dimension_of(cam, "groove_clearance") or 0) / 2
        self.given = scene.get("forces", {})
        self.forces = Forces(problem, scene) if self.given else None
        # On the follower at the cam angle that is looked at, N: set anew where it is not the same everywhere.
        self.load = constant(self.forces.points[0][1]) if self.forces else constant(0)

    def cost_unit(self):
        """What dimensions in the objective are divided by: the lift, of what turns times the centre distance, the middle of its range."""
        return self.units_of_motion[0] * (1 if self.kind == "translating" else middle_size(self.sizes["center_distance"]))

    def keys(self, name):
        """A translating follower's distance from the cam's axis is called the cylinder's radius."""
        return (name, "cylinder_radius") if name == "center_distance" and self.kind == "translating" else (name,)

    def size(self, name, numbers):
        if name not in self.searched:
            return constant(self.sizes[name])
        return numbers[4 + list(self.searched).index(name)] * largest_of(self.searched[name])

    def axis(self, numbers, height):
        """V_u, V_b, F, A_u, A_b and the parts of e' of the axis at a height over its near end."""
        s, slope, bend = self.states(numbers)
        sense, none = constant(self.sense), constant(0)
        arm, distance, beside = (self.size(n, numbers) for n in ("arm_length", "center_distance", "lateral_offset"))
        if self.kind == "translating":
            return slope, sense * (distance - height), sense * beside, bend, -beside, none, -sense
        sine, cosine = (self.start + s).sine_and_cosine()
        if self.kind == "barrel":
            rho, lateral = distance - height, arm * cosine - beside
            return arm * slope - sense * rho * sine, -sense * rho * cosine, sense * lateral, \
                arm * bend + lateral * sine, arm * slope.square() + lateral * cosine, sense * sine, sense * cosine
        rho = arm + height
        radial = distance - rho * cosine
        return rho * slope - sense * beside * sine, sense * radial, sense * beside * cosine, rho * bend - radial * sine, \
            2 * sense * rho * slope * sine - beside, slope, -sense * cosine

    def formulas(self, origin):
        """The rules of a limit at the roller's stations: the pressure angle and the height of the contact at its ends alone."""
        name, stations = origin.key.removeprefix("limits."), origin.chosen("station", STATIONS)
        if name == "pressure_angle_deg" and origin.sign:
            return [self.pressure(number(self.limits[name]), origin.sign, part) for part in self.ends(stations)]
        if name == "undercut_margin":
            return [self.scaled_margin(number(self.limits[name]), *station) for station in stations]
        if name not in LOADED or not self.forces:
            return []
        if origin.part == "undercut":
            return [self.scaled_margin(TOUCHES, *station) for station in stations]
        if origin.part == "contact_height":
            return [self.near(part) for part in self.ends(stations)]
        return [rule for corner in origin.chosen("load_speed", self.forces.corners, 0) for rule in self.loads(name, corner, origin, stations)]

    @staticmethod
    def ends(stations):
        return [part for part in PARTS[::2] if part in [own for _, own in stations]]

    def kept(self, key):
        """(formulas that are nowhere above 0 along a motion that keeps the limit, further numbers of theirs)."""
        if key == "undercut_margin":
            margin = number(self.limits[key])
            return [self.margin(margin, flank) for flank in (1, -1)], [(Fraction(0), Fraction(1))]
        return [f for origin in rows_of(key) for f in self.formulas(origin)], []

    def groove(self, numbers):
        """Half its width."""
        return self.size("roller_radius", numbers) + self.wider

    def height(self, part, numbers):
        return part * self.size("roller_length", numbers)

    def pressure(self, limit, sign, part):
        """sign V_u cos - |V_b| sin, at a part of the roller's length."""
        steep = tangent(limit)
        cosine = (1 + steep.square()).root().inverse()
        sine = cosine * steep
        above = constant(-self.sense if self.kind == "barrel" else self.sense)

        def rule(numbers):
            across, along = self.axis(numbers, self.height(part, numbers))[:2]
            return sign * across * cosine - above * along * sine - self.room
        return rule

    def loads(self, name, corner, origin, stations):
        """The rules of a limit on a load."""
        if name == "torque_max_nm":
            return [self.torque(sign, corner) for sign in origin.signs("torque")]
        if name == "contact_force_max_n":
            return [self.largest_force(pressed, corner) for pressed in origin.chosen("side", (1, -1))]
        if name == "hertz_pressure_max_mpa":
            return [self.hertz(number(self.limits[name]) * 10**6, corner, *station) for station in stations]
        return []

    def unscaled(self, rule):
        """Rows of these cams are divided by the centre distance beyond the formulas here, planes of a bound over boxes are not: of
        loads neither is."""
        size = constant(1 if self.of_planes else middle_size(self.sizes["center_distance"]))
        return lambda numbers: (rule(numbers) - self.room) * size

    def force(self, numbers, corner):
        return self.forces.on_follower(numbers, corner, self.load, self.forces.preload, self.forces.rate)

    def pressed(self, flank):
        """The sign of the force that presses on a flank."""
        return flank * (-self.sense if self.kind == "barrel" else self.sense)

    def torque(self, sign, corner):
        """sign F s' / most - 1, s' by the cam's angle in rad."""
        factor = constant(sign / number(self.limits["torque_max_nm"]))
        return self.unscaled(lambda numbers: self.force(numbers, corner) * self.states(numbers)[1] * factor - 1)

    def largest_force(self, pressed, corner):
        """`pressed`: the sign of the force that presses on the side."""
        most = number(self.limits["contact_force_max_n"])
        return self.unscaled(lambda numbers: self.force(numbers, corner) * (pressed / most) - 1)

    def near(self, part):
        """The axis of the cam stays away from that of the roller, by parts of the centre distance."""
        above = constant(-self.sense if self.kind == "barrel" else self.sense)
        inverse = constant(1 / middle_size(self.sizes["center_distance"]))
        return self.unscaled(lambda numbers: TOUCHES - above * self.axis(numbers, self.height(part, numbers))[1] * inverse)

    def hertz(self, most, corner, flank, part):
        """F <= carried * radius * lever, in parts of a unit of force (of what turns: of a moment)."""
        unit, carried = carried_at(most, self.problem, self.given)
        side, wider = constant(flank), constant(self.wider)
        above = constant(-self.sense if self.kind == "barrel" else self.sense)

        def rule(numbers):
            radius, height = self.size("roller_radius", numbers), self.height(part, numbers)
            across, along, beside, turn_u, turn_b, tilt_u, tilt_b = self.axis(numbers, height)
            inverse = (across.square() + along.square()).inverse()
            speed, groove = inverse.root(), radius + wider
            turn, tilt = turn_b * across - turn_u * along, tilt_b * across - tilt_u * along
            twist = (groove * tilt * inverse).square()
            g = 1 - side * groove * (turn - 2 * beside * tilt) * inverse * speed - twist
            inclined = 1 + twist
            contact = radius * groove * g * inclined.root() * (radius * inclined + wider * g).inverse()
            lever = constant(1) if self.kind == "translating" else self.size("arm_length", numbers)
            if self.kind == "rotating":
                lever = lever + height
            press = self.force(numbers, corner) * (self.pressed(flank) / unit)
            return press - carried * contact * lever * above * along * speed
        return self.unscaled(rule)

    def margin(self, least, flank):
        """least - g at any height: the last of the numbers is the part of the roller's length."""
        side = constant(flank)

        def rule(numbers):
            radius, height = self.groove(numbers), numbers[3] * self.size("roller_length", numbers)
            across, along, beside, turn_u, turn_b, tilt_u, tilt_b = self.axis(numbers, height)
            inverse = (across.square() + along.square()).inverse()
            turn, tilt = turn_b * across - turn_u * along, tilt_b * across - tilt_u * along
            bend = (turn - 2 * beside * tilt) * inverse * inverse.root()
            return least - 1 + side * radius * bend + (radius * tilt * inverse).square() - self.room
        return rule

    def scaled_margin(self, least, flank, part):
        """least - g times W^3 / (r lever |V_b|): linear in the follower's acceleration, which A_u has times the lever."""
        side = constant(flank)

        def rule(numbers):
            radius, height = self.groove(numbers), self.height(part, numbers)
            lever = constant(1) if self.kind == "translating" else self.size("arm_length", numbers)
            if self.kind == "rotating":
                lever = lever + height
            still = [*numbers[:2], constant(0), *numbers[3:]]
            across, along, beside, turn_u, turn_b, tilt_u, tilt_b = self.axis(still, height)
            square = across.square() + along.square()
            turn, tilt = turn_b * across - turn_u * along, tilt_b * across - tilt_u * along
            room = (least - 1) * square * square.root() * radius.inverse() + \
                side * (turn - 2 * beside * tilt) + radius * tilt.square() * square.root().inverse()
            sign, bend = sign_of(along), self.states(numbers)[2]
            return room * (lever * sign * along).inverse() - side * sign * bend - self.room
        return rule

    def displacements(self):
        """Where a motion that rests at both ends and keeps the pressure angle's limit stays, of a barrel cam: at its largest and
        its least angle the index stands, and the limit says that it stands no farther aside than the limit."""
        if self.kind != "barrel" or "pressure_angle_deg" not in self.limits:
            return None
        most = ends_of(enclosed((number(self.limits["pressure_angle_deg"]), "deg")))[1]
        start, lift = ends_of(self.start), ends_of(self.units_of_motion[0])[0]
        return (-most - start[1]) / lift, (most - start[0]) / lift
