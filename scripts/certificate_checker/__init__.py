# SPDX-License-Identifier: MIT
"""The checker that scripts/verify-certificate runs. Each module states what it proves under "Theorem", and under which assumptions.

verdict.py is the top: it judges a result folder in the order of the program's docstring. problem.py, spaces.py, runs.py and conditions.py
derive the problem from the scene; motion.py and cam.py judge the delivered motion; bound.py and its parts (box_proof.py, cases.py,
any_curve.py, drive_rows.py, phase_rows.py, measured.py) derive the bound; stored.py repeats the files' own arithmetic; machine.py and
least.py judge several scenes together. All of it is computed by exact.py (fractions, polynomials) and enclosures.py (intervals).
"""
