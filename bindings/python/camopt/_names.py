# SPDX-License-Identifier: MIT
"""Keywords of Python as keys of a scene: lift_mm=10 is motion.lift_mm, limits=dict(jerk=70) is limits.jerk."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import Any

from ._camopt import InputError, scene_keys

# Where a keyword without a table is looked for, in this order.
_SEARCHED = ("", "motion", "spline", "solver")
_SHORT_WEIGHTS = {"v": "velocity", "a": "acceleration", "j": "jerk"}


def dotted(keys: Mapping[str, Any]) -> Iterator[tuple[str, Any]]:
    """Each as (dotted key of a scene, value). Raises InputError for a keyword that no table has."""
    tables = scene_keys("")
    for name, value in keys.items():
        if "." in name:
            yield name, value
        elif "__" in name:
            yield name.replace("__", "."), value
        elif name == "weights":
            for weight, number in _table(name, value):
                yield f"objective.{_SHORT_WEIGHTS.get(weight, weight)}", number
        elif name == "solver" and isinstance(value, str):
            yield "solver.name", value
        elif name in tables and (isinstance(value, Mapping) or value is None):
            if value is None:
                yield name, None
            else:
                yield from ((f"{name}.{inner}", one) for inner, one in value.items())
        else:
            yield _searched(name, value), value


def _table(name: str, value: Any) -> Iterator[tuple[str, Any]]:
    if not isinstance(value, Mapping):
        raise InputError(f"{name}: found {value!r}; allowed: a dict")
    yield from value.items()


def _searched(name: str, value: Any) -> str:
    if name == "segments" and isinstance(value, (list, tuple)):
        return "motion.segments"  # of a program; a number is the spline's
    if name == "segments":
        return "spline.segments"
    for table in _SEARCHED:
        if name in scene_keys(table):
            return f"{table}.{name}" if table else name
    allowed = [key for table in _SEARCHED[1:] for key in scene_keys(table)]
    raise InputError(f"{name}: found no key of this name; allowed: weights, limits, cam and the other tables of a "
                     f"scene as dicts, {', '.join(allowed)}")
