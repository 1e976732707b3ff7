// SPDX-License-Identifier: MIT
#include "solvers/structured/active_set_step.hpp"
#include "solvers/structured/sequential_solver.hpp"

namespace camopt::structured {

namespace {

using Eigen::VectorXd;

// Of the scaled step problem. Steps are only trials; the Nlp itself verifies the result.
constexpr double usable_error = 1e-4, usable_primal = 1e-7;
constexpr double sharp_part = 1e-3, sharpest = 1e-14;
constexpr int sharp_patience = 8;
// The warm start of a step problem is the place of this gap on the path of the one before: closer ones save
// no more iterations (measured: a third, of about 20).
constexpr double near_gap = 1e-2;
constexpr int most_from_near_gap = 25;
constexpr double half_way = 0.5;      // part of the violation: a step that leaves less is long enough
constexpr double kept = 1e-8;         // elastic part below which the linearized rows count as satisfied
constexpr double part_of_best = 0.1;  // of the possible reduction of the violation
constexpr double penalty_growth = 10.0;
constexpr double largest_penalty = 1e8;
constexpr int most_raises = 3;  // in one pass: the curvature still belongs to the previous penalty

// One step: its model, its computation, and whether the merit function accepts it.
constexpr double least_unit = 1e-3;     // of a step problem while the last digits are computed
constexpr double unit_lengths = 100.0;  // lengths of the last step in that unit
constexpr int elastic_passes = 3;       // after rows that could not be satisfied
// The merit function follows the rows too closely where ν is much larger than the multipliers require; a
// bounded number of reductions prevents cycling.
constexpr double penalty_excess = 8.0;
constexpr int most_reductions = 20;
constexpr int most_corrections = 3;
constexpr double step_rounding = 1e-14;

}  // namespace

/// Problems without relaxation start near the path of the last such problem.
InteriorPointResult StepSolver::solve_form(const LinearizedProblem& linearized, const StandardForm& form,
                                           const NlpPoint& point, const StepModel& model,
                                           InteriorPointLimits limits) {
    const bool relaxed = model.penalty > 0.0;
    const double cost_unit = model.unit * model.cost_unit / form.cost_scale();  // of the form's cost
    limits.keep_path = !relaxed;
    InteriorPointResult solved;
    if (near_ && !relaxed) {
        const NlpShape& shape = linearized.shape();
        const VectorXd u =
            ((near_->x - point.x) / model.unit).cwiseMax(shape.x_lower).cwiseMin(shape.x_upper);
        const CentralPoint near{
            {form.to_model(u), form.model_multipliers(near_->row_multipliers / model.cost_unit)},
            near_->mu / cost_unit,
            near_->gap};
        InteriorPointLimits few = limits;
        few.max_iterations = std::min(limits.max_iterations, most_from_near_gap);
        solved = interior_point(form.model(), near, few, control_);
        iterations_ += solved.iterations;
    }
    if (solved.stop != Stop::converged) {
        const VectorXd start = VectorXd::Zero(linearized.shape().variables());
        solved = interior_point(form.model(), form.to_model(start), limits, control_);
        iterations_ += solved.iterations;
    }
    near_.reset();
    for (const CentralPoint& place : solved.path) {
        if (near_ && place.gap < near_gap) break;
        const VectorXd lambda = form.row_multipliers(place.point.lambda, form.cost_scale());
        near_ = PathPoint{point.x + linearized.step_of(form.to_problem(place.point.x)),
                          linearized.multipliers_of(lambda), place.mu * cost_unit, place.gap};
    }
    return solved;
}

Step StepSolver::solve(const NlpPoint& point, const StepModel& model) {
    const LinearizedProblem linearized(problem_, point, model);
    const VectorXd start = VectorXd::Zero(linearized.shape().variables());
    const StandardForm form(linearized, start);
    Step result;
    if (form.status() != StandardForm::Status::ready) return result;
    InteriorPointLimits limits = limits_;
    limits.suspicious =
        model.penalty == 0.0;  // with elastic rows and a bounded step an optimum always exists
    if (model.sharp) {
        limits.tolerance = std::max(sharp_part * limits.tolerance, sharpest);
        limits.patience = std::min(limits.patience, sharp_patience);
    }
    const InteriorPointResult solved = solve_form(linearized, form, point, model, limits);
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

Step StepSolver::solve_held(const RowMatrix& jacobian, const StepModel& model,
                            const VectorXd& multipliers) const {
    Step result;
    auto found = ActiveSetStep(problem_.shape(), jacobian, model, limits_.tolerance).solve(multipliers);
    result.usable = found.has_value();
    if (!found) return result;
    result.stop = Stop::converged;
    result.step = std::move(found->step);
    result.multipliers = std::move(found->multipliers);
    return result;
}

StepSolver::Steered StepSolver::solve_elastic(const NlpPoint& point, StepModel& model, double violation) {
    Steered result{solve(point, model), {}, violation};
    if (!result.step.usable || result.step.elastic <= kept) return result;
    if (result.step.elastic <= half_way * violation) {
        // Relaxed rows carry all of ν: the next step gets a larger one, and this one need not wait for it.
        model.penalty = std::min(penalty_growth * model.penalty, largest_penalty);
        result.least_elastic = 0.0;
        return result;
    }
    StepModel feasibility = model;
    feasibility.slope.setZero();
    feasibility.curvature.setZero();
    feasibility.penalty = 1.0;
    feasibility.cost_unit = 1.0;
    const Step least = solve(point, feasibility);
    if (!least.usable) {
        result.least_elastic = 0.0;  // it is not known: nothing is said of it
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

using Eigen::Index;

StepModel SequentialRun::step_model() const {
    StepModel model;
    model.slope = here_.gradient + hessian_.slope;
    model.curvature = hessian_.lower;
    model.rows = here_.rows;
    model.step_lower = (shape_.x_lower - here_.x).cwiseMax(-radius_ * reach_);
    model.step_upper = (shape_.x_upper - here_.x).cwiseMin(radius_ * reach_);
    model.weights = weights_;
    model.elastic_base = violation(here_);
    model.cost_unit = cost_size();
    model.unit = std::min(1.0, radius_);
    model.sharp = polishing_ > 0;
    if (model.sharp)
        model.unit = std::clamp(unit_lengths * last_length_, std::min(least_unit, model.unit), model.unit);
    return model;
}

/// Near the solution, where the rows that hold the step are known. With ν above what its multipliers require
/// it is the step of the relaxed rows too.
Step SequentialRun::held_step(const StepModel& model) {
    Step step;
    if (warm_ || (last_length_ <= near_by && !saturated_ && !multipliers_.isZero()))
        step = steps_.solve_held(jacobian_, model, multipliers_);
    if (!step.usable && !warm_ && near_known())
        step = steps_.solve_held(jacobian_, model, known_multipliers_);
    warm_ = warm_ && step.usable;
    return step;
}

Step SequentialRun::next_step(StepModel& model) {
    least_elastic_ = 0.0;
    if (Step held = held_step(model); held.usable) {
        model.penalty = 0.0;
        relaxed_ = false;
        return held;
    }
    if (!relaxed_) {
        model.penalty = 0.0;
        Step step = steps_.solve(here_, model);
        if (!step.usable && !step.stopped() && model.sharp) {
            model.sharp = false;
            model.unit = std::min(1.0, radius_);
            step = steps_.solve(here_, model);
        }
        if (step.usable || step.stopped()) return step;
        relaxed_ = true;
        patience_ = elastic_passes;
    }
    model.penalty = penalty_;
    const double before = violation(here_);
    StepSolver::Steered steered = steps_.solve_elastic(here_, model, before);
    penalty_ = model.penalty;
    if (!steered.step.usable) return steered.step;
    const bool free = steered.step.elastic <= free_elastic;
    least_elastic_ = free ? 0.0 : steered.least_elastic;
    least_multipliers_ = steered.least_multipliers;
    relaxed_ = !free || --patience_ > 0;
    return steered.step;
}

/// Of the cost, to second order along curved rows.
double SequentialRun::slope_change(const VectorXd& step) const {
    const VectorXd image = true_hessian_.selfadjointView<Eigen::Lower>() * step;
    return here_.gradient.dot(step) + 0.5 * step.dot(image);
}

/// ν follows the multipliers of steps that satisfy the rows; elastic steps have determined theirs already.
void SequentialRun::adapt_penalty(const StepModel& model, const Step& step) {
    const double needed = needed_penalty(shape_, step.multipliers);
    const bool too_large = penalty_ > penalty_excess * needed && reductions_ < most_reductions;
    if (model.penalty == 0.0 && (penalty_ < 1.1 * needed || too_large)) {
        penalty_ = penalty_for(needed);
        reductions_ += too_large ? 1 : 0;
    }
    const double change = slope_change(step.step), reduction = violation(here_) - step.elastic;
    if (reduction > 0.0 && change > 0.0) penalty_ = std::max(penalty_, 2.0 * change / reduction);
}

VectorXd SequentialRun::corrected_rows(const NlpPoint& trial, const VectorXd& step) const {
    VectorXd rows = trial.rows - jacobian_ * step;
    for (Index i = 0; i < rows.size(); ++i)
        if (kind_of(shape_, i).linear) rows[i] = here_.rows[i];
    return rows;
}

/// Tries the step, with second-order corrections for the rows' curvature; true: accepted.
bool SequentialRun::take(const StepModel& model, Step step) {
    constexpr double accept = 1e-4, poor = 0.25, good = 0.75;
    adapt_penalty(model, step);
    const double before = merit(here_);
    const double noise = step_rounding * (cost_size() + penalty_);
    const double predicted = penalty_ * (violation(here_) - step.elastic) - slope_change(step.step) + noise;
    const auto ratio = [&](const NlpPoint& point) {
        if (!std::isfinite(point.cost) || !point.rows.allFinite()) return -infinity;
        return (before - merit(point) + noise) / std::max(predicted, noise);
    };
    NlpPoint trial = moved(step.step);
    double gained = ratio(trial);
    for (int k = 0; k < most_corrections; ++k) {
        if (!(gained < good) || !std::isfinite(gained) || violation(trial) <= step.elastic + step_rounding)
            break;
        StepModel again = model;
        again.rows = corrected_rows(trial, step.step);
        Step corrected = steps_.solve(here_, again);
        if (!corrected.usable) break;
        NlpPoint other = moved(corrected.step);
        const double value = ratio(other);
        if (!(value > gained)) break;
        trial = std::move(other);
        step = std::move(corrected);
        gained = value;
    }
    const double length = step.step.cwiseAbs().cwiseQuotient(reach_).maxCoeff();
    if (repairing_ && std::isfinite(gained)) gained = 1.0;
    repairing_ = false;
    if (gained > accept) {
        differentiate(problem_, trial);
        if (!trial.finite()) gained = -infinity;
    }
    spoiled_ = gained == -infinity;
    // The last digits are below the round-off of the merit function.
    const bool polishing = flat_ && !spoiled_ && merit(trial) - before <= options_.tolerance * cost_size();
    if (polishing && gained <= accept) {
        differentiate(problem_, trial);
        gained = trial.finite() ? 1.0 : -infinity;
    }
    if (gained > accept) {
        here_ = std::move(trial);
        multipliers_ = step.multipliers;
        saturated_ = saturates(step);
        last_length_ = length;
        fresh_ = true;
        if (gained > good && length > 0.9 * radius_) radius_ *= shrunk_ ? 1.5 : 4.0;
        shrunk_ = false;
        if (gained < poor) radius_ = std::min(radius_, 0.5 * length);
    } else {
        radius_ = 0.25 * std::min(radius_, length);
        shrunk_ = true;
    }
    return gained > accept;
}

}  // namespace camopt::structured
