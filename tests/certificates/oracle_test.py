# SPDX-License-Identifier: MIT
"""Final linear programs solved exactly by QSopt_ex: oracle_test.py SOLVED [NAME ...] (SOLVED: solve_examples.py).

The checker writes the linear program of a confirmed bound, with rational coefficients, for every example scene that has one.
esolver (Debian package qsopt-ex), which shares no code with camopt or the checker, finds its exact optimum. That must lie between
the stated bound and the objective of the delivered motion, or the program must be infeasible where camopt says so. Exit status
77 without esolver.
"""
import json
import re
import shutil
import subprocess
import sys
import tempfile
from fractions import Fraction
from pathlib import Path

import checker
import vipr_reader
from scenes_test import constant_of, left_out

SKIPPED, LEAST = 77, 30   # scenes
SAME = Fraction(1, 10**8)  # limits hold to within a tolerance: so does the objective of a program without it


class TooLong(Exception):
    """esolver cuts off what it writes of a number of more than 4096 digits."""


def terms(weights, names):
    """A linear form; a line of the format is short."""
    return "\n  ".join(f"{'-' if w < 0 else '+'} {abs(w)} {names[j]}" for j, w in weights.items() if w) or f"0 {names[0]}"


def text_of(names, objective, constraints):
    """The program in the LP format of esolver, whose numbers may be fractions."""
    lines = ["Problem", " final", "Minimize", f" objective: {terms(objective, names)}", "Subject To"]
    for i, (sense, right, weights) in enumerate(constraints):
        if any(weights.values()):
            lines.append(f" R{i}: {terms(weights, names)} {'= <= >='.split()['ELG'.index(sense)]} {right}")
    return "\n".join(lines + ["Bounds"] + [f" {name} free" for name in names] + ["End"]) + "\n"


def optimum_of(esolver, text, place):
    """The exact optimum; None: infeasible."""
    (place / "program.lp").write_text(text)
    run = subprocess.run([esolver, "-O", str(place / "program.sol"), str(place / "program.lp")], capture_output=True, text=True, timeout=600)
    found = (place / "program.sol").read_text() if (place / "program.sol").exists() else ""
    (place / "program.sol").unlink(missing_ok=True)
    if re.search(r"^status = INFEASIBLE", found, re.M):
        return None
    value = re.search(r"^\s*Value = ([-\d/]+)$", found, re.M)
    if not value and re.search(r"^\s*Value = \S+VARS:$", found, re.M):
        raise TooLong
    if not value:
        raise AssertionError(f"esolver ended with {run.returncode}: {found[:200]}{run.stderr[-200:]}")
    return Fraction(value[1])


def judged(esolver, proof, certificate, place):
    """(what was found, what is wrong with it or "")."""
    optimum = optimum_of(esolver, text_of(*vipr_reader.program(vipr_reader.Words(proof.read_text()))), place)
    if certificate["verdict"] == "infeasible" or optimum is None:
        same = certificate["verdict"] == "infeasible" and optimum is None
        return "infeasible" if optimum is None else f"optimum {float(optimum)}", "" if same else "the verdicts differ"
    optimum += constant_of(certificate) + left_out(proof)
    below, above = (optimum - Fraction(certificate["lower_bound"]), Fraction(certificate["objective"]) - optimum)
    room = SAME * max(1, abs(optimum))
    fault = "" if below >= -room and above >= -room else "the optimum is not between bound and objective"
    return f"optimum {float(optimum):.15g}, bound {float(-below):+.1e}, objective {float(above):+.1e}", fault


def main():
    esolver = shutil.which("esolver")
    if esolver is None:
        print("esolver is missing (package qsopt-ex)")
        return SKIPPED
    solved, chosen = Path(sys.argv[1]), sys.argv[2:]
    module, faults, exact = checker.load(), [], 0
    with tempfile.TemporaryDirectory() as place:
        place = Path(place)
        for folder in sorted(f for f in solved.iterdir() if (f / "certificate.json").exists() and (not chosen or f.name in chosen)):
            proof = place / (folder.name + ".vipr")
            checker.outcome(module, folder, proof)
            if not proof.exists():  # over boxes, or no bound
                continue
            try:
                found, fault = judged(esolver, proof, json.loads((folder / "certificate.json").read_text()), place)
                exact += not fault
            except TooLong:
                found, fault = "an optimum of more digits than esolver writes", ""
            print(f"{folder.name}: {found}", flush=True)
            faults += [f"{folder.name}: {fault}"] if fault else []
    print(f"{exact} final linear programs solved exactly")
    if not chosen and exact < LEAST:
        faults.append(f"fewer than {LEAST} scenes")
    return checker.end(faults)


if __name__ == "__main__":
    sys.exit(main())
