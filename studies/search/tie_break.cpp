// SPDX-License-Identifier: MIT
#include "studies/search/tie_break.hpp"

#include "scene/cost_table.hpp"
#include "solvers/structured/structured_solver.hpp"

namespace camopt {

namespace {

// Weights of the energy, tried until the objective stays within the tolerance of its optimum. Measured:
// larger ones than the first cost too much at n = 256 and 1024 and where a pressure angle is limited.
constexpr std::array<double, 4> tie_break_weights = {1e-6, 1e-7, 1e-8, 1e-9};
// The tie-break must be solved more exactly than the tolerance it may spend.
constexpr double tie_break_accuracy = 0.1;

// The energy pushes by its weight: the path of the problem without it is left where its gap is this many
// times as wide.
constexpr double energy_room = 10.0;

double relative_to(double objective) {
    return std::max(1.0, std::abs(objective));
}

/// What a smoother motion may cost, and what it is drawn to where it violates limits.
struct Allowance {
    double objective = 0.0, spent = 0.0, violation = 0.0;
    const Candidate& inside;

    [[nodiscard]] bool holds(const Candidate& point) const {
        return point.x.size() > 0 && point.objective <= objective + spent && point.violation <= violation;
    }
};

/// The optimum of the tied problem, as it would be delivered. The rounds end as soon as that is within the
/// allowance and costs no more than the optimum on the grid by as much, or the latter is beyond the
/// allowance.
Candidate smoother_optimum(const CamProblem& problem, TiedProblem& tied, Candidate start,
                           ExchangeOptions options, const Allowance& allowance, const SolveControl& control) {
    Candidate delivered;
    const auto deliver = [&](Candidate point) {
        if (point.x.size() > 0) point.objective = problem.grid().cost(point.x);
        delivered = pulled_inside(problem, point, allowance.inside);
    };
    options.enough = [&](const ExchangeResult& found) {
        const double on_grid = problem.grid().cost(found.last.x);
        deliver(found.latest);
        const bool suffices = allowance.holds(delivered) && delivered.objective <= on_grid + allowance.spent;
        return suffices || on_grid > allowance.objective + allowance.spent;
    };
    start.objective = tied.grid().cost(start.x);
    const ExchangeResult found =
        minimize_by_exchange(tied, *make_structured_solver(), start, options, control);
    if (found.converged && !allowance.holds(delivered)) deliver(found.best);
    return delivered;
}

}  // namespace

bool break_tie(const PlannedRun& run, CamProblem& problem, ContinuousResult& result) {
    if (!run.plan.tie_break || result.certificate.verdict != Verdict::optimal) return false;
    const Scene& scene = run.posed.scene;
    // Neighbours of a convex problem need the grid of the optimum alone, unless they are only looked at.
    const bool keeps = run.plan.look || !run.plan.convex;
    const double objective = result.certificate.objective;
    const Allowance allowance{objective, scene.solver.tolerance * relative_to(objective),
                              std::max(scene.solver.tolerance, result.certificate.worst_violation),
                              result.inside};
    ExchangeOptions options = exchange_options(scene);
    options.backend.native.clear();
    options.backend.tolerance = options.tolerance = tie_break_accuracy * scene.solver.tolerance;
    const Candidate start{result.x, objective, result.certificate.worst_violation};
    const std::vector<PathPoint>& path = result.exchange.last.path;
    TiedProblem tied(problem, tie_break_weights.front());
    for (const double weight : tie_break_weights) {
        if (run.plan.look && weight > run.known.tie_break_weight.value_or(weight)) continue;
        tied.set_weight(weight);
        if (const PathPoint* place = point_before(path, energy_room * weight)) options.backend.near = *place;
        const Candidate delivered = smoother_optimum(problem, tied, start, options, allowance, run.control);
        if (keeps) run.known.keep(problem);
        if (run.control.ending() || delivered.x.size() == 0) return false;
        if (!allowance.holds(delivered)) continue;
        if (keeps) run.known.tie_break_weight = weight;
        // What is proved of the motion before must be proved of this one too.
        if (relative_gap(delivered.objective, *result.certificate.lower_bound) > scene.solver.wanted_gap())
            continue;
        if (tied.energy(delivered.x) > tied.energy(result.x)) return true;
        result.x = delivered.x;
        Certificate& certificate = result.certificate;
        certificate.objective = delivered.objective;
        certificate.worst_violation = delivered.violation;
        certificate.gap = relative_gap(delivered.objective, *certificate.lower_bound);
        return true;
    }
    return false;
}

}  // namespace camopt
