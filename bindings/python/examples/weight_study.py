# SPDX-License-Identifier: MIT
"""What does a smoother motion cost in velocity and acceleration? The table of
camopt sweep scenes/drd_cubic_12.toml --vary objective.jerk=0:1:21 --out DIR, and where the knee is."""
import sys

import numpy as np

import camopt

scene = camopt.Scene.from_file(sys.argv[1] if len(sys.argv) > 1 else "scenes/drd_cubic_12.toml")
table = camopt.sweep(scene, {"objective.jerk": "0:1:21"})
columns = table.to_dict()
peaks = np.column_stack([columns[name] for name in ("velocity", "acceleration", "jerk")])
for weight, objective, (v, a, j) in zip(columns["objective.jerk"], columns["objective"], peaks):
    print(f"jerk weight {weight:4.2f}   objective {objective:.9f}   V {v:.4f}   A {a:.4f}   J {j:.3f}")
scaled = (peaks - peaks.min(axis=0)) / np.maximum(np.ptp(peaks, axis=0), 1e-12)
knee = int(np.argmin(np.linalg.norm(scaled, axis=1)))
print(f"nearest to the least of all three: jerk weight {columns['objective.jerk'][knee]:.2f}")
if len(sys.argv) > 2:
    open(sys.argv[2], "w").write(table.csv())
