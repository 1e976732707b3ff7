# SPDX-License-Identifier: MIT
"""Where on the designed curve the vertices of a drawn one lie. This search is numerical: nothing that is proved depends on
its result, only how good the proved bound is.
"""
import math

from certificate_checker.enclosures import ONE

SAMPLES = 1440
STEPS = 20
NARROWED = 50
SETTLED = 1e-15  # of a revolution


class Places:
    """Of points next to one curve parallel to the profile."""

    def __init__(self, cam, offset):
        self.cam, self.offset, self.end, self.is_open = cam, offset, cam.motion.end, cam.motion.is_open
        self.begin = cam.motion.begin
        self.step = (self.end - self.begin) // SAMPLES
        self.samples = [cam.point(self.place(i), offset)[:2] for i in range(SAMPLES + self.is_open)]

    def place(self, i):
        """Of a sample."""
        return self.begin + i * self.step

    def are_against(self, points):
        """Whether they follow each other against the cam angle."""
        if self.is_open:
            return math.dist(points[0], self.samples[0]) > math.dist(points[-1], self.samples[0])
        return (area_of(points) > 0) != (area_of(self.samples) > 0)

    def distance(self, point):
        """Of a point from the nearest sample."""
        return min(math.dist(point, sample) for sample in self.samples)

    def refined(self, point, x):
        """Newton's method for (P - point) P' = 0, within a step of x; where that fails, intervals of decreasing length."""
        low, high = x - self.step, x + self.step
        if self.is_open:
            low, high = max(low, self.begin), min(high, self.end)
        for _ in range(STEPS):
            px, py, dx, dy, bx, by = self.cam.point(x, self.offset)
            rx, ry = px - point[0], py - point[1]
            value, slope = rx * dx + ry * dy, dx * dx + dy * dy + 2 * (rx * bx + ry * by)
            if slope <= 0:
                break
            change = int(value / slope * ONE)
            x -= change
            if not low <= x <= high:
                break
            if abs(change) < SETTLED * self.end:
                return x
        return self.narrowed(point, low, high)

    def narrowed(self, point, low, high):
        for _ in range(NARROWED):
            third = (high - low) // 3
            inner = low + third, high - third
            near, far = (math.dist(self.cam.point(x, self.offset)[:2], point) for x in inner)
            low, high = (low, inner[1]) if near <= far else (inner[0], high)
        return (low + high) // 2

    def following(self, point, i, least):
        """The place next to a sample, from `least` on. Where it comes no further, at a cusp, which every point beside it finds, the
        nearest of those next to the neighbouring samples too."""
        place = max(self.refined(point, self.place(i)), least)
        if place - least > self.step // 1000:
            return place
        places = [place, *(max(self.refined(point, self.place(i + k)), least) for k in (-1, 1))]
        return min(places, key=lambda x: math.dist(self.cam.point(x, self.offset)[:2], point))

    def along(self, points):
        """Ascending places of the vertices of a curve that runs with the cam angle; of a closed one the first again a revolution
        later, of an open one both ends."""
        matched = self.matched(points)
        found = [self.begin if self.is_open else self.refined(points[0], self.place(matched[0]))]
        last = self.end if self.is_open else found[0] + self.end
        for point, i in zip(points[1:], matched[1:]):
            found.append(min(self.following(point, i, found[-1]), last))
        return (found[:-1] if self.is_open else found) + [last]

    def matched(self, points):
        """Ascending samples with the least sum of squared distances from the points, by dynamic programming: where a curve
        crosses itself the nearest sample alone may be on the wrong branch. The first point has its nearest sample, of an open
        curve the first one."""
        count = len(self.samples)
        first = 0 if self.is_open else min(range(count), key=self.squares(points[0], 0).__getitem__)
        costs, choices = [math.inf] * count, []
        costs[0] = 0.0
        for point in points[1:]:
            best, least, chosen, following = 0, math.inf, [], []
            for j, (cost, square) in enumerate(zip(costs, self.squares(point, first))):
                if cost < least:
                    best, least = j, cost
                chosen.append(best)
                following.append(least + square)
            costs = following
            choices.append(chosen)
        at = [min(range(count), key=costs.__getitem__)]
        for chosen in reversed(choices):
            at.append(chosen[at[-1]])
        return [first + j for j in reversed(at)]

    def squares(self, point, first):
        """Squared distances of the samples from a point, beginning with a sample."""
        px, py = point
        return [(x - px) ** 2 + (y - py) ** 2 for x, y in self.samples[first:] + self.samples[:first]]


def area_of(points):
    """Twice the area, above 0 counterclockwise."""
    return sum(a[0] * b[1] - a[1] * b[0] for a, b in zip(points, points[1:] + points[:1]))
