# SPDX-License-Identifier: MIT
"""Three-dimensional cams and programs for them as samples in doubles, for comparison with proved bounds.

Everything is compared in the cam's frame, with the machines' kinematics as matrices and normals by differences. Files are read by patterns.
"""
import math
import re

from plane_samples import Sampled

STEP = 1e-5            # rad, of differences
BEYOND = 0.5           # mm: of the tip below the roller
SHARES = 12            # samples in a block
WORDS = re.compile(r"([A-Z])(-?\d+\.?\d*)")


def turned(vector, angle):
    """About z."""
    c, s = math.cos(angle), math.sin(angle)
    return c * vector[0] - s * vector[1], s * vector[0] + c * vector[1], vector[2]


def leaned(vector, angle):
    """About y."""
    c, s = math.cos(angle), math.sin(angle)
    return c * vector[0] + s * vector[2], vector[1], c * vector[2] - s * vector[0]


def from_point(point, length, direction):
    return tuple(p + length * d for p, d in zip(point, direction))


def difference(a, b):
    return tuple(x - y for x, y in zip(a, b))


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def cross(a, b):
    return tuple(a[i - 2] * b[i - 1] - a[i - 1] * b[i - 2] for i in range(3))


class SampledRoller(Sampled):
    """Of scenes in mm and degrees, an indexing motion from 0 on."""

    def __init__(self, scene, result):
        super().__init__(scene | {"motion": {"lift_mm": 0} | scene["motion"]}, result)
        self.kind = self.cam.get("follower", "barrel")
        if self.kind != "translating":
            self.lift = math.radians(self.motion["lift_deg"])
        self.start = 0 if self.kind == "translating" else math.radians(self.cam["start_angle_deg"]) if "start_angle_deg" in self.cam else -self.lift / 2
        self.pitch = self.displacement(2 * math.pi - 1e-12) - self.displacement(0)

    def displacement(self, theta):
        if self.kind == "translating" and self.motion["type"] == "DRD":  # a groove that ends
            theta = min(max(theta, 0), 2 * math.pi - 1e-12)
        x = theta % (2 * math.pi) / self.unit
        return self.lift if x > self.parts[-1]["end"] and self.motion["type"] == "DRD" else super().displacement(theta)

    def axis(self, theta, height):
        """(point, direction into the cam) of the roller's axis."""
        turns = math.floor(theta / (2 * math.pi) + 1e-12) if self.kind != "translating" else 0
        within = max(theta - 2 * math.pi * turns, 0) if turns else theta
        q, cam = self.start + self.displacement(within) + turns * self.pitch, self.cam
        aside, along, sine, cosine = cam.get("lateral_offset_mm", 0), cam.get("axial_offset_mm", 0), math.sin(q), math.cos(q)
        if self.kind == "rotating":
            arm = cam["arm_length_mm"] + height
            fixed, way = (aside, cam["center_distance_mm"] - arm * cosine, along + arm * sine), (0, -cosine, sine)
        elif self.kind == "translating":
            fixed, way = (aside, cam["cylinder_radius_mm"] - height, along + q), (0, -1, 0)
        else:
            arm = cam["arm_length_mm"]
            fixed, way = (arm * cosine - aside, cam["center_distance_mm"] - height, -arm * sine - along), (0, -1, 0)
        return turned(fixed, -self.sense * theta), turned(way, -self.sense * theta)

    def belongs(self, theta, offset):
        """(tip, direction) of a cutter beside the roller's axis."""
        center, way = self.axis(theta, self.cam["roller_length_mm"])
        after, before = (self.axis(theta + e, self.cam["roller_length_mm"])[0] for e in (STEP, -STEP))
        across = cross(difference(after, before), way)
        return from_point(from_point(center, offset / math.sqrt(dot(across, across)), across), BEYOND, way), way

    def cutter(self, values, z_offset=0.0):
        """(tip, direction) by the machine's kinematics."""
        x, y, z, rotary, *tilt = (*values[:2], values[2] + z_offset, *values[3:])
        if not tilt:
            return turned((y, z, x), -math.radians(rotary)), turned((0, -1, 0), -math.radians(rotary))
        back, about = -math.radians(90 - tilt[0]), math.radians(90 - rotary)
        return turned(leaned((x, y, z), back), about), turned(leaned((0, 0, -1), back), about)

    def theta(self, values):
        return self.sense * math.radians(values[3] - (180 if len(values) > 4 else 0))

    def off_path(self, blocks, turns, offset):
        """The largest distance of either end of the working length from where it belongs."""
        length, most = self.cam["roller_length_mm"] + BEYOND, 0.0
        for start, end in zip(blocks, blocks[1:]):
            for k in range(SHARES):
                values = [a + (b - a) * k / SHARES for a, b in zip(start, end)]
                tip, way = self.cutter(values)
                place, along = self.belongs(self.theta(values) + 2 * math.pi * turns, offset)
                ends = difference(tip, place), difference(from_point(tip, -length, way), from_point(place, -length, along))
                most = max(most, *(math.sqrt(dot(e, e)) for e in ends))
        return most

    def depth(self, values, turns, radius):
        """How far a cutter reaches beside or below the roller at the same turn of the table."""
        tip, _ = self.cutter(values)
        foot, way = self.axis(self.theta(values) + 2 * math.pi * turns, self.cam["roller_length_mm"])
        beside = difference(tip, foot)
        under = dot(beside, way)
        across = from_point(beside, -under, way)
        return max(math.sqrt(dot(across, across)) + radius - self.cam["roller_radius_mm"], under - BEYOND)


def positions(program, letters):
    """[(number of the line, G of the block, values)] of every move, once all axes have a value."""
    values, motion, found = {}, None, []
    for number, line in enumerate(program.split("\n"), 1):
        words = {} if line.startswith(("(", ";", "%")) else {letter: float(value) for letter, value in WORDS.findall(line)}
        motion = words["G"] if words.get("G") in (0, 1) else motion
        if any(letter in words for letter in letters):
            values |= {letter: words[letter] for letter in letters if letter in words}
            if len(values) == len(letters):
                found.append((number, motion, [values[letter] for letter in letters]))
    return found


def last_passes(moves, count):
    """The feeds between the last rapids, each with the position before it."""
    passes = []
    for before, move in zip(moves, moves[1:]):
        if move[1] == 1:
            if before[1] != 1:
                passes.append([before])
            passes[-1].append(move)
    return passes[-count:]


def last_turn(moved):
    """The end of a pass, in which the table turns one way: its leads and its blocks along the groove."""
    turning = [k for k, (a, b) in enumerate(zip(moved, moved[1:])) if a[2][3] != b[2][3]]
    end = turning[-1] + 1
    begin = end
    while begin and (moved[begin][2][3] - moved[begin - 1][2][3]) * (moved[end][2][3] - moved[end - 1][2][3]) > 0:
        begin -= 1
    return moved[begin:end + 1]
