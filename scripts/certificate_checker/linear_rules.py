# SPDX-License-Identifier: MIT
"""The limits of linear (plate) cams, as those of disk cams in disk_rules.py.

The plate slides by c = travel / 2 pi for every radian below a roller that moves by w along d = (sin psi, cos psi): psi is the inclination of
a pushed roller (w = s') or the angle of an arm (w = l psi'), from -x upwards. Seen from the plate the roller's centre moves by (c, 0) + w d;
its parts along d and across it are

    N = w + c sin psi,   D = sense c cos psi,   v^2 = N^2 + D^2,   tan(pressure angle) = N / D.

d turns by psi' towards (cos psi, -sin psi), so that the path bends by w psi' across d beside w' along d: its curvature, > 0 where the plate
below it is convex, is (sense w psi' N - D w') / v^3 where psi' turns, -D s'' / v^3 where it does not.

Theorem. As of disk_rules.py, with the N, D and curvature above.
"""

from .disk_rules import DiskRules
from .dimensions import middle_size
from .enclosures import PI, PI_ITSELF
from .laws import constant
from .units import dimension_of, enclosed

DIMENSIONS = {"translating_knife": ("travel", "base_height"), "translating_roller": ("travel", "base_height", "roller_radius"),
              "oscillating_roller": ("travel", "base_height", "roller_radius", "arm_length", "pivot_height")}


def sense_of(cam):
    """Of the travel: a range lies on one side of 0."""
    return 1 if middle_size(dimension_of(cam, "travel")) > 0 else -1


class LinearRules(DiskRules):
    """`way`: the sign of the travel; `inclination`: (number, unit) of a pushed follower."""

    def __init__(self, problem, scene, follower, way, inclination, dimensions, room):
        self.way, self.inclination = way, inclination
        super().__init__(problem, scene, follower, 1, dimensions, room)

    def reach(self):
        """What the plate slides for a radian: to 35 digits."""
        return abs(middle_size(self.dimensions["travel"])) / (2 * PI_ITSELF)

    def pitch(self, numbers):
        s, slope, bend = self.states(numbers)
        size, way = self.sizes(numbers), constant(self.way)
        slide = size["travel"] * (2 * PI).inverse()
        if not self.swings:
            sine, cosine = enclosed(self.inclination).sine_and_cosine()
            return slope + slide * sine, way * slide * cosine, constant(0), constant(1), bend
        arm = size["arm_length"]
        start = (size["base_height"] + size["roller_radius"] - size["pivot_height"]) * arm.inverse()
        sine, cosine = self.turned(start, (1 - start.square()).root(), s)
        speed = arm * slope
        return speed + slide * sine, way * slide * cosine, way * speed * slope, arm, bend

    def excess(self, numbers, factor, share):
        """factor * curvature - share, times v^3 / (D lever)."""
        across, along, drift, lever, bend = self.pitch(numbers)
        square = across.square() + along.square()
        inverse = (along * lever).inverse()
        return factor * (drift * across * inverse - bend) - (share + self.room) * (square * square.root() * inverse)

    def curvature(self, numbers):
        across, along, drift, lever, bend = self.pitch(numbers)
        square = across.square() + along.square()
        speed = square.root()
        return (drift * across - along * lever * bend) * (square * speed).inverse(), speed
