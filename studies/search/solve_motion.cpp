// SPDX-License-Identifier: MIT
#include "studies/search/solve_motion.hpp"

#include "solvers/registry.hpp"
#include "studies/delivered/delivered_audit.hpp"
#include "studies/delivered/smallest_of_any_motion.hpp"
#include "studies/delivered/solution_parts.hpp"
#include "studies/delivered/solution_report.hpp"
#include "studies/search/convex_solve.hpp"
#include "studies/search/presolve.hpp"
#include "studies/search/start_search.hpp"
#include "studies/search/tie_break.hpp"

#include <fmt/format.h>

namespace camopt {

namespace {

/// The smoothest optimum of a relaxation that satisfies the rules of the whole is that of the whole, and the
/// rows of the relaxation are convex; else it is searched with all rules.
void break_tie_of_relaxation(const PlannedRun& run, CamProblem& relaxation, CamProblem& whole,
                             ContinuousResult& result) {
    const double allowed = std::max(run.posed.scene.solver.tolerance, result.certificate.worst_violation);
    ContinuousResult relaxed = result;
    if (break_tie(run, relaxation, relaxed)) {
        const double violation = judged(whole, relaxed.x).violation;
        if (violation <= allowed) {
            result = std::move(relaxed);
            result.certificate.worst_violation = violation;
            return;
        }
    }
    break_tie(run, whole, result);
}

ContinuousResult solve_convex_motion(const PlannedRun& run, const Solver& solver, CamProblem& problem,
                                     Solution& solution) {
    const JudgeOptions judge{solution.scene.solver.tolerance, solution.scene.solver.wanted_gap()};
    ExchangeOptions exchange = exchange_options(solution.scene);
    exchange.staged = run.known.is_cold();
    NextSolver next;
    ContinuousResult result =
        solve_convex({problem, solver, run.plan.next_solver, judge, run.control}, std::move(exchange), next);
    if (result.certificate.reason == Reason::unbounded) return result;
    if (next.reason)
        solution.notes.push_back(fmt::format("{} ended without a proof ({}); {} was tried next",
                                             run.plan.solver, name_of(*next.reason), run.plan.next_solver));
    if (next.found) solution.solver.name = run.plan.next_solver;
    run.known.keep(problem);
    const Stopwatch watch;
    break_tie(run, problem, result);
    solution.phases.tie_break = watch.seconds();
    return result;
}

/// The solve ended at a relaxation that settles the whole and leaves its strokes.
bool holds_strokes_next(const PlannedRun& run) {
    return run.leaves_strokes != nullptr && *run.leaves_strokes;
}

ContinuousResult solve_general(const PlannedRun& run, const Solver& solver, CamProblem& problem,
                               Solution& solution) {
    StartsResult all = solve_from_starts(run, problem.model(), solver);
    solution.solver.convex = false;
    solution.solver.starts = all.starts;
    if (holds_strokes_next(run)) return std::move(all.result);
    if (all.starts > 0 && all.starts < run.plan.starts && run.control.stopped())
        solution.notes.push_back(
            fmt::format("interrupted in the search: {} of {} starts were run", all.starts, run.plan.starts));
    if (all.next_solver_ran)
        solution.notes.push_back(fmt::format("{} found no motion within the limits; {} was tried next",
                                             run.plan.solver, run.plan.next_solver));
    if (all.found_by_next) solution.solver.name = run.plan.next_solver;
    if (all.starts > 0) return std::move(all.result);
    solution.solver.name = "structured";  // the relaxation settled it
    if (all.result.certificate.verdict != Verdict::optimal) return std::move(all.result);
    const Stopwatch watch;
    break_tie_of_relaxation(run, *all.relaxation, problem, all.result);
    solution.phases.tie_break = watch.seconds();
    solution.notes.emplace_back(
        "the limits that are not convex are inactive: the optimum without them satisfies them, so it is the "
        "optimum of the whole");
    return std::move(all.result);
}

/// Whether an optimum of a convex problem may serve neighbours of other weights.
bool serves_other_weights(const PlannedRun& run, const ContinuousResult& result) {
    const Certificate& certificate = result.certificate;
    return run.plan.convex && run.posed.units.are_its_own() && certificate.verdict == Verdict::optimal &&
           certificate.proof_kind == ProofKind::duality && certificate.proof && !is_relaxed(certificate) &&
           result.proof_source == run.plan.solver && result.exchange.last.row_multipliers;
}

/// Takes the certificate of `result`.
void report_result(Solution& solution, const CamProblem& problem, ContinuousResult& result) {
    const Stopwatch watch;
    solution.phases.solver = result.seconds.solver;
    solution.phases.judgement = result.seconds.judgement;
    solution.phases.proof = result.seconds.proof;
    solution.certificate = std::move(result.certificate);
    solution.solver.termination = result.exchange.termination;
    solution.solver.native_status = result.exchange.last.native_status;
    solution.solver.iterations = result.exchange.iterations;
    solution.solver.exchange_rounds = result.exchange.rounds;
    solution.solver.proof_source = result.proof_source;
    if (problem.model().cam) solution.evaluations.profile_points = *problem.model().cam->profile_points;
    if (result.x.size() > 0) report_motion(solution, problem, result.x);
    if (solution.certificate.verdict == Verdict::infeasible) report_conflict(solution);
    solution.phases.report = watch.seconds();
}

}  // namespace

Solution solve_motion(const PlannedRun& run) {
    const Stopwatch watch;
    Solution solution;
    solution.scene = run.posed.scene;
    solution.reference_peaks = run.posed.reference;
    solution.any_curve_limit = limit_curve(solution.scene, run.posed.reference);
    solution.solver.name = run.plan.solver;
    solution.solver.choice = run.plan.reason;
    solution.design.kind = run.plan.design;
    CountingSolver solver(make_solver(run.plan.solver));
    check_native_options(run.plan.solver, solution.scene.solver.options);
    const bool prescribed = solution.scene.motion.prescribed();
    if (prescribed && settle_prescribed(solution, run.posed.model)) return solution;
    CamProblem problem = run.known.problem(std::move(run.posed.model));
    solution.family = problem.family();
    report_redundant(solution, problem.model().design);
    solution.phases.setup = watch.seconds();
    if (run.plan.contradiction) {
        report_contradictions(solution, problem.model().design);
    } else if (prescribed && problem.model().parameters.empty()) {
        solution.certificate = certificate_of_constant(problem.model());
        report_motion(solution, problem, Eigen::VectorXd());
    } else if (!report_rest_conflict(solution, problem.model())) {
        const Stopwatch solve_watch;
        ContinuousResult result = run.plan.relaxations.empty()
                                      ? solve_convex_motion(run, solver, problem, solution)
                                      : solve_general(run, solver, problem, solution);
        solution.seconds_solve = solve_watch.seconds();
        solution.evaluations = solver.counts();
        const bool serves = serves_other_weights(run, result);
        report_result(solution, problem, result);
        if (serves)
            run.known.optima.propose(std::move(problem), result.x, *result.exchange.last.row_multipliers);
    }
    solution.seconds_total = watch.seconds();
    return solution;
}

}  // namespace camopt
