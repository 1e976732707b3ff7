// SPDX-License-Identifier: MIT
// A limit of a disk cam at one cam angle: a formula of (s, s', s'', dimensions) in SI, brought to the
// normalised (y, y', y'', y'''; q) of the optimizer by the chain rule: s^{(r)} = lift / unit_angle^r ·
// y^{(r)}, each variable dimension = reference · q.
#pragma once

#include "objectives/rules/cam_variables.hpp"
#include "objectives/rules/point_rule.hpp"
#include "profiles/disk/quantity_along.hpp"

#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace camopt {

struct CamFormula {
    std::string name;    ///< the key of the limit, as the user wrote it
    std::string remark;  ///< which part of the limit it is, where there are several
    /// <= 0 is kept; dimensionless, of order one.
    std::function<QuantityValue(const DiskCam&, const FollowerState&)> value;
    /// The same over a stretch of the cam angle.
    std::function<RangeAlong(const DiskCam&, const StateAlong&)> range;
    int highest_order = 2;
    bool linear = false;
    double scale = 1.0;                                          ///< a value of this is a violation of 100 %
    std::function<bool(double least, double most)> convex = {};  ///< none: never proved convex
    std::vector<double> places = {};  ///< x where alone it holds; empty: everywhere
    SlopeRange slope = {};            ///< of s' by the cam angle, m/rad or rad/rad, that it allows at all
};

/// Both from one text, generic over the state.
template <class Formula>
[[nodiscard]] CamFormula cam_formula(std::string name, const Formula& formula) {
    CamFormula result;
    result.name = std::move(name);
    result.value = formula;
    result.range = formula;
    return result;
}

class CamRule final : public PointRule {
 public:
    CamRule(std::shared_ptr<const DiskVariables> cam, CamFormula formula);

    [[nodiscard]] std::string name() const override { return formula_.name; }
    [[nodiscard]] RowOrigin origin() const override;
    [[nodiscard]] const std::vector<int>& parameters() const override { return parameters_; }
    [[nodiscard]] bool linear() const override { return formula_.linear; }
    [[nodiscard]] Curvature curvature(double least, double most) const override;
    [[nodiscard]] SlopeRange slope_range() const override;
    [[nodiscard]] int highest_order() const override { return formula_.highest_order; }
    [[nodiscard]] bool limit() const override { return true; }
    [[nodiscard]] const std::vector<double>& places() const override { return formula_.places; }
    [[nodiscard]] double scale() const override { return formula_.scale; }
    [[nodiscard]] std::optional<RangeAlong> range_along(const std::array<Interval, 5>& derivatives,
                                                        const Eigen::VectorXd& q) const override;
    [[nodiscard]] RuleValue evaluate(const MotionPoint& point, const Eigen::VectorXd& q) const override;

 private:
    std::shared_ptr<const DiskVariables> cam_;
    CamFormula formula_;
    std::vector<int> parameters_;
    /// The cam for the rule's own parameters.
    [[nodiscard]] DiskCam cam_at(const Eigen::VectorXd& q) const;
    /// Each variable of a quantity that moves: where its partial stands there, where in the rule's variables,
    /// and its unit.
    struct Slot {
        int from = 0;
        Eigen::Index to = 0;
        double unit = 1.0;
    };
    std::vector<Slot> slots_;
};

}  // namespace camopt
