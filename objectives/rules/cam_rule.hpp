// SPDX-License-Identifier: MIT
// A limit of a cam of any kind at one cam angle and one station: a formula of (s, s', s'', dimensions), in
// three algebras: values with partials, enclosures over boxes, enclosures along a stretch of a motion. It
// uses the cam only through its interface (scene/cam_mechanism.hpp).
//
// A formula is in SI. The rule converts it to the normalised (y, y', y'', y'''; q) of the optimizer by the
// chain rule: s^{(r)} = lift / unit_angle^r · y^{(r)}, each variable dimension = reference · q.
#pragma once

#include "objectives/rules/cam_call.hpp"
#include "objectives/rules/cam_variables.hpp"
#include "objectives/rules/point_rule.hpp"

#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace camopt {

struct CamFormula {
    std::string name;         ///< the key of the limit, as the user wrote it
    std::string remark = {};  ///< which part of the limit it is, where there are several
    int sign = 0;             ///< ±1: which of its two sides
    int highest_order = 2;
    double scale = 1.0;               ///< a value of this is a violation of 100 %
    std::vector<double> places = {};  ///< x where alone it holds; empty: everywhere
    MechanismQuantity figure = MechanismQuantity::pressure_numerator;  ///< what the limit is on

    /// <= 0 is satisfied; dimensionless, of order one.
    std::function<MechanismValue(const CamCall&)> value = {};
    /// The same over a box of states and dimensions, or that times a positive factor.
    std::function<std::optional<RangeOver>(const CamCallOver&)> over = {};
    /// The same along a stretch of the cam angle.
    std::function<std::optional<RangeAlong>(const CamCallAlong&)> along = {};
    /// Over all s from `least` to `most`; none: general.
    std::function<Curvature(double least, double most)> shape = {};
    bool linear = false;                       ///< linear over all of them
    Interval slopes = Interval::everything();  ///< of s' by the cam angle: the admissible range
};

/// All three from one formula, generic over the call.
template <class Formula>
[[nodiscard]] CamFormula cam_formula(std::string name, const Formula& formula) {
    CamFormula result;
    result.name = std::move(name);
    result.value = formula;
    result.over = [formula](const CamCallOver& call) { return call.known(formula(call)); };
    result.along = [formula](const CamCallAlong& call) { return call.known(formula(call)); };
    return result;
}

class CamRule final : public PointRule {
 public:
    /// Throws ModelError for more variable dimensions than a MechanismValue can have.
    CamRule(std::shared_ptr<const CamVariables> cam, CamFormula formula);

    /// Whether its stations are all that the limit covers; else it holds at them only.
    [[nodiscard]] bool at_every_station() const {
        return cam_->cam.formulas->has_all_stations(formula_.figure);
    }
    [[nodiscard]] std::string name() const override { return formula_.name; }
    [[nodiscard]] RowOrigin origin() const override;
    [[nodiscard]] const std::vector<int>& parameters() const override { return parameters_; }
    [[nodiscard]] int highest_order() const override { return formula_.highest_order; }
    [[nodiscard]] bool limit() const override { return true; }
    [[nodiscard]] const std::vector<double>& places() const override { return formula_.places; }
    [[nodiscard]] double scale() const override { return formula_.scale; }
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
    /// m in one unit of y, y', y''.
    [[nodiscard]] std::array<double, 3> units() const;
    [[nodiscard]] RuleValue normalised(const MechanismValue& physical) const;

    std::shared_ptr<const CamVariables> cam_;
    CamFormula formula_;
    std::vector<int> parameters_, active_;
};

}  // namespace camopt
