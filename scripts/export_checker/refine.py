# SPDX-License-Identifier: MIT
"""The largest value of a function that is enclosed over parts, which are halved where the bound is loose.

A part has `lo`, `hi` and `halves()`. `bounds(part)`: (an upper bound over it, the value in its middle).
"""
import heapq
import math

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
