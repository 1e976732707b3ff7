// SPDX-License-Identifier: MIT
// The epigraphs of peaks of the motion and of the torque.
#pragma once

#include "objectives/rules/point_rule.hpp"

namespace camopt {

// The epigraph of a peak: sign · y^{(order)} / reference − P <= 0, with P the peak variable in units of
// `reference`. Two of them, sign = ±1, make P >= max |y^{(order)}| / reference.

/// A limit on the motion itself: sign · y^{(order)} <= bound, as (sign · y^{(order)} − bound) / scale <= 0. A
/// hard limit with no variable.
class BoundRule final : public PointRule {
 public:
    struct Bound {
        int order = 0, sign = 1;
        double bound = 0.0;                ///< of sign · y^{(order)}
        double scale = 1.0;                ///< exceeding the bound by this is a violation of 100 %; > 0
        bool starts_without_rows = false;  ///< as in PointRule
        /// Of a rule that is active at both ends of a stroke, from `begin` to `end`, and leaves its bound
        /// with the power `contact` of the distance: violations are scaled by (4 ξ (1 − ξ))^contact, ξ = 0 …
        /// 1 along the stroke.
        int contact = 0;
        double begin = 0.0, end = 1.0;
        /// Active at one end only: by ξ^contact or (1 − ξ)^contact, so that the other end counts.
        bool touches_begin = true, touches_end = true;
        /// Of y', y'' and 1: where any is not 0 their sum is bounded in place of sign · y^{(order)}; then
        /// `order` is 2.
        std::array<double, 3> weights{};
        std::string remark = {};  ///< tells rows of one name apart

        [[nodiscard]] bool is_sum() const { return weights != std::array<double, 3>{}; }
    };
    BoundRule(std::string name, const Bound& bound) : name_(std::move(name)), bound_(bound) {}

    [[nodiscard]] std::string name() const override { return name_; }
    [[nodiscard]] RowOrigin origin() const override {
        RowOrigin origin = with_sign(PointRule::origin(), bound_.sign);
        origin.remark = bound_.remark;
        return origin;
    }
    [[nodiscard]] const std::vector<int>& parameters() const override { return none_; }
    [[nodiscard]] bool linear() const override { return true; }
    [[nodiscard]] int highest_order() const override { return bound_.order; }
    [[nodiscard]] bool limit() const override { return true; }
    [[nodiscard]] double scale() const override { return 1.0; }
    [[nodiscard]] double scale_at(double x) const override;
    [[nodiscard]] bool starts_without_rows() const override { return bound_.starts_without_rows; }
    [[nodiscard]] RuleValue evaluate(const MotionPoint& point, const Eigen::VectorXd& q) const override;

 private:
    std::string name_;
    Bound bound_;
    std::vector<int> none_;
};

class PeakRule final : public PointRule {
 public:
    /// order 1, 2 or 3; `parameter`: index of P among the problem's parameters; reference > 0.
    PeakRule(int order, int sign, int parameter, double reference);

    [[nodiscard]] std::string name() const override;
    [[nodiscard]] RowOrigin origin() const override { return with_sign(PointRule::origin(), sign_); }
    [[nodiscard]] const std::vector<int>& parameters() const override { return parameters_; }
    [[nodiscard]] bool linear() const override { return true; }
    [[nodiscard]] int highest_order() const override { return order_; }
    [[nodiscard]] bool limit() const override { return false; }
    [[nodiscard]] double scale() const override { return 1.0; }
    [[nodiscard]] RuleValue evaluate(const MotionPoint& point, const Eigen::VectorXd& q) const override;

 private:
    int order_, sign_;
    std::vector<int> parameters_;
    double reference_;
};

// The epigraph of the torque peak: sign · y' y'' / reference − Q <= 0, with Q the peak variable in units of
// `reference`. Two of them, sign = ±1, make Q >= max |y' y''| / reference.
//
// y' y'' is proportional to the torque of an inertial load. The rule is bilinear, hence indefinite.

class TorqueRule final : public PointRule {
 public:
    /// `parameter`: index of Q among the problem's parameters; reference > 0.
    TorqueRule(int sign, int parameter, double reference);

    [[nodiscard]] std::string name() const override { return sign_ > 0 ? "+torque" : "-torque"; }
    [[nodiscard]] const std::vector<int>& parameters() const override { return parameters_; }
    [[nodiscard]] bool linear() const override { return false; }
    [[nodiscard]] int highest_order() const override { return 2; }
    [[nodiscard]] bool limit() const override { return false; }
    [[nodiscard]] double scale() const override { return 1.0; }
    [[nodiscard]] RuleValue evaluate(const MotionPoint& point, const Eigen::VectorXd& q) const override;
    [[nodiscard]] Eigen::VectorXd along(const std::array<Eigen::VectorXd, 4>& derivatives,
                                        const Eigen::VectorXd& q) const override;
    [[nodiscard]] std::optional<RangeOver> range_over(std::span<const Interval> box,
                                                      double at) const override;

 private:
    int sign_;
    std::vector<int> parameters_;
    double reference_;
};

}  // namespace camopt
