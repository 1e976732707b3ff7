// SPDX-License-Identifier: MIT
#include "objectives/cam_rule.hpp"

#include <algorithm>

namespace camopt {

bool CamVariables::is_variable(DimensionIndex dimension) const {
    return std::ranges::any_of(
        variables, [dimension](const Variable& variable) { return variable.dimension == dimension; });
}

DiskCam CamVariables::cam_at(const Eigen::VectorXd& parameters) const {
    DiskCam own = cam;
    for (const Variable& variable : variables) {
        own.dimensions[static_cast<std::size_t>(variable.dimension)] =
            variable.reference * parameters[variable.parameter];
    }
    return own;
}

CamRule::CamRule(std::shared_ptr<const CamVariables> cam, CamFormula formula)
    : cam_(std::move(cam)), formula_(std::move(formula)) {
    for (const CamVariables::Variable& variable : cam_->variables) parameters_.push_back(variable.parameter);
}

Curvature CamRule::curvature(double least, double most) const {
    if (formula_.linear) return Curvature::linear;
    return formula_.convex && formula_.convex(least, most) ? Curvature::convex : Curvature::general;
}

SlopeRange CamRule::slope_range() const {
    if (!parameters_.empty()) return {};
    const double unit = cam_->scale.lift / cam_->scale.unit_angle;
    return {formula_.slope.least / unit, formula_.slope.most / unit};
}

RuleValue CamRule::evaluate(const MotionPoint& point, const Eigen::VectorXd& q) const {
    ++*cam_->profile_points;
    const std::size_t variables = cam_->variables.size();
    DiskCam cam = cam_->cam;
    for (std::size_t k = 0; k < variables; ++k) {
        cam.dimensions[static_cast<std::size_t>(cam_->variables[k].dimension)] =
            cam_->variables[k].reference * q[static_cast<Eigen::Index>(k)];
    }
    const QuantityValue physical = formula_.value(cam, state_of(point, cam_->scale));

    // Position of each physical variable in (y, y', y'', y''', q), and its unit.
    const Eigen::Index size = 4 + static_cast<Eigen::Index>(variables);
    std::vector<int> from = {0, 1, 2};
    std::vector<Eigen::Index> place = {0, 1, 2};
    const MotionScale& scale = cam_->scale;
    std::vector<double> unit = {scale.lift, scale.lift / scale.unit_angle,
                                scale.lift / (scale.unit_angle * scale.unit_angle)};
    for (std::size_t k = 0; k < variables; ++k) {
        from.push_back(3 + static_cast<int>(cam_->variables[k].dimension));
        place.push_back(4 + static_cast<Eigen::Index>(k));
        unit.push_back(cam_->variables[k].reference);
    }
    RuleValue rule{physical.value, Eigen::VectorXd::Zero(size), Eigen::MatrixXd::Zero(size, size)};
    for (std::size_t a = 0; a < from.size(); ++a) {
        rule.gradient[place[a]] = unit[a] * physical.gradient[from[a]];
        for (std::size_t b = 0; b < from.size(); ++b) {
            rule.hessian(place[a], place[b]) = unit[a] * unit[b] * physical.hessian(from[a], from[b]);
        }
    }
    return rule;
}

}  // namespace camopt
