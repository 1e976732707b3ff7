# SPDX-License-Identifier: MIT
"""The limits of barrel and cylindrical cams, as formulas like those of disk_rules.py.

The roller's axis moves across the cam's surface with V_u along its travel and V_b across it; tan(pressure angle) = V_u /
|V_b|. With A the second derivative of a point of the axis, F = V . e along the axis, M = e' . n, W^2 = V_u^2 + V_b^2, a flank
is regular where  1 - r (A . n - 2 F M) / W^2 - (r M / W)^2 > 0,  n the flank's normal, one for either side.
"""

from .dimensions import largest_of, middle_size
from .laws import constant
from .enclosures import Over
from .plane_vectors import sign_of
from .exact import PI, exactly, number, tangent, times
from .rational import Fraction
from .units import angle_of, dimension_of, enclosed

NAMES = ("roller_radius", "arm_length", "center_distance", "lateral_offset", "roller_length")


class SpatialRules:
    """Lengths in m, angles in rad. `found`: of dimensions that are searched what was found; without it they are the numbers
    behind y''' in units of the largest they may be. `room`: by how much a rule may be passed."""

    moves = False

    def __init__(self, problem, scene, room=Fraction(0), found=None):
        cam, self.limits, self.room = scene["cam"], problem.limits, constant(room)
        self.sense = -1 if cam.get("rotation", "counterclockwise") == "clockwise" else 1
        self.kind = "barrel" if cam["type"] == "barrel" else cam.get("follower")
        self.sizes = {name: dimension_of(cam, *self.keys(name)) for name in NAMES} | (found or {})
        self.searched, self.units = {name: size for name, size in self.sizes.items() if isinstance(size, tuple)}, dict.fromkeys(NAMES, "m")
        self.lift, self.beta = enclosed(problem.lift), enclosed(problem.unit_angle)
        self.start = tuple(-end / 2 for end in reversed(self.lift)) if self.kind != "translating" else exactly(Fraction(0))
        given = angle_of(cam, "start_angle")
        if given:
            self.start = enclosed(given)

    def cost_unit(self):
        """What dimensions in the objective are divided by: the lift, of what turns times the centre distance, the middle of its range."""
        return self.lift if self.kind == "translating" else times(self.lift, exactly(middle_size(self.sizes["center_distance"])))

    def keys(self, name):
        """A translating follower's distance from the cam's axis is called the cylinder's radius."""
        return (name, "cylinder_radius") if name == "center_distance" and self.kind == "translating" else (name,)

    def size(self, name, numbers):
        if name not in self.searched:
            return constant(self.sizes[name])
        return numbers[4 + list(self.searched).index(name)] * constant(largest_of(self.searched[name]))

    def axis(self, numbers, height):
        """V_u, V_b, F, A_u, A_b and the parts of e' of the axis at a height over its near end."""
        lift, inverse = Over.number(*self.lift), Over.number(*self.beta).inverse()
        slope, bend = numbers[1] * lift * inverse, numbers[2] * lift * inverse * inverse
        sense, none = constant(self.sense), constant(0)
        arm, distance, beside = (self.size(n, numbers) for n in ("arm_length", "center_distance", "lateral_offset"))
        if self.kind == "translating":
            return slope, sense * (distance - height), sense * beside, bend, -beside, none, -sense
        sine, cosine = (Over.number(*self.start) + numbers[0] * lift).sine_and_cosine()
        if self.kind == "barrel":
            rho, lateral = distance - height, arm * cosine - beside
            return arm * slope - sense * rho * sine, -sense * rho * cosine, sense * lateral, \
                arm * bend + lateral * sine, arm * slope.square() + lateral * cosine, sense * sine, sense * cosine
        rho = arm + height
        radial = distance - rho * cosine
        return rho * slope - sense * beside * sine, sense * radial, sense * beside * cosine, rho * bend - radial * sine, \
            constant(2) * sense * rho * slope * sine - beside, slope, -sense * cosine

    def formulas(self, key, order=None, sign=0, remark=""):
        """All rules that a limit stands for: at the near and the far end of the roller."""
        if key == "limits.pressure_angle_deg" and sign and not remark:
            return [self.pressure(number(self.limits["pressure_angle_deg"]), sign, part) for part in (Fraction(0), Fraction(1))]
        if key == "limits.undercut_margin" and not remark:
            return [self.scaled_margin(number(self.limits["undercut_margin"]), flank, part) for flank in (1, -1)
                    for part in (Fraction(0), Fraction(1, 2), Fraction(1))]
        return []

    def kept(self, key):
        """(formulas that are nowhere above 0 along a motion that keeps the limit, further numbers of theirs)."""
        if key == "pressure_angle_deg":
            return [f for sign in (1, -1) for f in self.formulas("limits." + key, 1, sign)], []
        if key == "undercut_margin":
            margin = number(self.limits[key])
            return [self.margin(margin, flank) for flank in (1, -1)], [(Fraction(0), Fraction(1))]
        return [], []

    def height(self, part, numbers):
        return constant(part) * self.size("roller_length", numbers)

    def pressures(self, limit, sign):
        return []

    def pressure(self, limit, sign, part):
        """sign V_u cos - |V_b| sin, at a part of the roller's length."""
        steep = Over.number(*tangent(limit))
        cosine = (constant(1) + steep.square()).root().inverse()
        sine = cosine * steep
        above = constant(-self.sense if self.kind == "barrel" else self.sense)

        def rule(numbers):
            across, along = self.axis(numbers, self.height(part, numbers))[:2]
            return constant(sign) * across * cosine - above * along * sine - self.room
        return rule

    def margin(self, least, flank):
        """least - g at any height: the last of the numbers is the part of the roller's length."""
        side = constant(flank)

        def rule(numbers):
            radius, height = self.size("roller_radius", numbers), numbers[3] * self.size("roller_length", numbers)
            across, along, beside, turn_u, turn_b, tilt_u, tilt_b = self.axis(numbers, height)
            inverse = (across.square() + along.square()).inverse()
            turn, tilt = turn_b * across - turn_u * along, tilt_b * across - tilt_u * along
            bend = (turn - constant(2) * beside * tilt) * inverse * inverse.root()
            return constant(least) - constant(1) + side * radius * bend + (radius * tilt * inverse).square() - self.room
        return rule

    def scaled_margin(self, least, flank, part):
        """least - g times W^3 / (r lever |V_b|): linear in the follower's acceleration, which A_u has times the lever."""
        side = constant(flank)

        def rule(numbers):
            radius, height = self.size("roller_radius", numbers), self.height(part, numbers)
            lever = constant(1) if self.kind == "translating" else self.size("arm_length", numbers)
            if self.kind == "rotating":
                lever = lever + height
            still = [*numbers[:2], constant(0), *numbers[3:]]
            across, along, beside, turn_u, turn_b, tilt_u, tilt_b = self.axis(still, height)
            square = across.square() + along.square()
            turn, tilt = turn_b * across - turn_u * along, tilt_b * across - tilt_u * along
            room = constant(least - 1) * square * square.root() * radius.inverse() + \
                side * (turn - constant(2) * beside * tilt) + radius * tilt.square() * square.root().inverse()
            sign, inverse = sign_of(along), Over.number(*self.beta).inverse()
            bend = numbers[2] * Over.number(*self.lift) * inverse.square()
            return room * (lever * sign * along).inverse() - side * sign * bend - self.room
        return rule

    def displacements(self):
        """Where a motion that rests at both ends and keeps the pressure angle's limit stays, of a barrel cam: at its largest and
        its least angle the index stands, and the limit says that it stands no farther aside than the limit."""
        if self.kind != "barrel" or "pressure_angle_deg" not in self.limits:
            return None
        most = times(PI, exactly(number(self.limits["pressure_angle_deg"]) / 180))[1]
        return (-most - self.start[1]) / self.lift[0], (most - self.start[0]) / self.lift[0]
