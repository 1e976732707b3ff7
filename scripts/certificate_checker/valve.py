# SPDX-License-Identifier: MIT
"""A valve lobe as the program it stands for, with rational numbers.

s = (valve lift + lash) / ratio of the follower, of one that swings / the valve's arm, an angle; a ramp of height h and velocity v is
the law run_in over 2h/3v to h/3 and a constant velocity over 2h/3v; the flank goes from its end to the nose through s(checking height),
t after the ramp's end, or as given, on the ramp where that is not below it. In t the jerk 60 L/D^3 up to the acceleration 4 L/D^2
reaches that point, L the lift and D the angle from the point to the nose. Strokes are monotone.

Theorem. `as_program` has the same motions as the scene of the valve: the definition in docs/valves.md, number by number.
"""

from .exact import Unverified, number
from .rational import Fraction
from .units import LENGTHS, RADIAN, angle_of, dimension_of, in_unit

OF_VALVES = ("type", "lift_", "rocker_ratio", "valve_arm_", "lash_", "duration_", "opening_", "closing_ramp", "checking_height_",
             "centerline_", "engine_speed_", "speed_", "corridor")
OF_RAMPS = ("height_", "velocity_", "end_")


def degrees(table, name):
    """None where it is not given."""
    angle = angle_of(table, name)
    return angle and in_unit(angle, "deg")


def ramp_of(table):
    """(height, m or rad; velocity, the same by degree; end or None)."""
    height = angle_of(table, "height")
    height = in_unit(height, "rad") if height else dimension_of(table, "height")
    for unit, size in (*LENGTHS.items(), ("deg", 1 / RADIAN)):
        for by, step in (("deg", 1), ("rad", RADIAN)):
            if f"velocity_{unit}_{by}" in table:
                return height, number(table[f"velocity_{unit}_{by}"]) * size / step, degrees(table, "end")
    raise Unverified("the velocity of a ramp in this unit")


def typical_angle(way, velocity, lift, angle):
    jerk, bend = 60 * lift / angle**3, 4 * lift / angle**2
    low, high = Fraction(0), way / velocity
    for _ in range(100):
        t = (low + high) / 2
        first = min(t, bend / jerk)
        rest = t - first
        moved = velocity * t + jerk * first**2 * (first / 6 + rest / 2) + bend * rest**2 / 2
        low, high = (t, high) if moved <= way else (low, t)
    return low


def as_program(scene):
    """The scene itself where its motion is another one."""
    motion = scene["motion"]
    if motion.get("type") != "valve":
        return scene
    for key in sorted(motion):
        if not key.startswith(OF_VALVES):
            raise Unverified(f"motion.{key}")
    ramps = [motion["opening_ramp"], motion.get("closing_ramp", motion["opening_ramp"])]
    for key in sorted(set(ramps[0]) | set(ramps[1])):
        if not key.startswith(OF_RAMPS):
            raise Unverified(f"motion.opening_ramp.{key}")
    arm, lash = dimension_of(motion, "valve_arm"), dimension_of(motion, "lash")
    ratio = arm or number(motion.get("rocker_ratio", 1))
    lift, checking = ((dimension_of(motion, name) + lash) / ratio for name in ("lift", "checking_height"))
    duration, opening = degrees(motion, "duration"), degrees(motion, "opening")
    opening = duration / 2 if opening is None else opening
    sides, total = [], Fraction(0)
    for ramp, angle in zip(ramps, (opening, duration - opening)):
        height, velocity, end = ramp_of(ramp)
        way, part = checking - height, 2 * height / (3 * velocity)
        before = way / velocity if way <= 0 else end if end is not None else typical_angle(way, velocity, lift, angle)
        via = [{"at": (before, angle), "displacement": checking / lift}] if way > 0 else []
        sides.append((height / lift, part, angle + before, via))
        total += 2 * part + angle + before
    (h, up_part, up, up_via), (k, down_part, down, down_via) = sides
    for point in up_via:
        point["at"] = point["at"][0] / up
    for point in down_via:
        point["at"] = point["at"][1] / down

    def spline(angle, to, via, **more):
        return {"kind": "spline", "angle_deg": angle, "to": to, **({"via": via} if via else {}), **more}

    def law(key, angle, to):
        return {"kind": "law", "law": key, "angle_deg": angle, "to": to}

    segments = [law("run_in", up_part, h / 3), law("constant_velocity", up_part, h), spline(up, Fraction(1), up_via, end={"velocity": 0}),
                spline(down, k, down_via), law("constant_velocity", down_part, k / 3), law("run_out", down_part, Fraction(0)),
                {"kind": "dwell", "angle_deg": 360 - total}]
    kept = {key: motion[key] for key in motion if key.startswith(("speed_", "corridor"))}
    for unit in ("rpm", "rad_s"):
        if f"engine_speed_{unit}" in motion:
            kept[f"speed_{unit}"] = number(motion[f"engine_speed_{unit}"]) / 2
    return {**scene, "motion": {"type": "program", "lift_rad" if arm else "lift_m": lift, "monotone": True, "segments": segments, **kept}}
