# SPDX-License-Identifier: MIT
"""The designed profile of a disk cam, and curves parallel to it, as enclosures.

Frames. The cam's centre is the origin; files show the cam at cam angle 0. In the fixed frame the cam turns by sigma theta,
sigma = 1 counterclockwise and -1 clockwise, so a fixed point p lies at Rot(-sigma theta) p on the cam. The follower, in the
fixed frame, with s its displacement:

    translating roller   centre (e, s0 + s), s0^2 = prime radius^2 - e^2
    translating face     the line y = base radius + s
    arm with a roller    pivot (a, 0), centre (a - l cos psi, l sin psi), psi = psi0 + s
    arm with a face      the line through the pivot at the angle psi, shifted by f towards the cam

A roller's centre moves in the cam's frame with the velocity v; the profile lies at a roller radius from it across v. A face
touches at the foot of the normal through the instantaneous centre of its motion relative to the cam. Lengths are in mm.
"""

from certificate_checker.cam import DIMENSIONS
from certificate_checker.enclosures import ONE, ZERO, Jet, halved, interval
from certificate_checker.exact import STATED, Refuted, Unverified, number
from certificate_checker.rational import Fraction
from certificate_checker.units import angle_of, dimension_of, enclosed

from .designed_motion import DesignedMotion, exact_numbers

MILLIMETRES = 1000
WITH_ROLLER = ("translating_roller", "oscillating_roller")


def size_of(table, name, design):
    """m. Dimensions that the optimizer chose are in design["cam"]["dimensions"]."""
    size = dimension_of(table, name)
    if isinstance(size, tuple):
        (low, high), chosen = size, (design.get("cam") or {}).get("dimensions", {})
        if name + "_m" not in chosen:
            raise Unverified(f"a result without the {name}, which is searched")
        size = number(chosen[name + "_m"])
        if not low - abs(low) * STATED <= size <= high + abs(high) * STATED:
            raise Refuted(f"the {name} is outside its range")
    return size


def sizes_of(cam, design):
    """Dimensions in m."""
    if cam["follower"] not in DIMENSIONS:
        raise Unverified(f"the follower {cam['follower']}")
    return {name: size_of(cam, name, design) for name in DIMENSIONS[cam["follower"]]}


def is_sector(scene):
    """Whether no return is designed: the outline that is drawn does not close."""
    return scene["motion"].get("type") == "DRD"


class PlaneCam:
    """`at(piece, lo, hi, offset)` encloses the curve at a distance `offset` outside the profile; 0: the profile. `second`:
    of a conjugate cam, the disk of the second roller."""

    def __init__(self, scene, design, second=False):
        scene = exact_numbers(scene)
        cam = scene.get("cam", {})
        if cam.get("type", "disk") != "disk" or "follower" not in cam:
            raise Unverified("a cam other than a disk cam")
        self.form, self.follower = cam.get("form", "open"), cam["follower"]
        if self.form not in ("open", "grooved", "conjugate") or (self.form != "open" and self.follower not in WITH_ROLLER):
            raise Unverified(f'cam.form = "{self.form}" of a {self.follower}')
        self.second = second and self.form == "conjugate"
        self.sense = -1 if cam.get("rotation", "counterclockwise") == "clockwise" else 1
        self.motion = DesignedMotion(scene, design, is_sector(scene))
        self.size = {name: size * MILLIMETRES for name, size in sizes_of(cam, design).items()}
        self.swings = self.follower.startswith("oscillating")
        self.set_units()
        self.set_start()
        self.roller = self.size["roller_radius"] if self.follower in WITH_ROLLER else Fraction(0)
        self.clearance = dimension_of(cam, "groove_clearance") * MILLIMETRES if self.form == "grooved" else Fraction(0)
        if self.second:
            self.set_second(cam)

    def set_units(self):
        problem = self.motion.problem
        if (problem.lift[1] == "m") == self.swings:
            raise Unverified("a lift whose unit does not fit the follower")
        lift, angle = enclosed(problem.lift), enclosed(problem.unit_angle)
        self.lift = (lift if self.swings else lift * MILLIMETRES).value
        self.unit_angle, self.by_angle = angle.value, angle.inverse().value

    # -- the follower at displacement 0

    def set_start(self):
        size = self.size
        self.prime = prime = size["base_radius"] + size.get("roller_radius", 0)
        if not self.swings:
            offset = size.get("offset", Fraction(0))
            self.height = Jet.number(prime * prime - offset * offset).root()
            return
        distance = size["center_distance"]
        if self.follower == "oscillating_roller":
            arm = size["arm_length"]
            self.rest_cosine = Jet.number((distance**2 + arm**2 - prime**2) / (2 * distance * arm))
            self.rest_sine = (Jet.number(Fraction(1)) - self.rest_cosine.square()).root()
        else:
            self.rest_sine = Jet.number((size["base_radius"] + size["face_offset"]) / distance)
            self.rest_cosine = (Jet.number(Fraction(1)) - self.rest_sine.square()).root()

    def set_second(self, cam):
        """The second roller: below the first on the same slide, or on a second arm at the angle gamma - psi below the line
        of centres. Its dimensions are those of the first where the scene does not state them."""
        for name in ("roller_radius", "offset", "arm_length"):
            if any(key.startswith("second_" + name + "_") for key in cam):
                self.size[name] = dimension_of(cam, "second_" + name) * MILLIMETRES
        self.roller = self.size["roller_radius"]
        if not self.swings:
            self.height = self.height - Jet.number(dimension_of(cam, "roller_distance") * MILLIMETRES)
            return
        more, less = enclosed(angle_of(cam, "arm_angle")).sine_and_cosine()
        sine, cosine = self.rest_sine, self.rest_cosine
        self.rest_sine, self.rest_cosine = more * cosine - less * sine, less * cosine + more * sine

    # -- the profile

    def at(self, piece, lo, hi, offset=Fraction(0)):
        """(x, y) as Jets over lo <= x <= hi, multiples of 2^-128 within the piece."""
        x = lo, hi
        point, normal, inwards = self.in_fixed_frame(*self.moved(piece, x))
        outwards = interval(offset - inwards)
        if outwards != ZERO:
            point = [p + n.scaled(outwards) for p, n in zip(point, normal)]
        return self.turned_back(point, x)

    def moved(self, piece, x):
        """The displacement and its derivative by the cam angle."""
        y = piece.states(x)
        return Jet.along(y[0], y[1], halved(y[2])).scaled(self.lift), \
            Jet.along(y[1], y[2], halved(y[3])).scaled(self.lift).scaled(self.by_angle)

    def turned_back(self, point, x):
        """The fixed point where it lies on the cam."""
        angle = Jet.along(x, (ONE, ONE)).scaled(self.unit_angle)
        sine, cosine = angle.sine_and_cosine()
        if self.sense < 0:
            sine = -sine
        return point[0] * cosine + point[1] * sine, point[1] * cosine - point[0] * sine

    def in_fixed_frame(self, s, speed):
        """(a point, the outward normal of the profile there, by how much the profile lies inside of the point)."""
        if self.follower == "translating_flat":
            return ((self.with_sense(speed), Jet.number(self.size["base_radius"]) + s),
                    (Jet(ZERO), Jet.number(Fraction(1))), Fraction(0))
        if not self.swings:
            return self.roller_at((Jet.number(self.size["offset"]), self.height + s), (Jet(ZERO), speed))
        more, less = s.sine_and_cosine()
        more = -more if self.second else more
        sine = self.rest_sine * less + self.rest_cosine * more
        cosine = self.rest_cosine * less - self.rest_sine * more
        pivot = Jet.number(self.size["center_distance"])
        if self.follower == "oscillating_flat":
            return self.face_on_arm(sine, cosine, pivot, speed)
        length = interval(self.size["arm_length"])
        sine, cosine = sine.scaled(length), cosine.scaled(length)
        if self.second:  # mirrored at the line of centres, where the arm's angle falls as the first one's rises
            return self.roller_at((pivot - cosine, -sine), (-(sine * speed), cosine * speed))
        return self.roller_at((pivot - cosine, sine), (sine * speed, cosine * speed))

    def with_sense(self, jet):
        return jet if self.sense > 0 else -jet

    def roller_at(self, center, velocity):
        """The centre moves in the cam's frame with v = velocity - sigma z x centre. Its normal on the side away from the cam
        is sigma (-v_y, v_x) / |v|: the roller runs around the cam against the cam's rotation."""
        vx, vy = velocity[0] + self.with_sense(center[1]), velocity[1] - self.with_sense(center[0])
        inverse = self.with_sense((vx.square() + vy.square()).root().inverse())
        return center, (-(vy * inverse), vx * inverse), self.roller

    def face_on_arm(self, sine, cosine, pivot, speed):
        """The face turns by 1 + sigma s' relative to the cam; it touches a cos psi / (1 + sigma s') from the pivot's foot."""
        turning = Jet.number(Fraction(1)) + self.with_sense(speed)
        reach = cosine * pivot * turning.inverse()
        shift = interval(self.size["face_offset"])
        point = pivot - sine.scaled(shift) - reach * cosine, reach * sine - cosine.scaled(shift)
        return point, (sine, cosine), Fraction(0)

    # -- places

    def pieces_between(self, lo, hi):
        """[(piece, lo, hi, added)] of a range of places, which may pass the end of the revolution: the place is x + added."""
        found = []
        while lo < hi:
            by = lo - self.motion.within(lo)
            piece = self.motion.piece_at(lo - by)
            until = min(hi, piece.end + by)
            found.append((piece, lo - by, until - by, by))
            lo = until
        return found

    def point(self, x, offset=Fraction(0)):
        """(x, y, x', y', x''/2, y''/2) at a place, as doubles: for searches."""
        x = self.motion.within(x)
        jets = self.at(self.motion.piece_at(x), x, x, offset)
        return [jet.c[order][0] / ONE for order in range(3) for jet in jets]

    def degrees(self, x):
        return self.motion.degrees(x)
