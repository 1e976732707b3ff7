// SPDX-License-Identifier: MIT
// A limit of a disk cam at one cam angle: a formula of (s, s', s'', dimensions) with an algebra of fixed
// size, and what encloses it along a stretch.
#pragma once

#include "objectives/rules/cam_variables.hpp"
#include "objectives/rules/limit_rule.hpp"
#include "profiles/disk/quantity_along.hpp"
#include "profiles/disk/quantity_over.hpp"

#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace camopt {

struct CamFormula : LimitFrame {
    /// <= 0 is kept; dimensionless, of order one.
    std::function<QuantityValue(const DiskCam&, const FollowerState&)> value;
    /// The same over a stretch of the cam angle.
    std::function<RangeAlong(const DiskCam&, const StateAlong&)> range;
    /// The same over a box of states and dimensions, or that times something positive.
    std::function<RangeOver(const DiskCam&, const StateOver&)> over = {};
    bool linear = false;
    std::function<bool(double least, double most)> convex = {};  ///< none: never proved convex
    SlopeRange slope = {};  ///< of s' by the cam angle, m/rad or rad/rad, that it allows at all
};

/// All from one text, generic over the state.
template <class Formula>
[[nodiscard]] CamFormula cam_formula(std::string name, const Formula& formula) {
    CamFormula result;
    result.name = std::move(name);
    result.value = formula;
    result.range = formula;
    result.over = formula;
    return result;
}

class CamRule final : public LimitRule {
 public:
    CamRule(std::shared_ptr<const DiskVariables> cam, CamFormula formula);

    [[nodiscard]] bool linear() const override { return formula_.linear; }
    [[nodiscard]] Curvature curvature(double least, double most) const override;
    [[nodiscard]] SlopeRange slope_range() const override;
    [[nodiscard]] std::optional<RangeAlong> range_along(const Interval& x,
                                                        const std::array<Interval, 5>& derivatives,
                                                        const Eigen::VectorXd& q) const override;
    [[nodiscard]] std::optional<RangeOver> range_over(std::span<const Interval> box,
                                                      double at) const override;
    [[nodiscard]] RuleValue evaluate(const MotionPoint& point, const Eigen::VectorXd& q) const override;

 private:
    /// The cam for the rule's own parameters.
    [[nodiscard]] DiskCam cam_at(const Eigen::VectorXd& q) const;

    std::shared_ptr<const DiskVariables> cam_;
    CamFormula formula_;
};

}  // namespace camopt
