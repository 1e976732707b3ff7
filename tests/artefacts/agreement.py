# SPDX-License-Identifier: MIT
"""Whether two results of one scene agree: the installed program's and that of another platform."""

CONVEX = 1e-9


def gap_of(result):
    return (result["bound"] or {}).get("gap") or 0.0


def ran_out_of_time(result):
    return result["verdict"] in ("feasible", "local") and result["reason"] == "time_limit"


def is_within(result, objective):
    """Whether another objective of the scene lies between the bound and the objective of this result."""
    return result["bound"]["lower"] <= objective * (1 + CONVEX) and objective <= result["objective"] * (1 + CONVEX)


def judged(here, there):
    """(relative difference of the objectives or None, allowed, a remark; a fault begins with FAILED).

    Optimal objectives of convex scenes must agree to 1e-9 relative, others within the sum of their gaps; verdicts must be the same.
    Where the program (`there`) went on to a solver that is missing `here` (Ipopt, NLopt), `here` may end as feasible, and either may
    run out of time (docs/install.md, "What each proves"): the other objective must then lie between its bound and objective."""
    lacks_solver = there["solver"]["name"] not in ("structured", here["solver"]["name"])
    unproved = [one for one in (here, there) if ran_out_of_time(one)]
    differ = here["verdict"] != there["verdict"]
    if differ and not unproved and not (lacks_solver and here["verdict"] == "feasible"):
        return None, 0.0, f"FAILED: verdicts {there['verdict']} and {here['verdict']}"
    a, b = here["objective"], there["objective"]
    if a is None or b is None:
        return None, 0.0, "" if a is b else "FAILED: one has no objective"
    size = max(abs(a), abs(b), 1e-300)
    difference = abs(a - b) / size
    if differ and unproved:
        one = unproved[0]
        inside = is_within(one, b if one is here else a)
        return difference, gap_of(one) / size, "out of time, by the gap" if inside else "FAILED: outside of the bounds"
    if lacks_solver:
        return difference, gap_of(here) / size, f"{there['solver']['name']}, by the gap" if is_within(here, b) else "FAILED: outside of the bounds"
    allowed = CONVEX if here["plan"]["convex"] and here["verdict"] != "feasible" else max(CONVEX, (gap_of(here) + gap_of(there)) / size)
    return difference, allowed, "" if difference <= allowed else f"FAILED: more than {allowed:.1e}"
