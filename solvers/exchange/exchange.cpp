// SPDX-License-Identifier: MIT
#include "solvers/exchange/exchange.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace camopt {

namespace {

// Rows are added for maxima above this part of the tolerance, so that their sum stays below it.
constexpr double adding_part = 0.1;

// No round is solved more coarsely than this.
constexpr double coarsest_round = 1e-4;

/// Adds rows where the motion behind a backend's point breaks rules. 0: there is no such place, or its rows
/// are there already, and the backend leaves violated what it was told to keep: nothing more to tell it.
int refined(ContinuousProblem& problem, const BackendResult& found, double tolerance) {
    std::vector<Violation> worst = problem.violations(found.x, 0.0);
    std::erase_if(worst,
                  [&](const Violation& violation) { return violation.amount <= adding_part * tolerance; });
    if (worst.empty()) return 0;
    const bool presses =
        found.row_multipliers && found.row_multipliers->size() == problem.grid().shape().constraints();
    return presses ? problem.refine_pressed(worst, *found.row_multipliers) : problem.refine(worst);
}

/// Who cancels before anything was searched for is not given the start for a result.
bool interrupted_at_once(const ExchangeResult& result) {
    return result.termination == Termination::interrupted && result.iterations == 0;
}

}  // namespace

bool was_stopped(Termination termination) {
    return termination == Termination::time_limit || termination == Termination::interrupted;
}

Candidate judged(const ContinuousProblem& problem, const Eigen::VectorXd& x) {
    Candidate candidate{problem.completed(x), infinity, infinity};
    if (!candidate.x.allFinite()) return {};
    candidate.objective = problem.grid().cost(candidate.x);
    candidate.violation = problem.worst_of_limits(candidate.x);
    return candidate;
}

bool is_better(const Candidate& left, const Candidate& right, double tolerance) {
    const bool left_feasible = left.violation <= tolerance;
    const bool right_feasible = right.violation <= tolerance;
    if (left_feasible != right_feasible) return left_feasible;
    return left_feasible ? left.objective < right.objective : left.violation < right.violation;
}

namespace {

/// What the grid does not see at a point of it, relative: of the objective or of the worst limit.
double unseen_by(const Nlp& grid, const Candidate& found, const Eigen::VectorXd& x) {
    const double unseen = found.objective - grid.cost(x);
    return std::max(found.violation, unseen / std::max(1.0, std::abs(found.objective)));
}

/// How exactly the next round is to be solved. The error of the exchange falls like that of Newton's method,
/// so the next grid misses about the square of what this one missed; to solve it more exactly is lost.
/// Only our own solver is told so, and only of programs that it solves by one run of its interior point.
double tolerance_of_next_round(const Solver& solver, const NlpShape& grid, double unseen, double wished) {
    const bool one_run =
        grid.convex && grid.quadratic_cost && std::ranges::all_of(grid.rows, &RowKind::linear);
    if (solver.name() != "structured" || !one_run) return wished;
    return std::max(wished, std::min(coarsest_round, unseen * unseen));
}

/// Goes on with `result`, whose best point is judged, from a start.
ExchangeResult exchanged(ContinuousProblem& problem, const Solver& solver, Eigen::VectorXd next_start,
                         const ExchangeOptions& options, const SolveControl& control, ExchangeResult result) {
    const SolveControl timed = control.sooner(options.backend.max_seconds);
    BackendOptions backend = options.backend;
    while (result.rounds < options.most_rounds) {
        if (const std::optional<Termination> ending = timed.ending()) {
            result.termination = *ending;
            if (interrupted_at_once(result)) result.best = {};
            return result;
        }
        result.last = solver.minimize(problem.grid(), next_start, backend, timed);
        result.termination = result.last.termination;
        result.iterations += result.last.iterations;
        ++result.rounds;
        const Eigen::VectorXd& x = result.last.x;
        if (x.size() == 0 || !x.allFinite()) return result;
        if (timed.known && timed.known(x)) {
            result.known = true;
            return result;
        }
        const Candidate& found = result.latest = judged(problem, x);
        if (is_better(found, result.best, options.tolerance)) result.best = found;
        if (control.progress) {
            const std::string line = fmt::format("round {}: objective {:.9g}, {} rows", result.rounds,
                                                 result.best.objective, problem.grid().shape().constraints());
            Progress progress(line);
            progress.round = result.rounds;
            if (result.best.x.size() > 0) {
                progress.incumbent = result.best.objective;
                progress.violation = result.best.violation;
            }
            control.progress(progress);
        }
        if (was_stopped(result.termination) || result.termination == Termination::infeasible ||
            result.termination == Termination::unsupported) {
            if (interrupted_at_once(result)) result.best = result.latest = {};
            return result;
        }
        const double unseen = unseen_by(problem.grid(), found, x);
        const bool settled = unseen <= options.tolerance;
        const bool nothing_to_add = settled || refined(problem, result.last, options.tolerance) == 0;
        const double wished = options.backend.tolerance;
        if (nothing_to_add && backend.tolerance <= wished) {
            result.converged = true;
            return result;
        }
        backend.tolerance =
            nothing_to_add ? wished : tolerance_of_next_round(solver, problem.grid().shape(), unseen, wished);
        next_start = found.x;
    }
    return result;
}

}  // namespace

ExchangeResult minimize_by_exchange(ContinuousProblem& problem, const Solver& solver, const Candidate& start,
                                    const ExchangeOptions& options, const SolveControl& control) {
    ExchangeResult result;
    result.best = start;
    return exchanged(problem, solver, start.x, options, control, std::move(result));
}

ExchangeResult minimize_by_exchange(ContinuousProblem& problem, const Solver& solver,
                                    const Eigen::VectorXd& start, const ExchangeOptions& options,
                                    const SolveControl& control) {
    const Candidate first = judged(problem, start);
    if (first.x.size() > 0) return minimize_by_exchange(problem, solver, first, options, control);
    return exchanged(problem, solver, start, options, control, {});
}

}  // namespace camopt
