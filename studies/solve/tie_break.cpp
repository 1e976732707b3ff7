// SPDX-License-Identifier: MIT
#include "studies/solve/tie_break.hpp"

#include "objectives/scene_model.hpp"
#include "scene/cost_table.hpp"
#include "solvers/structured/structured_solver.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace camopt {

namespace {

// Of the scene's tolerance, and the tightest that double precision carries.
constexpr double cone_tolerance = 1e-2, least_tolerance = 1e-12;

// Weights of the tie-break, tried until the objective stays within the tolerance of its optimum.
constexpr std::array<double, 4> tie_break_weights = {1e-4, 1e-5, 1e-6, 1e-7};
// The tie-break must be solved more exactly than the tolerance it may spend.
constexpr double tie_break_accuracy = 0.1;

double relative_to(double objective) {
    return std::max(1.0, std::abs(objective));
}

double mean_square_jerk(const CamProblem& problem, const Candidate& candidate) {
    const CamModel& model = problem.model();
    const QuadraticForm form = model.design.mean_square(3, model.mean_square_weights(3));
    return form.value(problem.design_values(candidate.x));
}

}  // namespace

ExchangeOptions exchange_options(const Scene& scene) {
    ExchangeOptions options;
    options.tolerance = scene.solver.tolerance;
    options.backend.tolerance = scene.solver.tolerance;
    options.backend.max_seconds = scene.solver.max_seconds;
    options.backend.native = scene.solver.options;
    // A point just outside is drawn to one well inside, which costs its violation times their distance;
    // tangents of a cone always leave it just outside, and a few more of them cost little.
    if (scene.limits.residual) {
        options.tolerance = std::max(cone_tolerance * options.tolerance, least_tolerance);
        options.backend.tolerance = options.tolerance;
    }
    return options;
}

void break_tie(const CamProblem& problem, const Scene& scene, ContinuousResult& result,
               const SolveControl& control, GridMemory* memory) {
    const double objective = result.certificate.objective;
    const double allowance = scene.solver.tolerance * relative_to(objective);
    const double violation = std::max(scene.solver.tolerance, result.certificate.worst_violation);
    ExchangeOptions options = exchange_options(scene);
    options.backend.native.clear();
    options.backend.tolerance = options.tolerance = tie_break_accuracy * scene.solver.tolerance;
    std::vector<RuleSample> samples = problem.samples();
    const bool looks = memory != nullptr && memory->only_looks;
    for (const double weight : tie_break_weights) {
        if (looks && weight > memory->tie_break_weight.value_or(weight)) continue;
        CamProblem tied(tie_break_model(problem.model(), weight), samples);
        const ExchangeResult smoother =
            minimize_by_exchange(tied, *make_structured_solver(), result.x, options, control);
        if (memory != nullptr) {
            memory->keep(tied);
            samples = tied.samples();
        }
        if (smoother.best.x.size() == 0 || control.ending()) return;
        const Candidate delivered = pulled_inside(problem, judged(problem, smoother.best.x), result.inside);
        if (delivered.objective > objective + allowance || delivered.violation > violation) continue;
        if (memory != nullptr) memory->tie_break_weight = weight;
        // What is proved of the motion before must be proved of this one too.
        if (relative_gap(delivered.objective, *result.certificate.lower_bound) > scene.solver.wanted_gap())
            continue;
        if (mean_square_jerk(problem, delivered) > mean_square_jerk(problem, {result.x})) return;
        result.x = delivered.x;
        Certificate& certificate = result.certificate;
        certificate.objective = delivered.objective;
        certificate.worst_violation = delivered.violation;
        certificate.gap = relative_gap(delivered.objective, *certificate.lower_bound);
        return;
    }
}

bool wants_tie_break(const Scene& scene, const Certificate& certificate) {
    // A root-mean-square term makes the optimum unique by itself.
    return certificate.verdict == Verdict::optimal && scene.objective.tie_break != TieBreak::none &&
           !weighs_any(scene.objective, CostTerm::Kind::rms);
}

}  // namespace camopt
