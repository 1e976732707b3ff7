#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""linear_programs.py FINAL_LP FOLDER: the final linear program of exchanged DRD scenes, for every solver there is.

FINAL_LP is the built program final_lp: it writes the programs, times the structured solver, Ipopt and Clp, and judges
every point (the true objective of its curve; its error is against the exchange at tolerance 1e-10). Here SciPy's HiGHS
and SLSQP and Octave's glpk and sqp get the same rows. the call on numbers already loaded; medians of five, slow calls once. Writes FOLDER/final_lp.csv and FOLDER/rivals.txt
(versions; what was absent). A rival that fails or runs out of time keeps its row.
"""

import csv
import io
import pathlib
import shutil
import statistics
import subprocess
import sys
import tempfile
import time

try:
    import numpy as np
    import scipy
    from scipy.optimize import linprog, minimize
    from scipy.sparse import coo_matrix, csc_matrix, vstack
except ImportError:
    scipy = None

DEGREES_AND_SEGMENTS = [(3, 12), (3, 64), (3, 256), (3, 1024), (5, 24), (5, 64)]
DESIGNS = ("states", "coefficients")
OWN_COLUMNS = ("program", "method", "design", "degree", "n", "status", "objective", "seconds_median", "seconds_min",
               "repeats", "iterations", "variables", "rows", "entries")
COLUMNS = ("program", "method", "design", "degree", "n", "status", "objective", "relative_error", "seconds_median", "seconds_min",
           "repeats", "iterations", "variables", "rows", "entries")
REPEATS, SLOW = 5, 2.0
# Dense methods: beyond this many segments one solve takes minutes.
MOST_SEGMENTS = {"slsqp": 64, "sqp": 24, "glpk-interior": 64}
OCTAVE_SECONDS = 10.0
# Options worth trying: presolve pays or does not, and the default tolerance is 1e-7.
HIGHS = [(method, presolve, tolerance) for method in ("highs-ds", "highs-ipm") for presolve in (True, False)
         for tolerance in (1e-7, 1e-9)]
GLPK = ("glpk-simplex", "glpk-dual", "glpk-dual-plain", "glpk-interior", "sqp")


class Program:
    """The numbers of linear_program_text.hpp, as SciPy wants them."""

    def __init__(self, path):
        numbers = np.fromfile(path, sep=" ")
        n, m, k = (int(number) for number in numbers[:3])
        self.variables, self.rows, self.entries = n, m, k
        columns = numbers[4:4 + 3 * n].reshape(n, 3)
        rows = numbers[4 + 3 * n:4 + 3 * (n + m)].reshape(m, 3)
        entries = numbers[4 + 3 * (n + m):].reshape(k, 3)
        matrix = coo_matrix((entries[:, 2], (entries[:, 0].astype(int), entries[:, 1].astype(int))), (m, n)).tocsr()
        equal = rows[:, 0] == rows[:, 1]
        upper = ~equal & np.isfinite(rows[:, 1])
        lower = ~equal & np.isfinite(rows[:, 0])
        self.cost, self.bounds = columns[:, 0], columns[:, 1:]
        self.inside = csc_matrix(vstack([matrix[upper], -matrix[lower]]))
        self.sides = np.concatenate([rows[upper, 1], -rows[lower, 0]])
        self.equalities = csc_matrix(matrix[equal]) if equal.any() else None
        self.equal_sides = rows[equal, 0] if equal.any() else None


def run_highs(program, method, presolve, tolerance):
    options = {"presolve": presolve, "primal_feasibility_tolerance": tolerance, "dual_feasibility_tolerance": tolerance,
               "time_limit": 20.0}
    begin = time.perf_counter()
    result = linprog(program.cost, A_ub=program.inside, b_ub=program.sides, A_eq=program.equalities,
                     b_eq=program.equal_sides, bounds=program.bounds, method=method, options=options)
    seconds = time.perf_counter() - begin
    return seconds, {0: "optimal", 1: "limit", 2: "infeasible", 3: "unbounded"}.get(result.status, "failed"), result


def run_slsqp(program):
    inside = program.inside.toarray()
    constraints = [{"type": "ineq", "fun": lambda x: program.sides - inside @ x, "jac": lambda x: -inside}]
    if program.equalities is not None:
        equal = program.equalities.toarray()
        constraints.append({"type": "eq", "fun": lambda x: equal @ x - program.equal_sides, "jac": lambda x: equal})
    begin = time.perf_counter()
    result = minimize(lambda x: program.cost @ x, np.zeros(program.variables), jac=lambda x: program.cost,
                      bounds=program.bounds, constraints=constraints, method="SLSQP",
                      options={"ftol": 1e-12, "maxiter": 200})
    seconds = time.perf_counter() - begin
    return seconds, "converged" if result.success else "failed", result


def repeated(once, slow=SLOW):
    """Seconds of each repeat, the last status and result; one repeat where it is slow."""
    seconds = []
    while not seconds or (seconds[0] < slow and len(seconds) < REPEATS):
        spent, status, result = once()
        seconds.append(spent)
    return seconds, status, result


class Study:
    def __init__(self, final_lp, folder):
        self.final_lp, self.folder = final_lp, folder
        self.work = pathlib.Path(tempfile.mkdtemp())
        self.rows, self.points = [], {}

    def call(self, action, degree, n):
        return subprocess.run([self.final_lp, action, str(degree), str(n), str(self.work)], check=True,
                              stdout=subprocess.PIPE, text=True).stdout

    def own_rows(self, action, degree, n):
        for cells in csv.reader(io.StringIO(self.call(action, degree, n))):
            self.rows.append(dict(zip(OWN_COLUMNS, cells)))

    def add(self, name, case, program, outcome):
        """outcome: seconds of each repeat, status, iterations, the point or its file."""
        seconds, status, iterations, point = outcome
        row = {"program": name[0], "method": name[1], "design": case[2], "degree": case[0], "n": case[1],
               "status": status, "repeats": len(seconds), "iterations": iterations}
        if program:
            row.update(variables=program.variables, rows=program.rows, entries=program.entries)
        if seconds:
            row.update(seconds_median=statistics.median(seconds), seconds_min=min(seconds))
        self.rows.append(row)
        if point is not None:
            self.points[self.point_file(name, case, point)] = row

    def point_file(self, name, case, point):
        file = f"x_{case[0]}_{case[1]}_{case[2]}_{name[0]}_{name[1]}.txt".replace(" ", "_").replace("/", "_")
        if isinstance(point, pathlib.Path):
            point.rename(self.work / file)
        else:
            np.savetxt(self.work / file, point, fmt="%.17g")
        return file

    def scipy_rows(self, case, path):
        program = Program(path)
        quickest = SLOW / 3
        for method, presolve, tolerance in HIGHS:
            words = f"{method}, {'presolve' if presolve else 'no presolve'}, {tolerance:g}"
            seconds, status, result = repeated(lambda: run_highs(program, method, presolve, tolerance), 3 * quickest)
            quickest = min([quickest] + seconds)
            self.add(("HiGHS", words), case, program, (seconds, status, result.nit, result.x))
        if case[1] > MOST_SEGMENTS["slsqp"]:
            self.add(("SciPy SLSQP", "ftol 1e-12"), case, program, ([], "skipped: too many segments", 0, None))
            return
        seconds, status, result = repeated(lambda: run_slsqp(program))
        self.add(("SciPy SLSQP", "ftol 1e-12"), case, program, (seconds, status, result.nit, result.x))

    def octave_rows(self, case, path):
        script = pathlib.Path(__file__).with_name("octave_linear_program.m")
        for method in GLPK:
            name = ("Octave", method)
            if case[1] > MOST_SEGMENTS.get(method, 1 << 30):
                self.add(name, case, None, ([], "skipped: too many segments", 0, None))
                continue
            point = self.work / "point.txt"
            command = ["octave", "--no-gui", "--no-window-system", "-qf", str(script), str(path), method, str(REPEATS),
                       str(point)]
            try:
                run = subprocess.run(command, cwd=self.work, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True,
                                     timeout=OCTAVE_SECONDS, check=False)
            except subprocess.TimeoutExpired:
                self.add(name, case, None, ([], f"stopped after {OCTAVE_SECONDS:g} s", 0, None))
                continue
            # GLPK's interior point prints; the last line is ours.
            words = run.stdout.strip().splitlines()[-1].split() if run.stdout.strip() else []
            if len(words) < 3:
                self.add(name, case, None, ([], "failed: no answer", 0, None))
                continue
            good = words[0] in (("104", "101") if method == "sqp" else ("5",))
            status = "optimal" if good else f"failed: status {words[0]}"
            self.add(name, case, None, ([float(word) for word in words[2:]], status, int(words[1]),
                                        point if point.exists() else None))

    def judge(self, degree, n):
        for line in self.call("judge", degree, n).splitlines():
            file, objective = line.split()
            if file in self.points:
                self.points[file]["objective"] = objective

    def run_case(self, degree, n):
        reference, first = float(self.call("export", degree, n)), len(self.rows)
        self.own_rows("structured", degree, n)
        for design in DESIGNS:
            case, path = (degree, n, design), self.work / f"lp_{degree}_{n}_{design}.txt"
            if scipy:
                self.scipy_rows(case, path)
            if shutil.which("octave"):
                self.octave_rows(case, path)
        self.own_rows("rivals", degree, n)
        self.judge(degree, n)
        for row in self.rows[first:]:
            if row.get("objective") not in (None, "", "nan"):
                row["relative_error"] = (float(row["objective"]) - reference) / reference
        print(f"linear_programs: degree {degree}, n = {n}", file=sys.stderr)

    def write(self):
        with open(self.folder / "final_lp.csv", "w", newline="") as file:
            writer = csv.DictWriter(file, COLUMNS, lineterminator="\n")
            writer.writeheader()
            writer.writerows(self.rows)


def versions(final_lp):
    """One line a rival: its version, or that it was absent and how to get it."""
    yield f"SciPy: {scipy.__version__} (HiGHS, SLSQP)" if scipy else "SciPy: ABSENT (apt-get install python3-scipy)"
    if shutil.which("octave"):
        out = subprocess.run(["octave", "--version"], stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True, check=False)
        yield f"Octave: {out.stdout.splitlines()[0].split()[-1]} (glpk, sqp)"
    else:
        yield "Octave: ABSENT (apt-get install octave)"
    clp = subprocess.run([final_lp, "versions", "0", "0", "."], stdout=subprocess.PIPE, text=True, check=False).stdout.strip()
    yield f"Clp: {clp}" if clp else "Clp: ABSENT (apt-get install coinor-libclp-dev, then build again)"


def main():
    final_lp, folder = sys.argv[1], pathlib.Path(sys.argv[2])
    study = Study(final_lp, folder)
    try:
        for degree, n in DEGREES_AND_SEGMENTS:
            study.run_case(degree, n)
        study.write()
        (folder / "rivals.txt").write_text("".join(line + "\n" for line in versions(final_lp)))
    finally:
        shutil.rmtree(study.work)


main()
