# SPDX-License-Identifier: MIT
"""What the objective divides by.

Theorem. Each reference is the scene's number, or the stated double within STATED of the enclosed peak of the reference law.
"""
from .exact import ORDERS, Refuted, STATED, Unverified, number
from .laws import law_peak


def references_of(scene, stated):
    """What the objective divides by: the scene's numbers, or the peaks of a law. camopt writes these as doubles; they
    are checked against their formulas and then are the definition of the objective."""
    objective = scene.get("objective", {})
    asked = objective.get("reference", "modified_sine")
    names = [n for n in (*ORDERS, "torque", "rms_acceleration", "rms_jerk") if number(objective.get(n, 0))]
    references = {}
    for name in names:
        if isinstance(asked, dict):
            if name not in asked:
                raise Unverified(f"objective.reference without {name}")
            references[name] = number(asked[name])
        else:
            low, high = law_peak(asked, name)
            references[name] = number(stated[name])
            if not low * (1 - STATED) <= references[name] <= high * (1 + STATED):
                raise Refuted(f"the reference {name} is {float(references[name])}, but that of the law is {float(low)}")
    for name in ORDERS:  # the unit of a peak that is only capped
        if name not in references:
            unit = stated.get(name)
            references[name] = number(float(sum(law_peak("modified_sine", name)) / 2) if unit is None else unit)
    return references
