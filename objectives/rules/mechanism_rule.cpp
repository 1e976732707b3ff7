// SPDX-License-Identifier: MIT
#include "objectives/rules/mechanism_rule.hpp"

#include <algorithm>

namespace camopt {

MechanismValue MechanismCall::dimension(int index) const {
    const auto size = 3 + static_cast<Eigen::Index>(active.size());
    MechanismValue result{state.dimensions[static_cast<std::size_t>(index)], Eigen::VectorXd::Zero(size),
                          Eigen::MatrixXd::Zero(size, size)};
    const auto found = std::ranges::find(active, index);
    if (found != active.end()) result.gradient[3 + (found - active.begin())] = 1.0;
    return result;
}

MechanismRule::MechanismRule(std::shared_ptr<const CamVariables> mechanism, MechanismFormula formula)
    : mechanism_(std::move(mechanism)), formula_(std::move(formula)) {
    const MotionScale& scale = mechanism_->scale;
    const double slope = scale.lift / scale.unit_angle;
    units_.resize(3 + static_cast<Eigen::Index>(mechanism_->variables.size()));
    units_.head(3) << scale.lift, slope, slope / scale.unit_angle;
    for (const CamVariables::Variable& variable : mechanism_->variables) {
        units_[3 + static_cast<Eigen::Index>(active_.size())] = variable.reference;
        active_.push_back(variable.dimension);
        parameters_.push_back(variable.parameter);
    }
}

RuleValue MechanismRule::evaluate(const MotionPoint& point, const Eigen::VectorXd& q) const {
    ++*mechanism_->profile_points;
    std::vector<double> dimensions = mechanism_->cam.dimensions;
    for (std::size_t k = 0; k < active_.size(); ++k)
        dimensions[static_cast<std::size_t>(active_[k])] =
            mechanism_->variables[k].reference * q[static_cast<Eigen::Index>(k)];
    const double theta = mechanism_->scale.unit_angle * point.x;
    const MechanismCall call{*mechanism_->cam.formulas,
                             {dimensions, state_of(point, mechanism_->scale), theta},
                             formula_.station,
                             active_};
    const MechanismValue physical = formula_.value(call);
    const auto variables = static_cast<Eigen::Index>(active_.size()), size = 4 + variables;
    RuleValue rule{physical.value, Eigen::VectorXd::Zero(size), Eigen::MatrixXd::Zero(size, size)};
    // y''' stands between y'' and the parameters, and no quantity depends on it.
    const auto to = [](Eigen::Index k) { return k < 3 ? k : k + 1; };
    for (Eigen::Index a = 0; a < 3 + variables; ++a) {
        rule.gradient[to(a)] = units_[a] * physical.gradient[a];
        for (Eigen::Index b = 0; b < 3 + variables; ++b)
            rule.hessian(to(a), to(b)) = units_[a] * units_[b] * physical.hessian(a, b);
    }
    rule.by_place = mechanism_->scale.unit_angle * physical.by_angle;
    return rule;
}

}  // namespace camopt
