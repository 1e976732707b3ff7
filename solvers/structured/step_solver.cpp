// SPDX-License-Identifier: MIT
#include "solvers/structured/step_solver.hpp"

#include "solvers/structured/standard_form.hpp"

#include <algorithm>

namespace camopt::structured {
namespace {

using Eigen::VectorXd;

// Of the scaled step problem. A step is only tried; what is delivered is judged by the Nlp itself.
constexpr double usable_error = 1e-4, usable_primal = 1e-7;
constexpr double sharp_part = 1e-3, sharpest = 1e-14;
constexpr int sharp_patience = 8;
constexpr double kept = 1e-8;         // elastic part below which the linearized rows count as kept
constexpr double part_of_best = 0.1;  // of the possible reduction of the violation
constexpr double penalty_growth = 10.0;
constexpr double largest_penalty = 1e8;
constexpr int most_raises = 3;  // in one pass: the curvature still belongs to the penalty before

}  // namespace

Step StepSolver::solve(const NlpPoint& point, const StepModel& model) {
    const LinearizedProblem linearized(problem_, point, model);
    const VectorXd start = VectorXd::Zero(linearized.shape().variables());
    const StandardForm form(linearized, start);
    Step result;
    if (form.status() != StandardForm::Status::ready) return result;
    InteriorPointLimits limits = limits_;
    limits.suspicious =
        model.penalty == 0.0;  // with elastic rows and a bounded step there always is an optimum
    if (model.sharp) {
        limits.tolerance = std::max(sharp_part * limits.tolerance, sharpest);
        limits.patience = std::min(limits.patience, sharp_patience);
    }
    const InteriorPointResult solved = interior_point(form.model(), form.to_model(start), limits, control_);
    iterations_ += solved.iterations;
    result.stop = solved.stop;
    result.usable = solved.has_point() && solved.errors.worst() <= usable_error &&
                    solved.errors.primal <= usable_primal && !result.stopped();
    if (!result.usable) return result;
    const VectorXd u = form.to_problem(solved.best.x);
    result.step = linearized.step_of(u);
    result.elastic = linearized.elastic_of(u);
    result.multipliers =
        linearized.multipliers_of(form.row_multipliers(solved.best.lambda, form.cost_scale()));
    return result;
}

StepSolver::Steered StepSolver::solve_elastic(const NlpPoint& point, StepModel& model, double violation) {
    Steered result{solve(point, model), {}, violation};
    if (!result.step.usable || result.step.elastic <= kept) return result;
    StepModel feasibility = model;
    feasibility.slope.setZero();
    feasibility.curvature.setZero();
    feasibility.penalty = 1.0;
    feasibility.cost_unit = 1.0;
    const Step least = solve(point, feasibility);
    if (!least.usable) {
        result.step.stop = least.stop;
        result.step.usable = !least.stopped();
        return result;
    }
    result.least_multipliers = least.multipliers;
    result.least_elastic = std::min(least.elastic, violation);
    const auto reduces = [&](double elastic) {
        if (result.least_elastic <= kept) return elastic <= kept;
        return violation - elastic >= part_of_best * (violation - result.least_elastic);
    };
    for (int k = 0; k < most_raises && !reduces(result.step.elastic) && model.penalty < largest_penalty;
         ++k) {
        model.penalty *= penalty_growth;
        Step stronger = solve(point, model);
        if (!stronger.usable) {
            if (stronger.stopped()) result.step = std::move(stronger);
            return result;
        }
        result.step = std::move(stronger);
    }
    return result;
}

}  // namespace camopt::structured
