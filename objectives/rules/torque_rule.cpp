// SPDX-License-Identifier: MIT
#include "objectives/rules/torque_rule.hpp"

#include "core/numbers/polynomial.hpp"

namespace camopt {

TorqueRule::TorqueRule(int sign, int parameter, double reference)
    : PointRule({.name = sign > 0 ? "+torque" : "-torque",
                 .highest_order = 2,
                 .limit = false,
                 .parameters = {parameter},
                 .sign = sign,
                 .fields = {.key = "torque"}}),
      sign_(sign),
      reference_(reference) {}

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

std::optional<RangeOver> TorqueRule::range_over(std::span<const Interval> box, const Interval&) const {
    const RangeOver velocity = RangeOver::variable(box[1], 1), acceleration = RangeOver::variable(box[2], 2);
    const RangeOver factor = Interval(sign_) / Interval(reference_);
    return factor * (velocity * acceleration) - RangeOver::variable(box[4], 4);
}

}  // namespace camopt
