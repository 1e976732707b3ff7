// SPDX-License-Identifier: MIT
// The epigraph of the torque peak: sign · y' y'' / reference − Q <= 0, with Q the peak variable in units of
// `reference`. Two of them, sign = ±1, make Q >= max |y' y''| / reference.
//
// y' y'' is proportional to the torque of an inertial load. The rule is bilinear, hence indefinite.
#pragma once

#include "objectives/rules/point_rule.hpp"

namespace camopt {

class TorqueRule final : public PointRule {
 public:
    /// `parameter`: index of Q among the problem's parameters; reference > 0.
    TorqueRule(int sign, int parameter, double reference);

    [[nodiscard]] RuleValue evaluate(const MotionPoint& point, const Eigen::VectorXd& q) const override;
    [[nodiscard]] Eigen::VectorXd along(const std::array<Eigen::VectorXd, 4>& derivatives,
                                        const Eigen::VectorXd& q) const override;
    [[nodiscard]] std::optional<RangeOver> range_over(std::span<const Interval> box,
                                                      const Interval& at) const override;

 private:
    int sign_;
    double reference_;
};

}  // namespace camopt
