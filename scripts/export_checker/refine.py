# SPDX-License-Identifier: MIT
"""The largest value of a function that is enclosed over parts, which are halved where the bound is loose.

A part has `lo`, `hi` and `halves()`. `bounds(part)`: (an upper bound over it, the value in its middle).
"""
import heapq
import math

from certificate_checker.enclosures import ONE
from certificate_checker.exact import Unverified

FLOOR = 1e-9         # mm: smaller bounds are not refined
CLOSE_ENOUGH = 1.02  # the bound is refined to within this factor of the largest value found


def largest(entries, low, bounds, name, most, shortest):
    """(the bound, where): of `entries`, (upper bound, part), or (upper bound, words) of what is no part. `low`: the largest value found
    so far; `name(part)`: words; at most `most` entries in all, no part below `shortest` is halved."""
    heap = [(-upper, count, own) for count, (upper, own) in enumerate(entries, 1)]
    heapq.heapify(heap)
    count = len(heap)
    while count < most:
        upper, _, part = heap[0]
        if -upper <= max(FLOOR, CLOSE_ENOUGH * low) or isinstance(part, str) or part.hi - part.lo < shortest:
            break
        heapq.heappop(heap)
        for half in part.halves():
            upper, there = bounds(half)
            heapq.heappush(heap, (-upper, count := count + 1, half))
            low = max(low, there)
    upper, _, part = heap[0]
    words = part if isinstance(part, str) else name(part)
    if upper == -math.inf:
        raise Unverified(f"{words}: no enclosure of what is designed there")
    return -upper, words


def largest_magnitude(value, slope, bend, reach):
    """An upper bound of |f| over |t| <= reach, as a double: f(m) and f'(m) are narrow, `bend` encloses f''/2."""
    low, high = range_over(value, slope, bend, reach)
    return max(-low, high)


def range_over(value, slope, bend, reach):
    """Doubles around f(m) + f'(m) t + bend t^2 over |t| <= reach. The slack covers the rounding of the doubles, whose
    relative error is below 1e-15 for each term."""
    h = reach / ONE
    a = value[0] / ONE, value[1] / ONE
    b = max(abs(slope[0]), abs(slope[1])) / ONE * h
    c = bend[0] / ONE * h * h, bend[1] / ONE * h * h
    slack = 1e-13 * (abs(a[0]) + abs(a[1]) + b + abs(c[0]) + abs(c[1])) + 1e-25
    low, high = a[0] - b + c[0], a[1] + b + c[1]
    if c[0] > 0 and b < 2 * c[0]:
        low = a[0] - b * b / (4 * c[0])
    if c[1] < 0 and b < -2 * c[1]:
        high = a[1] - b * b / (4 * c[1])
    return low - slack, high + slack
