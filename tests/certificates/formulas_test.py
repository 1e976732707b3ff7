# SPDX-License-Identifier: MIT
"""The checker's formulas against what is known of them from elsewhere: positions alone, or differential equations in steps."""
import math
import sys
import tempfile
import tomllib
from fractions import Fraction
from pathlib import Path
from types import SimpleNamespace

import checker
from plane_samples import guide_of

sys.path.insert(0, str(checker.ROOT / "scripts"))
from certificate_checker import enclosures  # noqa: E402
from certificate_checker.bound import Bound  # noqa: E402
from certificate_checker.exact import Unverified  # noqa: E402
from certificate_checker.laws import constant  # noqa: E402
from certificate_checker.inverse_rules import InverseRules  # noqa: E402
from certificate_checker.origins import Origin, read_certificate  # noqa: E402
from certificate_checker.problem import Problem  # noqa: E402
from certificate_checker.remote_rules import RemoteRules  # noqa: E402
from certificate_checker.spatial_rules import SpatialRules  # noqa: E402
from certificate_checker.train import Train  # noqa: E402
from certificate_checker.units import in_known_units  # noqa: E402


def scene_of(name):
    return in_known_units(tomllib.loads((checker.ROOT / "scenes" / f"{name}.toml").read_text(), parse_float=Fraction))


def problem_of(scene, lift, rise):
    return SimpleNamespace(limits=scene["limits"], lift=lift, unit_angle=(Fraction(rise), "deg"))


def value(number):
    return float(enclosures.fraction(sum(number.value) // 2))


def numbers(*values):
    return [constant(number) for number in values]


def near(name, found, expected, by=1e-12):
    return [] if abs(found - expected) <= by * max(1.0, abs(expected)) else [f"{name}: {found}, expected {expected}"]


def sides(name, rule_of, edge, state, *place):
    """A rule is kept on the one side of the edge and passed on the other; the second number says which."""
    edge, by = edge
    passed, kept = (value(rule_of(Fraction(edge + sign * by))(numbers(*state), *map(constant, place))) for sign in (1, -1))
    return [] if passed > 0 > kept else [f"{name}: {passed} and {kept} beside its edge"]


def tappet():
    """The tappet's lever and cam at 100 deg: figures of 60-digit arithmetic from positions, tests/profiles/remote."""
    scene = scene_of("tappet_75")
    rules = RemoteRules(problem_of(scene, (Fraction(80, 1000), "m"), 120), scene)
    s = Fraction("-23.6171056594636") / 1000 + Fraction(40, 1000)
    way, rate, bend = rules.roller_arm(constant(s))
    faults = near("lever", math.atan2(value(way[1]), value(way[0])), -0.0591478088492702)
    first = 0.208911060095432 / value(rate)
    second = (0.331525238681079 - value(bend) * first**2) / value(rate)
    beta, lift = math.radians(120), 0.08
    state = [float(s) / lift, first * beta / lift, second * beta**2 / lift]
    angle = math.degrees(math.atan(0.506286954581988))
    faults += sides("tappet's pressure angle", lambda a: rules.pressure(a, -1), (angle, -1e-9), state)
    return faults + sides("tappet's curvature", lambda r: rules.excess(r - Fraction(30, 1000), constant(1)),
                          (1 / 6.87914199115577, 1e-9), state)


def feeder():
    """Guide, pressure angle and curvature from positions by differences."""
    scene = scene_of("inverse_feeder")
    lift, rise = 2.694, math.radians(143.3)
    rules = InverseRules(problem_of(scene, (Fraction(2694, 1000) * Fraction(254, 10000), "m"), Fraction("143.3")), scene)
    cam = {key: float(size) for key, size in scene["cam"].items() if key != "type"}
    motion = [0.3, 1.4, 0.5, -0.8]

    def guide(x):
        return guide_of(cam, lift * sum(c * x**k for k, c in enumerate(motion)), x * rise)

    x, h = 0.4, 1e-4
    (l0, p0), (l1, p1), (l2, p2) = guide(x - h), guide(x), guide(x + h)
    steep = math.degrees(math.atan(l1 * (p2 - p0) / (l2 - l0)))
    points = [(r * math.cos(p), r * math.sin(p)) for r, p in ((l0, p0), (l1, p1), (l2, p2))]
    (ax, ay), (bx, by), (cx, cy) = points
    area = (bx - ax) * (cy - ay) - (by - ay) * (cx - ax)
    curvature = 2 * area / math.dist(points[0], points[1]) / math.dist(points[1], points[2]) / math.dist(points[0], points[2])
    state = [motion[0] + motion[1] * x + motion[2] * x**2 + motion[3] * x**3,
             motion[1] + 2 * motion[2] * x + 3 * motion[3] * x**2, 2 * motion[2] + 6 * motion[3] * x]

    def either(limit):
        return lambda z, at: max((rules.pressure(limit, sign)(z, at) for sign in (1, -1)), key=value)

    faults = sides("feeder's pressure angle", either, (abs(steep), -1e-4), state, x)
    radius = float(scene["cam"]["roller_radius_in"])
    for side in (1, -1):
        faults += sides("feeder's wall", lambda m, side=side: rules.margin(m, side), (1 - side * radius * curvature, 1e-5),
                        state, x)
    return faults


def barrel():
    """The margin of a flank is passed by the scaled rule where it is passed by the plain one; the index starts where the scene says."""
    scene, faults = scene_of("barrel_paper_cup"), []
    other = scene | {"cam": scene["cam"] | {"start_angle_deg": Fraction(-20)}}
    started = SpatialRules(problem_of(scene, (scene["motion"]["lift_deg"], "deg"), 160), other).start
    faults += near("start angle", value(started), math.radians(-20), 1e-12)
    rules = SpatialRules(problem_of(scene, (scene["motion"]["lift_deg"], "deg"), 160), scene)
    for state in ([0.2, 1.5, 4.0], [0.7, 1.1, -5.0], [0.5, 1.7, 0.0]):
        for flank in (1, -1):
            for part in (0, 1):
                plain = -value(rules.margin(Fraction(0), flank)(numbers(*state, part)))
                faults += sides("flank", lambda m, f=flank, p=part: rules.scaled_margin(m, f, p), (plain, 1e-9), [*state, 0])
    return faults


def slide(to_ground=0):
    """The residual of the modified sine, by Runge and Kutta. `to_ground`: a damper, N s/m."""
    scene = scene_of("dynamics_fast_slide")
    scene = scene | {"dynamics": scene["dynamics"] | {"ground_damping_n_s_m": Fraction(to_ground)}}
    train = Train(Problem(scene, dict.fromkeys(("velocity", "acceleration", "jerk"), Fraction(1))))
    train.times = (train.time_at(Fraction(280)),) * 2
    found = train.residual_of_law("modified_sine")
    w, z = 2 * math.pi * 70 * 90 / (6 * 280), 0.02
    share = 1 - 8000 / (2.5 * (2 * math.pi * 70)**2)
    q = z + to_ground / (2 * 2.5 * 2 * math.pi * 70)  # of both dampers
    size, slow, fast = 4 * math.pi**2 / (4 + math.pi), 4 * math.pi / 3, 4 * math.pi

    def bend(x):
        return size * (math.sin(fast * x) if x < 1 / 8 else math.cos(slow * (x - 1 / 8)) if x < 7 / 8 else
                       -math.cos(fast * (x - 7 / 8)))

    def rates(x, state):
        slope, e, rate = state
        # The mass is at share * y + e: the damper to ground takes the velocity of both, that of the train what y and the mass differ by.
        return bend(x), rate, 2 * z * w * (slope - share * slope - rate) - 2 * (q - z) * w * (share * slope + rate) - share * bend(x) - w * w * e

    state, count = (0.0, 0.0, 0.0), 8000
    for n in range(count):
        x, h = n / count, 1 / count
        k1 = rates(x, state)
        k2 = rates(x + h / 2, [s + h / 2 * k for s, k in zip(state, k1)])
        k3 = rates(x + h / 2, [s + h / 2 * k for s, k in zip(state, k2)])
        k4 = rates(x + h * (1 - 1e-12), [s + h * k for s, k in zip(state, k3)])
        state = [s + h / 6 * (a + 2 * b + 2 * c + d) for s, a, b, c, d in zip(state, k1, k2, k3, k4)]
    e, rate = state[1:]
    expected = math.hypot(e, (rate + q * w * e) / (w * math.sqrt(1 - q * q)))
    return near(f"residual of the modified sine with {to_ground} N s/m to ground", float(found[0]), expected, 1e-8)


def narrow_segment():
    """y''' of the last of graded segments, at rest at its end, is no larger than the third derivative can be: what rounding
    leaves of multipliers there is not worth what y'' may be in the middle, over the width."""
    widths = [Fraction(1, 10**k) for k in range(9)]
    scene = {"motion": {"type": "DRD"}, "objective": {"velocity": Fraction(2, 5), "acceleration": Fraction(2, 5), "jerk": Fraction(1, 5)},
             "spline": {"degree": 3, "breakpoints": [sum(widths[:k], Fraction(0)) / sum(widths) for k in range(10)]}}
    problem = Problem(scene, dict.fromkeys(("velocity", "acceleration", "jerk"), Fraction(1)))
    bound = Bound(problem, Fraction(100), Fraction(0))
    run, supremum = problem.runs[0], bound.supremum[0]
    constant_part, residual = bound.under(run, run.space.functional(Fraction(1), 3, "left"), supremum)
    return [] if abs(constant_part) + residual <= supremum[3] else [f"y''' of a narrow segment: {float(residual)} of {float(supremum[3])}"]


def beside_free_ends():
    """The first control point that rest leaves open is y''' at the start, times the cube of the width: that a run begins at a dwell is known
    where its end is free, too."""
    kinds = [("dwell", 90, {}), ("spline", 60, {}), ("law", 60, {"law": "constant_velocity"}), ("spline", 60, {"to": 1}),
             ("spline", 90, {"to": 0})]
    segments = [{"kind": kind, "angle_deg": Fraction(angle), **more} for kind, angle, more in kinds]
    scene = {"motion": {"type": "program", "lift": Fraction(1), "segments": segments}, "objective": {"jerk": Fraction(1)},
             "spline": {"segments": 8}}
    problem = Problem(in_known_units(scene), dict.fromkeys(("velocity", "acceleration", "jerk"), Fraction(1)), None, [])
    bound = Bound(problem, Fraction(100), Fraction(0))
    bound.functions[0] = {3: Fraction(1)}
    largest = bound.supremum[0][3] * problem.runs[0].space.width(0)**3
    bound.under_together()
    return [] if bound.residual <= largest * Fraction(101, 100) else [f"beside free ends: {float(bound.residual)}, not {float(largest)}"]


def old_format():
    """A certificate without the fields of its rows is named, not judged."""
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "certificate.json"
        path.write_text('{"verdict": "optimal"}')
        try:
            read_certificate(path)
        except Unverified as gap:
            return [] if "certificate.json of format 1: this checker reads format 2" in str(gap) else [f"old format: {gap}"]
    return ["old format: a certificate without fields is read"]


def whole_limits():
    """A row that says which of several rules it is of has that one alone; a limit all of them."""
    stations = [(flank, part) for part in (0, 1, 2) for flank in (1, -1)]
    whole, station = Origin("limits.undercut_margin"), Origin("limits.undercut_margin", which={"station": 3.0})
    torque = Origin("limits.torque_max_nm", which={"torque": -1.0})
    found = [whole.chosen("station", stations), station.chosen("station", stations), torque.signs("torque"),
             torque.chosen("load_speed", "abc", 0)]
    return [] if found == [stations, [(-1, 1)], [-1], "a"] else [f"rows of a limit: {found}"]


def main():
    tests = tappet, feeder, barrel, slide, lambda: slide(300), narrow_segment, beside_free_ends, old_format, whole_limits
    faults = [fault for test in tests for fault in test()]
    return checker.end(faults)


if __name__ == "__main__":
    sys.exit(main())
