# SPDX-License-Identifier: MIT
"""The exact rational numbers that every proof is computed in: gmpy2's (the GNU multiple precision library) where it is installed,
which is two to five times faster, else those of Python's standard library. Theorem. Both are exact, so that they prove the same;
CAMOPT_STANDARD_RATIONALS in the environment selects the latter (tests compare them)."""
import fractions
import os

Fraction = fractions.Fraction
if not os.environ.get("CAMOPT_STANDARD_RATIONALS"):
    try:
        from gmpy2 import mpq as Fraction
    except ImportError:
        pass


def parsed(text):
    """The number that a JSON or TOML file writes, digit for digit. The standard library reads forms that gmpy2 does not: "+.5"."""
    return Fraction(fractions.Fraction(text))
