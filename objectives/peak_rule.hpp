// SPDX-License-Identifier: MIT
// The epigraph of a peak: sign · y^{(order)} / reference − P <= 0, with P the peak variable in units of
// `reference`. Two of them, sign = ±1, make P >= max |y^{(order)}| / reference.
#pragma once

#include "objectives/point_rule.hpp"

namespace camopt {

class PeakRule final : public PointRule {
 public:
    /// order 1, 2 or 3; `parameter`: index of P among the problem's parameters; reference > 0.
    PeakRule(int order, int sign, int parameter, double reference);

    [[nodiscard]] std::string name() const override;
    [[nodiscard]] const std::vector<int>& parameters() const override { return parameters_; }
    [[nodiscard]] bool linear() const override { return true; }
    [[nodiscard]] bool limit() const override { return false; }
    [[nodiscard]] double scale() const override { return 1.0; }
    [[nodiscard]] RuleValue evaluate(const MotionPoint& point, const Eigen::VectorXd& q) const override;

 private:
    int order_, sign_;
    std::vector<int> parameters_;
    double reference_;
};

}  // namespace camopt
