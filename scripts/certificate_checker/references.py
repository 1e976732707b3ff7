# SPDX-License-Identifier: MIT
"""What the objective divides by."""
from fractions import Fraction

from .exact import (
    ORDERS, PI, Refuted, STATED, Unverified, derivative, exactly, integral, largest_magnitude, number, product, root, times)
from .laws import END_VELOCITIES, POLYNOMIALS


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


def modified_sine_torque():
    """max of A^2/(4 pi) cos p (1 + 3 sin p) over the middle of the law: at sin p = (sqrt 73 - 1)/12."""
    sine = tuple((r - 1) / 12 for r in root(Fraction(73)))
    cosine = root(1 - sine[1]**2)[0], root(1 - sine[0]**2)[1]
    acceleration = law_peak("modified_sine", "acceleration")
    factor = times(times(acceleration, acceleration), (1 / (4 * PI[1]), 1 / (4 * PI[0])))
    return times(factor, times(cosine, tuple(1 + 3 * s for s in sine)))


def law_peak(law, name):
    """(low, high) around a peak of a law of the catalogue."""
    one = exactly(Fraction(1))
    inverse = (1 / (4 + PI[1]), 1 / (4 + PI[0]))
    bent = (1 / (2 + PI[1]), 1 / (2 + PI[0]))
    square = times(PI, PI)
    cube = times(square, PI)
    known = {
        ("modified_sine", "velocity"): lambda: times(exactly(4), times(PI, inverse)),
        ("modified_sine", "acceleration"): lambda: times(exactly(4), times(square, inverse)),
        ("modified_sine", "jerk"): lambda: times(exactly(16), times(cube, inverse)),
        ("modified_sine", "torque"): modified_sine_torque,
        ("modified_trapezoid", "velocity"): lambda: times(exactly(2), one),
        ("modified_trapezoid", "acceleration"): lambda: times(exactly(8), times(PI, bent)),
        ("modified_trapezoid", "jerk"): lambda: times(exactly(32), times(square, bent)),
        ("parabolic", "velocity"): lambda: times(exactly(2), one),
        ("parabolic", "acceleration"): lambda: times(exactly(4), one),
        ("simple_harmonic", "velocity"): lambda: times(exactly(Fraction(1, 2)), PI),
        ("simple_harmonic", "acceleration"): lambda: times(exactly(Fraction(1, 2)), square),
        ("cycloidal", "velocity"): lambda: times(exactly(2), one),
        ("cycloidal", "acceleration"): lambda: times(exactly(2), PI),
        ("cycloidal", "jerk"): lambda: times(exactly(4), square),
    }
    if (law, name) in known:
        return known[(law, name)]()
    if law in POLYNOMIALS and law not in END_VELOCITIES:
        y = [Fraction(c) for c in POLYNOMIALS[law]]
        if name in ORDERS:
            return largest_magnitude([(derivative(y, ORDERS[name]), Fraction(1))])
        if name.startswith("rms_"):
            bent = derivative(y, ORDERS[name[4:]])
            return root(integral(product(bent, bent), Fraction(1)))
        return largest_magnitude([(product(derivative(y), derivative(y, 2)), Fraction(1))])
    raise Unverified(f"the {name} of the law {law}, which the objective divides by")
