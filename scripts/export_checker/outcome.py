# SPDX-License-Identifier: MIT
"""What the check of an exported file found."""
from dataclasses import dataclass, field


@dataclass
class Outcome:
    """`bounds`: proved upper bounds by name; `places`: where each is reached; `faults`: what refuses the file, each with
    its place; `unverified`: what the check did not cover."""

    bounds: dict[str, float] = field(default_factory=dict)
    places: dict[str, str] = field(default_factory=dict)
    faults: list[str] = field(default_factory=list)
    unverified: list[str] = field(default_factory=list)
    stated: str = ""  # what the file says about the set-up, on which everything rests
    limits: str = ""  # of the scene, for the exported motion
