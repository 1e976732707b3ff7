# SPDX-License-Identifier: MIT
"""Contact force, torque and Hertz pressure of a follower that is pushed straight, along the splines of the delivered motion."""
import itertools
from fractions import Fraction

from .exact import KEPT, PI, Refuted, Unverified, bernstein, combination, derivative, largest, largest_magnitude, number, product, \
    shifted


def loaded_pieces(cam, curve):
    """[(polynomial, width, the force along it)]: pieces of the splines, on all copies, where the load is a line."""
    forces, speed, pieces = cam.forces, cam.problem.turns_per_second(), []
    for copy, (run, own) in itertools.product(range(cam.problem.copies if not forces.is_constant() else 1),
                                              zip(cam.problem.runs, curve.pieces)):
        for p, width, left, stretch in own:
            x = left - run.begin_of(stretch) + stretch.begin + copy * cam.problem.stretches[-1].end
            for begin, end, load, slope in forces.lines(x, x + width):
                part = shifted(p, begin - x)
                force = combination((forces.mass * speed**2 * cam.lift, derivative(part, 2)),
                                    (forces.damping * speed * cam.lift, derivative(part)), (forces.rate * cam.lift, part),
                                    (1, [forces.preload + load + slope * begin, slope]))
                pieces.append((part, end - begin, force))
    return pieces


def keep_force(cam, curve):
    unit = cam.forces.unit(cam.problem)
    pieces = [([-c / unit for c in force], width) for _, width, force in loaded_pieces(cam, curve)]
    if pieces and largest(pieces)[1] > -cam.forces.least / unit + KEPT * 10:
        raise Refuted("the contact force passes its limit")


def keep_torque(cam, curve, most):
    pieces = [(product(force, [c * cam.lift / cam.beta[0] / most for c in derivative(p)]), width)
              for p, width, force in loaded_pieces(cam, curve)]
    if largest_magnitude(pieces)[1] > 1 + KEPT * 10:
        raise Refuted("the torque passes its limit")


def keep_hertz(cam, curve, most):
    """p^2 = F_n / (pi b C) (1/cam radius + 1/roller), F_n = F sqrt(Q) / D, Q = D^2 + u^2, C = sum of (1 - nu^2) /
    E, and 1/cam radius + 1/roller = 1 / (r (1 - r N / Q^(3/2))): with K = 1 / (pi b C r most^2) it is kept where
    K F Q^2 + r N D <= sqrt(D^2 Q^3), D > 0."""
    forces = cam.scene["forces"]
    compliance = sum((1 - number(forces.get(f"{side}_poisson", Fraction(3, 10)))**2) /
                     (number(forces.get(f"{side}_modulus_gpa", 210)) * 10**9) for side in ("cam", "follower"))
    if any(key.startswith(("cam_modulus", "follower_modulus")) and not key.endswith("_gpa") for key in forces):
        raise Unverified("moduli of elasticity in another unit than GPa")
    pressed = 1 / (sum(PI) / 2 * cam.forces.width * compliance * cam.roller * most**2)
    for p, w, force in loaded_pieces(cam, curve):
        high, _, square, bent = cam.geometry(p)
        if min(bernstein(high, w)) <= 0:
            raise Unverified("limits.hertz_pressure where the contact may lie below the cam's centre")
        side = combination((pressed, product(force, product(square, square))), (cam.roller, product(bent, high)))
        root_of = product(product(high, high), product(square, product(square, square)))
        cam.decide(side, root_of, w, "the Hertz pressure passes its limit")
