# SPDX-License-Identifier: MIT
"""The motion of a result folder as exact polynomials over the cam angle, and how far a table is from it.

Stretches are (begin, end, shape) in degrees; a shape is a list of coefficients about its begin (fractions; mm or deg),
or a function of the angle that gives s, s', s'', s''' (a law).
"""

import json
import math
import tomllib
from fractions import Fraction

SAME_JOINT = Fraction(1, 10**9)  # deg: what rounding makes of one joint


def unit_angle(scene):
    """The cam angle of x = 1 in degrees."""
    motion = scene["motion"]
    if motion["type"] != "program":
        return Fraction(motion.get("rise_deg", 180))
    return next(Fraction(segment["angle_deg"]) for segment in motion["segments"] if segment["kind"] == "spline")


def shifted(coefficients, t):
    """The same polynomial about a place t farther."""
    return [sum(math.comb(k, r) * c * t**(k - r) for k, c in enumerate(coefficients) if k >= r)
            for r in range(len(coefficients))]


def derived(coefficients, order):
    for _ in range(order):
        coefficients = [k * c for k, c in enumerate(coefficients)][1:] or [Fraction(0)]
    return coefficients


def evaluated(coefficients, t):
    value = 0
    for c in reversed(coefficients):
        value = value * t + c
    return value


def modified_trapezoid(x):
    """y, y', y'', y''' of the acceleration sine up, constant, cosine down through 0, constant, back to 0."""
    b, w = 1 / 8, 4 * math.pi
    pieces = [(0, b, lambda t: (t / w - math.sin(w * t) / w**2, 1 / w - math.cos(w * t) / w, math.sin(w * t),
                                w * math.cos(w * t))),
              (b, 3 * b, lambda t: (t * t / 2, t, 1.0, 0.0)),
              (3 * b, 5 * b, lambda t: ((1 - math.cos(w * t)) / w**2, math.sin(w * t) / w, math.cos(w * t),
                                        -w * math.sin(w * t))),
              (5 * b, 7 * b, lambda t: (-t * t / 2, -t, -1.0, 0.0)),
              (7 * b, 1, lambda t: (-(1 - math.cos(w * t)) / w**2, -math.sin(w * t) / w, -math.cos(w * t),
                                    w * math.sin(w * t)))]

    def at(place):
        y = v = 0.0
        for begin, end, shape in pieces:
            if place <= end or end == 1:
                own = shape(place - begin)
                return y + v * (place - begin) + own[0], v + own[1], own[2], own[3]
            own = shape(end - begin)
            y, v = y + v * (end - begin) + own[0], v + own[1]
        raise AssertionError(place)

    top = at(1.0)[0]
    return [value / top for value in at(x)]


LAWS = {"modified_trapezoid": (modified_trapezoid, [0, Fraction(1, 8), Fraction(3, 8), Fraction(5, 8), Fraction(7, 8), 1])}


def law_stretches(part, per_x, lift):
    law, joints = LAWS[part["law"]]
    x0, scale, y0, y_scale = (Fraction(part[name]) for name in ("x0", "x_scale", "y0", "y_scale"))
    sign = float(1 / (scale * per_x))

    def at(theta):
        values = law(min(1.0, max(0.0, float((Fraction(theta) / per_x - x0) / scale))))
        found = [float(lift * y_scale) * value * sign**r for r, value in enumerate(values)]
        return [found[0] + float(lift * y0)] + found[1:]

    places = sorted((x0 + scale * Fraction(joint)) * per_x for joint in joints)
    return [(begin, end, at) for begin, end in zip(places, places[1:])]


def spline_stretches(part, curve, per_x, lift):
    x0, scale, y0, y_scale = (Fraction(part[name]) for name in ("x0", "x_scale", "y0", "y_scale"))
    breaks = [Fraction(b) for b in curve["breakpoints"]]
    stretches = []
    for begin, end, piece in zip(breaks, breaks[1:], curve["pieces"]):
        piece = [Fraction(c) for c in piece]
        if scale < 0:  # run through from its end: about the end
            begin, end, piece = end, begin, shifted(piece, end - begin)
        own = [lift * y_scale * c / (scale * per_x)**k for k, c in enumerate(piece)]
        own[0] += lift * y0
        stretches.append(((x0 + scale * begin) * per_x, (x0 + scale * end) * per_x, own))
    return sorted(stretches, key=lambda stretch: stretch[0])


def motion_of(folder):
    """Stretches over the whole turn, and the lift."""
    scene = tomllib.loads((folder / "scene.toml").read_text())
    result = json.loads((folder / "result.json").read_text())
    motion = scene["motion"]
    lift = Fraction(motion.get("lift_mm", motion.get("lift_deg", 1)))
    per_x = unit_angle(scene)
    stretches = []
    for part in result["motion"]["parts"]:
        if part["curve"] is not None:
            stretches += spline_stretches(part, result["motion"]["curves"][part["curve"]], per_x, lift)
        elif part["law"] is not None:
            stretches += law_stretches(part, per_x, lift)
        else:
            stretches.append((Fraction(part["begin"]) * per_x, Fraction(part["end"]) * per_x,
                              [lift * Fraction(part["y0"])]))
    if stretches[-1][1] < 360 - SAME_JOINT:  # the rest of the turn is dwell
        begin, end, shape = stretches[-1]
        rests = Fraction(0) if motion["type"] == "RR" else evaluated(shape, end - begin)
        stretches.append((end, Fraction(360), [rests]))
    return stretches, lift


def common_stretches(stretches, pieces):
    """(begin, end, stretch, piece) between the joints of both."""
    joints = sorted([s[0] for s in stretches] + [p[0] for p in pieces])
    merged = [joints[0]]
    for joint in joints[1:] + [stretches[-1][1]]:
        if joint > merged[-1] + SAME_JOINT:
            merged.append(joint)
    own, other = 0, 0
    for begin, end in zip(merged, merged[1:]):
        middle = (begin + end) / 2
        while own + 1 < len(stretches) and stretches[own][1] <= middle:
            own += 1
        while other + 1 < len(pieces) and pieces[other][1] <= middle:
            other += 1
        yield begin, end, stretches[own], pieces[other]


def differences(begin, end, stretch, piece, orders, places):
    """Largest |motion − table| of each order at evenly spaced places of one stretch."""
    h = end - begin
    table = shifted(piece[2], begin - piece[0])
    if callable(stretch[2]):
        rows = [[float(value) for value in derived(table, r)] for r in range(orders)]
        worst = [0.0] * orders
        for i in range(places + 1):
            t = float(h) * i / places
            # a hair inside: at a joint the law has two sides
            values = stretch[2](float(begin) + min(max(t, 1e-12), float(h) - 1e-12))
            for r in range(orders):
                worst[r] = max(worst[r], abs(values[r] - evaluated(rows[r], t)))
        return worst
    exact = shifted(stretch[2], begin - stretch[0])
    size = max(len(exact), len(table))
    exact, table = ([*c, *[0] * (size - len(c))] for c in (exact, table))
    gap = [a - b for a, b in zip(exact, table)]
    worst = []
    for r in range(orders):
        scaled = [float(c * h**k) for k, c in enumerate(derived(gap, r))]
        worst.append(max(abs(evaluated(scaled, i / places)) for i in range(places + 1)))
    return worst


def loss(stretches, pieces, orders):
    """Largest |motion − table| of s, s', … over the turn."""
    assert abs(pieces[0][0]) <= SAME_JOINT and abs(pieces[-1][1] - 360) <= SAME_JOINT
    assert all(begin < end for begin, end, _ in pieces)
    assert all(abs(a[1] - b[0]) <= SAME_JOINT for a, b in zip(pieces, pieces[1:]))
    places = 256 if len(pieces) < 200 else 16
    worst = [0.0] * orders
    for begin, end, stretch, piece in common_stretches(stretches, pieces):
        worst = [max(a, b) for a, b in zip(worst, differences(begin, end, stretch, piece, orders, places))]
    return worst


def peaks(stretches):
    return loss(stretches, [(Fraction(0), Fraction(360), [Fraction(0)])], 4)
