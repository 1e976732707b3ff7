// SPDX-License-Identifier: MIT
#include "studies/search/solve_motion.hpp"

#include "solvers/registry.hpp"
#include "studies/delivered/delivered_audit.hpp"
#include "studies/delivered/smallest_of_any_motion.hpp"
#include "studies/delivered/solution_parts.hpp"
#include "studies/delivered/solution_report.hpp"
#include "studies/search/presolve.hpp"
#include "studies/search/start_search.hpp"
#include "studies/search/tie_break.hpp"

#include <fmt/format.h>

namespace camopt {

namespace {

// A proof that comes at all comes within these; where doubles end, more of either only take time.
constexpr int most_rounds_of_next = 20, most_iterations_of_next = 200;
// Of a small gap: what closes it at all does so at once, else the next backend may.
constexpr double nearly_proved = 1e-4, share_where_nearly_proved = 0.05;
// Where segments differ by two orders of magnitude the default shift hides rows, and errors fall late.
constexpr double fine_shift = 1e-11;
constexpr long long long_patience = 60;

bool is_proved(const ContinuousResult& result) {
    return result.certificate.verdict == Verdict::optimal ||
           result.certificate.verdict == Verdict::infeasible;
}

/// Whether a proof is one for relaxed limits: only their tolerance gives the problem room.
bool is_relaxed(const Certificate& certificate) {
    return certificate.proof && certificate.proof->limits_relaxed_by > 0.0;
}

/// Keeps the better of two results: what proves more, of what does not the motion of the least objective with
/// the largest bound of either. Whether it is the motion of `other`.
bool keep_better(ContinuousResult& result, ContinuousResult other, const JudgeOptions& judge) {
    result.seconds += other.seconds;
    other.seconds = result.seconds;  // of both attempts, whichever is kept
    if (is_proved(result)) return false;
    const auto is_first = [&](const ContinuousResult& one, const ContinuousResult& two) {
        if (is_proved(one) || one.x.size() == 0 || two.x.size() == 0)
            return is_proved(one) || (one.x.size() > 0 && two.x.size() == 0);
        const double less = two.certificate.objective - one.certificate.objective;
        const bool equal = std::abs(less) <= judge.gap * std::max(1.0, std::abs(one.certificate.objective));
        return equal ? one.certificate.verdict < two.certificate.verdict : less > 0.0;
    };
    const bool takes = is_first(other, result);
    if (takes) std::swap(result, other);
    Certificate& kept = result.certificate;
    Certificate& left = other.certificate;  // its bound is one for all motions that are no worse than its own
    if (is_proved(result) || result.x.size() == 0 || !left.proof || is_relaxed(left) ||
        left.lower_bound <= kept.lower_bound ||
        bound_passes(kept.objective, *left.lower_bound, judge.tolerance) ||
        !(kept.objective <= left.objective))
        return takes;
    kept.lower_bound = left.lower_bound;
    kept.gap = relative_gap(kept.objective, *left.lower_bound);
    kept.proof = std::move(left.proof);
    kept.proof_kind = left.proof_kind;
    result.proof_source = std::move(other.proof_source);
    settle_verdict(kept, result.exchange.termination, judge);
    return takes;
}

/// Solves again with other options.
void try_again(const PlannedRun& run, const Solver& solver, const ExchangeOptions& exchange,
               const JudgeOptions& judge, CamProblem& problem, ContinuousResult& result) {
    if (is_proved(result) || run.control.ending()) return;
    keep_better(result, solve_continuous(problem, solver, exchange, judge, run.control), judge);
}

/// Problems whose numbers are hard: another backend tries from the same grid. Where only the tolerance gives
/// room none finds more.
void try_next_solver(const PlannedRun& run, const JudgeOptions& judge, CamProblem& problem,
                     ContinuousResult& result, Solution& solution) {
    if (run.plan.next_solver.empty() || is_proved(result) || is_relaxed(result.certificate)) return;
    if (run.control.ending()) return;
    ExchangeOptions exchange = exchange_options(solution.scene);
    exchange.backend.native.clear();  // they belong to the first backend
    exchange.backend.max_iterations = std::min(exchange.backend.max_iterations, most_iterations_of_next);
    exchange.most_rounds = std::min(exchange.most_rounds, most_rounds_of_next);
    ContinuousResult other =
        solve_continuous(problem, *make_solver(run.plan.next_solver), exchange, judge, run.control);
    solution.notes.push_back(fmt::format("{} ended without a proof ({}); {} was tried next", run.plan.solver,
                                         name_of(result.certificate.reason), run.plan.next_solver));
    if (keep_better(result, std::move(other), judge)) solution.solver.name = run.plan.next_solver;
}

/// With finer and more patient steps, then with exact ones, from the same grid. Each ends at the first
/// failure, and where another backend follows all together take a share of the time.
void try_harder(const PlannedRun& run, const Solver& solver, ExchangeOptions exchange,
                const JudgeOptions& judge, CamProblem& problem, ContinuousResult& result) {
    double share = 1.0;
    if (!run.plan.next_solver.empty())
        share = result.certificate.gap.value_or(infinity) <= nearly_proved ? share_where_nearly_proved
                                                                           : share_of_first;
    const SolveControl timed = run.control.sooner(share * run.control.deadline.seconds_left());
    const PlannedRun part{run.posed, run.plan, timed, run.known};
    exchange.backend.has_optimum = result.inside.violation <= 0.0;  // the first attempt found no ray
    const auto proves = [&](const ExchangeOptions& options) {
        try_again(part, solver, options, judge, problem, result);
        return is_proved(result);
    };
    ExchangeOptions fine = exchange, exact = exchange;
    fine.backend.native.emplace("regularisation", fine_shift);
    fine.backend.native.emplace("patience", long_patience);
    exact.backend.exact_steps = ExactSteps::always;
    if (proves(fine) || proves(exact)) return;
    fine.enough = nullptr;  // rows of a later round may make a problem well posed that was not
    proves(fine);
}

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

ContinuousResult solve_convex(const PlannedRun& run, const Solver& solver, CamProblem& problem,
                              Solution& solution) {
    const JudgeOptions judge{solution.scene.solver.tolerance, solution.scene.solver.wanted_gap()};
    ExchangeOptions exchange = exchange_options(solution.scene);
    exchange.staged = run.known.is_cold();
    const bool structured = run.plan.solver == "structured";
    if (structured) {
        if (run.plan.next_solver.empty()) exchange.backend.exact_steps = ExactSteps::after_failure;
        // A round that fails is followed by others that fail: other steps are tried at once.
        exchange.enough = [](const ExchangeResult& found) {
            return found.last.termination == Termination::numerical_failure;
        };
    }
    ContinuousResult result = solve_continuous(problem, solver, exchange, judge, run.control);
    if (result.certificate.reason == Reason::unbounded) {
        forget_proof(result.certificate);  // of motions up to the farthest that proofs cover
        return result;
    }
    if (structured && !is_proved(result)) try_harder(run, solver, exchange, judge, problem, result);
    try_next_solver(run, judge, problem, result, solution);
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
                                      ? solve_convex(run, solver, problem, solution)
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
