// SPDX-License-Identifier: MIT
// A rule that looks at the motion as a whole, and is linear in it: g(motion; q; setting) <= 0 for every
// setting.
//
// A setting is what beside a place belongs to one row: a speed of the cam, a direction. Rows are added where
// the rule is largest over places and settings together.
#pragma once

#include "core/numbers/extremum.hpp"
#include "objectives/rules/point_rule.hpp"
#include "splines/motion_family.hpp"

#include <span>
#include <string>
#include <vector>

namespace camopt {

class WholeMotionRule : public PointRule {
 public:
    struct Place {
        Extremum where;
        std::vector<double> setting;
    };

    /// The local maxima along the motion over all settings, the largest among them; q as in evaluate().
    [[nodiscard]] virtual std::vector<Place> maxima(const Motion& motion, const Eigen::VectorXd& q) const = 0;
    /// The rule at q = 0 by the entries of the family.
    [[nodiscard]] virtual AffineRow row(const MotionFamily& family, double at, Side side,
                                        std::span<const double> setting) const = 0;
    /// The rows of the first grid: so many that a motion which keeps them cannot be far off between them.
    /// Values do not count.
    [[nodiscard]] virtual std::vector<Place> first() const = 0;
    /// Further settings whose rows belong beside those of this one.
    [[nodiscard]] virtual std::vector<std::vector<double>> beside(std::span<const double> setting) const = 0;
    /// Which row it is: "310 rpm".
    [[nodiscard]] virtual std::string remark(std::span<const double> setting) const = 0;

    [[nodiscard]] bool linear() const final { return true; }
    [[nodiscard]] const WholeMotionRule* whole() const final { return this; }
    /// It sees no single point; throws ModelError.
    [[nodiscard]] RuleValue evaluate(const MotionPoint& point, const Eigen::VectorXd& q) const final;
};

}  // namespace camopt
