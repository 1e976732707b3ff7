// SPDX-License-Identifier: MIT
#include "solvers/structured/newton_step.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace camopt::structured {
namespace {

// A direction may leave this part of what is wrong, and need not be more exact than rounding allows; where
// the tolerance asks for the last digits, it must be more exact.
double inexactness(double tolerance) {
    return std::min(1e-3, 1e7 * tolerance);
}
double finest(double tolerance) {
    return std::min(1e-16, 1e-3 * tolerance);
}
// Relative residual above which a direction is not trusted.
constexpr double good_residual = 1e-8;
// The careful system pivots on free variables too, which the condensed one never does.
constexpr double careful_shift = 1e-9;

double largest(const Eigen::VectorXd& v) {
    double result = 0.0;
    for (Eigen::Index i = 0; i < v.size(); ++i) result = std::max(result, std::abs(v[i]));
    return result;
}

}  // namespace

using Eigen::Index;
using Eigen::VectorXd;

bool Residuals::finite() const {
    return dual.allFinite() && equality.allFinite() && bound.allFinite() && std::isfinite(mu);
}

void Direction::resize(const ConvexModel& model, const BoundList& bounds) {
    x.setZero(model.variables());
    lambda.setZero(model.constraints());
    gap.setZero(bounds.size());
    dual.setZero(bounds.size());
}

Direction& Direction::operator+=(const Direction& other) {
    x += other.x;
    lambda += other.lambda;
    gap += other.gap;
    dual += other.dual;
    finite = finite && other.finite;
    return *this;
}

NewtonStep::NewtonStep(const ConvexModel& model, const BoundList& bounds, const InteriorPointLimits& limits)
    : model_(model),
      bounds_(bounds),
      tolerance_(limits.tolerance),
      shift_(limits.shift),
      system_(model, limits.factor, limits.shift),
      hessian_(static_cast<std::size_t>(model.hessian.size())),
      inverse_gap_(bounds.size()),
      sigma_(model.variables()),
      d_(VectorXd::Zero(model.constraints())),
      force_x_(model.variables()),
      force_row_(model.constraints()),
      p_(model.variables()),
      q_(model.constraints()),
      image_(model.constraints()),
      solution_{VectorXd(model.variables()), VectorXd(model.constraints()), VectorXd(model.constraints())} {}

void NewtonStep::residuals(const Iterate& point, Residuals& out) {
    model_.cost->gradient(point.x, out.gradient);
    out.dual = out.gradient;
    system_.columns().add_product(1.0, point.lambda, out.dual);
    for (Index b = 0; b < bounds_.of_variables; ++b)
        out.dual[bounds_.of[b]] -= bounds_.sign[b] * point.dual[b];
    system_.rows().multiply(point.x, image_);
    out.equality.setZero(model_.constraints());
    for (const int i : bounds_.equalities) out.equality[i] = image_[i] - model_.row_lower[i];
    out.bound.resize(bounds_.size());
    bounds_.each(point.x, image_, [&](Index b, double t) {
        out.bound[b] = bounds_.sign[b] * (t - bounds_.value[b]) - point.gap[b];
    });
    out.mu = point.gap.dot(point.dual) / static_cast<double>(std::max<Index>(1, bounds_.size()));
}

bool NewtonStep::prepare(const Iterate& point, bool& finite) {
    model_.cost->hessian(point.x, hessian_);
    finite = std::all_of(hessian_.begin(), hessian_.end(), [](double v) { return std::isfinite(v); });
    if (!finite) return false;
    inverse_gap_ = point.gap.cwiseInverse();
    sigma_.setZero();
    d_.setZero();
    for (Index b = 0; b < bounds_.of_variables; ++b) sigma_[bounds_.of[b]] += point.dual[b] * inverse_gap_[b];
    for (Index b = bounds_.of_variables; b < bounds_.size(); ++b)
        d_[bounds_.of[b]] += point.dual[b] * inverse_gap_[b];
    for (Index i = 0; i < d_.size(); ++i)
        if (d_[i] > 0.0) d_[i] = 1.0 / d_[i];
    careful_is_current_ = false;
    return system_.factorize(hessian_, sigma_, d_) || prepare_careful();
}

bool NewtonStep::prepare_careful() {
    if (!careful_) careful_ = std::make_unique<KktSystem>(model_, std::max(shift_, careful_shift));
    careful_is_current_ = careful_->factorize(hessian_, sigma_, d_);
    return careful_is_current_;
}

/// solution_ from p_, q_.
void NewtonStep::solve(double goal) {
    CondensedSystem::Accuracy accuracy{infinity, false};
    if (!careful_is_current_) accuracy = system_.solve(p_, q_, goal, solution_);
    solved_ = std::isfinite(accuracy.residual);
    const double size = std::max(largest(p_), largest(q_));
    if (accuracy.reached || accuracy.residual <= good_residual * size) return;
    if (!careful_is_current_ && !prepare_careful()) return;
    const KktSystem::Step careful = careful_->solve(p_, q_);
    if (!careful.finite || careful.residual * size >= accuracy.residual) return;
    solution_.x = careful.x;
    solution_.lambda = careful.lambda;
    system_.rows().multiply(solution_.x, solution_.image);
    solved_ = true;
}

void NewtonStep::direction(const Iterate& point, const Residuals* residuals, const VectorXd& change,
                           Direction& out) {
    force_x_.setZero();
    force_row_.setZero();
    const auto force = [&](Index b) {
        const double rest = residuals != nullptr ? residuals->bound[b] : 0.0;
        return bounds_.sign[b] * (change[b] - point.dual[b] * rest) * inverse_gap_[b];
    };
    for (Index b = 0; b < bounds_.of_variables; ++b) force_x_[bounds_.of[b]] += force(b);
    for (Index b = bounds_.of_variables; b < bounds_.size(); ++b) force_row_[bounds_.of[b]] += force(b);
    p_ = force_x_;
    q_ = d_.cwiseProduct(force_row_);
    if (residuals != nullptr) {
        p_ -= residuals->dual;
        q_ -= residuals->equality;
        const double wrong =
            std::max({largest(residuals->dual), largest(residuals->equality), residuals->mu});
        goal_ = std::max(inexactness(tolerance_) * wrong, finest(tolerance_));
    }
    solve(goal_);  // a correction must be as exact as what it corrects: what it leaves over stays
    out.x = solution_.x;
    out.lambda = solution_.lambda;
    // Δt of a row two ways: exact for the row where its gap is far from 0, exact for the multiplier
    // otherwise.
    VectorXd& image = solution_.image;
    for (Index i = 0; i < d_.size(); ++i)
        if (d_[i] < 1.0) image[i] = d_[i] * (out.lambda[i] + force_row_[i]);
    double sum = 0.0;  // not finite if anything is not
    bounds_.each(out.x, image, [&](Index b, double t) {
        const double rest = residuals != nullptr ? residuals->bound[b] : 0.0;
        out.gap[b] = bounds_.sign[b] * t + rest;
        out.dual[b] = (change[b] - point.dual[b] * out.gap[b]) * inverse_gap_[b];
        sum += out.dual[b];
    });
    out.finite = solved_ && std::isfinite(sum) && out.x.allFinite();
    // The multiplier of an inequality is that of its bounds.
    for (Index b = bounds_.of_variables; b < bounds_.size(); ++b) out.lambda[bounds_.of[b]] = 0.0;
    for (Index b = bounds_.of_variables; b < bounds_.size(); ++b)
        out.lambda[bounds_.of[b]] -= bounds_.sign[b] * out.dual[b];
}

double step_to_boundary(const VectorXd& value, const VectorXd& change, double fraction) {
    double step = 1.0;
    for (Index i = 0; i < value.size(); ++i)
        if (change[i] * step < -fraction * value[i]) step = -fraction * value[i] / change[i];
    return step;
}

void advance(Iterate& point, const Direction& direction, double primal_step, double dual_step) {
    point.x += primal_step * direction.x;
    point.gap += primal_step * direction.gap;
    point.lambda += dual_step * direction.lambda;
    point.dual += dual_step * direction.dual;
}

}  // namespace camopt::structured
