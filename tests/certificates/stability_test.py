# SPDX-License-Identifier: MIT
"""The kinds of rows of the stability table as scene files: stability_test.py CAMOPT.

Whatever camopt calls optimal or infeasible there, the checker must confirm. Other verdicts must not be refuted. Each
group says how many proofs it must have, so that none can fall silent.
"""
import sys
import tempfile
from pathlib import Path

import checker

PUBLISHED = 'reference = { velocity = 1.76, acceleration = 5.53, jerk = 69 }'


def study(degree, segments, kind="DRD", motion="", spline="", limits="", weights=(0.4, 0.4, 0.2), reference=PUBLISHED,
          more=""):
    v, a, j = weights
    return "\n".join([f'[motion]\ntype = "{kind}"', motion, f"[spline]\ndegree = {degree}", spline or
                      f"segments = {segments}", f"[objective]\nvelocity = {v!r}\nacceleration = {a!r}\njerk = {j!r}",
                      reference, "[limits]\n" + limits if limits else "", more]) + "\n"


def design_vectors():
    for kind in ("ordinates", "coefficients", "states"):
        for n in (4, 12, 32):
            yield f"cubic {kind} n = {n}", study(3, n, spline=f'segments = {n}\ndesign = "{kind}"')
        yield f"quintic {kind} n = 12", study(5, 12, spline=f'segments = 12\ndesign = "{kind}"')
    for n in (64, 128):
        yield f"cubic n = {n}", study(3, n)
    for n in (8, 24, 48):
        yield f"quintic n = {n}", study(5, n)
    for n in (16, 64):
        yield f"RR n = {n}", study(3, n, "RR")


def weights():
    for degree, n, kind in ((3, 12, "DRD"), (5, 12, "DRD"), (3, 24, "RR")):
        for corner in range(3):
            for beside in (0.0, 1e-12, 1e-9):
                own = [beside] * 3
                own[corner] = 1.0
                yield f"{kind} {degree} {n} {own}", study(degree, n, kind, weights=own)
    for factor in (1e-9, 1e-6, 1e6, 1e9):
        yield f"weights times {factor}", study(3, 12, weights=[factor * w for w in (0.4, 0.4, 0.2)])
        peaks = "velocity = {!r}, acceleration = {!r}, jerk = {!r}".format(1.76 * factor, 5.53 * factor, 69.0 * factor)
        yield f"reference times {factor}", study(3, 12, reference=f"reference = {{ {peaks} }}")


def scaling():
    for length in (1e-6, 1.0, 1e6):
        for rise in (0.001, 90, 360):
            yield f"lift {length} mm in {rise} deg", study(3, 12, motion=f"lift_mm = {length!r}\nrise_deg = {rise}")
    for speed in (1e-6, 1.0, 1e6):
        yield f"limits in time at {speed} rpm", study(
            3, 24, motion=f"lift_mm = 20\nrise_deg = 120\nspeed_rpm = {300 * speed!r}",
            limits=f"velocity_mm_s = {550 * speed!r}\nacceleration_m_s2 = {30 * speed**2!r}")


def breakpoints():
    for beside in (0, 5):
        for ratio in (1e-4, 1e-8):
            places = sorted([k / 12 for k in range(13)] + [(beside + ratio) / 12])
            yield f"one of {ratio} beside breakpoint {beside}", study(3, 0, spline=f"breakpoints = {places}")
    widths = [10**(-k) for k in range(9)]
    places = [sum(widths[:k]) / sum(widths) for k in range(9)] + [1.0]
    yield "graded", study(3, 0, spline=f"breakpoints = {places}")


def exact_points():
    for error in ("0", "1e-6"):
        at = 0.5 + float(error)
        yield f"symmetry and y(1/2) off by {error}", study(
            3, 12, motion=f"symmetric = true\nvia = [{{ at = 0.5, displacement = {at!r} }}]")
    for distance in (1e-2, 1e-4, 1e-6):
        second = f"{{ at = {0.5 + distance!r}, displacement = {0.5 + 1.5 * distance!r} }}"
        points = "{ at = 0.5, displacement = 0.5 }, " + second
        yield f"two points {distance} apart", study(3, 12, motion=f"via = [{points}]")
    places = (0.25, 0.5, 0.75, 0.1, 0.33, 0.6, 0.9, 0.95)
    for error in (1e-6, 1e-3):
        points = ", ".join("{{ at = {!r}, displacement = {!r} }}".format(
            x, x**3 * (10 + x * (-15 + 6 * x)) + (error if x == 0.95 else 0)) for x in places)
        yield f"eight points, one off by {error}", study(5, 4, motion=f"via = [{points}]")


def limits():
    least = {(3, "acceleration"): 4.8, (3, "jerk"): 32.0}
    for (degree, peak), edge in least.items():
        for step in (1e-4, 1e-6, -1e-6, -1e-4):
            yield f"{peak} {step:+g}", study(degree, 12, limits=f"{peak} = {edge * (1 + step)!r}")
    for velocity in (0.5, 0.9, 1.1):
        yield f"velocity {velocity}", study(3, 12, limits=f"velocity = {velocity}")
        yield f"quintic, velocity {velocity}", study(5, 8, limits=f"velocity = {velocity}")
    cam = '[cam]\ntype = "disk"\nfollower = "translating_roller"\nbase_radius_mm = {}\nroller_radius_mm = 10'
    for base in (16.9, 17.1, 25, 30):
        yield f"base radius {base}", study(3, 24, motion="lift_mm = 20\nrise_deg = 60",
                                           limits="pressure_angle_deg = 30", more=cam.format(base))


def degenerate():
    for n in (8, 12, 13):
        for corner in range(3):
            own = [0.0] * 3
            own[corner] = 1.0
            yield f"n = {n}, {own} alone", study(3, n, weights=own)
    for degree, n in ((3, 1), (3, 2), (3, 3), (5, 1)):
        yield f"degree {degree}, n = {n}", study(degree, n)
    for n in (12, 13):
        yield f"symmetric n = {n}", study(3, n, motion="symmetric = true")
    yield "capped at their values", study(3, 12, weights=(0.0, 0.0, 1.0), limits="velocity = 2\nacceleration = 8")


GROUPS = {design_vectors: 19, weights: 35, scaling: 12, breakpoints: 5, exact_points: 7, limits: 18, degenerate: 16}


def main():
    module, faults = checker.load(), []
    with tempfile.TemporaryDirectory() as place:
        for group, least in GROUPS.items():
            proved = 0
            for number, (name, text) in enumerate(group()):
                folder = Path(place) / f"{group.__name__}_{number}"
                verdict = checker.solve(sys.argv[1], text, folder)
                found, why = checker.outcome(module, folder)
                print(f"{group.__name__}: {name}: {verdict}: {why}", flush=True)
                claims = verdict in ("optimal", "infeasible")
                proved += claims and found == "confirmed"
                if found == "refuted" or (claims and found != "confirmed"):
                    faults.append(f"{group.__name__}: {name}: {verdict}: {why}")
            print(f"{group.__name__}: {proved} proofs confirmed")
            if proved < least:
                faults.append(f"{group.__name__}: {proved} proofs confirmed, expected {least}")
    return checker.end(faults)


if __name__ == "__main__":
    sys.exit(main())
