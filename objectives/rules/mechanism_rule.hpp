// SPDX-License-Identifier: MIT
// A limit of any cam mechanism at one cam angle and one station: a formula of (s, s', s'', variable
// dimensions) in SI, brought to the normalised (y, y', y'', y'''; q) of the optimizer by the chain rule, as
// cam_rule.hpp does for the disk cams. Knows the mechanism by its interface alone.
#pragma once

#include "objectives/rules/cam_variables.hpp"
#include "objectives/rules/point_rule.hpp"
#include "scene/scene.hpp"

#include <functional>
#include <memory>
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

struct MechanismFormula {
    std::string name;  ///< the key of the limit, as the user wrote it
    int station = 0;
    /// <= 0 is kept; dimensionless, of order one.
    std::function<MechanismValue(const MechanismCall&)> value;
    int highest_order = 2;
    double scale = 1.0;  ///< a value of this is a violation of 100 %
    Curvature shape = Curvature::general;
};

class MechanismRule final : public PointRule {
 public:
    MechanismRule(std::shared_ptr<const CamVariables> mechanism, MechanismFormula formula);

    [[nodiscard]] std::string name() const override { return formula_.name; }
    [[nodiscard]] const std::vector<int>& parameters() const override { return parameters_; }
    [[nodiscard]] bool linear() const override { return formula_.shape == Curvature::linear; }
    [[nodiscard]] Curvature curvature(double, double) const override { return formula_.shape; }
    [[nodiscard]] int highest_order() const override { return formula_.highest_order; }
    [[nodiscard]] bool limit() const override { return true; }
    [[nodiscard]] double scale() const override { return formula_.scale; }
    [[nodiscard]] RuleValue evaluate(const MotionPoint& point, const Eigen::VectorXd& q) const override;

 private:
    std::shared_ptr<const CamVariables> mechanism_;
    MechanismFormula formula_;
    std::vector<int> parameters_, active_;
    Eigen::VectorXd units_;  ///< of (s, s', s'', variables) in the rule's own
};

/// Every limit of the scene on its mechanism, at every station:
///   pressure angle   (± N cos φm − D sin φm)/L, by pressure_excess of the mechanism
///   convex radius    (r + ρ_min) κ − 1          planar
///   concave radius   −(ρ_c − r) κ − 1           planar
///   undercut margin  margin − regularity
[[nodiscard]] std::vector<std::shared_ptr<const MechanismRule>> mechanism_limits(
    const Scene& scene, const std::shared_ptr<const CamVariables>& mechanism);

}  // namespace camopt
