#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The largest pressure angles of docs/papers/003.md, computed with nothing of camopt: Python's standard library.

Loop 1 |D(psi) - E(eta)| = coupler, loop 2 |G(eta) - H(y)| = second coupler. From the frame y to the rocker eta to the
lever psi by two dyads; psi' by the cam angle by a difference of fourth order; tan phi = (C.u - l psi') / (C.t) at the
roller's centre C. mm, rad. Prints a line a cam: its name, the largest pressure angle in deg, the cam angle it is at.
"""

import cmath
import math

ROLLER_ARM, PIVOT, LEVER, LEVER_TURN = 160.0, complex(-160, 85), 240.0, math.radians(-10)
ROCKER_PIVOT, ROCKER_IN, ROCKER_OUT = complex(260, 400), 220.0, 250.0
COUPLER, SECOND_COUPLER, SLIDER_X, SLIDER_Y, LIFT = 351.3, 200.0, 10.0, 560.0, 80.0


def dyad(pivot, arm, link, far, side):
    """The direction of an arm whose end is `link` away from `far`; side +1: on the left of the line to it."""
    line = far - pivot
    cosine = (arm * arm + abs(line) ** 2 - link * link) / (2.0 * arm * abs(line))
    return cmath.phase(line) + side * math.acos(cosine)


def lever(displacement):
    """The direction of the roller's arm."""
    rocker = dyad(ROCKER_PIVOT, ROCKER_OUT, SECOND_COUPLER, complex(SLIDER_X, SLIDER_Y + displacement), 1)
    joint = ROCKER_PIVOT + cmath.rect(ROCKER_IN, rocker)
    return dyad(PIVOT, LEVER, COUPLER, joint, -1) - LEVER_TURN


def modified_trapezoid(t):
    if t > 0.5:
        return 1.0 - modified_trapezoid(1.0 - t)
    a, w = 8.0 * math.pi / (2.0 + math.pi), 4.0 * math.pi
    if t <= 0.125:
        return a / w * (t - math.sin(w * t) / w)
    if t <= 0.375:
        s = t - 0.125
        return a / w * (0.125 - 1.0 / w) + a / w * s + 0.5 * a * s * s
    s = t - 0.375
    return modified_trapezoid(0.375) + (a / w + 0.25 * a) * s + a / w**2 * (1.0 - math.cos(w * s))


def polynomial_4567(t):
    return t**4 * (35.0 + t * (-84.0 + t * (70.0 - 20.0 * t)))


def frame(law, dwell, theta):
    """Rests, rises, rests, returns; theta in deg."""
    theta %= 360.0
    rise = 180.0 - dwell
    if theta < 180.0:
        return LIFT * law(max(0.0, (theta - dwell) / rise))
    return LIFT * (1.0 - law(max(0.0, (theta - 180.0 - dwell) / rise)))


def pressure_angle(law, dwell, lower, theta):
    h = 0.02
    psi = [lever(frame(law, dwell, theta + k * h)) for k in (-2, -1, 0, 1, 2)]
    slope = (psi[0] - 8.0 * psi[1] + 8.0 * psi[3] - psi[4]) / (12.0 * math.radians(h))
    u = cmath.rect(1.0, psi[2])
    centre = PIVOT + ROLLER_ARM * u + complex(0.0, lower)
    along, across = (centre * u.conjugate()).real, (centre * u.conjugate()).imag
    return math.degrees(abs(math.atan((along - ROLLER_ARM * slope) / across)))


def largest(law, dwell, lower):
    coarse = max((k * 0.1 for k in range(3600)), key=lambda x: pressure_angle(law, dwell, lower, x))
    fine = max((coarse - 0.1 + k * 0.001 for k in range(201)), key=lambda x: pressure_angle(law, dwell, lower, x))
    return pressure_angle(law, dwell, lower, fine), fine


def main():
    for name, law in (("MT", modified_trapezoid), ("4567-", polynomial_4567)):
        for words, dwell, lower in (("60", 60, 0), ("75", 75, 0), ("90", 90, 0), ("752", 75, 10)):
            angle, at = largest(law, dwell, lower)
            print(f"{name + words:8} {angle:.4f} deg at {at:.2f} deg")


main()
