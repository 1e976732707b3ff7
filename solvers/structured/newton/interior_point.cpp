// SPDX-License-Identifier: MIT
#include "solvers/structured/interior_point.hpp"

#include "solvers/structured/linearized_problem.hpp"
#include "solvers/structured/newton/newton_step.hpp"
#include "solvers/structured/newton/path_reduction.hpp"

#include <cstddef>
#include <utility>

namespace camopt::structured {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

class Iteration {
 public:
    Iteration(const ConvexModel& model, const InteriorPointLimits& limits)
        : model_(model), limits_(limits), ranges_(model), newton_(model, ranges_, limits) {
        for (Direction* direction : {&affine_, &direction_, &trial_})
            direction->resize(model.variables(), ranges_);
        change_.setZero(ranges_.sides());
    }

    InteriorPointResult run(const VectorXd& start, const SolveControl& control) {
        return initialise(start) ? run(control) : not_evaluated();
    }
    InteriorPointResult run(const CentralPoint& near, const SolveControl& control) {
        return resume(near) ? run(control) : not_evaluated();
    }

 private:
    static InteriorPointResult not_evaluated() {
        InteriorPointResult result;
        result.stop = Stop::evaluation_error;
        return result;
    }
    InteriorPointResult run(const SolveControl& control);
    InteriorPointResult search(const SolveControl& control);
    bool initialise(const VectorXd& start);
    bool resume(const CentralPoint& near);
    void keep_place(const Errors& now, std::vector<CentralPoint>& path) const;
    void push_inside(const VectorXd& start);
    [[nodiscard]] Errors errors() const;
    bool take_step(Stop& reason);
    bool take_smooth_step(double target, Stop& reason);
    void add_correctors(double target);
    void polish_multipliers(InteriorPointResult& result);
    [[nodiscard]] double target_after_affine() const;
    [[nodiscard]] double merit(const Residuals& rest, const Iterate& point) const;
    [[nodiscard]] bool looks_infeasible() const;
    [[nodiscard]] bool looks_unbounded() const;
    /// The change that moves every product g z to the target.
    void aim_at(double target) { change_ = target * ranges_.present - point_.gap.cwiseProduct(point_.dual); }
    [[nodiscard]] double boundary_fraction() const { return std::clamp(1.0 - 10.0 * rest_.mu, 0.99, 0.9995); }
    [[nodiscard]] double primal_step(const Direction& direction, double fraction) const {
        return step_to_boundary(newton_.inverse_gap(), direction.gap, fraction);
    }
    [[nodiscard]] double dual_step(const Direction& direction, double fraction) const {
        return step_to_boundary(newton_.inverse_dual(), direction.dual, fraction);
    }

    const ConvexModel& model_;
    const InteriorPointLimits& limits_;
    RangeRows ranges_;
    NewtonStep newton_;
    Iterate point_, tried_, best_;
    Residuals rest_, tried_rest_;
    Direction affine_, direction_, trial_;
    VectorXd change_;  ///< of the products g z
};

/// The start, moved off the active bounds of the variables.
void Iteration::push_inside(const VectorXd& start) {
    constexpr double far = 1e3, away = 1.0;  // scaled problem: everything is of order 1
    point_.x = start.unaryExpr([&](double v) { return std::isfinite(v) ? std::clamp(v, -far, far) : 0.0; });
    for (Index j = 0; j < model_.variables(); ++j) {
        const double low = model_.x_lower[j], high = model_.x_upper[j];
        const double margin = std::min(away, 0.25 * (high - low));
        if (std::isfinite(low)) point_.x[j] = std::max(point_.x[j], low + margin);
        if (std::isfinite(high)) point_.x[j] = std::min(point_.x[j], high - margin);
    }
}

/// One least-squares step from the given start, then gaps and multipliers shifted away from zero.
bool Iteration::initialise(const VectorXd& start) {
    // Measured: closer starts save linear problems one iteration in fifteen, but cost curved ones some.
    const double away = model_.kind == CostKind::linear ? 0.1 : 1.0;
    push_inside(start);
    point_.lambda = VectorXd::Zero(ranges_.equal_to.size());
    point_.gap = VectorXd::Ones(ranges_.sides());
    point_.dual = ranges_.present;
    bool finite = true;
    if (!newton_.prepare(point_, finite)) return finite;
    newton_.residuals(point_, rest_);
    if (!rest_.dual.allFinite()) return false;
    rest_.dual = rest_.gradient;
    const VectorXd beyond = rest_.bound + point_.gap.cwiseProduct(ranges_.present);
    rest_.bound = beyond.cwiseMin(0.0);  // how far the start is beyond each bound
    change_.setZero();
    newton_.direction(point_, &rest_, change_, direction_);
    const bool smooth = model_.kind == CostKind::smooth;
    if (direction_.finite) {
        if (!smooth) point_.x += direction_.x;
        point_.lambda += direction_.lambda;
    }
    newton_.residuals(point_, rest_);
    for (Index b = 0; b < ranges_.sides(); ++b) {
        if (ranges_.present[b] == 0.0) continue;
        const bool of_variable = ranges_.source[static_cast<std::size_t>(b)].row < 0;
        point_.gap[b] = std::max(rest_.bound[b] + point_.gap[b], smooth && of_variable ? 0.0 : away);
        point_.dual[b] = direction_.finite ? std::max(direction_.dual[b], away) : away;
    }
    return true;
}

/// Warm start near a point of the central path. Bounds that are new, or that the point violates now, get the
/// gap and multiplier for its barrier parameter.
bool Iteration::resume(const CentralPoint& near) {
    // Of a new bound: sizes are of order 1. Products may differ from the path by this factor.
    constexpr double new_multiplier = 0.1, off_path = 10.0;
    point_.x = near.point.x;
    point_.lambda.resize(ranges_.equal_to.size());
    for (std::size_t k = 0; k < ranges_.equalities.size(); ++k)
        point_.lambda[static_cast<Index>(k)] = near.point.lambda[ranges_.equalities[k]];
    point_.gap.setZero(ranges_.sides());
    point_.dual.setZero(ranges_.sides());
    newton_.residuals(point_, rest_);
    if (!rest_.bound.allFinite()) return false;
    for (Index b = 0; b < ranges_.sides(); ++b) {
        point_.gap[b] = 1.0;
        if (ranges_.present[b] == 0.0) continue;
        const RangeRows::Source& from = ranges_.source[static_cast<std::size_t>(b)];
        const double known = from.row < 0 ? 0.0 : -from.sign * near.point.lambda[from.row];
        point_.gap[b] = std::max(rest_.bound[b], near.mu / std::max(known, new_multiplier));
        const double on_path = near.mu / point_.gap[b];
        point_.dual[b] = std::clamp(known, on_path / off_path, on_path * off_path);
    }
    return true;
}

Errors Iteration::errors() const {
    const double size = std::max(model_.cost_unit, std::abs(model_.cost->value(point_.x)));
    return {std::max(largest(rest_.equality), largest(rest_.bound)) / (1.0 + largest(point_.x)),
            largest(rest_.dual) / (model_.cost_unit + largest(rest_.gradient)),
            static_cast<double>(ranges_.sides_present) * rest_.mu / size};
}

bool Iteration::looks_infeasible() const {
    const double value = point_.dual.dot(ranges_.limit) - point_.lambda.dot(ranges_.equal_to);
    if (value <= 0.0) return false;
    double rest = 0.0;
    for (Index j = 0; j < rest_.dual.size(); ++j)
        rest = std::max(rest, std::abs(rest_.dual[j] - rest_.gradient[j]));
    return rest * (1.0 + largest(point_.x)) < 1e-3 * value && errors().primal > 1e3 * limits_.tolerance;
}

bool Iteration::looks_unbounded() const {
    const double size = largest(point_.x);
    return size > 1e7 && rest_.gradient.dot(point_.x) < -1e-6 * size &&
           errors().dual > 1e3 * limits_.tolerance;
}

/// Mehrotra's choice: the better the affine direction, the smaller the centering parameter.
double Iteration::target_after_affine() const {
    const double primal = primal_step(affine_, 1.0), dual = dual_step(affine_, 1.0);
    const double total =
        ((point_.gap + primal * affine_.gap).array() * (point_.dual + dual * affine_.dual).array()).sum();
    const double reached = total / static_cast<double>(std::max<Index>(1, ranges_.sides_present));
    const double ratio = rest_.mu > 0.0 ? std::clamp(reached / rest_.mu, 0.0, 1.0) : 0.0;
    return std::max(ratio * ratio * ratio, 1e-6) * rest_.mu;
}

/// Gondzio's centrality corrections, as long as they lengthen the step.
void Iteration::add_correctors(double target) {
    constexpr double low = 0.1, high = 10.0, reach = 0.3, worthwhile_gain = 0.02, long_enough = 0.95;
    const double fraction = boundary_fraction();
    double primal = primal_step(direction_, fraction), dual = dual_step(direction_, fraction);
    for (int k = 0; k < limits_.correctors && std::min(primal, dual) < long_enough; ++k) {
        const double far_primal = std::min(1.0, primal + reach), far_dual = std::min(1.0, dual + reach);
        change_ =
            (point_.gap + far_primal * direction_.gap).cwiseProduct(point_.dual + far_dual * direction_.dual);
        change_ = ranges_.present.cwiseProduct(
            (change_.cwiseMax(low * target).cwiseMin(high * target) - change_).cwiseMax(-high * target));
        newton_.direction(point_, nullptr, change_, trial_);
        if (!trial_.finite) return;
        trial_ += direction_;
        const double trial_primal = primal_step(trial_, fraction), trial_dual = dual_step(trial_, fraction);
        if (trial_primal + trial_dual < primal + dual + worthwhile_gain) return;
        std::swap(direction_, trial_);
        primal = trial_primal;
        dual = trial_dual;
    }
}

bool Iteration::take_step(Stop& reason) {
    bool finite = true;
    if (!newton_.prepare(point_, finite)) {
        reason = finite ? Stop::breakdown : Stop::evaluation_error;
        return false;
    }
    change_ = -point_.gap.cwiseProduct(point_.dual);
    newton_.direction(point_, &rest_, change_, affine_);
    if (!affine_.finite) {
        reason = Stop::breakdown;
        return false;
    }
    const double target = target_after_affine();
    aim_at(target);
    change_ -= affine_.gap.cwiseProduct(affine_.dual);
    newton_.direction(point_, &rest_, change_, direction_);
    if (!direction_.finite) std::swap(direction_, affine_);
    add_correctors(target);
    if (model_.kind == CostKind::smooth) return take_smooth_step(std::max(target, 0.1 * rest_.mu), reason);

    const double fraction = boundary_fraction();
    double primal = primal_step(direction_, fraction), dual = dual_step(direction_, fraction);
    if (model_.kind == CostKind::quadratic) primal = dual = std::min(primal, dual);
    advance(point_, direction_, primal, dual);
    newton_.residuals(point_, rest_);
    if (rest_.finite()) return true;
    reason = Stop::evaluation_error;
    return false;
}

/// The residual of the dual equations, removed by the multipliers alone: in a proof it is multiplied by the
/// size of the box that contains an optimum.
void Iteration::polish_multipliers(InteriorPointResult& result) {
    constexpr int most = 2;
    constexpr double rounding = 1e-15, most_shrunk = 0.9;
    for (int k = 0; k < most && result.errors.dual > rounding; ++k) {
        // Linear costs: any factorization removes it, also that of the last step.
        bool finite = true;
        if (model_.kind != CostKind::linear && !newton_.prepare(point_, finite)) return;
        tried_rest_ = rest_;
        tried_rest_.equality.setZero();
        tried_rest_.bound.setZero();
        tried_rest_.mu = 0.0;
        change_.setZero();
        newton_.direction(point_, &tried_rest_, change_, direction_);
        if (!direction_.finite) return;
        point_.lambda += direction_.lambda;
        point_.dual += direction_.dual.cwiseMax(-most_shrunk * point_.dual);
        newton_.residuals(point_, rest_);
        const Errors now = errors();
        if (!(now.dual < result.errors.dual) || now.worst() > limits_.tolerance) return;
        best_ = point_;
        result.errors = now;
    }
}

double Iteration::merit(const Residuals& rest, const Iterate& point) const {
    return std::sqrt(rest.dual.squaredNorm() + rest.equality.squaredNorm() + rest.bound.squaredNorm() +
                     point.gap.cwiseProduct(point.dual).squaredNorm());
}

/// Backtracking on the norm of all residuals: first along the corrected direction, then along the plain
/// Newton direction, for which a decrease is guaranteed.
bool Iteration::take_smooth_step(double target, Stop& reason) {
    constexpr double shrink = 0.6, decrease = 1e-3;
    bool evaluated = false;
    for (int attempt = 0; attempt < 2; ++attempt) {
        if (attempt == 1) {
            aim_at(target);
            newton_.direction(point_, &rest_, change_, direction_);
        }
        if (!direction_.finite) continue;
        const double fraction = boundary_fraction();
        double step = std::min(primal_step(direction_, fraction), dual_step(direction_, fraction));
        const double before = merit(rest_, point_);
        for (int k = 0; k < (attempt == 0 ? 4 : 40); ++k, step *= shrink) {
            tried_ = point_;
            advance(tried_, direction_, step, step);
            newton_.residuals(tried_, tried_rest_);
            if (!tried_rest_.finite()) continue;
            evaluated = true;
            if (merit(tried_rest_, tried_) > (1.0 - decrease * step) * before) continue;
            std::swap(point_, tried_);
            std::swap(rest_, tried_rest_);
            return true;
        }
    }
    reason = evaluated ? Stop::breakdown : Stop::evaluation_error;
    return false;
}

/// Stores the point when the gap has decreased by a factor since the last one stored.
void Iteration::keep_place(const Errors& now, std::vector<CentralPoint>& path) const {
    constexpr double first = 1.0, closer = 0.5, last = 1e-9;
    const double before = path.empty() ? 2.0 * first : path.back().gap;
    if (now.gap > closer * before || now.gap < last || now.primal > now.gap) return;
    path.push_back({{point_.x, ranges_.row_multipliers(point_.lambda, point_.dual)}, rest_.mu, now.gap});
}

InteriorPointResult Iteration::run(const SolveControl& control) {
    InteriorPointResult result = search(control);
    if (result.has_point()) result.best = {best_.x, ranges_.row_multipliers(best_.lambda, best_.dual)};
    return result;
}

InteriorPointResult Iteration::search(const SolveControl& control) {
    InteriorPointResult result;
    newton_.residuals(point_, rest_);
    if (!rest_.finite() || !std::isfinite(model_.cost->value(point_.x))) {
        result.stop = Stop::evaluation_error;
        return result;
    }
    int since_best = 0;
    for (;;) {
        const Errors now = errors();
        since_best = now.worst() < 0.9 * result.errors.worst() ? 0 : since_best + 1;
        if (now.worst() < result.errors.worst() || result.iterations == 0) {
            best_ = point_;
            result.errors = now;
        }
        if (limits_.keep_path) keep_place(now, result.path);
        if (result.errors.worst() <= limits_.tolerance) {
            result.stop = Stop::converged;
            polish_multipliers(result);
        } else if (since_best > limits_.patience)
            result.stop = Stop::stagnated;
        else if (result.iterations >= limits_.max_iterations)
            result.stop = Stop::iteration_limit;
        else if (control.stopped())
            result.stop = Stop::interrupted;
        else if (limits_.deadline.passed())
            result.stop = Stop::time_limit;
        else if (limits_.suspicious && looks_infeasible())
            result.stop = Stop::suspect_infeasible;
        else if (limits_.suspicious && looks_unbounded())
            result.stop = Stop::suspect_unbounded;
        else if (take_step(result.stop)) {
            ++result.iterations;
            continue;
        }
        return result;
    }
}

}  // namespace

namespace {

/// Converts the result of the smaller model to the given one.
InteriorPointResult restored(InteriorPointResult result, const PathReduction& reduction) {
    const auto restore = [&](PrimalDualPoint& point) {
        point = {reduction.restored(point.x), reduction.restored_multipliers(point.lambda)};
    };
    if (result.has_point()) restore(result.best);
    for (CentralPoint& place : result.path) restore(place.point);
    return result;
}

}  // namespace

InteriorPointResult interior_point(const ConvexModel& model, const VectorXd& start,
                                   const InteriorPointLimits& limits, const SolveControl& control) {
    const PathReduction reduction(model, start);
    return restored(Iteration(reduction.model(), limits).run(reduction.reduced(start), control), reduction);
}

InteriorPointResult interior_point(const ConvexModel& model, const CentralPoint& near,
                                   const InteriorPointLimits& limits, const SolveControl& control) {
    const PathReduction reduction(model, near.point.x);
    CentralPoint begin = near;
    begin.point = {reduction.reduced(near.point.x), reduction.reduced_multipliers(near.point.lambda)};
    return restored(Iteration(reduction.model(), limits).run(begin, control), reduction);
}

}  // namespace camopt::structured
