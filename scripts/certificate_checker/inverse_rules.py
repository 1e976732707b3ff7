# SPDX-License-Identifier: MIT
"""The limits of an inverse cam, as formulas of the feeder's y, y', y'' and of the place x in the motion.

The roller is at (L, 0), L = rest + (end - rest) (angle / stroke)^2, the guide in the body has the polar angle psi(L) = -theta, theta the body's
angle. The body's pin P, |P| = L1, lies on the rocker's line through C in the direction e of the angle phi: P = C + r e, hence

    r = -C . e -+ sqrt((C . e)^2 + L1^2 - |C|^2),   tan phi = (Y - C_y) / offset,   phi' = Y' cos^2 phi / offset.

P' = theta' P*, * for turned by +90 degrees, is r' e + r phi' e*. Times e* and e, and differentiated once more, with q = P . e, t = P . e*:

    theta' q = r phi',   r' = -theta' t,   theta'' q = r phi'' - 2 theta' phi' t + theta'^2 t.

tan(pressure angle) = L dpsi/dL = -L theta' / L'. The guide's curvature is (L psi'' + 2 psi' + L^2 psi'^3) / (1 + L^2 psi'^2)^(3/2), here '
by L: psi' = -theta'/L', psi'' = -(theta'' + psi' L'') / L'^2. Its walls are regular where 1 -+ r curvature > 0, r the roller's radius.

Theorem. A limit is satisfied at a place where its formula is at or below 0: the formula is the limit's excess times a positive number, as
long as the levers that it divides by keep their sign in the box (otherwise `Unverified`).
"""

from .dimensions import Dimensions
from .enclosures import tangent
from .laws import constant
from .exact import number
from .plane_vectors import across, direction, divided, dot, minus, plus, scaled, sign_of
from .origins import rows_of
from .rational import Fraction
from .remote_rules import given_in
from .units import enclosed

NAMES = ("roller_radius", "roller_rest", "roller_end", "roller_angle", "roller_from", "pin_distance", "pin_angle", "rocker_pivot_x",
         "rocker_pivot_y", "feeder_offset", "feeder_start")


class InverseRules(Dimensions):
    """Lengths in m, angles in rad. Rules depend on the place in the motion: moves."""

    moves = True

    def __init__(self, problem, scene, room=Fraction(0), found=None):
        super().__init__(problem, given_in(scene["cam"], NAMES), found or {}, room)
        self.beta = enclosed(problem.unit_angle)
        self.side, self.nearer = self.branch()

    def cost_unit(self):
        """What dimensions in the objective are divided by."""
        return self.units_of_motion[0]

    def branch(self):
        """Which way along the rocker's line, and which of the two places there, is the pin of the scene: P . e < 0 at the nearer one.
        It is the same for all dimensions that are searched."""
        pin = scaled(self.size("pin_distance"), direction(self.size("pin_angle")))
        arm = minus(pin, self.pivot())
        return sign_of(arm[0]), -sign_of(dot(pin, arm))

    def pivot(self):
        return self.size("rocker_pivot_x"), self.size("rocker_pivot_y")

    def pin(self, s):
        """P, r, e, tan phi and cos^2 phi at a displacement of the feeder."""
        pivot = self.pivot()
        rise = divided(s + self.size("feeder_start") - pivot[1], self.size("feeder_offset"))
        square = (1 + rise.square()).inverse()
        cosine = square.root() * self.side
        e = cosine, cosine * rise
        foot = dot(pivot, e)
        rest = foot.square() + self.size("pin_distance").square() - dot(pivot, pivot)
        reach = -foot - self.nearer * rest.root()
        return plus(pivot, scaled(reach, e)), reach, e, rise, square

    def body(self, s, slope):
        """dtheta/ds, theta' and theta'' without what s'' adds to it, which is dtheta/ds s''."""
        pin, reach, e, rise, square = self.pin(s)
        offset = self.size("feeder_offset")
        per_slope = divided(square, offset)
        along, beside = dot(pin, e), dot(pin, across(e))
        ratio = divided(reach * per_slope, along)
        turning = per_slope * slope
        rate = ratio * slope
        still = divided(-2 * reach * turning.square() * rise - 2 * rate * turning * beside +
                        rate.square() * beside, along)
        return ratio, rate, still

    def roller(self, x):
        """L, L', L'' by the cam angle, at a place in rises."""
        inverse, length = self.size("roller_angle").inverse(), self.size("roller_end") - self.size("roller_rest")
        begin = ((self.size("roller_from") - self.size("roller_rest")) * length.inverse()).root()
        part = begin + x * self.beta * inverse  # of the stroke
        return self.size("roller_rest") + length * part.square(), 2 * length * part * inverse, \
            2 * length * inverse.square()

    def state(self, numbers):
        self.choose(numbers)
        return self.states(numbers)

    # -- the rules

    def formulas(self, origin, at):
        """The rules of a limit at a place."""
        return [lambda numbers, f=f: f(numbers, constant(at)) for f in self.along(origin)]

    def along(self, origin):
        """Those of the numbers and the place; of the margin one for either wall, the left one first."""
        name = origin.key.removeprefix("limits.")
        if name == "pressure_angle_deg" and origin.sign:
            return [self.pressure(number(self.limits[name]), origin.sign)]
        if name == "undercut_margin":
            return [self.margin(number(self.limits[name]), side) for side in origin.chosen("station", (1, -1))]
        return []

    def kept(self, key):
        """(formulas of the numbers and the place, nowhere above 0 along a motion that keeps the limit; further numbers)."""
        return [f for origin in rows_of(key) for f in self.along(origin)], []

    def pressure(self, limit, sign):
        """sign (-L theta') cos(limit) <= L' sin(limit), over cos(limit) L |dtheta/ds|: linear in the feeder's velocity."""
        steep = tangent(limit)

        def rule(numbers, x):
            s, slope, _ = self.state(numbers)
            distance, speed, _ = self.roller(x)
            ratio = self.body(s, slope)[0]
            turns = sign_of(ratio)
            return -sign * turns * slope - divided(steep * speed, turns * distance * ratio) - self.room
        return rule

    def margin(self, least, side):
        """least - (1 - side r curvature), times (1 + tan^2)^(3/2) L'^2 / (r L |dtheta/ds|): linear in the feeder's acceleration."""
        def rule(numbers, x):
            s, slope, acceleration = self.state(numbers)
            distance, speed, forth = self.roller(x)
            ratio, rate, still = self.body(s, slope)
            guide = -rate * speed.inverse()
            steep = distance * guide
            secant = 1 + steep.square()
            bend = -(still + guide * forth) * speed.square().inverse()
            top = distance * bend + guide * (2 + steep.square())
            room = side * top + ((least - 1) - self.room) * secant * secant.root() * \
                self.size("roller_radius").inverse()
            turns = sign_of(ratio)
            return divided(room * speed.square(), turns * distance * ratio) - side * turns * acceleration
        return rule
