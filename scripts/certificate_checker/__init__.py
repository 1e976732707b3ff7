# SPDX-License-Identifier: MIT
"""The checker behind scripts/verify-certificate, which says what it does and how.

It reads top down: verdict.py is the order of everything; problem.py, spaces.py and conditions.py are the scene;
motion.py and cam.py the delivered motion and its limits; bound.py the bound by multipliers, any_curve.py that of free
breakpoints, cases.py proofs by cases; stored.py the files' own arithmetic; drive.py a motor in place of a cam; exact.py
what all of it is computed with.
"""
