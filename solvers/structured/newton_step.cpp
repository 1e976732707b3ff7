// SPDX-License-Identifier: MIT
#include "solvers/structured/newton_step.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace camopt::structured {

using Eigen::Index;
using Eigen::VectorXd;

BoundMask::BoundMask(const ConvexModel& model) {
    const Index n = model.variables(), m = model.constraints();
    lower_bound.resize(n + m);
    upper_bound.resize(n + m);
    lower_bound << model.x_lower, model.row_lower;
    upper_bound << model.x_upper, model.row_upper;
    lower = VectorXd::Zero(n + m);
    upper = lower;
    equality = VectorXd::Zero(m);
    for (Index i = 0; i < n + m; ++i) {
        if (i >= n && model.is_equality(i - n)) {
            equality[i - n] = 1.0;
            continue;
        }
        lower[i] = std::isfinite(lower_bound[i]) ? 1.0 : 0.0;
        upper[i] = std::isfinite(upper_bound[i]) ? 1.0 : 0.0;
        if (lower[i] == 0.0) lower_bound[i] = 0.0;
        if (upper[i] == 0.0) upper_bound[i] = 0.0;
    }
    count = lower.sum() + upper.sum();
}

bool Residuals::finite() const {
    return dual.allFinite() && row.allFinite() && lower.allFinite() && upper.allFinite() && std::isfinite(mu);
}

Direction& Direction::operator+=(const Direction& other) {
    w += other.w;
    lambda += other.lambda;
    lower_gap += other.lower_gap;
    upper_gap += other.upper_gap;
    lower_dual += other.lower_dual;
    upper_dual += other.upper_dual;
    finite = finite && other.finite;
    return *this;
}

NewtonStep::NewtonStep(const ConvexModel& model, const BoundMask& mask, double shift)
    : model_(model),
      mask_(mask),
      system_(model, shift),
      hessian_(static_cast<std::size_t>(model.hessian.size())) {}

Residuals NewtonStep::residuals(const Iterate& point) const {
    const Index n = model_.variables(), m = model_.constraints();
    Residuals result;
    const VectorXd x = point.w.head(n);
    result.gradient = model_.cost->gradient(x);
    result.dual = result.gradient + model_.rows.transpose() * point.lambda - point.lower_dual.head(n) +
                  point.upper_dual.head(n);
    result.row = model_.rows * x - point.w.tail(m);
    result.lower = mask_.lower.cwiseProduct(point.w - mask_.lower_bound - point.lower_gap);
    result.upper = mask_.upper.cwiseProduct(mask_.upper_bound - point.w - point.upper_gap);
    const double products = point.lower_gap.dot(point.lower_dual) + point.upper_gap.dot(point.upper_dual);
    result.mu = products / std::max(1.0, mask_.count);
    return result;
}

bool NewtonStep::prepare(const Iterate& point, bool& finite) {
    const Index n = model_.variables(), m = model_.constraints();
    model_.cost->hessian(point.w.head(n), hessian_);
    finite = std::all_of(hessian_.begin(), hessian_.end(), [](double v) { return std::isfinite(v); });
    if (!finite) return false;
    sigma_ =
        point.lower_dual.cwiseQuotient(point.lower_gap) + point.upper_dual.cwiseQuotient(point.upper_gap);
    d_ = VectorXd::Zero(m);
    for (Index i = 0; i < m; ++i)
        if (mask_.equality[i] == 0.0) d_[i] = 1.0 / sigma_[n + i];
    return system_.factorize(hessian_, sigma_.head(n), d_);
}

Direction NewtonStep::direction(const Iterate& point, const Residuals* residuals,
                                const ProductChange& change) {
    const Index n = model_.variables(), m = model_.constraints();
    const VectorXd zero = VectorXd::Zero(n + m);
    const VectorXd& lower_rest = residuals != nullptr ? residuals->lower : zero;
    const VectorXd& upper_rest = residuals != nullptr ? residuals->upper : zero;
    VectorXd force =
        (change.lower - point.lower_dual.cwiseProduct(lower_rest)).cwiseQuotient(point.lower_gap) -
        (change.upper - point.upper_dual.cwiseProduct(upper_rest)).cwiseQuotient(point.upper_gap);
    VectorXd p = force.head(n), q = d_.cwiseProduct(force.tail(m));
    if (residuals != nullptr) {
        p -= residuals->dual;
        q -= residuals->row;
    }
    const KktSystem::Step solved = system_.solve(p, q);

    Direction result;
    result.w.resize(n + m);
    result.w.head(n) = solved.x;
    // Δs two ways: exact for the row where the slack is far from its bound, exact for the multiplier
    // otherwise.
    const VectorXd image = model_.rows * solved.x;
    for (Index i = 0; i < m; ++i) {
        const double row_rest = residuals != nullptr ? residuals->row[i] : 0.0;
        result.w[n + i] = mask_.equality[i] != 0.0 ? 0.0
                          : d_[i] < 1.0            ? d_[i] * (solved.lambda[i] + force[n + i])
                                                   : image[i] + row_rest;
    }
    result.lower_gap = mask_.lower.cwiseProduct(result.w + lower_rest);
    result.upper_gap = mask_.upper.cwiseProduct(upper_rest - result.w);
    result.lower_dual =
        (change.lower - point.lower_dual.cwiseProduct(result.lower_gap)).cwiseQuotient(point.lower_gap);
    result.upper_dual =
        (change.upper - point.upper_dual.cwiseProduct(result.upper_gap)).cwiseQuotient(point.upper_gap);
    result.lambda = result.upper_dual.tail(m) - result.lower_dual.tail(m);
    for (Index i = 0; i < m; ++i)
        if (mask_.equality[i] != 0.0) result.lambda[i] = solved.lambda[i];
    result.finite = solved.finite && result.w.allFinite() && result.lambda.allFinite() &&
                    result.lower_dual.allFinite() && result.upper_dual.allFinite();
    return result;
}

double step_to_boundary(const VectorXd& value, const VectorXd& change, double fraction) {
    double step = 1.0;
    for (Index i = 0; i < value.size(); ++i)
        if (change[i] < 0.0) step = std::min(step, -fraction * value[i] / change[i]);
    return step;
}

void advance(Iterate& point, const Direction& direction, double primal_step, double dual_step) {
    point.w += primal_step * direction.w;
    point.lower_gap += primal_step * direction.lower_gap;
    point.upper_gap += primal_step * direction.upper_gap;
    point.lambda += dual_step * direction.lambda;
    point.lower_dual += dual_step * direction.lower_dual;
    point.upper_dual += dual_step * direction.upper_dual;
}

}  // namespace camopt::structured
