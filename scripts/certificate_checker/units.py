# SPDX-License-Identifier: MIT
"""Numbers of a scene with their units."""
from fractions import Fraction

from .exact import PI, PI_ITSELF, Unverified, exactly, number, times

INCH, POUND, POUND_FORCE = Fraction(254, 10000), Fraction(45359237, 10**8), Fraction("4.4482216152605")
LENGTHS = {"mm": Fraction(1, 1000), "m": Fraction(1), "in": INCH}
FORCE = {"n": 1, "lbf": POUND_FORCE}
UNITS = {"mass": {"kg": 1, "lb": POUND}, "spring_rate": {"n_mm": 1000, "n_m": 1, "lbf_in": POUND_FORCE / INCH},
         "preload": FORCE, "damping": {"n_s_m": 1}, "load": FORCE, "contact_width": LENGTHS, "contact_force_min": FORCE}


def unit_of(table, name):
    """(the key of a quantity, SI of one in its unit), or (None, None)."""
    for unit, size in UNITS[name].items():
        if f"{name}_{unit}" in table:
            return f"{name}_{unit}", Fraction(size)
    found = [key for key in table if key.startswith(name + "_")]
    if found:
        raise Unverified(f"{found[0]}: this unit")
    return None, None


def quantity(table, name):
    """SI; 0 where it is not given."""
    key, size = unit_of(table, name)
    return number(table[key]) * size if key else Fraction(0)


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


def angle_of(table, key):
    """(value, "deg" or "rad"), or None."""
    for spelling, unit, size in (("deg", "deg", 1), ("rad", "rad", 1), ("crank_deg", "deg", Fraction(1, 2))):
        if f"{key}_{spelling}" in table:
            value = table[f"{key}_{spelling}"]
            if isinstance(value, dict):
                raise Unverified(f"{key}_{spelling}: an angle that is searched")
            return number(value) * size, unit
    return None


def enclosed(angle):
    """(low, high) around rad, of (number, "deg" or "rad"); a length is what it is."""
    size, unit = angle
    return times(exactly(size / 180), PI) if unit == "deg" else exactly(size)


def in_unit(angle, unit):
    """Its number of degrees or radians, from one to the other with pi to 35 digits; a length is what it is."""
    value, own = angle
    return value if own in (unit, "m") else value * 180 / PI_ITSELF if unit == "deg" else value * PI_ITSELF / 180


def ratio(a, b):
    """Of two angles in one unit. Degrees and radians mixed have no exact ratio."""
    if a[1] != b[1]:
        raise Unverified("angles in degrees and in radians in one scene")
    return a[0] / b[0]
