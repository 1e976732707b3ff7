// SPDX-License-Identifier: MIT
#include "solvers/exchange/exchange.hpp"

#include <fmt/format.h>

#include <iterator>

namespace camopt {

namespace {

// Rows are added for maxima above this part of the tolerance, so that their sum stays below it.
constexpr double adding_part = 0.1;

// The optimum moves by about the violation of its new rows. The warm start is the point of the central path
// whose gap is this many times as wide: measured, closer points send long problems (n = 256 and more) to the
// slower system at the end of the path, but not where it was left early.
constexpr double room = 1000.0, room_after_stage = 10.0;

// A problem of this many variables is solved in stages: its first round ends at the first gap, each of the
// next ones at this part of the one before. Measured: 22 iterations instead of 38 at n = 256; of smaller
// problems a round more costs what the iterations save.
constexpr int least_staged = 512;
constexpr double first_stage = 1e-3, next_stage = 1e-3;

struct Refinement {
    int rows = 0;            ///< added
    double violation = 0.0;  ///< the worst violation among them
};

/// Adds rows where the motion of a backend's point violates rules. None: there is no violation, or its rows
/// exist already, and the backend leaves them violated: no further progress.
Refinement refined(ContinuousProblem& problem, const BackendResult& found, double tolerance) {
    std::vector<Violation> worst = problem.violations(found.x, 0.0);
    std::erase_if(worst,
                  [&](const Violation& violation) { return violation.amount <= adding_part * tolerance; });
    if (worst.empty()) return {};
    double violation = 0.0;
    for (const Violation& one : worst) violation = std::max(violation, one.amount);
    const bool presses =
        found.row_multipliers && found.row_multipliers->size() == problem.grid().shape().constraints();
    return {presses ? problem.refine_pressed(worst, *found.row_multipliers) : problem.refine(worst),
            violation};
}

/// The central path up to the warm start, and the new one from there.
std::vector<PathPoint> joined(std::vector<PathPoint> before, double gap, std::vector<PathPoint> after) {
    std::erase_if(before, [&](const PathPoint& point) { return point.gap < gap; });
    before.insert(before.end(), std::make_move_iterator(after.begin()), std::make_move_iterator(after.end()));
    return before;
}

/// Whether the backend follows a central path that the next round can resume.
bool has_path(const Solver& solver, const NlpShape& shape) {
    return solver.name() == "structured" && shape.convex && std::ranges::all_of(shape.rows, &RowKind::linear);
}

/// A cancellation before the search returns no start as a result.
bool interrupted_at_once(const ExchangeResult& result) {
    return result.termination == Termination::interrupted && result.iterations == 0;
}

/// Continues with `result`, whose best point is verified, from a start.
ExchangeResult exchanged(ContinuousProblem& problem, const Solver& solver, Eigen::VectorXd next_start,
                         const ExchangeOptions& options, const SolveControl& control, ExchangeResult result) {
    const SolveControl timed = control.sooner(options.backend.max_seconds);
    BackendOptions backend = options.backend;
    backend.keep_path = true;
    const bool staged = options.staged && !backend.near &&
                        problem.grid().shape().variables() >= least_staged &&
                        has_path(solver, problem.grid().shape());
    double stage = staged ? first_stage : 0.0;
    while (result.rounds < options.most_rounds) {
        if (const std::optional<Termination> ending = timed.ending()) {
            result.termination = *ending;
            if (interrupted_at_once(result)) result.best = {};
            return result;
        }
        std::vector<PathPoint> before = std::move(result.last.path);
        backend.tolerance = std::max(options.backend.tolerance, stage);
        const bool last_stage = backend.tolerance == options.backend.tolerance;
        const Stopwatch watch;
        result.last = solver.minimize(problem.grid(), next_start, backend, timed);
        result.seconds_solver += watch.seconds();
        if (backend.near)
            result.last.path = joined(std::move(before), backend.near->gap, std::move(result.last.path));
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
        if (options.enough && options.enough(result)) return result;
        const double unseen = found.objective - problem.grid().cost(x);
        const bool settled = last_stage &&
                             unseen <= options.tolerance * std::max(1.0, std::abs(found.objective)) &&
                             found.violation <= options.tolerance;
        const Refinement added = settled ? Refinement{} : refined(problem, result.last, options.tolerance);
        if (added.rows == 0 && last_stage) {
            result.converged = true;
            return result;
        }
        next_start = found.x;
        backend.near.reset();
        if (const PathPoint* place =
                point_before(result.last.path, (staged ? room_after_stage : room) * added.violation))
            backend.near = *place;
        stage = added.rows > 0 ? next_stage * stage : 0.0;
        // A bounded cost stays bounded with more rows, and a point within all limits is within these.
        backend.has_optimum = backend.has_optimum ||
                              (result.best.violation <= 0.0 && result.termination != Termination::unbounded);
    }
    return result;
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
