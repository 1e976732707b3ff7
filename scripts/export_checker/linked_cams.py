# SPDX-License-Identifier: MIT
"""Remote and inverse cams as enclosures: the roller's centre through the linkage, the outline across its path.

The linkages are those of certificate_checker: their formulas give a link's direction u with its angle's first two derivatives by the
displacement s, as numbers with slopes by s. The slope of the second derivative is the third one, which u'' of an outline needs.
Lengths of linkages are in m, points in mm. Frames: plane_cam.py; the guide of an inverse cam lies in its body, the pivot at the
origin, at displacement 0 as the scene's pin angle says.
"""

from certificate_checker.enclosures import ONE, ZERO, Jet, added, halved, interval, multiplied, negative, squared
from certificate_checker.exact import Unverified
from certificate_checker.inverse_rules import InverseRules
from certificate_checker.plane_vectors import direction, minus, scaled, turned
from certificate_checker.rational import Fraction
from certificate_checker.remote_rules import RemoteRules
from certificate_checker.units import LENGTHS, enclosed

from .designed_motion import DesignedMotion, exact_numbers
from .plane_cam import MILLIMETRES, PlaneCam, is_sector, size_of

THOUSAND = interval(Fraction(MILLIMETRES))


def settled(table, design):
    """A table of the scene with the lengths that the optimizer chose."""
    own = {}
    for key, value in table.items():
        name, _, unit = key.rpartition("_")
        if isinstance(value, dict) and unit in LENGTHS:
            own[name + "_m"] = size_of(table, name, design)
        else:
            own[key] = value
    return own


def by_itself(s):
    """The displacement as a number with its slope, for formulas of it."""
    return Jet(s.value, {0: (ONE, ONE)})


def along_motion(s, way, rate, bend):
    """(the unit vector `way`, the derivative `rate` of its angle by s) of the place; `bend`: the derivative of `rate`. Faster than the same
    by jets of the second order through the whole linkage."""
    x, y, first, second = way[0].value, way[1].value, rate.value, bend.value

    def of(a, across):
        """A component: a' = rate * across, a'' = bend * across - rate^2 * a."""
        bent = added(multiplied(second, across), negative(multiplied(squared(first), a)))
        return Jet.along(a, multiplied(first, across), halved(bent)).after(s)
    return (of(x, negative(y)), of(y, x)), Jet.along(first, second, halved(bend.slopes.get(0, ZERO))).after(s)


class LinkedCam(PlaneCam):
    """What both kinds have in common; `rules`: the linkage."""

    form, second = "open", False

    def set_linkage(self, scene, design, make, rests=True):
        scene = exact_numbers(scene)
        tables = {name: settled(scene[name], design) for name in ("cam", "linkage") if name in scene}
        self.motion = DesignedMotion(scene, design, is_sector(scene), rests)
        self.rules = make(self.motion.problem, scene | tables)
        self.roller = self.rules.sizes["roller_radius"] * MILLIMETRES
        self.swings = scene.get("linkage", {}).get("type") in ("lever", "lever_coupler_lever")
        self.set_units()
        self.lift = enclosed(self.motion.problem.lift).value


class RemoteCam(LinkedCam):
    def __init__(self, scene, design):
        self.set_linkage(scene, design, RemoteRules)
        self.sense = -1 if scene["cam"].get("rotation") == "clockwise" else 1
        rules = self.rules
        self.arm = interval(rules.sizes["roller_arm"] * MILLIMETRES)
        pivot = scaled(MILLIMETRES, minus(rules.place("lever_pivot"), rules.place("center")))
        self.pivot = [Jet(z.value) for z in pivot]

    def in_fixed_frame(self, s, speed):
        way, rate = along_motion(s, *self.rules.roller_arm(by_itself(s)))
        x, y = (z.scaled(self.arm) for z in way)
        turning = rate * speed
        return self.roller_at((self.pivot[0] + x, self.pivot[1] + y), (-(y * turning), x * turning))


class InverseCam(LinkedCam):
    """`at` with an offset to the left of the roller's path in the body: the walls are at +- the roller's radius."""

    def __init__(self, scene, design):
        if not is_sector(scene):
            raise Unverified("an inverse cam of another motion than a rise")
        self.set_linkage(scene, design, InverseRules, rests=False)
        self.to_body = direction(-self.rules.size("pin_angle"))
        self.by_length = self.rules.size("pin_distance").inverse()

    def at(self, piece, lo, hi, offset=Fraction(0)):
        """The roller at (L, 0) in the fixed frame, in the body that has turned by theta at L (cos theta, -sin theta)."""
        s, speed = self.moved(piece, (lo, hi))
        own = by_itself(s)
        ratio, _, still = self.rules.body(own, Jet.number(1))  # by s itself: s' = 1, s'' = 0
        (cosine, sine), rate = along_motion(s, scaled(self.by_length, turned(self.rules.pin(own)[0], self.to_body)), ratio, still)
        distance, along = self.roller_along((lo, hi))
        across = distance * rate * speed
        vx, vy = along * cosine - across * sine, -(along * sine) - across * cosine
        point = distance * cosine, -(distance * sine)
        if offset:
            shift = (vx.square() + vy.square()).root().inverse().scaled(interval(offset))
            point = point[0] - vy * shift, point[1] + vx * shift
        return point

    def roller_along(self, x):
        """L and its derivative by the cam angle."""
        distance, speed, forth = (multiplied(own.value, THOUSAND) for own in self.rules.roller(Jet(x)))
        beta = self.unit_angle
        return Jet.along(distance, multiplied(speed, beta), halved(multiplied(multiplied(forth, beta), beta))), \
            Jet.along(speed, multiplied(forth, beta))
