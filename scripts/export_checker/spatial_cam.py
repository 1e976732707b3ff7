# SPDX-License-Identifier: MIT
"""The roller of a three-dimensional cam as enclosures.

Frames. The cam's axis is z. In the fixed frame the cam turns by sigma theta about it, sigma = 1 counterclockwise and -1 clockwise.
The roller's axis in the fixed frame is C = c + h e, h from the roller's near end, with the follower at q = start + s:

    barrel        c = (r cos q - l1, l3, -r sin q - l2)        e = (0, -1, 0)
    rotating      c = (dx, dy - f cos q, dz + f sin q)         e = (0, -cos q, sin q)
    translating   c = (dx, rho, dz + q)                        e = (0, -1, 0)

l1, dx: lateral offset, l2, dz: axial offset, l3, dy: centre distance, r, f: arm length, rho: cylinder's radius. In the cam's frame
C moves with V = C' - sigma z x C, by theta, and the roller touches the flanks at C +- radius n, n = V x e / |V x e|. Lengths are in mm.

Machines. The tool points down. Where `rotary` has turned the cam by sigma theta (a table that tilts: by 180 deg + sigma theta) the cam
stands as in the fixed frame, leaned by the tilt t: with the tip at (X, Y, Z) over the centre of the cam, the cutter's axis goes
in the fixed frame up from P, in the direction up, and a lies across it:

    P = Y (1, 0, 0) + X a + Z up,   a = (0, -sin t, cos t),   up = (0, cos t, sin t).

A roller's axis is such a line as well, with t = -q of a rotating follower and 0 of the others: up = -e.
"""
from certificate_checker.enclosures import ONE, ZERO, Jet, added, halved, interval, multiplied, negative
from certificate_checker.exact import Unverified
from certificate_checker.units import RADIAN, angle_of, enclosed, in_unit

from .designed_motion import ENOUGH_FOR_A_JOINT, DesignedMotion, exact_numbers, on_grid
from .plane_cam import MILLIMETRES, size_of

SAME_PLACE = ENOUGH_FOR_A_JOINT  # 2^-60 of a lift: the groove closes
NO_SINE, ONE_COSINE = Jet(ZERO), Jet((ONE, ONE))


class WholeTurn(DesignedMotion):
    """From 0 to one revolution, the rest after the motion. It may end where it did not begin: `pitch` further, in lifts."""

    def check_joints(self):
        self.pieces[-1].end = self.end = on_grid(self.turn)  # from which it differs by SAME_TURN at most
        before, after = (piece.states((x, x)) for piece, x in ((self.pieces[-1], self.end), (self.pieces[0], self.begin)))
        self.pitch = before[0][0] - after[0][1], before[0][1] - after[0][0]
        self.closes = max(map(abs, self.pitch)) < SAME_PLACE
        self.is_open = not self.closes
        super().check_joints()
        self.is_smooth = max(before[1][1] - after[1][0], after[1][1] - before[1][0]) < SAME_PLACE


class SpatialCam:
    """`indexes`: a roller that has left the cam goes on in the groove of its neighbour. Places x count in the scene's unit angle, in
    multiples of 2^-128; those of an indexing cam may lie outside of the revolution."""

    def __init__(self, scene, design):
        scene = exact_numbers(scene)
        cam = {key.replace("cylinder_radius", "center_distance"): value for key, value in scene["cam"].items()}
        self.kind = "barrel" if cam["type"] == "barrel" else cam.get("follower")
        if self.kind not in ("barrel", "rotating", "translating"):
            raise Unverified(f"a cylindrical cam with the follower {self.kind}")
        self.sense = -1 if cam.get("rotation", "counterclockwise") == "clockwise" else 1
        self.motion, self.swings, self.tilts = WholeTurn(scene, design), self.kind != "translating", self.kind == "rotating"
        problem = self.motion.problem
        if (problem.lift[1] == "m") == self.swings:
            raise Unverified("a lift whose unit does not fit the follower")
        self.indexes = self.swings and not self.motion.closes
        if self.indexes and not self.motion.is_smooth:
            raise Unverified("an indexing cam whose velocity jumps from one roller to the next")
        self.radius, self.length, self.lateral, self.axial, self.distance, self.arm = (
            size_of(cam, name, design) * MILLIMETRES
            for name in ("roller_radius", "roller_length", "lateral_offset", "axial_offset", "center_distance", "arm_length"))
        self.radius += size_of(cam, "groove_clearance", design) * MILLIMETRES / 2  # half the width of the groove
        lift = enclosed(problem.lift)
        self.lift = (lift if self.swings else lift * MILLIMETRES).value
        given = angle_of(cam, "start_angle") if self.swings else None
        self.start = enclosed(given).value if given else halved(negative(self.lift)) if self.swings else ZERO
        self.by_angle = enclosed(problem.unit_angle).inverse().value

    def place(self, rotary):
        """x as a fraction, of an angle of the table in degrees."""
        unit = self.motion.problem.unit_angle
        return in_unit((self.sense * (rotary - (180 if self.tilts else 0)), "deg"), unit[1]) / unit[0]

    @staticmethod
    def radians(degrees):
        return degrees / RADIAN

    def pieces_between(self, lo, hi):
        """[(piece, lo, hi, revolutions before)] of a range of places; one place is a range too."""
        motion, found = self.motion, []
        endless = self.indexes or motion.closes
        turns, lo = (lo // motion.end, lo) if endless else (0, max(lo, 0))  # rounding before the begin
        while True:
            by = turns * motion.end
            piece = motion.piece_at(lo - by)
            until = min(hi, piece.end + by) if endless or piece is not motion.pieces[-1] else hi
            found.append((piece, lo, until, turns))
            if until >= hi:
                return found
            lo, turns = until, until // motion.end

    def roller(self, piece, turns, x):
        """(q, sin q, cos q, dq / d theta) as Jets of what x is a Jet of; of a slide (q, 0, 1, dq / d theta)."""
        by = turns * self.motion.end
        y = piece.states((x.c[0][0] - by, x.c[0][1] - by))
        raised = (turns * self.motion.pitch[0], turns * self.motion.pitch[1]) if turns >= 0 else \
            (turns * self.motion.pitch[1], turns * self.motion.pitch[0])
        q = (Jet.along(added(y[0], raised), y[1], halved(y[2])).scaled(self.lift) + Jet(self.start)).after(x)
        speed = Jet.along(y[1], y[2], halved(y[3])).scaled(multiplied(self.lift, self.by_angle)).after(x)
        return (q, *q.sine_and_cosine(), speed) if self.swings else (q, NO_SINE, ONE_COSINE, speed)

    def axis(self, roller, height):
        """(C at a height of the roller, its derivative by theta) in the fixed frame."""
        q, sine, cosine, speed = roller
        if self.kind == "translating":
            return (Jet.number(self.lateral), Jet.number(self.distance - height), Jet.number(self.axial) + q), (Jet(ZERO), Jet(ZERO), speed)
        arm = interval(self.arm + height if self.tilts else self.arm)
        across, along = cosine.scaled(arm), sine.scaled(arm)
        if self.tilts:
            return (Jet.number(self.lateral), Jet.number(self.distance) - across, Jet.number(self.axial) + along), \
                (Jet(ZERO), along * speed, across * speed)
        return (across - Jet.number(self.lateral), Jet.number(self.distance - height), -along - Jet.number(self.axial)), \
            (-(along * speed), Jet(ZERO), -(across * speed))

    def normal(self, roller, center, velocity):
        """n in the fixed frame."""
        vx, vy, vz = velocity
        vx, vy = (vx + center[1], vy - center[0]) if self.sense > 0 else (vx - center[1], vy + center[0])
        _, sine, cosine, _ = roller
        n = (vy * sine + vz * cosine, -(vx * sine), -(vx * cosine)) if self.tilts else (vz, Jet(ZERO), -vx)
        inverse = (n[0].square() + n[1].square() + n[2].square()).root().inverse()
        return [own * inverse for own in n]

    def degrees(self, x):
        """Of a place, for messages."""
        return (x % self.motion.end if self.motion.closes else x) / ONE / float(self.motion.turn) * 360
