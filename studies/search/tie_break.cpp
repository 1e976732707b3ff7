// SPDX-License-Identifier: MIT
#include "objectives/grid/cam_problem.hpp"
#include "scene/cost_table.hpp"
#include "solvers/structured/structured_solver.hpp"
#include "studies/search/solve_steps.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <optional>
#include <utility>

namespace camopt {

namespace {

// Weights of the tie-break, tried until the objective stays within the tolerance of its optimum.
constexpr std::array<double, 4> tie_break_weights = {1e-4, 1e-5, 1e-6, 1e-7};
// The tie-break must be solved more exactly than the tolerance it may spend.
constexpr double tie_break_accuracy = 0.1;

// The energy pushes by its weight: the path of the problem without it is left where its gap is this many
// times as wide.
constexpr double energy_room = 1.0;

double relative_to(double objective) {
    return std::max(1.0, std::abs(objective));
}

// A weight whose first round costs this many times what the tie-break may spend is too large.
constexpr double clearly_too_much = 10.0;

/// The optimum of the tied problem; none where its first round already costs more than is worth going on.
std::optional<Candidate> smoother_optimum(const CamProblem& problem, TiedProblem& tied, Candidate start,
                                          const ExchangeOptions& options, double most,
                                          const SolveControl& control) {
    const std::unique_ptr<Solver> solver = make_structured_solver();
    start.objective = tied.grid().cost(start.x);
    ExchangeOptions one_round = options;
    one_round.most_rounds = 1;
    ExchangeResult found = minimize_by_exchange(tied, *solver, start, one_round, control);
    if (found.last.x.size() > 0 && problem.grid().cost(found.last.x) > most) return std::nullopt;
    const bool unfinished = !found.converged && found.rounds == one_round.most_rounds;
    if (unfinished && !was_stopped(found.termination) && found.latest.x.size() > 0)
        found = minimize_by_exchange(tied, *solver, found.best, options, control);
    Candidate best = std::move(found.best);
    if (best.x.size() > 0) best.objective = problem.grid().cost(best.x);
    return best;
}

}  // namespace

void break_tie(const PlannedRun& run, CamProblem& problem, ContinuousResult& result) {
    if (!run.plan.tie_break || result.certificate.verdict != Verdict::optimal) return;
    const Scene& scene = run.posed.scene();
    // Neighbours of a convex problem need the grid of the optimum alone, unless they are only looked at.
    const bool keeps = run.plan.look || !run.plan.convex;
    const double objective = result.certificate.objective;
    const double allowance = scene.solver.tolerance * relative_to(objective);
    const double violation = std::max(scene.solver.tolerance, result.certificate.worst_violation);
    ExchangeOptions options = exchange_options(scene);
    options.backend.native.clear();
    options.backend.tolerance = options.tolerance = tie_break_accuracy * scene.solver.tolerance;
    const Candidate start{result.x, objective, result.certificate.worst_violation};
    TiedProblem tied(problem, tie_break_weights.front());
    const std::vector<PathPoint>& path = result.exchange.last.path;
    for (const double weight : tie_break_weights) {
        if (run.plan.look && weight > run.known.tie_break_weight.value_or(weight)) continue;
        tied.set_weight(weight);
        if (const PathPoint* place = point_before(path, energy_room * weight)) options.backend.near = *place;
        const std::optional<Candidate> smoother = smoother_optimum(
            problem, tied, start, options, objective + clearly_too_much * allowance, run.control);
        if (keeps) run.known.keep(problem);
        if (run.control.ending()) return;
        if (!smoother) continue;
        if (smoother->x.size() == 0) return;
        const Candidate delivered = pulled_inside(problem, *smoother, result.inside);
        if (delivered.objective > objective + allowance || delivered.violation > violation) continue;
        if (keeps) run.known.tie_break_weight = weight;
        // What is proved of the motion before must be proved of this one too.
        if (relative_gap(delivered.objective, *result.certificate.lower_bound) > scene.solver.wanted_gap())
            continue;
        if (tied.energy(delivered.x) > tied.energy(result.x)) return;
        result.x = delivered.x;
        Certificate& certificate = result.certificate;
        certificate.objective = delivered.objective;
        certificate.worst_violation = delivered.violation;
        certificate.gap = relative_gap(delivered.objective, *certificate.lower_bound);
        return;
    }
}

}  // namespace camopt
