#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""results_page.py FOLDER PAGE: writes RESULTS.md and its pictures from the tables of one run in FOLDER.

Every number on the page is computed here from the CSV files; a table that is absent is named as absent, never filled.
Python's standard library only.
"""

import csv
import math
import pathlib
import statistics
import sys

import study_pictures as pictures
from study_pictures import number

ACCURATE = 1e-8


def read(folder, name):
    path = folder / name
    if not path.exists():
        return []
    with open(path, newline="") as file:
        return list(csv.DictReader(file))


def seconds(value):
    if value is None:
        return "–"
    for factor, unit in ((1, "s"), (1e3, "ms"), (1e6, "µs")):
        if value * factor >= 1:
            return f"{value * factor:.3g} {unit}"
    return f"{value * 1e6:.2g} µs"


def short(value):
    return "–" if value is None else f"{value:.2g}"


def table(head, rows, left=1):
    lines = ["| " + " | ".join(head) + " |",
             "|" + "|".join([" :--- "] * left + [" ---: "] * (len(head) - left)) + "|"]
    return lines + ["| " + " | ".join(str(cell) for cell in row) + " |" for row in rows] + [""]


def verdict(holds):
    return "yes" if holds else "**no**"


class Page:
    def __init__(self, folder, page):
        self.folder, self.page, self.lines, self.machine = folder, page, [], ""
        self.absent = []
        machine = folder / "machine.txt"
        if machine.exists():
            facts = dict(line.split(": ", 1) for line in machine.read_text().splitlines() if ": " in line)
            self.machine = f"{facts.get('processor', '?')}, {facts.get('cores', '?')} cores, {facts.get('date', '?')}"
        commit = folder / "commit.txt"  # written by scripts/benchmark
        self.commit = commit.read_text().strip() if commit.exists() else "commit not recorded"

    def say(self, *lines):
        self.lines.extend(lines)

    def rows(self, name):
        rows = read(self.folder, name)
        if not rows:
            self.absent.append(name)
        return rows

    def picture(self, name, svg, words):
        (self.folder / name).write_text(svg)
        place = self.folder.relative_to(self.page.parent) if self.folder.is_relative_to(self.page.parent) else self.folder
        self.say(f"![{words}]({place}/{name})", "")


# ---- acceptance -----------------------------------------------------------------------------------------------------

def best_of_ipopt(rows, n, kind):
    """The structured solver's row and Ipopt's quickest that is accurate; None where one is missing."""
    own = [row for row in rows if row["n"] == str(n) and row["kind"] == kind and row["eligible"] == "yes"]
    structured = [row for row in own if row["solver"] == "structured"]
    ipopt = [row for row in own if row["solver"] == "ipopt"]
    if not structured or not ipopt:
        return None
    return structured[0], min(ipopt, key=lambda row: number(row, "seconds_median"))


def best_of_program(rows, program, degree, n):
    good = [row for row in rows if row["program"] == program and row["degree"] == str(degree) and row["n"] == str(n) and
            number(row, "relative_error") is not None and abs(number(row, "relative_error")) <= ACCURATE]
    return min(good, key=lambda row: number(row, "seconds_median")) if good else None


def exponent(points):
    """The slope of a straight line through the logarithms."""
    if len(points) < 2:
        return None
    logs = [(math.log(n), math.log(value)) for n, value in points]
    centre = [statistics.fmean(column) for column in zip(*logs)]
    return (sum((a - centre[0]) * (b - centre[1]) for a, b in logs) / sum((a - centre[0]) ** 2 for a, _ in logs))


def growth_points(rows, kind, least=256):
    return [(int(row["n"]), number(row, "seconds_median")) for row in rows
            if row["kind"] == kind and int(row["n"]) >= least and number(row, "seconds_median")]


def acceptance(page):
    against, lp = read(page.folder, "structured_against_ipopt.csv"), read(page.folder, "final_lp.csv")
    growth, sweep = read(page.folder, "growth_of_time.csv"), read(page.folder, "sweep_seconds.csv")
    workers = read(page.folder, "sweep_workers.csv")
    lines = []
    for n in (12, 64, 256, 1024):
        for kind, words in (("call", "one call on the final grid"), ("exchange", "the exchange"), ("solve", "whole solve")):
            pair = best_of_ipopt(against, n, kind)
            if pair:
                own, rival = pair
                ratio = number(rival, "seconds_median") / number(own, "seconds_median")
                # Asked for is the solver against the solver; the whole solve has parts that both share.
                holds = verdict(ratio >= 40) if kind != "solve" else ""
                errors = f"{short(number(own, 'relative_error'))}, {short(number(rival, 'relative_error'))}"
                lines.append([f"structured against Ipopt, n = {n}: {words}", "≥ 40" if kind != "solve" else "(no target)",
                              seconds(number(own, "seconds_median")), seconds(number(rival, "seconds_median")),
                              f"{ratio:.1f}", holds, errors])
    for row in read(page.folder, "whole_solve.csv"):
        ratio, target = number(row, "ratio"), number(row, "target")
        lines.append([f"whole solve, tie-break included, against one call on its final grid: {row['case']}, n = {row['n']}",
                      f"≤ {target:g}", seconds(number(row, "seconds_solve_median")),
                      seconds(number(row, "seconds_call_median")), f"{ratio:.1f}", verdict(ratio <= target),
                      short(number(row, "relative_error"))])
    starts = read(page.folder, "search_from_starts.csv")
    for own, rival in zip(starts[::2], starts[1::2]):
        ratio, excess = number(rival, "ratio"), number(rival, "excess")
        holds = ratio >= number(rival, "target_ratio") and excess <= number(rival, "target_excess")
        lines.append([f"searches from 8 starts, not convex, against {rival['solver']}: {rival['scene']}, n = {rival['segments']}",
                      f"≥ {number(rival, 'target_ratio'):g}", seconds(number(own, "seconds_median")),
                      seconds(number(rival, "seconds_median")), f"{ratio:.1f}", verdict(holds), short(excess)])
    for n in (64, 256, 1024):
        own, rival = best_of_program(lp, "structured", 3, n), best_of_program(lp, "HiGHS", 3, n)
        if own and rival:
            ratio = number(rival, "seconds_median") / number(own, "seconds_median")
            lines.append([f"structured against HiGHS, n = {n}: the final LP", "≥ 10", seconds(number(own, "seconds_median")),
                          seconds(number(rival, "seconds_median")), f"{ratio:.1f}", verdict(ratio >= 10),
                          f"{short(number(own, 'relative_error'))}, {short(number(rival, 'relative_error'))}"])
    for kind in ("call", "exchange", "solve"):
        points = growth_points(growth, kind)
        slope = exponent(points)
        if slope is not None:
            lines.append([f"growth from n = {points[0][0]} to {points[-1][0]}: {kind}", "exponent ≤ 1.2", seconds(points[0][1]),
                          seconds(points[-1][1]), f"{slope:.2f}", verdict(slope <= 1.2), ""])
    if len(sweep) >= 2:
        first = sweep[0]
        for other in sweep[1:]:
            ratio = number(other, "seconds_median") / number(first, "seconds_median")
            target = "≥ 20" if other["solver"] == "ipopt" else "(no target)"
            lines.append([f"sweep of {first['rows']} weights, n = 32, against cold solves with {other['solver']} "
                          f"({other['passes']} passes)", target, seconds(number(first, "seconds_median")),
                          seconds(number(other, "seconds_median")), f"{ratio:.1f}",
                          verdict(ratio >= 20) if other["solver"] == "ipopt" else "",
                          short(number(other, "worst_difference_from_cold"))])
    # The last line is a single run of many more weights.
    times = {row["workers"]: number(row, "seconds_median") for row in workers if row["same_rows"]}
    if "1" in times and "2" in times:
        ratio = times["1"] / times["2"]
        lines.append([f"sweep of {workers[0]['rows']} weights: two workers against one", "≥ 1.7", seconds(times["2"]),
                      seconds(times["1"]), f"{ratio:.2f}", verdict(ratio >= 1.7), ""])
    page.say("## The ratios asked for", "",
             "Medians of at least five runs, both sides measured in turns in this run; a rival counts with its quickest "
             f"options that come within {ACCURATE:g} of the optimum (relative, the true objective of the curve found).", "")
    page.say(*table(["comparison", "target", "camopt", "rival", "ratio", "met", "relative errors"], lines))
    met = [line[5] for line in lines if line[5]]
    page.say(f"{met.count('yes')} of {len(met)} targets are met in this run.", "")


# ---- sections -------------------------------------------------------------------------------------------------------

def section_error(page):
    rows = page.rows("error_against_time.csv")
    if not rows:
        return
    for row in rows:
        if row["status"] == "unsupported":  # the start, handed back: neither a result nor a time
            row["verdict"] = row["relative_error"] = row["seconds_median"] = ""
    page.say("## Error against run time", "")
    page.picture("error_against_time.svg", pictures.error_against_time(rows, page.machine), "Error against run time")
    lines = []
    for backend in dict.fromkeys(row["backend"] for row in rows):
        own = [row for row in rows if row["backend"] == backend]
        ran = [row for row in own if row["verdict"]]
        wrong = [row for row in ran if row["status"] == "converged" and (number(row, "relative_error") or 0) > 1e-6]
        proved = [row for row in ran if row["verdict"] == "optimal"]
        worst = max((abs(number(row, "relative_error")) for row in proved if number(row, "relative_error") is not None),
                    default=None)
        largest = max((int(row["n"]) for row in proved), default=0)
        lines.append([backend, len(own), len(ran), len(proved), short(worst), largest, len(wrong),
                      sum(row["status"] == "time_limit" for row in ran),
                      sum(row["status"].startswith("killed") for row in own),
                      sum(row["status"] == "unsupported" for row in own),
                      sum(not row["verdict"] and row["status"] != "unsupported" for row in own)])
    page.say(*table(["backend", "rows", "ran", "proved", "worst error of the proved", "largest n proved",
                     "says converged, 1e-6 off", "out of time", "hung, killed", "unsupported", "without a result"],
                    lines))
    wrong = [row for row in rows if row["status"] == "converged" and (number(row, "relative_error") or 0) > 1e-6]
    false = [row for row in wrong if row["verdict"] == "optimal" and number(row, "relative_error") > 1e-5]
    page.say("Seconds are those of the exchange on a problem made beforehand. `unsupported`: the method takes no equality "
             "rows, and nearly all but DRD `coefficients` have some. A series ends where a solve runs out of its "
             "time (structured 6 s, Ipopt 2 s, NLopt 0.6 s); references are exact fractions or the structured solver's "
             "at tolerance 1e-10, proved to 1e-8 or better. Every solve runs in a process of its own: one that does not come "
             "back is killed and its row says so. "
             f"{len(wrong)} rows say \"converged\" more than 1e-6 above the optimum; {len(false)} of them carry the "
             "verdict optimal against a reference 1e-5 lower.", "")
    page.picture("time_against_segments.svg", pictures.time_against_segments(rows, page.machine), "Time against segments")
    page.say("What a backend costs as segments multiply, over `states`. A line ends where the time does.", "")


def section_cam(page):
    rows = page.rows("cam_error_against_time.csv")
    if not rows:
        return
    page.say("## Scenes with a cam", "", "![Error against time for scenes with a cam](results/cam_error_against_time.svg)", "")
    lines = []
    for name in dict.fromkeys((row["backend"], row["hessian"]) for row in rows):
        own = [row for row in rows if (row["backend"], row["hessian"]) == name]
        count = lambda word: sum(row["verdict"] == word for row in own)
        spent = [number(row, "seconds_median") for row in own if number(row, "seconds_median")]
        missed = sum((number(row, "relative_error") or 0) > 1e-6 for row in own)
        lines.append([", ".join(name), len(own), count("optimal"), count("local"), count("feasible"), count("infeasible"),
                      count("failed"), count(""), missed, f"{seconds(min(spent))} … {seconds(max(spent))}" if spent else "–"])
    page.say(*table(["backend", "rows", "optimal", "local", "feasible", "infeasible", "failed", "not run",
                     "above the optimum by 1e-6", "seconds"], lines))
    page.say("Timed is the whole solve, starts and proof included, at most 8 s. An infeasible scene counts as solved where "
             "that is proved.", "")


def section_checks(page):
    rows = page.rows("forward_check.csv")
    if rows:
        page.say("## The exported profile", "")
        page.picture("forward_check.svg", pictures.forward_check(rows, page.machine), "Forward check")
        law = rows[0]["law"]
        for other in dict.fromkeys(row["law"] for row in rows):
            by_points = {}
            for row in rows:
                if row["law"] == other and number(row, "relative") is not None:
                    by_points.setdefault(round(int(row["points"]), -1), []).append(number(row, "relative"))
            worst = ", ".join(f"{points}: {max(values):.1g}" for points, values in sorted(by_points.items())[:5])
            page.say(f"{other}: largest relative deviation of any follower by points: {worst}.", "")
        page.say(f"A follower runs over the exported points of every kind of cam; the check of one costs "
                 f"{seconds(statistics.median(number(row, 'seconds') for row in rows if row['law'] == law))} (median).", "")
    rows = page.rows("mechanism_check.csv")
    if rows:
        page.say("## The finished cams of the mechanisms", "")
        page.picture("mechanism_check.svg", pictures.mechanism_check(rows, page.machine), "Mechanism check")
        lines = []
        for scene in dict.fromkeys(row["scene"] for row in rows):
            own = {int(row["asked"]): row for row in rows if row["scene"] == scene}
            lines.append([scene, own[2000]["type"]] + [short(number(own[asked], "relative")) for asked in (125, 500, 2000, 8000)]
                         + [seconds(number(own[2000], "seconds_points")), seconds(number(own[2000], "seconds"))])
        page.say(*table(["scene", "type", "relative deviation, 125 points", "500", "2000", "8000", "making 2000 points",
                         "their check"], lines, left=2))
        page.say("Points a turn (remote), a section of either flank (barrel, cylindrical), a wall (inverse). The deviation is "
                 "the output's, by its lift; of remote followers the roller's, by the prime radius.", "")
    rows = page.rows("peaks_by_sampling.csv")
    if rows:
        page.say("## Peaks: sampled against exact", "")
        page.picture("peaks_by_sampling.svg", pictures.peaks_by_sampling(rows, page.machine), "Peaks by sampling")
        at = [row for row in rows if row["samples"] == "180"]
        worst = max(((-number(row, key), row["curve"], words) for row in at for key, words in
                     (("error_velocity", "velocity"), ("error_acceleration", "acceleration"), ("error_jerk", "jerk"))),
                    default=None)
        exact = [number(row, "seconds_median") for row in rows if row["samples"] == "0"]
        if worst:
            page.say(f"At 180 samples the worst loss is {100 * worst[0]:.2g} % of the {worst[2]} ({worst[1]}). Exact extrema "
                     f"take {seconds(min(exact))} to {seconds(max(exact))}.", "")


def section_rivals(page):
    rows = page.rows("final_lp.csv")
    if not rows:
        return
    page.say("## One linear program, every solver", "",
             "The program on which the exchange of a DRD scene ended (tolerance 1e-10): the same rows at the same cam angles "
             "for all, over `states` (sparse, with equalities) and over B-spline coefficients. Timed is the call on numbers "
             "already loaded. Every point found is put back on its curve; the error is that of the curve's true "
             "objective.", "")
    rivals = page.folder / "rivals.txt"
    if rivals.exists():
        page.say(*(f"* {'**' + line + '**' if 'ABSENT' in line else line}" for line in rivals.read_text().splitlines()), "")
    programs = list(dict.fromkeys(row["program"] for row in rows))
    cases = list(dict.fromkeys((row["degree"], int(row["n"])) for row in rows))
    best = {}
    for program in programs:
        for degree, n in cases:
            row = best_of_program(rows, program, degree, n)
            if row:
                best.setdefault((program, degree), []).append((n, number(row, "seconds_median")))
    page.picture("final_lp.svg", pictures.final_lp(best, page.machine), "Final linear program")
    lines = []
    for degree, n in cases:
        own = best_of_program(rows, "structured", degree, n)
        for program in programs:
            tried = [row for row in rows if row["program"] == program and row["degree"] == degree and row["n"] == str(n)]
            ran = [row for row in tried if row["status"] != "skipped: too many segments"]
            if not ran:
                continue
            row = best_of_program(rows, program, degree, n)
            good = sum(number(one, "relative_error") is not None and abs(number(one, "relative_error")) <= ACCURATE
                       for one in ran)
            told = sum(one["status"] in ("optimal", "converged") and not (
                number(one, "relative_error") is not None and abs(number(one, "relative_error")) <= 1e-6) for one in ran)
            cells = [degree, n, program, f"{good} of {len(ran)}", told]
            if row:
                ratio = number(row, "seconds_median") / number(own, "seconds_median") if own else None
                cells += [f"{row['method']}, {row['design']}", seconds(number(row, "seconds_median")),
                          short(number(row, "relative_error")), "–" if ratio is None else f"{ratio:.1f}"]
            else:
                cells += ["none", "–", "–", "–"]
            lines.append(cells)
    page.say(*table(["degree", "n", "program", "ways within 1e-8", "says optimal, 1e-6 off", "the quickest of them", "seconds",
                     "relative error", "times structured"], lines, 3))
    page.say("Ways tried: HiGHS by `linprog` (highs-ds, highs-ipm; presolve on and off; tolerances 1e-7 and 1e-9); SLSQP with "
             "ftol 1e-12 up to 64 segments; Octave `glpk` (primal, dual, dual without presolve, interior point up to 64 segments; "
             "tolerances 1e-9) and `sqp` (up to 24 segments, tolerance 1e-10), stopped after 10 s; Clp (dual, primal, with "
             "and without presolve, barrier up to 12 segments; tolerances 1e-9); Ipopt (predictor-corrector, adaptive, "
             "monotone; peaks as dense columns and as chained copies; tolerance 1e-9); the structured solver (tolerances 1e-7, 1e-8, 1e-9). Both forms of the design vector for all but Ipopt and the structured solver "
             "(`states`). Slow ways are timed once. Every attempt is a row of `final_lp.csv`.", "")


def section_ipopt(page):
    rows = page.rows("structured_against_ipopt.csv")
    if not rows:
        return
    page.say("## Structured against Ipopt", "")
    lines = []
    for n in dict.fromkeys(row["n"] for row in rows):
        for kind in ("call", "exchange", "solve"):
            for row in rows:
                if row["n"] == n and row["kind"] == kind:
                    lines.append([n, kind, f"{row['solver']}, {row['variant']}", f"{number(row, 'tolerance'):g}",
                                  seconds(number(row, "seconds_median")), seconds(number(row, "seconds_min")),
                                  row["iterations"], row["rounds"], short(number(row, "relative_error")),
                                  f"{number(row, 'ratio') or 0:.1f}"])
    page.say(*table(["n", "timed", "solver", "tolerance", "median", "least", "iterations", "rounds", "relative error",
                     "ratio"], lines, 3))
    scouts = [row for row in rows if row["kind"] == "scout"]
    missed = sum(row["eligible"] != "yes" for row in scouts)
    page.say(f"Ipopt was tried in {len(scouts)} ways (barrier rule × dense or chained peak columns × tolerance 1e-9, 1e-10), "
             f"{missed} of which missed the optimum by more than {ACCURATE:g}; the two quickest accurate ones ran against the "
             "structured solver in turns.", "")


def section_phases(page):
    rows = page.rows("whole_solve.csv")
    if not rows or "seconds_setup" not in rows[0]:
        return
    phases = ("setup", "solver", "judgement", "proof", "tie_break", "report")
    page.say("## Phases of a whole solve", "")
    page.say(*table(["case", "n", "whole", "one call"] + [phase.replace("_", "-") for phase in phases],
                    [[row["case"], row["n"], seconds(number(row, "seconds_solve_min")), seconds(number(row, "seconds_call_min"))]
                     + [seconds(number(row, f"seconds_{phase}")) for phase in phases] for row in rows]))
    page.say("Of the quickest run. Setup: scene to model, spline space and first grid; solver: inside the backend, all rounds; "
             "judgement: first point, continuous maxima, new rows; proof: the bound from multipliers; tie-break with its calls "
             "of the backend; report: properties of the delivered motion and its audit. Every `result.json` has them under "
             "`seconds`.", "")


def section_examples(page):
    rows = page.rows("example_seconds.csv")
    if not rows:
        return
    solved = [row for row in rows if row["command"] == "solve"]
    page.say("## The example scenes", "",
             f"All {len(solved)} example scenes: {seconds(sum(number(row, 'seconds_wall') for row in solved))} together, "
             f"{sum(number(row, 'seconds_wall') <= 0.1 for row in solved)} of them within 0.1 s and "
             f"{sum(number(row, 'seconds_wall') <= 1 for row in solved)} within 1 s. Wall seconds of the whole command, the quickest "
             "of three; those above 0.1 s:", "")
    slow = sorted((row for row in rows if number(row, "seconds_wall") > 0.1), key=lambda row: -number(row, "seconds_wall"))
    phases = ("setup", "solver", "judgement", "proof", "tie_break", "report", "search")
    page.say(*table(["scene", "verdict", "wall", "processor"] + [phase.replace("_", "-") for phase in phases],
                    [[row["scene"], row["verdict"], seconds(number(row, "seconds_wall")), seconds(number(row, "seconds_processor"))]
                     + [seconds(number(row, f"seconds_{phase}")) for phase in phases] for row in slow], left=2))


def section_growth(page):
    rows = page.rows("growth_of_time.csv")
    if not rows:
        return
    page.say("## Growth with the number of segments", "")
    page.picture("growth_of_time.svg", pictures.growth(rows, page.machine), "Growth of time")
    slopes = {kind: exponent(growth_points(rows, kind)) for kind in ("call", "exchange", "solve")}
    fitted = ", ".join(f"{kind} {slope:.2f}" for kind, slope in slopes.items() if slope is not None)
    page.say(f"Fitted exponents from n = 256 on: {fitted}.", "")
    lines = []
    for row in rows:
        if row["kind"] == "solve":
            difference, n = number(row, "relative_difference"), int(row["n"])
            target = 1e-8 if n == 16384 else 1e-9
            lines.append([n, row["status"], f"{number(row, 'objective') or math.nan:.10f}",
                          f"{number(row, 'independent_optimum'):.10f}" if difference is not None else "–",
                          short(difference), "" if difference is None else verdict(abs(difference) <= target),
                          seconds(number(row, "seconds_median")), row["repeats"], row["rounds"], row["iterations"]])
    page.say(*table(["n", "verdict", "objective", "independent optimum", "relative difference", "within 1e-9 (16384: 1e-8)",
                     "seconds", "repeats", "rounds", "iterations"], lines))
    page.say("The independent optima were computed by an LP solver with exchange and printed to ten digits.", "")


def section_sweep(page):
    rows = page.rows("sweep_seconds.csv")
    if rows:
        page.say("## A thousand weights", "")
        page.say(*table(["way", "solver", "rows solved", "passes", "median", "a row", "not proved optimal",
                         "largest difference from cold", "ratio"],
                        [[row["way"], row["solver"], row.get("solved", "–"), row["passes"], seconds(number(row, "seconds_median")),
                          seconds(number(row, "seconds_median") / int(row["rows"])), row["not_optimal"],
                          short(number(row, "worst_difference_from_cold")), f"{number(row, 'ratio'):.2f}"] for row in rows],
                        2))
        worst = max(number(row, "worst_difference_from_cold") for row in rows)
        page.say(f"{rows[0]['rows']} lattice weights of a DRD cubic of 32 segments, whole library solves in one process. No "
                 f"row differs by more than {worst:.1g} from its cold structured solve (asked for: 1e-8, "
                 f"{'met' if worst <= 1e-8 else 'not met'}).", "")
    rows = page.rows("sweep_workers.csv")
    if rows:
        page.say(*table(["workers", "rows", "runs", "median", "least", "rows a second", "same rows as one worker"],
                        [[row["workers"], row["rows"], row["repeats"], seconds(number(row, "seconds_median")),
                          seconds(number(row, "seconds_min")), f"{int(row['rows']) / number(row, 'seconds_median'):.0f}",
                          row["same_rows"]] for row in rows]))
        page.say("`camopt sweep` as a user runs it: starting, writing and the picture included.", "")


def section_camshape(page):
    rows = page.rows("camshape.csv")
    if not rows:
        return
    page.say("## A valve cam from outside", "")
    lines = []
    for row in rows:
        violation = number(row, "violation")
        is_there = violation is not None and violation <= 1e-6
        lines.append([row["n"], row["solver"], row["termination"].replace("_", " "),
                      seconds(number(row, "seconds_median")), f"{number(row, 'objective'):.12g}" if is_there else "–",
                      short(number(row, "above_optimum")) if is_there else "–", short(violation), row["iterations"]])
    page.say(*table(["radii", "solver", "it says", "seconds", "objective", "above the optimum", "violation", "iterations"],
                    lines, 3))
    page.say("`camshape` of COPS 3.0 (`outside/camshape.hpp`), which is not convex, through `Nlp` from the straight line, at most "
             "20 s each; the optima are those that MINLPLib has proved. What is not feasible to 1e-6 has no objective here. "
             "The structured solver is made for the convex scenes of cams and for what is near them; here it says that it found "
             "no feasible point.", "")


def section_algebra(page):
    rows = page.rows("linear_algebra.csv")
    if not rows:
        return
    page.say("## Linear algebra behind the structured solver", "")
    names = list(dict.fromkeys(row["factorization"] for row in rows))
    lines = []
    for n in dict.fromkeys((row["degree"], row["n"]) for row in rows):
        own = {row["factorization"]: row for row in rows if (row["degree"], row["n"]) == n}
        times = {name: number(row, "seconds_median") for name, row in own.items() if number(row, "seconds_median") and
                 number(row, "relative_error") is not None and
                 abs(number(row, "relative_error")) <= ACCURATE}
        quickest = min(times, key=times.get) if times else "none"
        lines.append([*n] + [f"{seconds(times[name])}" if name in times else own.get(name, {}).get("status", "–")
                             for name in names] + [quickest])
    page.say(*table(["degree", "n"] + names + ["quickest"], lines, 2))
    page.say("One call on the final grid, tolerance 1e-9, medians of five in turns; only results within 1e-8 of the optimum "
             "show their time. `auto` is what the solver takes by itself; cholmod and klu are SuiteSparse's; a build without "
             "it refuses them.", "")


def section_integrators(page):
    rows = page.rows("integrators.csv")
    if not rows:
        return
    names = [name for name, _ in pictures.INTEGRATORS if any(row["method"] == name for row in rows)]
    page.say("## The response of a follower train", "")
    page.picture("integrators.svg", pictures.integrators(rows, names), "Error against time of exact response and integrators")
    for train, words in (("one mass", "One mass, its stiffness over eight decades (1 to 10⁴ natural periods a rise)"),
                         ("two masses", "Two masses, 2.5 periods a rise, the first spring stiffer and stiffer")):
        lines = []
        for damping in (0.0, 0.02, 0.3, 1.0, 2.0):
            for name in names:
                cells = []
                for ratio in (1.0, 1e2, 1e4, 1e6, 1e8):
                    times = [number(row, "ratio") for row in rows if row["train"] == train and row["method"] == name and
                             number(row, "stiffness_ratio") == ratio and number(row, "damping_ratio") == damping and
                             row["status"] == "ok" and number(row, "error") <= 1e-6]
                    cells.append(f"{min(times):.3g}" if times else "–")
                lines.append([f"{damping:g}", name] + cells)
        page.say(f"{words}: time for an error of 1e-6, by that of the exact end state.", "")
        page.say(*table(["damping", "method", "1", "10²", "10⁴", "10⁶", "10⁸"], lines, 2))
    exact = [row for row in rows if row["method"] == "exact"]
    worst = max(number(row, "error") for row in exact)
    times = sorted(number(row, "seconds") for row in exact)
    count = lambda word: sum(row["status"] == word for row in rows)
    page.say(f"The exact end state takes {seconds(times[0])} to {seconds(times[-1])}, whatever the stiffness, and errs by at most "
             f"{worst:.1g}. Integrators: Jacobian given, dense; {count('unstable')} of their runs blew up, {count('too many evaluations')} "
             f"stopped after 400,000 evaluations, {count('wrong')} ended with an error above 1. –: no run came to 1e-6.", "")


def section_stability(page):
    rows = page.rows("stability.csv")
    if not rows:
        return
    page.say("## Numerical stability", "", "![Numerical stability](results/stability.svg)", "")
    lines = []
    for group in dict.fromkeys(row["group"] for row in rows):
        own = [row for row in rows if row["group"] == group]
        count = lambda word: sum(row["judgement"] == word for row in own)
        errors = [number(row, "relative_error") for row in own
                  if row["verdict"] == "optimal" and number(row, "relative_error") is not None]
        lines.append([group, len(own), count("ok"), count("unsolved"), count("wrong"), count("absent"),
                      short(max(map(abs, errors), default=None))])
    page.say(*table(["group", "rows", "ok", "unsolved", "wrong", "absent", "worst error where optimal"], lines))
    wrong = sum(row["judgement"] == "wrong" for row in rows)
    page.say(f"{len(rows)} rows, {wrong} of them wrong. Unsolved: a weaker verdict than hoped for, and a true one. Every row "
             "is in [stability.md](results/stability.md).", "")


def section_unneeded(page):
    rows = page.rows("evaluation_counts.csv")
    if rows:
        page.say("## Nothing unneeded: what is evaluated", "")
        without = [row for row in rows if row["cam"] == "no"]
        idle = sum(int(row["profile_points"]) for row in without)
        hessians = [row for row in without if row["solver"] == "structured" and row["hessian"] == "0"]
        page.say(f"{len(without)} of {len(rows)} example scenes have no cam; they evaluate {idle} profile points in all. "
                 f"{len(hessians)} of them need no second derivatives and ask for none.", "")
        keys = ("verdict", "solver", "starts", "exchange_rounds", "iterations", "cost", "gradient", "constraints", "jacobian",
                "hessian", "profile_points")
        page.say(*table(["scene"] + [key.replace("_", " ") for key in keys],
                        [[row["scene"]] + [row[key] for key in keys] for row in rows]))
        page.say("Counts are those of the named solver over all rounds and starts; a scene that its convex relaxation settles "
                 "has 0 starts. Linear rows and costs are read once a round, not at every iteration.", "")
    rows = page.rows("linked_parts.csv")
    if rows:
        page.say("## Nothing unneeded: what is linked", "")
        page.say(*table(["build", "program", "links", "shared libraries it names", "loaded in all", "objects by folder",
                         "code and data"],
                        [[row["build"], row["program"], row["links"], row["shared_libraries_named"],
                          row["shared_libraries_loaded"], row["objects_by_folder"], f"{int(row['bytes']) // 1024} kB"]
                         for row in rows], 4))
        page.say("The sources are in `benchmarks/embedding/`. Build `minimal` leaves every optional library out.", "")


def section_no_cam(page):
    rows = page.rows("no_cam_cost.csv")
    if rows:
        page.say("## What an unused cam costs", "")
        page.say(*table(["scene", "without", "with an idle cam", "ratio", "quartiles", "profile points without", "with"],
                        [[row["scene"], seconds(number(row, "seconds_without")), seconds(number(row, "seconds_with")),
                          f"{number(row, 'ratio_median'):.2f}",
                          f"{number(row, 'ratio_lower_quartile'):.2f} to {number(row, 'ratio_upper_quartile'):.2f}",
                          row["profile_points_without"], row["profile_points_with"]] for row in rows]))
        page.say("Processor time of `solve()`; the idle cam is so large that its limit does not bite.", "")


def section_machine(page):
    page.say("## Machine, versions, load", "", "```")
    for name in ("commit.txt", "load_before.txt", "machine.txt", "cam_machine.txt", "rivals.txt", "seconds_of_parts.txt"):
        path = page.folder / name
        if path.exists():
            page.say(f"{name}:", *("    " + line for line in path.read_text().splitlines()))
    page.say("```", "")
    if page.absent:
        page.say("**Not measured in this run**: " + ", ".join(f"`{name}`" for name in page.absent) + ".", "")


def main():
    folder, target = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2]).resolve()
    page = Page(folder, target)
    page.say("# Results of the benchmarks", "",
             "Generated by `scripts/benchmark`; how to read it: [README.md](README.md). Numbers, tables and pictures are those "
             f"of one run: {page.machine}, {page.commit}.", "")
    acceptance(page)
    for section in (section_error, section_cam, section_ipopt, section_phases, section_examples, section_rivals, section_growth, section_sweep,
                    section_camshape, section_algebra, section_integrators, section_stability, section_checks, section_unneeded, section_no_cam,
                    section_machine):
        section(page)
    target.write_text("\n".join(page.lines).rstrip() + "\n")


main()
