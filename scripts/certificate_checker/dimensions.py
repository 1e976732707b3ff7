# SPDX-License-Identifier: MIT
"""Dimensions of a cam: numbers, or ranges that are searched, which count in parts of their largest magnitude.

Theorem. With q a part of the largest magnitude of each searched range, q in `parts_of(range)`, `size` encloses the dimension in m or rad, and
`states` encloses displacement, velocity and acceleration of the follower by the cam angle.
"""
from .enclosures import Jet, interval
from .units import enclosed


def largest_of(ends):
    """The largest magnitude in a range: the unit of a dimension that is searched."""
    return max(map(abs, ends))


def middle_size(size):
    """A number, or the middle of a range."""
    return sum(size) / 2 if isinstance(size, tuple) else size


def parts_of(ends):
    """A range in that unit."""
    return tuple(end / largest_of(ends) for end in ends)


def corners_of(ends):
    """Where a magnitude plus what is linear in the dimension is least: at an end, or at 0."""
    return [*ends] + [0] * (ends[0] < 0 < ends[1])


class FollowerMotion:
    """s, s', s'' in m or rad by the cam angle in rad, of y, y', y''. What the rules of all kinds of cams have."""

    moves = False  # whether they depend on the place in the motion too

    def __init__(self, problem):
        lift, by_angle = enclosed(problem.lift), enclosed(problem.unit_angle).inverse()
        self.units_of_motion = lift, lift * by_angle, lift * by_angle.square()

    def states(self, numbers):
        return [y * unit for y, unit in zip(numbers, self.units_of_motion)]

    def displacements(self):
        """(least, most) of y that the limits alone allow; None: unknown."""
        return None

    def pressures(self, limit, sign):
        """The rules of the pressure angle at rest, with another limit."""
        return []


class Dimensions(FollowerMotion):
    """`given`: of names (size, "m", "deg" or "rad"), the size a number or (lowest, highest); `found`: m or rad, of those searched.
    Without it they are the numbers behind y''', in the order of `given`. `room`: by how much rules may be passed."""

    def __init__(self, problem, given, found, room):
        FollowerMotion.__init__(self, problem)
        self.limits, self.room = problem.limits, room
        given = given | {name: (size, "m" if given[name][1] == "m" else "rad") for name, size in found.items()}
        self.sizes = {name: size for name, (size, _) in given.items()}
        self.units = {name: unit for name, (_, unit) in given.items()}
        self.searched = {name: size for name, size in self.sizes.items() if isinstance(size, tuple)}
        self.largest = {name: enclosed((largest_of(size) if name in self.searched else size, self.units[name]))
                        for name, size in self.sizes.items()}
        self.chosen = {name: Jet(interval(*parts_of(ends))) for name, ends in self.searched.items()}  # all of each range

    def choose_middle(self):
        """The middle of each range."""
        self.chosen = {name: Jet.number(middle_size(parts_of(ends))) for name, ends in self.searched.items()}

    def choose(self, numbers):
        """The dimensions of a state of the motion."""
        self.chosen = dict(zip(self.searched, numbers[4:]))

    def size(self, name):
        return self.largest[name] * self.chosen[name] if name in self.searched else self.largest[name]
