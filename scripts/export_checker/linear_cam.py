# SPDX-License-Identifier: MIT
"""The plate of a linear cam, and curves parallel to its surface, as enclosures.

Frame of the plate: x along the travel, y = 0 its bottom, x = 0 below the roller's centre where the motion begins. The plate slides by
-c for every radian, c = travel / 2 pi: a point (x, y) that stands still lies at (x + c theta, y) in the plate. With the height h of
the surface at displacement 0 and the roller radius r the roller's centre stands at

    pushed       (s sin d, h + r + s cos d), d the inclination
    on an arm    (l (cos psi0 - cos psi), p + l sin psi), psi = psi0 + s, l sin psi0 = h + r - p

and moves in the plate with v = (c, 0) + its own velocity; the surface lies at the roller's radius from it across v, below. Lengths are
in mm.
"""
from certificate_checker.enclosures import Jet, ONE, PI, interval
from certificate_checker.exact import Unverified
from certificate_checker.linear_rules import DIMENSIONS, sense_of
from certificate_checker.rational import Fraction
from certificate_checker.units import angle_of, enclosed

from .designed_motion import DesignedMotion, exact_numbers
from .plane_cam import MILLIMETRES, PlaneCam, is_sector, size_of


class LinearCam(PlaneCam):
    """The surface, an open outline; what closes the body is checked in dxf.py."""

    form, second = "open", False

    def __init__(self, scene, design):
        scene = exact_numbers(scene)
        cam = scene["cam"]
        self.follower = cam.get("follower")
        if self.follower not in DIMENSIONS:
            raise Unverified(f"the follower {self.follower}")
        self.motion = DesignedMotion(scene, design, is_sector(scene))
        self.motion.is_open = True  # a whole cycle that returns ends elsewhere on the plate
        self.size = {name: size_of(cam, name, design) * MILLIMETRES for name in DIMENSIONS[self.follower]}
        self.swings, self.sense = self.follower.startswith("oscillating"), sense_of(cam)
        self.set_units()
        self.roller = self.size.get("roller_radius", Fraction(0))
        self.slide = (self.size["travel"] * (2 * PI).inverse()).value
        height = self.size["base_height"] + self.roller
        if not self.swings:
            lean = angle_of(cam, "inclination") or (Fraction(0), "deg")
            self.rest_sine, self.rest_cosine = enclosed(lean).sine_and_cosine()
            self.height = Jet.number(height)
            return
        self.rest_sine = Jet.number((height - self.size["pivot_height"]) / self.size["arm_length"])
        self.rest_cosine = (Jet.number(Fraction(1)) - self.rest_sine.square()).root()

    def in_fixed_frame(self, s, speed):
        if not self.swings:
            sine, cosine = self.rest_sine, self.rest_cosine
            return self.roller_at((s * sine, self.height + s * cosine), (speed * sine, speed * cosine))
        more, less = s.sine_and_cosine()
        length = interval(self.size["arm_length"])
        sine = (self.rest_sine * less + self.rest_cosine * more).scaled(length)
        cosine = (self.rest_cosine * less - self.rest_sine * more).scaled(length)
        center = self.rest_cosine.scaled(length) - cosine, Jet.number(self.size["pivot_height"]) + sine
        return self.roller_at(center, (sine * speed, cosine * speed))

    def roller_at(self, center, velocity):
        vx, vy = velocity[0] + Jet(self.slide), velocity[1]
        inverse = self.with_sense((vx.square() + vy.square()).root().inverse())
        return center, (-(vy * inverse), vx * inverse), self.roller

    def turned_back(self, point, x):
        """The plate has slid by then."""
        return point[0] + Jet.along(x, (ONE, ONE)).scaled(self.unit_angle).scaled(self.slide), point[1]

