# SPDX-License-Identifier: MIT
"""The limits of a cam whose lever moves the output through a linkage, as formulas of the output's y, y', y''.

A dyad: a link with the pivot B and the arm c reaches with a coupler of length b the joint E. With v = E - B the link's own joint
J, counted from B, is p v + q v', v' = v turned by +90 degrees: |J| = c and |J - v| = b give

    p = (v^2 + c^2 - b^2) / (2 v^2),   q = +- sqrt(c^2 / v^2 - p^2)   (+: J lies left of v).

b being constant, g = J - v has g . (J. - E.) = 0 and g . (J.. - E..) + |J. - E.|^2 = 0, a dot by the output; with J. = a. J' and
J.. = a.. J' - a.^2 J, a the link's angle,

    a. = g . E. / g . J',   a.. = (g . (E.. + a.^2 J) - |a. J' - E.|^2) / g . J'.

The roller sits at C = A + l u - O, A the lever's pivot, u the direction of its arm, O the cam's centre. By the cam angle, in
the frame that turns with the cam in the sense s: V = C' - s z x C and V' = C'' - 2 s z x C' - C. With C_u, C_a along u and across it and w
the angle of u,

    V = (s C_a, l w' - s C_u),   V' = (2 s l w' - l w'^2 - C_u, l w'' - C_a),   curvature |V|^3 = -s V x V'.

The roller's centre moves across u, the common normal is (C_u - s l w', C_a) / |V|: tan(pressure angle) = (C_u - s l w') / C_a.
The contact point, fixed to the lever, moves across l u - r normal instead, which makes the numerator C_u - s l w' - r |V| / l.

Theorem. A limit is satisfied where its formula is at or below 0: the formula is the limit's excess times a positive number, as long as the
levers that it divides by keep their sign in the box (otherwise `Unverified`). Assumption: the linkage stays in the branch of the scene.
"""

from .dimensions import Dimensions, middle_size
from .laws import constant
from .enclosures import Jet, tangent
from .exact import number, root
from .plane_vectors import across, direction, divided, dot, minus, plus, scaled, sign_of, turned
from .origins import rows_of
from .rational import Fraction
from .units import angle_of, dimension_of

OF_THE_CAM = ("roller_radius", "roller_arm", "lever_pivot_x", "lever_pivot_y", "center_x", "center_y")
OF_THE_LINKAGE = ("lever_arm", "lever_angle", "coupler", "rocker_pivot_x", "rocker_pivot_y", "rocker_input_arm", "rocker_output_arm",
                  "rocker_angle", "second_coupler", "slider_x", "slider_y", "slider_angle", "output_angle")


def given_in(table, names, default=None):
    """Of each name (size or range, unit); `default`: of angles in degrees, where it is not 0."""
    return {name: angle_of(table, name, True) or (Fraction((default or {}).get(name, 0)), "deg") if name.endswith("_angle") else
            (dimension_of(table, name), "m") for name in names}


class RemoteRules(Dimensions):
    """Lengths in m, angles in rad. `room`: by how much a rule may be passed, in parts of its limit."""

    def __init__(self, problem, scene, room=Fraction(0), found=None):
        cam, linkage = scene["cam"], scene["linkage"]
        super().__init__(problem, given_in(cam, OF_THE_CAM) | given_in(linkage, OF_THE_LINKAGE, {"slider_angle": 90}), found or {}, room)
        self.kind, self.at_contact = linkage["type"], cam.get("pressure_angle_at") == "contact_point"
        self.sense = constant(-1 if cam.get("rotation", "counterclockwise") == "clockwise" else 1)
        self.left = {name: constant(1 if linkage.get(name, "left") == "left" else -1)
                     for name in ("lever_branch", "rocker_branch")}
        self.choose_middle()
        self.side = sign_of(dot(self.pivot(), across(self.roller_arm(constant(0))[0])))  # of C_a wherever the cam moves the lever

    def cost_unit(self):
        """What dimensions in the objective are divided by: the lift, of an output that swings times the distance of the lever's pivot."""
        if self.kind.endswith("slider"):
            return self.units_of_motion[0]
        away = [middle_size(self.sizes[f"lever_pivot_{a}"]) - middle_size(self.sizes[f"center_{a}"]) for a in "xy"]
        return self.units_of_motion[0] * Jet.number(*root(away[0]**2 + away[1]**2))

    def place(self, name):
        return self.size(name + "_x"), self.size(name + "_y")

    def pivot(self):
        """Of the lever, from the cam's centre."""
        return minus(self.place("lever_pivot"), self.place("center"))

    # -- from the output back to the lever: (joint, its first and its second derivative by the output)

    def slider(self, s):
        way, none = direction(self.size("slider_angle")), (constant(0), constant(0))
        return plus(self.place("slider"), scaled(s, way)), way, none

    def swinging_output(self, s):
        """(direction, first and second derivative of the angle)."""
        return direction(self.size("output_angle") + s), constant(1), constant(0)

    def followed(self, pivot, arm, coupler, branch, far):
        """(direction of the arm of a dyad, first and second derivative of its angle)."""
        joint, first, second = far
        v = minus(joint, pivot)
        inverse = dot(v, v).inverse()
        p = (dot(v, v) + arm.square() - coupler.square()) * inverse * Fraction(1, 2)
        q = (arm.square() * inverse - p.square()).root() * self.left[branch]
        own = plus(scaled(p, v), scaled(q, across(v)))
        gap, swing = minus(own, v), across(own)
        lever = dot(gap, swing)
        rate = divided(dot(gap, first), lever)
        gone = minus(scaled(rate, swing), first)
        bend = divided(dot(gap, plus(second, scaled(rate.square(), own))) - dot(gone, gone), lever)
        return scaled(arm.inverse(), own), rate, bend

    def far_joint(self, s):
        """The coupler's joint that is not the lever's."""
        if self.kind == "lever_coupler_slider":
            return self.slider(s)
        pivot, arm = self.place("rocker_pivot"), self.size("rocker_input_arm")
        way, rate, bend = self.swinging_output(s)
        if self.kind == "lever_coupler_lever_coupler_slider":
            way, rate, bend = self.followed(pivot, self.size("rocker_output_arm"), self.size("second_coupler"),
                                            "rocker_branch", self.slider(s))
            way = turned(way, direction(self.size("rocker_angle")))
        along = scaled(arm, way)
        return plus(pivot, along), scaled(rate, across(along)), \
            minus(scaled(bend, across(along)), scaled(rate.square(), along))

    def roller_arm(self, s):
        """(u, first and second derivative of its angle by the output)."""
        if self.kind == "lever":
            return self.swinging_output(s)
        way, rate, bend = self.followed(self.place("lever_pivot"), self.size("lever_arm"), self.size("coupler"),
                                        "lever_branch", self.far_joint(s))
        return turned(way, direction(-self.size("lever_angle"))), rate, bend

    def roller(self, numbers):
        """C_u, C_a, u's angle by the output to both orders, s' and s''."""
        self.choose(numbers)
        s, slope, acceleration = self.states(numbers)
        way, rate, bend = self.roller_arm(s)
        pivot = self.pivot()
        return dot(pivot, way) + self.size("roller_arm"), dot(pivot, across(way)), rate, bend, slope, acceleration

    # -- the rules

    def formulas(self, origin):
        """The rules of a limit. The sign tells rises from returns of the lever; as the pressure angle's limit is the same for both,
        either sign must be kept."""
        name = origin.key.removeprefix("limits.")
        if name == "pressure_angle_deg" and origin.sign:
            return [self.pressure(number(self.limits[name]), origin.sign)]
        for start, factor in (("cam_radius_min_", 1), ("concave_radius_min_", -1)):
            if name.startswith(start):
                return [self.excess(factor * dimension_of(self.limits, start.removesuffix("_")), constant(1))]
        if name == "undercut_margin":
            return [self.excess(Fraction(0), constant(1 - number(self.limits[name])))]
        return []

    def pressures(self, limit, sign):
        return [self.pressure(limit, sign)]

    def kept(self, key):
        """(formulas that are nowhere above 0 along a motion that keeps the limit, further numbers of theirs)."""
        return [f for origin in rows_of(key) for f in self.formulas(origin)], []

    def pressure(self, limit, sign):
        """sign (C_u - s l w') cos(limit) <= |C_a| sin(limit), over cos(limit) l |dw/ds|: linear in the output's velocity. At the
        contact point as it is, m. Where C_a has another sign than at rest nothing satisfies both sides."""
        steep = tangent(limit)
        cosine = (1 + steep.square()).root().inverse()

        def rule(numbers):
            along, beside, rate, _, slope, _ = self.roller(numbers)
            arm, side = self.size("roller_arm"), self.side * sign
            lever = arm * rate
            if self.at_contact:
                along = along - self.sense * lever * slope
                speed = (along.square() + beside.square()).root()
                return cosine * (side * (along - self.size("roller_radius") * speed * arm.inverse()) -
                                 (steep + self.room) * self.side * beside)
            turns = sign_of(rate)
            still = divided(side * along - self.side * beside * steep, turns * lever)
            return still - side * self.sense * turns * slope - self.room
        return rule

    def excess(self, wider, share):
        """(roller + wider) curvature - share, times |V|^3 / (l |C_a dw/ds|): linear in the output's acceleration."""
        def rule(numbers):
            along, beside, rate, bend, slope, acceleration = self.roller(numbers)
            arm, factor = self.size("roller_arm"), self.size("roller_radius") + wider
            swing = arm * rate * slope
            v, w = self.sense * beside, swing - self.sense * along
            square = v.square() + w.square()
            forth = 2 * self.sense * swing - swing * rate * slope - along
            aside = arm * bend * slope.square() - beside
            still = -self.sense * (v * aside - w * forth)
            lever = arm * rate * beside
            turns = sign_of(lever)
            return divided(factor * still - (share + self.room) * square * square.root(), turns * lever) - \
                factor * turns * acceleration
        return rule
