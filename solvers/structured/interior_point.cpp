// SPDX-License-Identifier: MIT
#include "solvers/structured/interior_point.hpp"

#include "solvers/structured/newton_step.hpp"

#include <algorithm>
#include <cmath>

namespace camopt::structured {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

double largest(const VectorXd& v) {
    return v.size() > 0 ? v.cwiseAbs().maxCoeff() : 0.0;
}

class Iteration {
 public:
    Iteration(const ConvexModel& model, const InteriorPointLimits& limits)
        : model_(model), limits_(limits), mask_(model), newton_(model, mask_, limits.shift) {}

    InteriorPointResult run(const VectorXd& start, const SolveControl& control);

 private:
    bool initialise(const VectorXd& start);
    [[nodiscard]] Errors errors() const;
    bool take_step(Stop& reason);
    bool take_smooth_step(const ProductChange& plain, Direction direction, Stop& reason);
    void add_correctors(Direction& direction, double target);
    [[nodiscard]] double merit(const Residuals& rest, const Iterate& point, double target) const;
    [[nodiscard]] bool looks_infeasible() const;
    [[nodiscard]] bool looks_unbounded() const;
    [[nodiscard]] ProductChange towards(double target) const;
    [[nodiscard]] double boundary_fraction() const { return std::clamp(1.0 - 10.0 * rest_.mu, 0.99, 0.9995); }

    const ConvexModel& model_;
    const InteriorPointLimits& limits_;
    BoundMask mask_;
    NewtonStep newton_;
    Iterate point_;
    Residuals rest_;
};

ProductChange Iteration::towards(double target) const {
    return {mask_.lower * target - point_.lower_gap.cwiseProduct(point_.lower_dual),
            mask_.upper * target - point_.upper_gap.cwiseProduct(point_.upper_dual)};
}

/// One step of least squares from the given start, then distances and multipliers pushed away from zero.
bool Iteration::initialise(const VectorXd& start) {
    constexpr double far = 1e3, away = 1.0;  // scaled problem: everything is of order 1
    const Index n = model_.variables(), m = model_.constraints();
    VectorXd x = start.unaryExpr([&](double v) { return std::isfinite(v) ? std::clamp(v, -far, far) : 0.0; });
    for (Index j = 0; j < n; ++j) {
        const double low = model_.x_lower[j], high = model_.x_upper[j];
        const double margin = std::min(away, 0.25 * (high - low));
        if (std::isfinite(low)) x[j] = std::max(x[j], low + margin);
        if (std::isfinite(high)) x[j] = std::min(x[j], high - margin);
    }
    point_.w.resize(n + m);
    point_.w << x, (model_.rows * x).cwiseMax(model_.row_lower).cwiseMin(model_.row_upper);
    point_.lambda = VectorXd::Zero(m);
    point_.lower_gap = VectorXd::Ones(n + m);
    point_.upper_gap = point_.lower_gap;
    point_.lower_dual = mask_.lower;
    point_.upper_dual = mask_.upper;
    bool finite = true;
    if (!newton_.prepare(point_, finite)) return finite;
    rest_ = newton_.residuals(point_);
    if (!rest_.dual.allFinite()) return false;
    rest_.dual = rest_.gradient;
    rest_.lower.setZero();
    rest_.upper.setZero();
    const Direction first = newton_.direction(point_, &rest_, {VectorXd::Zero(n + m), VectorXd::Zero(n + m)});
    if (first.finite) {
        if (model_.kind != CostKind::smooth) point_.w.head(n) += first.w.head(n);
        point_.w.tail(m) = model_.rows * point_.w.head(n);
        for (Index i = 0; i < m; ++i) {
            if (mask_.equality[i] != 0.0) point_.w[n + i] = model_.row_lower[i];
            if (mask_.equality[i] != 0.0) point_.lambda[i] = first.lambda[i];
        }
    }
    for (Index i = 0; i < n + m; ++i) {
        const double least = model_.kind == CostKind::smooth && i < n ? 0.0 : away;
        const double guess = first.finite ? first.upper_dual[i] - first.lower_dual[i] : 0.0;
        if (mask_.lower[i] != 0.0) {
            point_.lower_gap[i] = std::max(point_.w[i] - mask_.lower_bound[i], least);
            point_.lower_dual[i] = std::max(-guess, away);
        }
        if (mask_.upper[i] != 0.0) {
            point_.upper_gap[i] = std::max(mask_.upper_bound[i] - point_.w[i], least);
            point_.upper_dual[i] = std::max(guess, away);
        }
    }
    for (Index i = 0; i < m; ++i)
        if (mask_.equality[i] == 0.0) point_.lambda[i] = point_.upper_dual[n + i] - point_.lower_dual[n + i];
    return true;
}

Errors Iteration::errors() const {
    const Index n = model_.variables();
    const VectorXd x = point_.w.head(n);
    const double size = std::max(model_.cost_unit, std::abs(model_.cost->value(x)));
    return {std::max({largest(rest_.row), largest(rest_.lower), largest(rest_.upper)}) / (1.0 + largest(x)),
            largest(rest_.dual) / (model_.cost_unit + largest(rest_.gradient)),
            mask_.count * rest_.mu / size};
}

bool Iteration::looks_infeasible() const {
    const Index n = model_.variables();
    double value = -mask_.upper_bound.dot(point_.upper_dual) + mask_.lower_bound.dot(point_.lower_dual);
    for (Index i = 0; i < model_.constraints(); ++i)
        if (mask_.equality[i] != 0.0) value -= point_.lambda[i] * model_.row_lower[i];
    const double rest = largest(rest_.dual - rest_.gradient);
    return value > 0.0 && rest * (1.0 + largest(point_.w.head(n))) < 1e-3 * value &&
           errors().primal > 1e3 * limits_.tolerance;
}

bool Iteration::looks_unbounded() const {
    const VectorXd x = point_.w.head(model_.variables());
    const double size = largest(x);
    return size > 1e7 && rest_.gradient.dot(x) < -1e-6 * size && errors().dual > 1e3 * limits_.tolerance;
}

void Iteration::add_correctors(Direction& direction, double target) {
    constexpr double low = 0.1, high = 10.0, reach = 0.3, worthwhile = 0.02;
    const double fraction = boundary_fraction();
    const auto steps = [&](const Direction& d) {
        return std::pair{std::min(step_to_boundary(point_.lower_gap, d.lower_gap, fraction),
                                  step_to_boundary(point_.upper_gap, d.upper_gap, fraction)),
                         std::min(step_to_boundary(point_.lower_dual, d.lower_dual, fraction),
                                  step_to_boundary(point_.upper_dual, d.upper_dual, fraction))};
    };
    auto [primal, dual] = steps(direction);
    for (int k = 0; k < limits_.correctors && std::min(primal, dual) < 0.95; ++k) {
        const double far_primal = std::min(1.0, primal + reach), far_dual = std::min(1.0, dual + reach);
        const auto wanted = [&](const VectorXd& mask, const VectorXd& gap, const VectorXd& dgap,
                                const VectorXd& z, const VectorXd& dz) {
            VectorXd change = VectorXd::Zero(gap.size());
            for (Index i = 0; i < gap.size(); ++i) {
                if (mask[i] == 0.0) continue;
                const double product = (gap[i] + far_primal * dgap[i]) * (z[i] + far_dual * dz[i]);
                change[i] =
                    std::max(std::clamp(product, low * target, high * target) - product, -high * target);
            }
            return change;
        };
        Direction trial = newton_.direction(point_, nullptr,
                                            {wanted(mask_.lower, point_.lower_gap, direction.lower_gap,
                                                    point_.lower_dual, direction.lower_dual),
                                             wanted(mask_.upper, point_.upper_gap, direction.upper_gap,
                                                    point_.upper_dual, direction.upper_dual)});
        if (!trial.finite) return;
        trial += direction;
        const auto [trial_primal, trial_dual] = steps(trial);
        if (trial_primal + trial_dual < primal + dual + worthwhile) return;
        direction = std::move(trial);
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
    const Direction affine = newton_.direction(point_, &rest_, towards(0.0));
    if (!affine.finite) {
        reason = Stop::breakdown;
        return false;
    }
    double primal = std::min(step_to_boundary(point_.lower_gap, affine.lower_gap, 1.0),
                             step_to_boundary(point_.upper_gap, affine.upper_gap, 1.0));
    double dual = std::min(step_to_boundary(point_.lower_dual, affine.lower_dual, 1.0),
                           step_to_boundary(point_.upper_dual, affine.upper_dual, 1.0));
    const double reached =
        ((point_.lower_gap + primal * affine.lower_gap).dot(point_.lower_dual + dual * affine.lower_dual) +
         (point_.upper_gap + primal * affine.upper_gap).dot(point_.upper_dual + dual * affine.upper_dual)) /
        std::max(1.0, mask_.count);
    const double ratio = rest_.mu > 0.0 ? std::clamp(reached / rest_.mu, 0.0, 1.0) : 0.0;
    const double target = std::max(ratio * ratio * ratio, 1e-6) * rest_.mu;

    const ProductChange plain = towards(target);
    const ProductChange corrected{plain.lower - affine.lower_gap.cwiseProduct(affine.lower_dual),
                                  plain.upper - affine.upper_gap.cwiseProduct(affine.upper_dual)};
    Direction direction = newton_.direction(point_, &rest_, corrected);
    if (!direction.finite) direction = affine;
    add_correctors(direction, target);
    if (model_.kind == CostKind::smooth)
        return take_smooth_step(towards(std::max(target, 0.1 * rest_.mu)), std::move(direction), reason);

    const double fraction = boundary_fraction();
    primal = std::min(step_to_boundary(point_.lower_gap, direction.lower_gap, fraction),
                      step_to_boundary(point_.upper_gap, direction.upper_gap, fraction));
    dual = std::min(step_to_boundary(point_.lower_dual, direction.lower_dual, fraction),
                    step_to_boundary(point_.upper_dual, direction.upper_dual, fraction));
    if (model_.kind == CostKind::quadratic) primal = dual = std::min(primal, dual);
    advance(point_, direction, primal, dual);
    rest_ = newton_.residuals(point_);
    if (rest_.finite()) return true;
    reason = Stop::evaluation_error;
    return false;
}

double Iteration::merit(const Residuals& rest, const Iterate& point, double target) const {
    const double products =
        (point.lower_gap.cwiseProduct(point.lower_dual) - mask_.lower * target).squaredNorm() +
        (point.upper_gap.cwiseProduct(point.upper_dual) - mask_.upper * target).squaredNorm();
    return std::sqrt(rest.dual.squaredNorm() + rest.row.squaredNorm() + rest.lower.squaredNorm() +
                     rest.upper.squaredNorm() + products);
}

/// Backtracking on the norm of all residuals: first along the corrected direction, then along the plain
/// Newton direction, for which a decrease is certain.
bool Iteration::take_smooth_step(const ProductChange& plain, Direction direction, Stop& reason) {
    constexpr double shrink = 0.6, decrease = 1e-3;
    bool evaluated = false;
    for (int attempt = 0; attempt < 2; ++attempt) {
        if (attempt == 1) direction = newton_.direction(point_, &rest_, plain);
        if (!direction.finite) continue;
        const double fraction = boundary_fraction();
        double step = std::min({step_to_boundary(point_.lower_gap, direction.lower_gap, fraction),
                                step_to_boundary(point_.upper_gap, direction.upper_gap, fraction),
                                step_to_boundary(point_.lower_dual, direction.lower_dual, fraction),
                                step_to_boundary(point_.upper_dual, direction.upper_dual, fraction)});
        const double before = merit(rest_, point_, 0.0);
        for (int k = 0; k < (attempt == 0 ? 4 : 40); ++k, step *= shrink) {
            Iterate trial = point_;
            advance(trial, direction, step, step);
            Residuals rest = newton_.residuals(trial);
            if (!rest.finite()) continue;
            evaluated = true;
            if (merit(rest, trial, 0.0) > (1.0 - decrease * step) * before) continue;
            point_ = std::move(trial);
            rest_ = std::move(rest);
            return true;
        }
    }
    reason = evaluated ? Stop::breakdown : Stop::evaluation_error;
    return false;
}

InteriorPointResult Iteration::run(const VectorXd& start, const SolveControl& control) {
    InteriorPointResult result;
    if (!initialise(start)) {
        result.stop = Stop::evaluation_error;
        return result;
    }
    rest_ = newton_.residuals(point_);
    if (!rest_.finite() || !std::isfinite(model_.cost->value(point_.w.head(model_.variables())))) {
        result.stop = Stop::evaluation_error;
        return result;
    }
    int since_best = 0;
    for (;;) {
        const Errors now = errors();
        since_best = now.worst() < 0.9 * result.errors.worst() ? 0 : since_best + 1;
        if (now.worst() < result.errors.worst() || result.iterations == 0) {
            result.best = point_;
            result.errors = now;
        }
        if (result.errors.worst() <= limits_.tolerance)
            result.stop = Stop::converged;
        else if (since_best > limits_.patience)
            result.stop = Stop::stagnated;
        else if (result.iterations >= limits_.max_iterations)
            result.stop = Stop::iteration_limit;
        else if (control.stopped())
            result.stop = Stop::interrupted;
        else if (std::chrono::steady_clock::now() >= limits_.deadline)
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

InteriorPointResult interior_point(const ConvexModel& model, const VectorXd& start,
                                   const InteriorPointLimits& limits, const SolveControl& control) {
    return Iteration(model, limits).run(start, control);
}

}  // namespace camopt::structured
