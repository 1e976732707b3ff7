# SPDX-License-Identifier: MIT
"""The cutter and the blank as the table stands, in the fixed frame of spatial_cam.py: up = (0, cos t, sin t), the blank about z.

In doubles; coordinates are below 1e4 mm, so their rounding stays far below ROUNDING, by which distances are reduced.
"""
import math

from .clearance import ROUNDING


class Blank:
    """A cylinder about the cam's axis. `reach`: of its farthest point from the cam's centre."""

    def __init__(self, radius, lower, upper):
        self.radius, self.lower, self.upper = float(radius), float(lower), float(upper)
        self.reach = math.hypot(self.radius, max(abs(self.lower), abs(self.upper))) + ROUNDING


class Stand:
    """A cutter of this radius, without an upper end. `height`: of the tip over the centre of the cam, along the tool."""

    def __init__(self, position, z_offset, radius):
        self.x, self.across, self.height, self.radius = float(position[0]), float(position[1]), float(position[2] + z_offset), float(radius)
        self.tilt = math.radians(position[4]) if len(position) > 4 else 0.0
        self.sine, self.cosine = math.sin(self.tilt), math.cos(self.tilt)

    def lowest(self):
        """How far the cutter stays above the plane through the cam's axis that is level across the tool."""
        return self.height * self.cosine - self.x * self.sine - self.radius * abs(self.sine) - ROUNDING

    def room(self, blank):
        """How far planes keep the cutter off the blank: above it, level along the cutter, to both sides and beyond both ends along it."""
        beside, beyond = blank.radius + self.radius + ROUNDING, blank.radius * abs(self.sine) + self.radius + ROUNDING
        return self.height - ROUNDING - blank.radius * self.cosine - max(self.sine * blank.lower, self.sine * blank.upper), \
            self.lowest() - blank.radius, self.across - beside, -self.across - beside, \
            self.x - beyond - blank.upper * self.cosine, -self.x - beyond + blank.lower * self.cosine

    def is_over(self, blank):
        """As the table stands: next to the blank as well."""
        return self.room(blank)[0] >= 0

    def is_clear_of(self, blank):
        return max(self.room(blank)) >= 0


def stay_clear(a, b, blank):
    """On the way from one place to the other while the table does not tilt: by one plane."""
    return a.tilt == b.tilt and any(min(rooms) >= 0 for rooms in zip(a.room(blank), b.room(blank)))


def lowest_between(a, b):
    """Of the cutter on its way from one place to the other, all axes in proportion: at the ends, less what a line with these second
    derivatives may be below them."""
    turned = abs(b.tilt - a.tilt)
    most = max(abs(a.x), abs(b.x)) + max(abs(a.height), abs(b.height))
    return min(a.lowest(), b.lowest()) - (turned**2 * most + 2 * turned * (abs(b.x - a.x) + abs(b.height - a.height))) / 8
