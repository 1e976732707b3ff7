# SPDX-License-Identifier: MIT
"""rational_test.py SOLVED: the checker says the same with gmpy2's rational numbers as with the standard library's
(SOLVED: solve_examples.py). Exit status 77 without gmpy2."""
import fractions
import os
import random
import subprocess
import sys
from pathlib import Path

try:
    import gmpy2
except ImportError:
    print("rational_test: there is no gmpy2 (python3-gmpy2)")
    sys.exit(77)

import checker

SCENES = ("cam_roller", "drd_rms_jerk", "infeasible_velocity_cap", "valve_intake")


def faults_of_numbers():
    """Of texts and doubles, sums and quotients."""
    draw = random.Random(1)
    for _ in range(2000):
        double = draw.uniform(-1, 1) * 10.0 ** draw.randint(-300, 300)
        for value in (double, repr(double), draw.getrandbits(200)):
            if gmpy2.mpq(value) != fractions.Fraction(value):
                yield f"gmpy2 reads {value!r} otherwise"
        a, b = (fractions.Fraction(draw.getrandbits(90) - 2**89, draw.getrandbits(80) | 1) for _ in range(2))
        if gmpy2.mpq(a) * gmpy2.mpq(b) - gmpy2.mpq(a) / gmpy2.mpq(b) // 1 != a * b - a / b // 1:
            yield f"gmpy2 computes otherwise with {a} and {b}"


def outcome(folder, standard):
    surroundings = dict(os.environ) | ({"CAMOPT_STANDARD_RATIONALS": "1"} if standard else {})
    done = subprocess.run([sys.executable, "-B", checker.ROOT / "scripts/verify-certificate", "--quiet", folder],
                          capture_output=True, text=True, check=False, env=surroundings)
    return done.returncode, done.stdout + done.stderr


def main():
    sys.path.insert(0, str(checker.ROOT / "scripts"))
    from certificate_checker.rational import Fraction, parsed
    faults = list(faults_of_numbers())
    if Fraction is not gmpy2.mpq:
        faults.append("the checker does not use gmpy2")
    if parsed("+.5") != fractions.Fraction(1, 2):
        faults.append("+.5 is not read as 1/2")
    for name in SCENES:
        quick, slow = (outcome(Path(sys.argv[1]) / name, standard) for standard in (False, True))
        if quick[0] != 0 or quick != slow:
            faults.append(f"{name}: {quick} with gmpy2, {slow} with the standard library")
    print("\n".join(faults + [f"rational_test: {len(SCENES)} scenes, {len(faults)} faults"]))
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
