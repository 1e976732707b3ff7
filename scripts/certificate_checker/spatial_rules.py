# SPDX-License-Identifier: MIT
"""The limits of barrel and cylindrical cams, as formulas like those of disk_rules.py.

The roller's axis moves across the cam's surface with V_u along its travel and V_b across it; tan(pressure angle) = V_u /
|V_b|. With A the second derivative of a point of the axis, F = V . e along the axis, M = e' . n, W^2 = V_u^2 + V_b^2, a flank
is regular where  1 - r (A . n - 2 F M) / W^2 - (r M / W)^2 > 0,  n the flank's normal, one for either side.
"""
from fractions import Fraction

from .disk_rules import constant
from .enclosures import Over
from .exact import PI, exactly, number, tangent, times
from .problem import LENGTHS, angle_of

NAMES = ("roller_radius", "arm_length", "center_distance", "lateral_offset", "roller_length")


class SpatialRules:
    """Lengths in m, angles in rad."""

    searched = ()

    def __init__(self, problem, scene, room=Fraction(0)):
        cam, self.limits, self.room = scene["cam"], problem.limits, constant(room)
        self.sense = -1 if cam.get("rotation", "counterclockwise") == "clockwise" else 1
        self.kind = "barrel" if cam["type"] == "barrel" else cam.get("follower")
        self.sizes = {name: next((number(cam[f"{key}_{unit}"]) * size for unit, size in LENGTHS.items()
                                  for key in self.keys(name) if f"{key}_{unit}" in cam), Fraction(0)) for name in NAMES}
        size, unit = problem.lift
        degree = times(PI, exactly(Fraction(1, 180)))
        self.lift = times(exactly(size), degree if unit == "deg" else exactly(Fraction(1)))
        angle, unit = problem.unit_angle
        self.beta = times(exactly(angle), degree if unit == "deg" else exactly(Fraction(1)))
        self.start = tuple(-end / 2 for end in reversed(self.lift)) if self.kind != "translating" else exactly(Fraction(0))
        given = angle_of(cam, "start")
        if given:
            self.start = times(exactly(given[0]), degree if given[1] == "deg" else exactly(Fraction(1)))

    def keys(self, name):
        """A translating follower's distance from the cam's axis is called the cylinder's radius."""
        return (name, "cylinder_radius") if name == "center_distance" and self.kind == "translating" else (name,)

    def axis(self, numbers, height):
        """V_u, V_b, F, A_u, A_b and the parts of e' of the axis at a height over its near end."""
        lift, inverse = Over.number(*self.lift), Over.number(*self.beta).inverse()
        slope, bend = numbers[1] * lift * inverse, numbers[2] * lift * inverse * inverse
        sense, none = constant(self.sense), constant(0)
        arm, distance, beside = (constant(self.sizes[n]) for n in ("arm_length", "center_distance", "lateral_offset"))
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
        ends = [] if remark else [constant(0), constant(self.sizes["roller_length"])]
        if key == "limits.pressure_angle_deg" and sign:
            return [self.pressure(number(self.limits["pressure_angle_deg"]), sign, height) for height in ends]
        return []

    def pressure(self, limit, sign, height):
        """sign V_u cos - |V_b| sin."""
        steep = Over.number(*tangent(limit))
        cosine = (constant(1) + steep.square()).root().inverse()
        sine = cosine * steep
        above = constant(-self.sense if self.kind == "barrel" else self.sense)

        def rule(numbers):
            across, along = self.axis(numbers, height)[:2]
            return constant(sign) * across * cosine - above * along * sine - self.room
        return rule

    def margin(self, least, flank):
        """least - g at any height: the last of the numbers is the part of the roller's length."""
        radius, side = constant(self.sizes["roller_radius"]), constant(flank)

        def rule(numbers):
            height = numbers[3] * constant(self.sizes["roller_length"])
            across, along, beside, turn_u, turn_b, tilt_u, tilt_b = self.axis(numbers, height)
            inverse = (across.square() + along.square()).inverse()
            turn, tilt = turn_b * across - turn_u * along, tilt_b * across - tilt_u * along
            bend = (turn - constant(2) * beside * tilt) * inverse * inverse.root()
            return constant(least) - constant(1) + side * radius * bend + (radius * tilt * inverse).square() - self.room
        return rule

    def displacements(self):
        """Where a motion that rests at both ends and keeps the pressure angle's limit stays, of a barrel cam: at its largest and
        its least angle the index stands, and the limit says that it stands no farther aside than the limit."""
        if self.kind != "barrel" or "pressure_angle_deg" not in self.limits:
            return None
        most = times(PI, exactly(number(self.limits["pressure_angle_deg"]) / 180))[1]
        return (-most - self.start[1]) / self.lift[0], (most - self.start[0]) / self.lift[0]
