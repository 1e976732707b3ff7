// SPDX-License-Identifier: MIT
#include "solvers/structured/sequential_solver.hpp"

#include <fmt/core.h>

namespace camopt::structured {

namespace {

constexpr double least_radius = 1e-13;
constexpr double largest_size = 1e10;   // of a variable: beyond it the iteration diverges
constexpr double linear_reach = 100.0;  // how much further linear variables may move
constexpr double proximal = 1e-8;       // multiple of I in H, of the size of the gradient
constexpr double loose = 0.1;           // part of the last step: a row that far from its bound is not active
constexpr double left = 1e-3;           // of the step's length: from there on it has left a row
constexpr int most_polishing = 6;       // passes
constexpr double polished = 1e-3;       // of the tolerance: stationarity that no pass can improve
constexpr double stationary = 1e-6;     // threshold for Termination::converged
constexpr double nearly_kept = 1e3;     // tolerances of violation that further passes remove
constexpr int slow_passes = 25;         // in which the violation must fall by a tenth
constexpr int most_failures = 8;        // step problems in a row that failed
constexpr double stationary_violation = 1e-7;
constexpr double off = 0.1;            // of the tolerance: linear rows that must be restored first
constexpr double nudge = 0.01;         // of the size of a variable
constexpr double slightly_off = 0.05;  // violation of linear rows that the first step of a warm start repairs
constexpr double near_known_point = 0.1;  // relative distance at which the same rows may be active

}  // namespace

using Eigen::Index;
using Eigen::VectorXd;

SequentialRun::SequentialRun(const Nlp& problem, const BackendOptions& options, const SolveControl& control)
    : problem_(problem),
      shape_(problem.shape()),
      options_(options),
      control_(control),
      guard_(options, control),
      steps_(problem, interior_point_limits(options, structured_options(options.native), control), control),
      weights_(VectorXd::Ones(shape_.constraints())),
      curved_(curved_variables(shape_)),
      jacobian_pattern_(shape_.constraints(), shape_.variables(), shape_.jacobian),
      hessian_pattern_(shape_.variables(), shape_.variables(), shape_.hessian, true),
      multipliers_(VectorXd::Zero(shape_.constraints())) {
    const StructuredOptions own = structured_options(options.native);
    most_passes_ = std::min(own.max_passes, options.max_iterations);
    radius_ = own.first_radius;
    for (Index i = 0; i < weights_.size(); ++i) weights_[i] = kind_of(shape_, i).scale;
    if (options.near && options.near->row_multipliers.size() <= multipliers_.size()) {
        known_multipliers_ = VectorXd::Zero(shape_.constraints());
        known_multipliers_.head(options.near->row_multipliers.size()) = options.near->row_multipliers;
    }
}

bool SequentialRun::near_known() const {
    if (known_multipliers_.size() == 0) return false;
    const VectorXd& known = options_.near->x;
    if (known.size() != here_.x.size()) return false;
    return ((here_.x - known).array().abs() <= near_known_point * known.array().abs().max(1.0)).all();
}

NlpPoint SequentialRun::moved(const VectorXd& step) const {
    return evaluated(problem_, (here_.x + step).cwiseMax(shape_.x_lower).cwiseMin(shape_.x_upper));
}

/// At the solution of a neighbouring problem its multipliers are those of this one, nearly.
void SequentialRun::take_multipliers() {
    if (!near_known()) return;
    warm_ = true;
    multipliers_ = known_multipliers_;
    relaxed_ = false;
    penalty_ = penalty_for(needed_penalty(shape_, multipliers_));
}

/// A first point that satisfies the linear rows and the bounds: all later ones then do.
std::optional<BackendResult> SequentialRun::begin(const VectorXd& start) {
    here_ = evaluated(problem_, start.cwiseMax(shape_.x_lower).cwiseMin(shape_.x_upper));
    const double outside = violation_of(shape_, here_.rows, true);
    if (passes_ == 0) take_multipliers();
    repairing_ = warm_ && outside > off * options_.tolerance && outside <= slightly_off;
    if (!repairing_ && outside > off * options_.tolerance) {
        differentiate(problem_, here_);
        const StepModel model = projection_model(problem_, here_);
        const LinearizedProblem projection(problem_, here_, model);
        BackendOptions options = options_;
        options.max_seconds = guard_.seconds_left();
        const BackendResult found =
            linear_rows_minimize(projection, VectorXd::Zero(shape_.variables()), options, control_);
        if (found.termination != Termination::converged && found.termination != Termination::acceptable) {
            BackendResult result = found;
            result.native_status = "linear rows: " + found.native_status;
            result.x = found.x.size() > 0 ? VectorXd(here_.x + found.x) : here_.x;
            return result;
        }
        here_ = moved(found.x);
    }
    differentiate(problem_, here_);
    fresh_ = true;
    if (!here_.finite())
        return ended(Termination::evaluation_error, "the start gives values that are not finite");
    return std::nullopt;
}

void SequentialRun::linearize() {
    jacobian_ = jacobian_pattern_.filled(here_.jacobian);
    // Multipliers of relaxed rows grow with ν: their curvature would shorten the steps that satisfy the rows.
    const VectorXd curving = saturated_ ? VectorXd::Zero(shape_.constraints()) : multipliers_;
    true_hessian_ = hessian_pattern_.filled(lagrangian_hessian(problem_, here_.x, curving));
    active_ = Stationarity{shape_, here_, jacobian_, multipliers_}.active_rows(loose * last_length_);
    convexify();
    reach_.resize(shape_.variables());
    for (Index j = 0; j < reach_.size(); ++j)
        reach_[j] =
            std::max(1.0, std::abs(here_.x[j])) * (curved_[static_cast<std::size_t>(j)] ? 1.0 : linear_reach);
    fresh_ = false;
}

void SequentialRun::convexify() {
    const double size = here_.gradient.size() > 0 ? here_.gradient.cwiseAbs().maxCoeff() : 0.0;
    hessian_ = convexifier_.convexified(true_hessian_, active_, proximal * std::max(size, 1e-8));
}

/// Rows to which the convexified Hessian confines the step, but which the step leaves, were not active:
/// without them the step is as long as the problem allows. True: there were some, and the Hessian changed.
bool SequentialRun::drop_left_rows(const Step& step) {
    if (!hessian_.holds) return false;
    const VectorXd distance = active_.normals * step.step + active_.residuals;
    const double least = left * step.step.norm();
    ActiveRows kept = active_.part([&](Index row) { return std::abs(distance[row]) <= least; });
    if (kept.residuals.size() == active_.residuals.size()) return false;
    active_ = std::move(kept);
    convexify();
    return true;
}

/// Tangents of convex rows that contradict each other, with the linear rows, prove infeasibility.
std::optional<BackendResult> SequentialRun::contradiction() {
    StepModel model = step_model();
    model.slope.setZero();
    model.curvature.setZero();
    model.step_lower = shape_.x_lower - here_.x;
    model.step_upper = shape_.x_upper - here_.x;
    model.unit = model.cost_unit = 1.0;
    const LinearizedProblem tangents(problem_, here_, model);
    BackendOptions options = options_;
    options.max_seconds = guard_.seconds_left();
    BackendResult found =
        linear_rows_minimize(tangents, VectorXd::Zero(shape_.variables()), options, control_);
    if (found.termination != Termination::infeasible) return std::nullopt;
    BackendResult result =
        ended(Termination::infeasible, "tangents of the rows contradict: " + found.native_status);
    result.row_multipliers = found.row_multipliers;
    result.bound_multipliers = found.bound_multipliers;
    return result;
}

/// No decrease, and the rows are satisfied. The last digits, above all those of the multipliers, take some
/// more passes: the best of them is delivered.
bool SequentialRun::settled(const Step& step) {
    flat_ = std::abs(slope_change(step.step)) <= options_.tolerance * cost_size();
    if (!flat_) polishing_ = 0;
    if (!flat_ || violation(here_) > nearly_kept * options_.tolerance) return false;
    if (!kept(here_) && ++polishing_ <= most_polishing) return false;
    const double now = std::max(
        Stationarity{shape_, here_, jacobian_, step.multipliers}.error() / cost_size(), violation(here_));
    const bool better = !best_ || now < 0.5 * best_->error;
    if (!best_ || now < best_->error) best_ = Best{here_, step.multipliers, now, kept(here_)};
    // Multipliers of a convex problem prove its bound: their error counts times the size of the box.
    const double enough = (shape_.convex ? polished : 1.0) * options_.tolerance;
    return now <= enough || (!better && polishing_ >= 2) || ++polishing_ > most_polishing;
}

BackendResult SequentialRun::finished() const {
    return best_->kept && best_->error <= stationary ? ended(Termination::converged, "converged")
                                                     : ended(Termination::acceptable, "no further progress");
}

/// No step reduces the linearized violation. By convexity a feasible point would then be distant: at least 1
/// / stationary_violation times the size of the point.
bool SequentialRun::stationary_in_violation(double least_elastic) const {
    const double now = violation(here_);
    return now - least_elastic <= stationary_violation * now * std::min(1.0, radius_);
}

BackendResult SequentialRun::infeasible() const {
    BackendResult result = ended(Termination::infeasible, "the least violation of convex rows is positive");
    result.row_multipliers = least_multipliers_ / violation(here_);
    result.bound_multipliers = bound_multipliers(shape_, jacobian_.transpose() * *result.row_multipliers);
    return result;
}

/// A start away from a stationary point of the violation, such as the center of a disc to be left.
VectorXd SequentialRun::nudged() const {
    VectorXd x = here_.x;
    for (Index j = 0; j < x.size(); ++j)
        if (curved_[static_cast<std::size_t>(j)])
            x[j] += nudge * std::max(1.0, std::abs(x[j])) * std::cos(2.4 * static_cast<double>(j) + 1.0);
    return x;
}

/// The violation is locally minimal, or decreases too slowly.
bool SequentialRun::hopeless(double least_elastic) {
    const double now = violation(here_);
    if (now <= 0.9 * marked_violation_) {
        marked_violation_ = now;
        marked_pass_ = passes_;
    }
    return stationary_in_violation(least_elastic) || passes_ - marked_pass_ > slow_passes;
}

std::optional<BackendResult> SequentialRun::pass() {
    if (fresh_) linearize();
    StepModel model = step_model();
    const bool flat = passes_ == 1 && multipliers_.isZero();
    Step step = next_step(model);
    if (flat && step.usable && !saturates(step) && !step.multipliers.isZero()) {
        // The first step had no multipliers, hence no curvature of the rows.
        multipliers_ = step.multipliers;
        linearize();
        model = step_model();
        step = next_step(model);
    }
    const bool joins = step.usable && control_.known && control_.known(here_.x + step.step);
    if (step.usable && !joins && (polishing_ == 0 || shape_.convex) && drop_left_rows(step)) {
        model = step_model();
        Step longer = next_step(model);
        if (longer.usable || longer.stopped()) step = std::move(longer);
    }
    if (step.stopped())
        return ended(step.stop == Stop::time_limit ? Termination::time_limit : Termination::interrupted,
                     "stopped");
    if (!step.usable) {
        if (best_) return finished();
        if (repairing_) {
            warm_ = false;
            return begin(here_.x);
        }
        radius_ *= 0.25;
        if (++failures_ > most_failures)
            return ended(Termination::numerical_failure, "no step could be computed");
        return std::nullopt;
    }
    failures_ = 0;
    if (settled(step)) return finished();
    const double before = violation(here_);
    if (least_elastic_ > options_.tolerance && before > options_.tolerance) {
        if (shape_.convex)
            if (auto proved = contradiction()) return proved;
        const bool over = hopeless(least_elastic_);
        if (over && shape_.convex && stationary_in_violation(least_elastic_)) return infeasible();
        if (over && !shape_.convex && !nudged_) {
            nudged_ = true;
            marked_violation_ = infinity;
            return begin(nudged());
        }
        if (over)
            return ended(Termination::numerical_failure,
                         "no feasible point found: the violation is locally minimal");
    }
    if (!take(model, std::move(step)) && best_ && polishing_ > 0) return finished();
    if (control_.known && control_.known(here_.x))
        return ended(Termination::acceptable, "near a known minimum");
    if (radius_ < least_radius) {
        if (spoiled_) return ended(Termination::evaluation_error, "no step leads to finite values");
        if (kept(here_)) return ended(Termination::acceptable, "the steps became too small");
        return ended(Termination::numerical_failure, "no feasible point found: the steps became too small");
    }
    if (here_.x.size() > 0 && here_.x.cwiseAbs().maxCoeff() > largest_size)
        return ended(Termination::unbounded, "the objective decreases without bound");
    return std::nullopt;
}

BackendResult SequentialRun::ended(Termination termination, std::string why) const {
    BackendResult result;
    result.termination = termination;
    result.iterations = passes_;
    const NlpPoint& point = best_ ? best_->point : here_;
    result.x = point.x;
    result.native_status = fmt::format("{}: {} passes, {} interior iterations, largest violation {:.1e}", why,
                                       passes_, steps_.interior_iterations(), violation(point));
    result.row_multipliers = best_ ? best_->multipliers : multipliers_;
    if (point.finite() && point.gradient.size() > 0) {
        const RowMatrix jacobian = jacobian_pattern_.filled(point.jacobian);
        result.bound_multipliers = bound_multipliers(
            shape_, Stationarity{shape_, point, jacobian, *result.row_multipliers}.lagrangian_gradient());
    } else {
        result.bound_multipliers = VectorXd::Zero(shape_.variables());
    }
    // Of no path: a neighbouring problem takes the multipliers alone, from this place, for any gap.
    if (options_.keep_path) result.path.push_back({point.x, *result.row_multipliers, 0.0, infinity});
    return result;
}

BackendResult SequentialRun::run(const VectorXd& start) {
    if (std::optional<BackendResult> refused = begin(start)) return *refused;
    for (;;) {
        if (guard_.must_stop()) {
            guard_.rethrow();
            return ended(*guard_.reason(), "stopped");
        }
        if (passes_ >= most_passes_) return ended(Termination::iteration_limit, "limit of passes");
        ++passes_;
        guard_.report(passes_, here_.cost, violation(here_));
        if (std::optional<BackendResult> end = pass()) return *end;
    }
}

BackendResult sequential_minimize(const Nlp& problem, const VectorXd& start, const BackendOptions& options,
                                  const SolveControl& control) {
    if (std::optional<BackendResult> crossed = result_of_crossed_bounds(problem)) {
        crossed->x = start;
        return *crossed;
    }
    return SequentialRun(problem, options, control).run(start);
}

}  // namespace camopt::structured
