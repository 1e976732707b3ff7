# SPDX-License-Identifier: MIT
"""The camopt program and the scenes of the tree, for the tests of the Python package."""

import os
import pathlib
import subprocess
import unittest

ROOT = pathlib.Path(os.environ["CAMOPT_SOURCE_DIR"])
PROGRAM = os.environ.get("CAMOPT_PROGRAM", "")

needs_program = unittest.skipUnless(PROGRAM, "*** SKIPPED: no camopt program to compare with (CAMOPT_BUILD_APPS)")


def scene_path(name):
    return str(ROOT / "scenes" / name)


def run(*words):
    """What the program prints; a scene that is infeasible ends it with 3."""
    ended = subprocess.run([PROGRAM, *words], capture_output=True, text=True, check=False)
    if ended.returncode not in (0, 3):
        raise AssertionError(f"camopt {' '.join(words)}: exit {ended.returncode}: {ended.stderr}")
    return ended.stdout


def refusal(*words):
    """What the program says of wrong input."""
    ended = subprocess.run([PROGRAM, *words], capture_output=True, text=True, check=False)
    if ended.returncode != 2:
        raise AssertionError(f"camopt {' '.join(words)}: exit {ended.returncode}, not 2")
    return ended.stderr.strip()
