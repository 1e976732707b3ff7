# SPDX-License-Identifier: MIT
"""camopt finds the best motion curve for a cam, and proves that it is the best.

    import camopt

    found = camopt.solve(lift_mm=10, rise_deg=120, segments=12, weights=dict(v=.4, a=.4, j=.2))
    found.verdict, found.fun, found.bound      # 'optimal', 0.9395…, 0.9395…
    found.motion([0, 0.25, 0.5], order=1)      # y', y = displacement / lift, x = cam angle / rise angle

Scenes have the keys, units and messages of scene files (docs/scene_file.md). Wrong input raises InputError, a
ValueError; a numerical outcome is a verdict, never an exception. While a scene is solved other threads of Python run;
Ctrl-C raises KeyboardInterrupt, and what was found until then is its attribute `solution` (`table`, `comparison`).
"""

from ._camopt import (CompanionChange, Comparison, ComparisonRow, Constraint, InputError, Law, MachineSolution, ModelError, Motion, Number,
                      OwnTermValue, Peak, Peaks, Progress, Relaxation, Solution, Spline, SweepTable, UnavailableError, __version__,
                      law, laws, licenses)
from ._rules import DerivativeCheck, OwnLimit, OwnTerm, check_derivatives, limit, term
from ._scene import Scene
from ._solving import Solver, compare, solve, solve_machine
from ._sweep import simplex_weights, structured, sweep

__all__ = ["CompanionChange", "Comparison", "ComparisonRow", "Constraint", "DerivativeCheck", "InputError", "Law", "MachineSolution",
           "ModelError", "Motion", "Number", "OwnLimit", "OwnTerm", "OwnTermValue", "Peak", "Peaks", "Progress", "Relaxation", "Scene",
           "Solution", "Solver", "Spline", "SweepTable", "UnavailableError", "check_derivatives", "compare", "law",
           "laws", "licenses", "limit", "simplex_weights", "solve", "solve_machine", "structured", "sweep", "term"]
