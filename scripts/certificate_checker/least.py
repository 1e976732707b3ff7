# SPDX-License-Identifier: MIT
"""How far a number of a scene goes (objective.least, objective.largest).

Theorem. Let F(v) be the motions of the scene with v in place of the number under the key, and let F shrink as v falls:
F(v) is a part of F(w) for v <= w. If F(impossible) is empty, then so is F(v) for every v <= impossible, and with a motion
in F(value) the least value with a motion lies in (impossible, value]. For `largest` with the signs turned.

F shrinks with a cap on a figure by definition of the cap, and rises with a least value of one. For other numbers this
module knows it where `shrinks` says so; elsewhere it confirms the two ends and no more.

The folder holds the scene with `value` and its motion; its folder `least` the scene with `impossible`, its result and its
certificate, which are judged like any other. The two scenes must be the same but for the number.
"""
import copy
import json
import re
import tomllib

from .exact import Refuted, Unverified, number
from .linear_rules import sense_of
from .rational import Fraction, parsed
from .units import in_known_units

KEYS = ("least", "largest", "least_gap")
FORCES_BUT_CONTACT = ("contact_force_max", "contact_moment_max", "torque_max", "hertz_pressure_max", "residual", "dynamic_contact_force_min", "spring_harmonic")
RADII = ("cam_radius_min", "concave_radius_min", "undercut_margin")
NOT_NEGATIVE = ("forces.spring_rate",)  # keys whose values end at 0
ABSENT = ("forces.preload", "forces.spring_rate")  # keys that are 0 where a scene does not give them
IN_TIME = re.compile(r".*_s[23]?")
SAME = Fraction(1, 10**12)


def without_keys(scene):
    """The scene as it is solved, and what it seeks: (key, largest, gap), or None."""
    objective = {name: value for name, value in scene.get("objective", {}).items() if name not in KEYS}
    asked = scene.get("objective", {})
    largest = bool(asked.get("largest"))
    key = asked.get("largest" if largest else "least")
    plain = {name: table for name, table in scene.items() if name != "objective"} | ({"objective": objective} if objective else {})
    return plain, (key, largest, number(asked.get("least_gap", Fraction(1, 10**4)))) if key else None


def member_of(scene, key):
    """(its table, its last name) of a dotted key: motion.segments[2].angle_deg."""
    *path, last = re.findall(r"[^.\[\]]+", key)
    for name in path:
        scene = scene[int(name)] if name.isdigit() else scene[name]
    return scene, last


def value_of(scene, key):
    table, last = member_of(scene, key)
    return number(table.get(last, 0) if key.startswith(ABSENT) else table[last])


def without_companions(scene, key):
    """Without what changes along with an angle: the dwell that a segment's is taken from; with a rise its return and places on it."""
    motion = scene["motion"]
    if re.fullmatch(r"motion\.segments\[\d+\]\.angle_\w+", key):
        changing = [(segment, ("angle_",)) for segment in motion["segments"] if segment["kind"] == "dwell"]
    elif re.match(r"motion\.(rise|return)_", key):
        changing = [(motion, ("return_",))] + [(point, ("at_", "from_", "to_")) for point in motion.get("via", [])]
    else:
        changing = []
    for table, names in changing:
        for name in [name for name in table if name.startswith(names)]:
            del table[name]


def differs_only_in(one, other, key):
    """Two scenes are the same without the number."""
    for scene in (one, other):
        table, last = member_of(scene, key)
        table[last] = None
        without_companions(scene, key)
    return alike(one, other, SAME if key.startswith("motion.") else 0)


def alike(one, other, room):
    """Where a motion is changed, set points in units are converted anew, and rounded."""
    if isinstance(one, dict) and isinstance(other, dict):
        return one.keys() == other.keys() and all(alike(value, other[name], room) for name, value in one.items())
    if isinstance(one, list) and isinstance(other, list):
        return len(one) == len(other) and all(alike(*pair, room) for pair in zip(one, other))
    numbers = all(isinstance(value, (int, type(SAME))) and not isinstance(value, bool) for value in (one, other))
    return abs(one - other) <= room * max(abs(one), abs(other)) if numbers else one == other


def is_limit_of(key, names):
    return key.startswith(tuple(f"limits.{name}" for name in names))


def has_limit(scene, names):
    return any(limit.startswith(names) for limit in scene.get("limits", {}))


def moves(state):
    return any(name.startswith("velocity") and number(value) for name, value in state.items())


def never_below_zero(motion):
    """Where strokes stay between displacements that are given: set points and ends in motion may take them out."""
    if motion["type"] == "valve":
        return True
    segments = motion.get("segments", [])
    strokes = [segment for segment in segments if segment["kind"] != "dwell"]
    ends = [[number(value) for name, value in stroke.items() if name.split("_")[0] == "to"] for stroke in strokes]
    if strokes and motion.get("closed", True) is True and not ends[-1]:
        ends[-1] = [Fraction(0)]  # the last one returns
    states = [motion.get("start", {}), motion.get("end", {})] + [segment.get("end", {}) for segment in segments]
    return motion.get("within_lift", True) and all(end and end[0] >= 0 for end in ends) and not motion.get("via") and \
        not any(segment.get("via") for segment in segments) and not any(map(moves, states))


def counts_in_time(part):
    """A number of the motion by time: set points, corridors, states."""
    if isinstance(part, dict):
        return any(IN_TIME.fullmatch(name) and not name.startswith("speed") or counts_in_time(own) for name, own in part.items())
    return isinstance(part, list) and any(map(counts_in_time, part))


def held_at_rest(scene):
    """Without damping F(sw) = F_0 + s^2 (F(w) - F_0) lies between the force F_0 at rest and F(w), s <= 1: where the spring alone holds
    the follower at rest, at every s >= 0, a speed at which it stays on the cam has none below it at which it leaves."""
    scene = in_known_units(scene)
    forces, limits, load = scene["forces"], scene["limits"], scene["forces"].get("load_n", 0)
    if any(name.startswith(("damping", "speed_range")) and (name.startswith("speed") or number(own)) for name, own in forces.items()):
        return False
    preload = forces.get("preload_n", 0)
    least = number(preload["min"] if isinstance(preload, dict) else preload)
    least += min(number(force) for _, force in load) if isinstance(load, list) else number(load)
    return "contact_force_min_n" in limits and least >= number(limits["contact_force_min_n"]) and never_below_zero(scene["motion"])


def slows_down(scene):
    """A motion at a speed is one at every lower speed. Limits by time loosen; one of a single side has to allow rest."""
    sided = [own for name, own in scene.get("limits", {}).items() if IN_TIME.fullmatch(name) and isinstance(own, dict)]
    contact = has_limit(scene, ("contact_force_min", "contact_moment_min"))
    return not has_limit(scene, FORCES_BUT_CONTACT + ("motor_",)) and not counts_in_time(scene["motion"]) and \
        not any(own.get("min", 0) > 0 or own.get("max", 0) < 0 for own in sided) and (not contact or held_at_rest(scene))


def shrinks(scene, key, largest):
    """Whether motions only disappear as the number goes on beyond the edge."""
    if key.startswith("limits."):
        return True
    loads_beside_contact = has_limit(scene, FORCES_BUT_CONTACT)
    contact = has_limit(scene, ("contact_force_min", "contact_moment_min"))
    if key.startswith("tolerance."):  # what holds for all cams within the wider ones holds for those within the narrower ones
        return largest
    if key.startswith("forces.preload"):  # F = m s'' w^2 + k s + preload + ... grows with it
        return not largest and not loads_beside_contact
    if key.startswith("forces.spring_rate"):  # likewise, where s >= 0
        return not largest and not loads_beside_contact and never_below_zero(scene["motion"])
    if key.startswith("motion.speed"):
        return largest and slows_down(scene)
    if key.startswith("cam.travel"):  # s' lies between bounds in proportion to the travel of a plate under a pushed follower
        pushed = scene["cam"].get("follower", "").startswith("translating_") and scene["cam"].get("type") == "linear"
        forwards = pushed and sense_of(scene["cam"]) > 0
        return not largest and forwards and not loads_beside_contact and not contact and not has_limit(scene, RADII)
    if key.startswith("cam.base_radius"):  # tan(phi) = (s' - e)/(s0 + s), s0 grows with the radius
        follower = scene["cam"].get("follower", "")
        straight = follower.startswith("translating_") and scene["cam"].get("type", "disk") == "disk"
        curved = has_limit(scene, RADII) and follower != "translating_flat"  # of a flat face: base radius + s + s''
        return not largest and straight and not loads_beside_contact and not contact and not curved
    return False


def check_direction(key, largest):
    if not key.startswith("limits."):
        return
    least_value = is_limit_of(key, RADII + ("contact_force_min", "contact_moment_min", "dynamic_contact_force_min")) or \
        key.endswith(".min")
    if least_value != largest:
        raise Refuted(f"{key} is sought in the wrong direction")


def judge_least(folder, scene, sought, result, judge_inner, report):
    """What result.json says of the number; what is not verified, in a list. scene: as written, with the value."""
    key, largest, gap = sought
    stated = result.get("least")
    if stated is None:
        if result["motion"] is None or result["verdict"] in ("infeasible", "failed"):
            return []  # no value was found: the verdict is that of the scene
        raise Refuted(f"the scene seeks {key}, and the result says nothing of it")
    if stated["key"] != key or stated["largest"] != largest:
        raise Refuted(f"the result speaks of {stated['key']}, the scene of {key}")
    check_direction(key, largest)
    value = value_of(scene, key)
    if abs(value - number(stated["value"])) > SAME * abs(value):
        raise Refuted(f"{key} is {float(value)} in scene.toml, not {stated['value']}")
    if stated["impossible"] is None:
        if stated["verdict"] in ("local", "feasible") or (value == 0 and not largest and key.startswith(NOT_NEGATIVE)):
            return []
        return [f"that {key} ends at {stated['value']}"]
    impossible = number(stated["impossible"])
    if not (impossible > value if largest else impossible < value):
        raise Refuted("the value lies beyond the one that is said to be impossible")
    other = tomllib.loads((folder / "least" / "scene.toml").read_text(), parse_float=parsed)
    if abs(value_of(other, key) - impossible) > SAME * max(abs(impossible), abs(value)):
        raise Refuted(f"{key} is {float(value_of(other, key))} in least/scene.toml, not {stated['impossible']}")
    if not differs_only_in(copy.deepcopy(without_keys(scene)[0]), copy.deepcopy(other), key):
        raise Refuted(f"least/scene.toml differs in more than {key}")
    if json.loads((folder / "least" / "certificate.json").read_text())["verdict"] != "infeasible":
        raise Refuted("least/ does not say that there is no motion")
    code, outcome = judge_inner(folder / "least")
    if code == 1:
        raise Refuted(f"least/: {outcome}")
    if code == 2:
        raise Unverified(f"least/: {outcome}")
    report.say(f"{key}: at {float(impossible):.12g} there is no motion, at {float(value):.12g} there is one")
    if stated["verdict"] == "local":
        return []
    if not shrinks(scene, key, largest):
        return [f"that beyond {float(impossible):.12g} no value of {key} has a motion"]
    if stated["verdict"] == "optimal" and abs(value - impossible) > gap * abs(value) * (1 + SAME):
        raise Refuted(f"{key}: the two values are further apart than least_gap")
    return []
