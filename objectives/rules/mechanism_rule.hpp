// SPDX-License-Identifier: MIT
// A limit of any cam mechanism at one cam angle and one station: a formula of (s, s', s'', variable
// dimensions). Knows the mechanism by its interface alone.
#pragma once

#include "objectives/rules/cam_variables.hpp"
#include "objectives/rules/limit_rule.hpp"
#include "scene/scene.hpp"

#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace camopt {

/// What a formula is given: partials are by (s, s', s'', the variables in their order).
struct MechanismCall {
    const CamMechanism& formulas;
    MechanismState state;
    int station = 0;
    std::vector<int> active;

    [[nodiscard]] MechanismValue operator()(MechanismQuantity which) const {
        return formulas.quantity(which, state, station, active);
    }
    [[nodiscard]] MechanismValue pressure_excess(double limit, int sign) const {
        return formulas.pressure_excess(limit, sign, state, station, active);
    }
    /// One of its dimensions as a quantity.
    [[nodiscard]] MechanismValue dimension(int index) const;
};

struct MechanismFormula : LimitFrame {
    int station = 0;
    MechanismQuantity figure = MechanismQuantity::regularity;  ///< what the limit is on
    /// <= 0 is kept; dimensionless, of order one.
    std::function<MechanismValue(const MechanismCall&)> value = {};
    Curvature shape = Curvature::general;
    /// The same over a box, or that times something positive.
    std::function<std::optional<RangeOver>(const CamMechanism&, const MechanismStateOver&)> over = {};
    /// The same along a stretch of a motion.
    std::function<std::optional<RangeAlong>(const CamMechanism&, const MechanismStateAlong&)> along = {};
};

class MechanismRule final : public LimitRule {
 public:
    MechanismRule(std::shared_ptr<const CamVariables> mechanism, MechanismFormula formula);

    /// Whether its stations are all places of the cam that the limit speaks of; else it holds at them alone.
    [[nodiscard]] bool at_every_station() const;
    [[nodiscard]] bool linear() const override { return formula_.shape == Curvature::linear; }
    [[nodiscard]] Curvature curvature(double, double) const override { return formula_.shape; }
    [[nodiscard]] std::optional<RangeOver> range_over(std::span<const Interval> box,
                                                      double at) const override;
    [[nodiscard]] std::optional<RangeAlong> range_along(const Interval& x,
                                                        const std::array<Interval, 5>& derivatives,
                                                        const Eigen::VectorXd& q) const override;
    [[nodiscard]] RuleValue evaluate(const MotionPoint& point, const Eigen::VectorXd& q) const override;

 private:
    [[nodiscard]] std::vector<double> dimensions_at(const Eigen::VectorXd& q) const;

    std::shared_ptr<const CamVariables> mechanism_;
    MechanismFormula formula_;
    std::vector<int> active_;
};

/// Every limit of the scene on its mechanism, at every station:
///   pressure angle   (± N cos φm − D sin φm)/L, by pressure_excess of the mechanism
///   convex radius    (r + ρ_min) κ − 1          planar
///   concave radius   −(ρ_c − r) κ − 1           planar
///   undercut margin  margin − regularity
[[nodiscard]] std::vector<std::shared_ptr<const MechanismRule>> mechanism_limits(
    const Scene& scene, const std::shared_ptr<const CamVariables>& mechanism);

}  // namespace camopt
