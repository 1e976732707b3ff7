# SPDX-License-Identifier: MIT
"""The load of a follower: mass, spring, preload, viscous damping, and a load over the cam angle; of an arm inertia and moments.

Theorem. F = mass speed^2 s'' + damping speed s' + rate s + preload + load, in N, speed in unit angles a second; of an arm s is an angle
in rad, F a moment in N m. F is affine in (speed^2, speed), and over a range of speeds these lie in the convex hull of `corners`: a limit
that is satisfied at all corners and is convex in F is satisfied at every speed of the range.
"""

from .exact import Unverified, number
from .rational import Fraction
from .units import in_unit


class Forces:
    """F = mass speed^2 s'' + damping speed s' + rate s + preload + load, in N; speed in unit angles a second. Of an arm s is an angle
    in rad, F a moment in N m."""

    def __init__(self, problem, scene):
        given = scene.get("forces", {})
        self.ranges = {}  # of what is searched, the key without its unit: (lowest, highest), N or N/m
        self.mass, self.damping = (number(given.get(name, 0)) for name in ("mass_kg", "damping_n_s_m"))
        self.rate, self.preload = (self.of_spring(given, key, unit) for key, unit in (("spring_rate", "n_m"), ("preload", "n")))
        self.least = number(problem.limits.get("contact_force_min_n", 0))
        self.lift = in_unit(problem.lift, "rad")
        self.end = problem.stretches[-1].end * problem.copies
        self.points = self.points_of(problem, given)  # (x, load), ascending over one turn of the cam
        self.turn = self.points[-1][0] - self.points[0][0]
        self.corners = self.corners_of(problem, given)

    def of_spring(self, given, key, unit):
        """A number; of a range its middle."""
        value = given.get(f"{key}_{unit}", 0)
        if not isinstance(value, dict):
            return number(value)
        self.ranges[f"forces.{key}"] = ends = number(value["min"]), number(value["max"])
        return sum(ends) / 2

    @staticmethod
    def points_of(problem, given):
        """The last point passes on to the first of the next turn."""
        value = given.get("load_n", 0)
        if not isinstance(value, list):
            return [(Fraction(0), number(value))]
        degree = in_unit((Fraction(1), "deg"), problem.unit_angle[1]) / problem.unit_angle[0]
        points = [(number(angle) * degree, number(load)) for angle, load in value]
        turn = points[0][0] + 360 * degree
        return points + ([(turn, points[0][1])] if points[-1][0] < turn else [])

    def corners_of(self, problem, given):
        """[(square, speed)], unit angles a second: F is linear in both. That of the scene, the ends of the range that limits hold over, and
        with damping the point where the tangents of the curve (speed^2, speed) at these meet: the curve lies in that triangle."""
        own = problem.turns_per_second()
        if not self.mass and not self.damping:
            return [(own**2, own)]
        presses = any(self.ranges.get(f"forces.{key}", (0, number))[1] > 0 for key, number in
                      (("spring_rate", self.rate), ("preload", self.preload)))
        shares = [Fraction(0) if presses and "hertz_pressure_max_mpa" in problem.limits else Fraction(1), Fraction(1)]
        for unit in ("rpm", "rad_s"):
            if f"speed_range_{unit}" in given:
                if f"speed_{unit}" not in problem.motion:
                    raise Unverified("a speed and a range of speeds in two units")
                shares = [number(end) / number(problem.motion[f"speed_{unit}"]) for end in given[f"speed_range_{unit}"]]
        low, high = (own * share for share in shares)
        corners = [(own**2, own), *((end**2, end) for end in (low, high) if end != own)]
        if self.damping and low < high:
            corners.append((low * high, (low + high) / 2))
        return corners

    def on_follower(self, numbers, corner, load, preload, rate):
        """F of y, y', y'' at a corner of the speeds, with the load at that cam angle."""
        square, speed = corner
        return (numbers[2] * (self.mass * square) + numbers[1] * (self.damping * speed) + numbers[0] * rate) * self.lift + preload + load

    def is_constant(self):
        return len({load for _, load in self.points}) == 1

    def largest_load(self):
        return max(abs(load) for _, load in self.points)

    def lines(self, begin, end):
        """[(from, until, load at x = 0, slope by x)]: the load between two places, as lines."""
        if self.is_constant():
            return [(begin, end, self.points[0][1], Fraction(0))]
        found = []
        turns = (begin - self.points[0][0]) // self.turn
        while self.points[0][0] + turns * self.turn < end:
            for (a, low), (b, high) in zip(self.points, self.points[1:]):
                a, b = a + turns * self.turn, b + turns * self.turn
                if a < b and max(a, begin) < min(b, end):
                    slope = (high - low) / (b - a)
                    found.append((max(a, begin), min(b, end), low - slope * a, slope))
            turns += 1
        return found

    def load_at(self, x, side):
        step = Fraction(1, 10**6)
        around = self.lines(x, x + step)[0] if side == "right" else self.lines(x - step, x)[-1]
        return around[2] + around[3] * x

    def unit(self, problem):
        """What camopt divides a row of the contact force by."""
        swing = self.largest_load() + self.mass * problem.turns_per_second()**2 * self.lift
        return max(abs(self.least), self.preload, swing, Fraction(1, 1000))
