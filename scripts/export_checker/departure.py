# SPDX-License-Identifier: MIT
"""A proved bound of the distance, in both directions, between a drawn curve and the designed one.

Vertex i of the drawn curve gets a place x_i on the designed curve, x_0 <= x_1 <= ... <= x_0 + one revolution; of an open
one, the first and the last vertex have its ends. Any places
give a true bound; good ones give a small one. For a segment from A to B and the part of the designed curve between its
places, let D be the largest distance of that part from the segment's circle, e_A and e_B the distances of A and B from the
ends of the part, o by how much the part's projection passes the segment's ends.

- Every point of the part lies within D + 2 o of the segment.
- The projection of the part is continuous, so it covers the segment from the projection of its first point to that of its
  last one. What remains of the segment lies within e_A or e_B of these points. Every point of the segment is therefore
  within max(D, e_A, e_B) of the part.

Both need a part near its segment. For others, the distance from A and twice the segment's length bound both directions.
"""
import math

from certificate_checker.enclosures import ONE
from certificate_checker.exact import Unverified

from .refine import largest, largest_magnitude, range_over

AT_A_VERTEX = 1.25     # a bound within this factor of the distance of a vertex is named after it
MOST_PARTS = 12000
BESIDE = 0.01          # of a segment's length: a part that projects further beyond its ends is not near to it
NEAR_CENTER = 0.25     # of an arc's diameter: likewise a part this far from its circle
JOINTS = 1e-12         # mm: what pieces of the motion may be apart at a joint (2^-60 of a lift), and doubles at the ends
SHORTEST = ONE >> 60   # a part of the designed curve that is not divided further


class Part:
    """A part of the designed curve within one piece of the motion, compared with a segment."""

    def __init__(self, segment, piece, lo, hi, added):
        self.segment, self.piece, self.lo, self.hi, self.added = segment, piece, lo, hi, added

    def halves(self):
        middle = (self.lo + self.hi) // 2
        return [Part(self.segment, self.piece, lo, hi, self.added) for lo, hi in ((self.lo, middle), (middle, self.hi))]

    def bounds(self, cam, offset):
        """(an upper bound over the part, the distance in its middle)."""
        middle = (self.lo + self.hi) // 2
        reach = max(self.hi + 1 - middle, middle - self.lo)
        segment = self.segment
        try:
            center = cam.at(self.piece, middle, middle, offset)
            over = cam.at(self.piece, self.lo, self.hi + 1, offset)
        except Unverified:  # a root or a quotient over too long a part
            return math.inf, 0.0

        def spread(at_center, over_part):
            return at_center.c[0], at_center.c[1], over_part.c[2], reach
        value = segment.distance(*center)
        largest = segment.from_circle(largest_magnitude(*spread(value, segment.distance(*over))))
        there = max(-value.c[0][1], value.c[0][0], 0) / ONE
        pairs = zip(segment.ahead(*center), segment.ahead(*over))
        beyond = max(0.0, *(-range_over(*spread(a, b))[0] for a, b in pairs))
        if beyond > BESIDE * segment.length or segment.k_size * largest > NEAR_CENTER:
            away = [largest_magnitude(*spread(a - start, b - start)) for a, b, start in zip(center, over, segment.at_start)]
            return math.hypot(*away) * (1 + 1e-15) + 2 * segment.length + segment.band, there
        return largest + 2 * beyond + segment.band, there


def distance_of(cam, vertex, x, offset):
    """(low, high) around the distance of a point from a place of the curve."""
    x = cam.motion.within(x)
    low, high = [], []
    for jet, z in zip(cam.at(cam.motion.piece_at(x), x, x, offset), vertex):
        a, b = jet.c[0][0] - z.c[0][1], jet.c[0][1] - z.c[0][0]
        low.append(max(a, -b, 0) / ONE)
        high.append(max(-a, b) / ONE)
    return math.hypot(*low) * (1 - 1e-15), math.hypot(*high) * (1 + 1e-15)


def gap_of(cam, offset):
    """Upper bound of the distance between the end of the revolution and its start, where the cam closes."""
    motion = cam.motion
    if motion.is_open:
        return 0.0
    ends = cam.at(motion.pieces[-1], motion.end, motion.end, offset), cam.at(motion.pieces[0], 0, 0, offset)
    return math.hypot(*(max(abs(a.c[0][1] - b.c[0][0]), abs(a.c[0][0] - b.c[0][1])) / ONE for a, b in zip(*ends)))


def largest_departure(cam, segments, places, offset):
    """(bound in mm, where it is reached: "line 12, 45.2 deg"). places[i], places[i + 1]: of the ends of segments[i]."""
    entries, low, vertex = [], 0.0, (0.0, "nowhere")
    corners = [(own.at_start, own.start_line, max(before.band, own.band)) for before, own in zip(segments[-1:] + segments, segments)]
    if cam.motion.is_open:
        corners.append((segments[-1].at_end, segments[-1].end_line, segments[-1].band))
    for (corner, line, band), x in zip(corners, places):
        least, most = distance_of(cam, corner, x, offset)
        entries.append((most + 2 * band, where(cam, line, x)))
        low, vertex = max(low, least), max(vertex, (least, where(cam, line, x)))
    for segment, lo, hi in zip(segments, places, places[1:]):
        for part in [Part(segment, *own) for own in cam.pieces_between(lo, hi)] or [still(cam, segment, lo)]:
            upper, there = part.bounds(cam, offset)
            entries.append((upper, part))
            low = max(low, there)
    bound, words = largest(entries, low, lambda part: part.bounds(cam, offset),
                           lambda part: where(cam, part.segment.line, (part.lo + part.hi) // 2 + part.added), MOST_PARTS, SHORTEST)
    if bound <= AT_A_VERTEX * vertex[0]:
        words = vertex[1]
    return bound + gap_of(cam, offset) + JOINTS, words


def still(cam, segment, x):
    """Where both ends of a segment have one place."""
    at = cam.motion.within(x)
    return Part(segment, cam.motion.piece_at(at), at, at, x - at)


def where(cam, line, x):
    return f"line {line}, {cam.degrees(x):.4f} deg"
