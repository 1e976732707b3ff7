# SPDX-License-Identifier: MIT
"""Sweeps: many solves of one scene as one table."""

from __future__ import annotations

import os
from collections.abc import Callable, Mapping, Sequence
from typing import Any

import numpy as np
import numpy.typing as npt

from . import _camopt
from ._scene import Scene

Keys = str | tuple[str, ...]


def sweep(scene: Scene, axes: Mapping[Keys, Any], *, workers: int | None = None, chunk: int | None = None,
          progress: Callable[[int, int], object] | None = None) -> _camopt.SweepTable:
    """Solves a scene at every point of a grid; the rows are those of `camopt sweep`, bit for bit.

        table = camopt.sweep(scene, {"objective.jerk": np.linspace(0, 1, 200)})
        pandas.DataFrame(table.to_dict())

    axes: from keys of a scene to their values in the unit of the key: an array, or the command line's "0:1:200" or
    "1:100:20:log". A tuple of keys varies them together, an array with a column each (simplex_weights makes such). Rows
    are the grid of all axes in an order of neighbours, the first axis slowest.
    workers: threads; None: one a core. The rows do not depend on it.
    chunk: rows that are solved one from the other before a cold start; None: as the command line.
    progress: called in this thread with (rows done, all rows).

    Every row is checked before the first is solved: InputError. A row whose solve fails has the verdict "failed" and
    its reason. Ctrl-C raises KeyboardInterrupt, and what a callback raises comes through; the rows finished until then
    are the exception's attribute `table`.
    """
    given = [_axis(keys, values) for keys, values in axes.items()]
    return _camopt.sweep(scene._read, given, chunk=chunk, workers=workers or os.cpu_count() or 1, progress=progress)


def simplex_weights(divisions: int) -> dict[Keys, npt.NDArray[np.float64]]:
    """An axis for sweep(): all weights i/N, j/N, k/N of velocity, acceleration and jerk with i + j + k = N."""
    keys, values = _camopt.simplex(divisions)
    return {tuple(keys): values}


def structured(columns: Mapping[str, npt.ArrayLike]) -> npt.NDArray[Any]:
    """Columns {name: array}, as tables and profiles give them, as one structured array: a record a row."""
    arrays = {name: np.asarray(column) for name, column in columns.items()}
    length = len(next(iter(arrays.values()))) if arrays else 0
    result = np.empty(length, dtype=[(name, column.dtype) for name, column in arrays.items()])
    for name, column in arrays.items():
        result[name] = column
    return result


def _axis(keys: Keys, values: Any) -> tuple[Sequence[str], Any]:
    names = [keys] if isinstance(keys, str) else list(keys)
    if isinstance(values, str):
        return _camopt.varied_key(f"{','.join(names)}={values}")
    return names, np.asarray(values, dtype=float)
