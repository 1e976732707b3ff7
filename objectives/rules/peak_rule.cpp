// SPDX-License-Identifier: MIT
#include "objectives/rules/peak_rule.hpp"

#include "core/numbers/polynomial.hpp"

namespace camopt {

PeakRule::PeakRule(int order, int sign, int parameter, double reference)
    : order_(order), sign_(sign), parameters_{parameter}, reference_(reference) {}

std::string PeakRule::name() const {
    return std::string(sign_ > 0 ? "+" : "-") + derivative_names[order_];
}

RuleValue PeakRule::evaluate(const MotionPoint& point, const Eigen::VectorXd& q) const {
    RuleValue result{0.0, Eigen::VectorXd::Zero(5), Eigen::MatrixXd::Zero(5, 5)};
    result.gradient[order_] = sign_ / reference_;
    result.gradient[4] = -1.0;
    result.value = result.gradient[order_] * point.derivative[order_] - q[0];
    return result;
}

double BoundRule::scale_at(double x) const {
    if (bound_.contact == 0) return 1.0;
    // So close to the ends that y, which leaves them from rest, is below 1e-10 of its stroke.
    constexpr double at_the_end = 1e-9;
    const double along = std::clamp((x - bound_.begin) / (bound_.end - bound_.begin), 0.0, 1.0);
    const double from_ends = bound_.touches_begin && bound_.touches_end ? 4.0 * along * (1.0 - along)
                             : bound_.touches_begin                     ? along
                                                                        : 1.0 - along;
    const double scale = std::pow(from_ends, bound_.contact);
    return scale > at_the_end ? scale : 0.0;
}

RuleValue BoundRule::evaluate(const MotionPoint& point, const Eigen::VectorXd&) const {
    if (bound_.is_sum()) {
        const auto& [velocity, acceleration, constant] = bound_.weights;
        RuleValue sum{
            (velocity * point.derivative[1] + acceleration * point.derivative[2] + constant - bound_.bound) /
                bound_.scale,
            Eigen::VectorXd::Zero(4), Eigen::MatrixXd::Zero(4, 4)};
        sum.gradient[1] = velocity / bound_.scale;
        sum.gradient[2] = acceleration / bound_.scale;
        return sum;
    }
    const double weight = bound_.sign / bound_.scale;
    RuleValue rule{weight * point.derivative[bound_.order] - bound_.bound / bound_.scale,
                   Eigen::VectorXd::Zero(4), Eigen::MatrixXd::Zero(4, 4)};
    rule.gradient[bound_.order] = weight;
    return rule;
}

TorqueRule::TorqueRule(int sign, int parameter, double reference)
    : sign_(sign), parameters_{parameter}, reference_(reference) {}

RuleValue TorqueRule::evaluate(const MotionPoint& point, const Eigen::VectorXd& q) const {
    RuleValue result{0.0, Eigen::VectorXd::Zero(5), Eigen::MatrixXd::Zero(5, 5)};
    const double factor = sign_ / reference_;
    const double velocity = point.derivative[1], acceleration = point.derivative[2];
    result.value = factor * velocity * acceleration - q[0];
    result.gradient[1] = factor * acceleration;
    result.gradient[2] = factor * velocity;
    result.gradient[4] = -1.0;
    result.hessian(1, 2) = result.hessian(2, 1) = factor;
    return result;
}

Eigen::VectorXd TorqueRule::along(const std::array<Eigen::VectorXd, 4>& derivatives,
                                  const Eigen::VectorXd& q) const {
    Eigen::VectorXd polynomial = sign_ / reference_ * product(derivatives[1], derivatives[2]);
    polynomial[0] -= q[0];
    return polynomial;
}

std::optional<RangeOver> TorqueRule::range_over(std::span<const Interval> box, double) const {
    const RangeOver velocity = RangeOver::variable(box[1], 1), acceleration = RangeOver::variable(box[2], 2);
    const RangeOver factor = Interval(sign_) / Interval(reference_);
    return factor * (velocity * acceleration) - RangeOver::variable(box[4], 4);
}

}  // namespace camopt
