# SPDX-License-Identifier: MIT
"""Cost terms and limits that are functions of Python, with exact partials or with checked ones."""

from __future__ import annotations

import dataclasses
from collections.abc import Callable
from typing import Any

import numpy as np
import numpy.typing as npt

from . import _camopt
from ._camopt import ModelError

Function = Callable[..., Any]

_NAMES = ("x", "y", "v", "a", "j")
# How far points and steps reach in y, v, a, j: about the peaks of good motions.
_SIZES = np.array([1.0, 1.0, 2.0, 6.0, 60.0])
_STEP = 2e-3  # of a size
# A derivative is wrong where it is off by this many of the difference's own errors, and by this part of its size.
_ERRORS, _PART = 100.0, 1e-6


@dataclasses.dataclass(frozen=True, kw_only=True)
class _OwnRule:
    """What terms and limits have in common."""

    name: str
    f: Function
    shape: str = "general"
    highest_order: int = 3
    gradient: Function | None = None
    hessian: Function | None = None


@dataclasses.dataclass(frozen=True, kw_only=True)
class OwnTerm(_OwnRule):
    """A user-defined cost term: made by camopt.term()."""

    weight: float
    reference: float = 1.0


@dataclasses.dataclass(frozen=True, kw_only=True)
class OwnLimit(_OwnRule):
    """A user-defined limit: made by camopt.limit()."""

    limit: float
    unit: str = ""
    size: float = 0.0


@dataclasses.dataclass(frozen=True)
class DerivativeCheck:
    """What check_derivatives() found: whether all agree, the largest relative disagreement, and the worst entry."""

    agree: bool
    error: float
    worst: str
    points: int

    def __bool__(self) -> bool:
        return self.agree


def term(name: str, f: Function, *, weight: float, reference: float = 1.0, shape: str = "general",
         highest_order: int = 3, gradient: Function | None = None, hessian: Function | None = None) -> OwnTerm:
    """A cost term: the objective gains weight · max(0, largest f over the motion) / reference.

        camopt.solve(scene, terms=[camopt.term("power", lambda x, y, v, a, j: v * a, weight=0.2, reference=5.5)])

    f: called as f(x, y, v, a, j) with x = cam angle / rise angle, y = displacement / lift and its derivatives by x. It
    is called with numbers that carry their partials (camopt.Number): arithmetic, comparisons and NumPy's functions of
    one number work, `math` does not. Its partials are then exact. Or give them: gradient(x, y, v, a, j) the four by
    y, v, a, j (a fifth is by x), hessian(…) the 4 x 4 second ones; all three are called with floats, and checked
    against differences at once: ModelError where they disagree.
    shape: of f over all (y, v, a, j): "linear" and "convex" let the optimum be proved, and are ModelErrors where they
    are not true; "general" is always right.
    highest_order: of the derivatives in f: 3 where j stands in it.
    Solving calls f in this and other threads, in turns. What f raises comes through.
    """
    return _checked(OwnTerm(name=name, f=f, weight=weight, reference=reference, shape=shape, highest_order=highest_order,
                            gradient=gradient, hessian=hessian))


def limit(name: str, f: Function, limit: float, *, unit: str = "", size: float = 0.0, shape: str = "general",
          highest_order: int = 3, gradient: Function | None = None, hessian: Function | None = None) -> OwnLimit:
    """A limit: f(x, y, v, a, j) <= limit at every cam angle, also between samples. Reports call it "own.NAME".

    unit: of f, for reports. size: what a violation is measured by; 0: |limit|, or 1 where that is 0. The rest as
    term().
    """
    return _checked(OwnLimit(name=name, f=f, limit=limit, unit=unit, size=size, shape=shape,
                             highest_order=highest_order, gradient=gradient, hessian=hessian))


def check_derivatives(f: Function | OwnTerm | OwnLimit, gradient: Function | None = None,
                      hessian: Function | None = None, *, points: npt.ArrayLike | None = None) -> DerivativeCheck:
    """Compares the partials of a function, a term or a limit with extrapolated differences of its values.

    points: rows of (x, y, v, a, j); None: 24 about the modified sine. A False one names its worst entry.
    """
    rule = f if isinstance(f, _OwnRule) else OwnTerm(name="f", f=f, weight=1.0, gradient=gradient, hessian=hessian)
    rows = _points_of_motions() if points is None else np.atleast_2d(np.asarray(points, dtype=float))
    found = [_disagreement(rule, row) for row in rows]
    wrong, error, worst = max(found, key=lambda one: (one[0], one[1]))
    return DerivativeCheck(not wrong, error, worst, len(rows))


def _checked(rule: Any) -> Any:
    if (rule.gradient is None) != (rule.hessian is None):
        given, absent = ("gradient", "hessian") if rule.hessian is None else ("hessian", "gradient")
        raise ModelError(f"{rule.name}: found a {given} without a {absent}; allowed: both, or neither")
    if rule.gradient is not None:
        check = check_derivatives(rule)
        if not check:
            raise ModelError(f"{rule.name}: found derivatives that disagree with differences of f: {check.worst}")
    return rule


def _points_of_motions() -> npt.NDArray[np.float64]:
    """Points near a good motion, a little off it so that no partial is 0 by chance; the same ones every time."""
    law = _camopt.law("modified_sine")
    x = np.linspace(0.03, 0.97, 24)
    rows = np.column_stack([x, *(law(x, order=order) for order in range(4))])
    return rows + np.random.default_rng(1).uniform(-0.05, 0.05, rows.shape) * _SIZES * [0.0, 1, 1, 1, 1]


def _disagreement(rule: Any, point: npt.NDArray[np.float64]) -> tuple[bool, float, str]:
    """Whether an entry is wrong, how far the worst one is off, and its words."""
    value, gradient, hessian = _camopt.evaluate_rule(rule, point)
    differences = [_difference(rule, point, index) for index in range(5)]
    entries = [(f"d/d{_NAMES[k]}", gradient[k], differences[k][0][0], differences[k][1][0]) for k in range(1, 5)]
    entries += [(f"d²/d{_NAMES[k]}d{_NAMES[m]}", hessian[k - 1, m - 1], differences[k][0][m], differences[k][1][m])
                for k in range(1, 5) for m in range(1, 5)]
    worst = (False, 0.0, "")
    place = ", ".join(f"{name} = {number:.6g}" for name, number in zip(_NAMES, point))
    for name, given, expected, doubt in entries:
        off = abs(given - expected)
        size = max(1.0, abs(given), abs(expected))
        wrong = not (off <= _ERRORS * doubt + _PART * size)
        error = off / size if np.isfinite(off) else np.inf
        words = f"{name} is {given:.9g}, by differences {expected:.9g}, at {place}"
        worst = max(worst, (bool(wrong), float(error), words), key=lambda one: one[:2])
    return worst


def _difference(rule: Any, point: npt.NDArray[np.float64], index: int) -> tuple[Any, Any]:
    """Of (f, gradient) by one variable: the extrapolated central difference, and how far two of them are apart."""
    def central(step: float) -> npt.NDArray[np.float64]:
        aside = np.zeros(5)
        aside[index] = step
        sides = [_camopt.evaluate_rule(rule, point + sign * aside) for sign in (1, -1)]
        ahead, behind = (np.concatenate([[value], gradient]) for value, gradient, _ in sides)
        return (ahead - behind) / (2 * step)

    coarse, middle, fine = (central(_STEP * _SIZES[index] / 2**k) for k in range(3))
    first, second = (4 * middle - coarse) / 3, (4 * fine - middle) / 3
    best = (16 * second - first) / 15
    # gradient[0] is by x: what stands at m is d²/(d index d m).
    return np.concatenate([best[:1], best[2:]]), np.abs(np.concatenate([(best - first)[:1], (best - first)[2:]]))
