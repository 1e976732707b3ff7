# SPDX-License-Identifier: MIT
"""Numbers of a scene with their units.

Theorem. Lengths, forces, moments and pressures convert exactly. Degrees and radians convert with pi to 35 digits (`in_unit`, `ratio`), or are
enclosed (`enclosed`).
"""

from .enclosures import PI, PI_ITSELF, Jet
from .exact import Unverified, number
from .rational import Fraction

INCH, POUND, POUND_FORCE = Fraction(254, 10000), Fraction(45359237, 10**8), Fraction("4.4482216152605")
LENGTHS = {"mm": Fraction(1, 1000), "m": Fraction(1), "in": INCH}
FORCE = {"n": Fraction(1), "lbf": POUND_FORCE}
MOMENTS = {"nm": Fraction(1), "lbf_in": POUND_FORCE * INCH}
RADIAN = 180 / PI_ITSELF  # deg
PRESSURES = {"mpa": Fraction(1), "gpa": Fraction(1000), "pa": Fraction(1, 10**6), "ksi": POUND_FORCE / INCH**2 / 1000}
MODULI = {unit: size / 1000 for unit, size in PRESSURES.items()}
RATES = {"n_m": 1, "n_mm": 1000, "lbf_in": POUND_FORCE / INCH, "n_m_rad": 1, "nm_rad": 1, "nm_deg": RADIAN}
DAMPING = {"n_s_m": 1, "nm_s_rad": 1}
MASSES = [("mass_kg", "mass", {"kg": 1, "lb": POUND}), ("mass_kg", "inertia", {"kg_m2": 1})]
TRAIN = MASSES + [("preload_n", "preload", FORCE | MOMENTS)] + [
    (f"{name}_n_s_m", name, DAMPING) for name in ("damping", "ground_damping")] + [
    (f"{name}_n_m", name, RATES) for name in ("stiffness", "return_spring")]
# Table: (the key that the checker knows, its name and units in a scene, each in units of the known one). An arm's moments stand for
# forces, its inertia for a mass.
SPELLINGS = {
    "limits": [(f"{side}pressure_angle_deg", f"{side}pressure_angle", {"rad": RADIAN}) for side in ("", "rise_", "return_")] +
              [("contact_force_min_n", "contact_force_min", FORCE), ("contact_force_min_n", "contact_moment_min", MOMENTS),
               ("contact_force_max_n", "contact_force_max", FORCE), ("contact_force_max_n", "contact_moment_max", MOMENTS),
               ("torque_max_nm", "torque_max", MOMENTS), ("hertz_pressure_max_mpa", "hertz_pressure_max", PRESSURES),
               ("residual_mm", "residual", {"um": Fraction(1, 1000)}), ("spring_harmonic_mm", "spring_harmonic", {"um": Fraction(1, 1000)}),
               ("dynamic_contact_force_min_n", "dynamic_contact_force_min", FORCE | MOMENTS)],
    "forces": MASSES + [("spring_rate_n_m", "spring_rate", RATES), ("preload_n", "preload", FORCE | MOMENTS),
                        ("damping_n_s_m", "damping", DAMPING), ("load_n", "load", FORCE | MOMENTS)] +
              [(f"{part}_modulus_gpa", f"{part}_modulus", MODULI) for part in ("cam", "follower")] +
              [("contact_width_m", "contact_width", LENGTHS), ("spring_frequency_hz", "spring_frequency", {"rad_s": 1 / (2 * PI_ITSELF)})],
    "tolerance": [("spring_rate_n_m", "spring_rate", RATES), ("preload_n", "preload", FORCE | MOMENTS)],
    "dynamics": TRAIN + [("speed_range_rpm", "speed_range", {"rad_s": 30 / PI_ITSELF})],
}
KNOWN_KEYS = {table: {f"{name}_{unit}": (known, Fraction(size)) for known, name, units in rows for unit, size in units.items()}
              for table, rows in SPELLINGS.items()}


def scaled(value, size):
    """Of a number, of a range, of a list of numbers, or of pairs (an angle, a number)."""
    if isinstance(value, dict):
        return {end: number(v) * size for end, v in value.items()}
    if isinstance(value, list):
        return [[v[0], number(v[1]) * size] if isinstance(v, list) else number(v) * size for v in value]
    return number(value) * size


def in_known_units(scene):
    """The scene with limits, forces and masses in the units that the checker knows."""
    def converted(table, known):
        return {known.get(key, (key, None))[0]: scaled(value, known[key][1]) if key in known else value for key, value in table.items()}

    tables = {name: converted(scene[name], known) for name, known in KNOWN_KEYS.items() if name in scene}
    if "stage" in scene.get("dynamics", {}):
        tables["dynamics"]["stage"] = [converted(stage, KNOWN_KEYS["dynamics"]) for stage in scene["dynamics"]["stage"]]
    return scene | tables


def known_limit(key):
    """The key of a limit as the checker knows it, of one as the scene has it."""
    name = key.removeprefix("limits.")
    return "limits." + KNOWN_KEYS["limits"][name][0] if key != name and name in KNOWN_KEYS["limits"] else key


def dimension_of(table, *names):
    """m, or (least, most) where it is searched; 0 where no name is given."""
    for unit, size in LENGTHS.items():
        for name in names:
            value = table.get(f"{name}_{unit}")
            if isinstance(value, dict):
                return number(value["min"]) * size, number(value["max"]) * size
            if value is not None:
                return number(value) * size
    return Fraction(0)


def angle_of(table, key, searched=False):
    """(value, "deg" or "rad"), or None. `searched`: of a range the value is (least, most)."""
    for spelling, unit, size in (("deg", "deg", 1), ("rad", "rad", 1), ("crank_deg", "deg", Fraction(1, 2))):
        if f"{key}_{spelling}" in table:
            value = table[f"{key}_{spelling}"]
            if isinstance(value, dict) and searched:
                return (number(value["min"]) * size, number(value["max"]) * size), unit
            if isinstance(value, dict):
                raise Unverified(f"{key}_{spelling}: an angle that is searched")
            return number(value) * size, unit
    return None


def enclosed(angle):
    """rad, of (number, "deg" or "rad"); a length is what it is."""
    size, unit = angle
    return size / 180 * PI if unit == "deg" else Jet.number(size)


def in_unit(angle, unit):
    """Its number of degrees or radians, from one to the other with pi to 35 digits; a length is what it is."""
    value, own = angle
    return value if own in (unit, "m") else value * 180 / PI_ITSELF if unit == "deg" else value * PI_ITSELF / 180


def ratio(a, b):
    """Of two angles; of degrees and radians with pi to 35 digits."""
    return in_unit(a, b[1]) / b[0]
