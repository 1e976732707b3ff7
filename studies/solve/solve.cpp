// SPDX-License-Identifier: MIT
#include "studies/solve/solve.hpp"

#include "studies/delivered/solution_report.hpp"
#include "studies/explain/explain.hpp"
#include "studies/least/least_value.hpp"
#include "studies/tolerance/tolerance_study.hpp"

#include <fmt/format.h>

namespace camopt {

Solution solve(const Scene& scene, const SolveControl& control) {
    const Stopwatch watch;
    const SolveControl timed = control.sooner(scene.solver.max_seconds);
    Solution solution = solve_asked(scene, timed, nullptr, {.explain = true});
    const Certificate& certificate = solution.certificate;
    const bool to_explain =
        certificate.verdict == Verdict::infeasible || certificate.reason == Reason::no_feasible_point ||
        (certificate.verdict == Verdict::failed && certificate.reason == Reason::time_limit);
    if (to_explain && !timed.ending())  // a stopped search must not pass for "nothing helps"
        explain(solution, timed);
    // Not after an interruption, which the verdict or the explanation names, nor by the explanation's own
    // limit.
    const bool cut = solution.explanation && !solution.explanation->own_limit && timed.deadline.was_felt() &&
                     !timed.stopped();
    if (to_explain && (cut || timed.ending() == Termination::time_limit))
        solution.notes.push_back(fmt::format(
            "the time (solver.max_seconds = {:g}) ran out before every change was searched: what is "
            "not named may also suffice",
            scene.solver.max_seconds));
    if (scene.tolerance) report_tolerance(solution, timed);
    note_phase(solution);
    solution.seconds_total = watch.seconds();
    return solution;
}

}  // namespace camopt
