// SPDX-License-Identifier: MIT
// A rule over the whole motion, linear in it: g(motion; q; setting) <= 0 for every setting.
//
// A setting identifies a row besides its location: a speed of the cam, a direction. Rows are added where the
// rule is largest over locations and settings together.
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
    /// The rows of the first grid: so many that a motion that satisfies them is nearly feasible between them.
    /// Values do not count.
    [[nodiscard]] virtual std::vector<Place> first() const = 0;
    /// Further settings whose rows are added together with those of this one.
    [[nodiscard]] virtual std::vector<std::vector<double>> beside(std::span<const double> setting) const = 0;
    /// Identifies the row: "310 rpm".
    [[nodiscard]] virtual std::string remark(std::span<const double> setting) const = 0;

    [[nodiscard]] bool linear() const final { return true; }
    [[nodiscard]] const WholeMotionRule* whole() const final { return this; }
    /// It does not depend on a single point; throws ModelError.
    [[nodiscard]] RuleValue evaluate(const MotionPoint& point, const Eigen::VectorXd& q) const final;
};

}  // namespace camopt
