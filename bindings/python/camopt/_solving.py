# SPDX-License-Identifier: MIT
"""Solving from Python: one scene, a comparison with the classical laws, neighbouring scenes one after another."""

from __future__ import annotations

import os
from collections.abc import Callable, Mapping
from typing import Any

from . import _camopt
from ._camopt import Comparison, InputError, MachineSolution, ModelError, Progress, Solution, UnavailableError
from ._scene import Scene, _settings

Callback = Callable[[Progress], object]

for _error in (InputError, UnavailableError, ModelError):
    _error.__module__ = "camopt"  # what a traceback shows


def solve(scene: Scene | None = None, /, *, progress: Callback | None = None, **keys: Any) -> Solution:
    """The best motion of a scene, and of keywords as Scene() takes them; both: the scene with these keys.

        camopt.solve(lift_mm=10, rise_deg=120, segments=12, weights=dict(v=.4, a=.4, j=.2), limits=dict(velocity=1.7))

    progress: called with a Progress now and then. An infeasible scene is a verdict; its `relaxation` says what
    would help. Raises InputError for a wrong scene, UnavailableError for a backend that this build leaves out.
    """
    return _camopt.solve(_given(scene, keys)._read, progress)


def compare(scene: Scene | None = None, /, *, progress: Callback | None = None, **keys: Any) -> Comparison:
    """Every classical law on a scene (or keywords), compared with its optimum. Raises as solve() does."""
    return _camopt.compare(_given(scene, keys)._read, progress)


def solve_machine(file: str | os.PathLike[str], keys: Mapping[str, Any] | None = None, /, *, speed_gap: float | None = None,
                  max_seconds: float | None = None, progress: Callback | None = None) -> MachineSolution:
    """The largest speed of a machine file (several axes on one master) with its proof, or at a given speed the motions of
    least total objective, as `camopt machine` finds them.

        found = camopt.solve_machine("cartoner.toml", {"axis[1].phase_deg": 10, "pusher.limits.acceleration_m_s2": 20})
        found.speed_rpm, found.impossible_above_rpm, found.axes["pusher"].motion

    keys: of the machine file, or of the scene of an axis behind its name. speed_gap: relative, of the largest speed
    (1e-3); max_seconds: wall time (60). Raises InputError for a wrong file.
    """
    return _camopt.solve_machine(os.fspath(file), _settings(keys or {}), speed_gap, max_seconds, progress)


class Solver:
    """Neighbouring scenes one after another, each solved from what the last one found.

        solver = camopt.Solver(scene)
        for lift in (10, 11, 12):
            solver.update(lift_mm=lift)
            print(solver.solve().fun)

    Verdict and objective are those of a cold solve, to the solver's tolerance; only the way there is shorter. An
    infeasible scene is not explained: for its relaxation use camopt.solve(). One thread at a time.
    """

    def __init__(self, scene: Scene | None = None, /, **keys: Any) -> None:
        self.scene = _given(scene, keys).copy()
        self.solution: Solution | None = None
        self._sequence = _camopt.Sequence()

    def update(self, keys: Mapping[str, Any] | None = None, /, **more: Any) -> None:
        """Changes the scene: Scene.update()."""
        self.scene.update(keys, **more)

    def solve(self, progress: Callback | None = None) -> Solution:
        """Solves the scene as it is now; also kept in `solution`, where it was interrupted too."""
        try:
            self.solution = self._sequence.solve(self.scene._read, progress)
        except BaseException as stop:
            self.solution = getattr(stop, "solution", None)
            raise
        return self.solution


def _given(scene: Scene | None, keys: Mapping[str, Any]) -> Scene:
    if scene is None:
        return Scene(**keys)
    if not isinstance(scene, Scene):
        raise InputError(f"scene: found a {type(scene).__name__}; allowed: a camopt.Scene, as Scene.from_file() gives")
    if not keys:
        return scene
    changed = scene.copy()
    changed.update(**keys)
    return changed
