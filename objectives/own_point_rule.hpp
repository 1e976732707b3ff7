// SPDX-License-Identifier: MIT
//
// A user-defined term or limit (scene/own_rule.hpp) as a rule of the optimizer:
//     (g(point) − level) / size − q <= 0,   q the term's variable; a limit has none.
#pragma once

#include "objectives/rules/model.hpp"
#include "scene/scene.hpp"

namespace camopt {

class OwnPointRule final : public PointRule {
 public:
    /// `parameter`: index of q among the problem's parameters.
    OwnPointRule(const OwnTerm& term, int parameter);
    explicit OwnPointRule(const OwnLimit& limit);

    [[nodiscard]] Curvature curvature(double, double) const override { return shape_; }
    /// Throws ModelError if the formula contradicts its declared shape, or its partials are undefined where
    /// it is defined.
    [[nodiscard]] RuleValue evaluate(const MotionPoint& point, const Eigen::VectorXd& q) const override;

 private:
    MotionFormula formula_;
    Curvature shape_;
    double level_ = 0.0, size_ = 1.0;

    void check_shape(const MotionPoint& point, const FormulaValue& found) const;
};

/// Parameters and rules of every user-defined term and limit of the scene.
void add_own_rules(CamModel& model, const Scene& scene);

/// The largest g of a user-defined term along a motion, or 0 if it is nowhere above, and where. Accurate to
/// round-off where g is smooth between breakpoints; found by samples of value and slope.
[[nodiscard]] Extremum largest_of_own(const OwnTerm& term, const Motion& motion);
/// The largest g of a limit.
[[nodiscard]] Extremum largest_of_own(const OwnLimit& limit, const Motion& motion);

}  // namespace camopt
