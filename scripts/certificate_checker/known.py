# SPDX-License-Identifier: MIT
"""What a scene or a machine may say, as far as this checker knows what it means.

Theorem. A scene that passes `name_what_is_unknown` has no table, key or term that changes the problem and that no module reads; any other is
named and not verified.
"""
from .exact import ORDERS, Unverified

KNOWN_TABLES = {"title", "motion", "spline", "objective", "cam", "linkage", "forces", "measured", "limits", "drawing",
                "solver", "dynamics", "drive", "tolerance"}
KNOWN_TERMS = {"velocity", "acceleration", "jerk", "area", "rms_acceleration", "rms_jerk", "torque", "residual", "reference", "tie_break", "peaks",
               "base_radius", "roller_radius", "offset", "center_distance", "arm_length", "face_offset", "motor_torque",
               "motor_torque_rms", "deviation", "deviation_rms"}
KNOWN_LIMITS = ("velocity", "acceleration", "jerk", "cam_velocity", "cam_acceleration", "cam_jerk", "pressure_angle", "rise_pressure_angle", "return_pressure_angle", "cam_radius_min",
                "concave_radius_min", "undercut_margin", "contact_force_min", "contact_moment_min", "contact_force_max",
                "contact_moment_max", "torque_max", "hertz_pressure_max",
                "residual", "spring_harmonic", "dynamic_contact_force_min", "motor_torque", "motor_torque_rms", "motor_speed", "motor_curve")


KNOWN_OF_MOTION = ("type", "lift_", "rise_", "return_", "speed_", "symmetric", "within_lift", "monotone", "via", "start", "end",
                   "corridor", "segments", "closed", "repeat", "stops", "phase_")


KNOWN_KEYS = {"spline": ("degree", "segments", "breakpoints", "knots", "continuity", "end_jerk", "rest", "design"),
              "measured": ("table", "columns", "decimal", "theta", "s_", "step_", "zero", "angles", "outliers", "use", "norm",
                           "name"),
              "segments": ("kind", "angle_", "law", "to", "via", "end"),
              "via": ("at", "from", "to", "displacement", "velocity", "acceleration"),
              "corridor": ("from", "to", "displacement", "velocity", "acceleration", "jerk"),
              "start": ("velocity", "acceleration"), "end": ("velocity", "acceleration"),
              "machine": ("speed_",), "axis": ("name", "scene", "phase_"),
              "clearance": ("between", "factors", "at_least_", "from_", "to_")}


def name_unknown_keys(table, path):
    """Of a table whose keys are listed, and of those in it."""
    known = KNOWN_KEYS[path.rsplit(".", 1)[-1]]
    for key in sorted(table):
        if not key.startswith(known):
            raise Unverified(f"{path}.{key}")
        if key in ("via", "end"):
            name_unknown_keys_of(table[key], f"{path}.{key}")


def name_unknown_keys_of(tables, path):
    for table in tables if isinstance(tables, list) else [tables]:
        name_unknown_keys(table, path)


OF_CAM_MOTION = tuple(f"cam_{name}" for name in ORDERS)  # only where the motion of the output is prescribed


def name_unknown_limits(scene):
    for limit in sorted(scene.get("limits", {})):
        if not limit.startswith(KNOWN_LIMITS):
            raise Unverified(f"limits.{limit}")
        needed = "drive" if limit.startswith("motor_") else "dynamics" if limit.startswith(("residual", "dynamic_", *OF_CAM_MOTION)) else \
            None if limit.startswith(tuple(ORDERS)) else "cam"
        if needed and needed not in scene:
            raise Unverified(f"limits.{limit} without [{needed}]")


def name_what_is_unknown(scene):
    """A table, a key or a term that nothing below looks at would pass unseen."""
    for table in sorted(set(scene) - KNOWN_TABLES):
        raise Unverified(f"[{table}]")
    for term in sorted(set(scene.get("objective", {})) - KNOWN_TERMS):
        raise Unverified(f"objective.{term}")
    name_unknown_limits(scene)
    motion = scene["motion"]
    for tables, path in ((scene.get("spline", {}), "spline"), (scene.get("measured", {}), "measured"),
                         *((motion.get(key, []), f"motion.{key}") for key in ("segments", "via", "corridor", "start", "end"))):
        name_unknown_keys_of(tables, path)
    if scene.get("measured", {}).get("use", "compare") not in ("compare", "start", "nearest"):
        raise Unverified(f"measured.use = {scene['measured']['use']}")
    if motion["type"] not in ("DRD", "RR", "program"):
        raise Unverified(f'motion.type = "{motion["type"]}"')
    for key in sorted(motion):
        if not key.startswith(KNOWN_OF_MOTION):
            raise Unverified(f"motion.{key}")


def name_unknown_of_machine(machine):
    for table in sorted(set(machine) - {"title"}):
        if table not in ("machine", "axis", "clearance"):
            raise Unverified(f"[{table}] of a machine")
        name_unknown_keys_of(machine[table], table)
