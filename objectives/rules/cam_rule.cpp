// SPDX-License-Identifier: MIT
#include "objectives/rules/cam_rule.hpp"

#include "profiles/disk/quantity_algebra.hpp"

namespace camopt {

CamRule::CamRule(std::shared_ptr<const DiskVariables> cam, CamFormula formula)
    : LimitRule(static_cast<const LimitFrame&>(formula), cam->scale),
      cam_(std::move(cam)),
      formula_(std::move(formula)) {
    for (const DiskVariables::Variable& variable : cam_->variables)
        add_variable(column_of(variable.dimension), variable.parameter, variable.reference);
}

Curvature CamRule::curvature(double least, double most) const {
    if (formula_.linear) return Curvature::linear;
    return formula_.convex && formula_.convex(least, most) ? Curvature::convex : Curvature::general;
}

SlopeRange CamRule::slope_range() const {
    if (!parameters().empty()) return {};
    const double unit = cam_->scale.lift / cam_->scale.unit_angle;
    return {formula_.slope.least / unit, formula_.slope.most / unit};
}

DiskCam CamRule::cam_at(const Eigen::VectorXd& q) const {
    DiskCam cam = cam_->cam;
    for (std::size_t k = 0; k < cam_->variables.size(); ++k) {
        cam.dimensions[static_cast<std::size_t>(cam_->variables[k].dimension)] =
            cam_->variables[k].reference * q[static_cast<Eigen::Index>(k)];
    }
    return cam;
}

std::optional<RangeAlong> CamRule::range_along(const Interval&, const std::array<Interval, 5>& derivatives,
                                               const Eigen::VectorXd& q) const {
    if (!formula_.range) return {};
    ++*cam_->profile_points;
    // By x, as the rule's slope along the motion is: only s', s'' themselves are by the cam angle.
    const auto along = [&](double unit, std::size_t order) {
        const Interval by(unit);
        return RangeAlong(by * derivatives[order], by * derivatives[order + 1], by * derivatives[order + 2]);
    };
    const double lift = cam_->scale.lift, slope = lift / cam_->scale.unit_angle;
    return formula_.range(cam_at(q),
                          {along(lift, 0), along(slope, 1), along(slope / cam_->scale.unit_angle, 2)});
}

std::optional<RangeOver> CamRule::range_over(std::span<const Interval> box, double) const {
    if (!formula_.over || box.size() > RangeOver::most) return {};
    ++*cam_->profile_points;
    const double lift = cam_->scale.lift, slope = lift / cam_->scale.unit_angle;
    StateOver state{RangeOver::variable(box[0], 0, lift),
                    RangeOver::variable(box[1], 1, slope),
                    RangeOver::variable(box[2], 2, slope / cam_->scale.unit_angle),
                    {}};
    for (std::size_t k = 0; k < state.dimensions.size(); ++k) state.dimensions[k] = cam_->cam.dimensions[k];
    int column = 4;
    for (const DiskVariables::Variable& variable : cam_->variables) {
        state.dimensions[static_cast<std::size_t>(variable.dimension)] =
            RangeOver::variable(box[static_cast<std::size_t>(column)], column, variable.reference);
        ++column;
    }
    return formula_.over(cam_->cam, state);
}

RuleValue CamRule::evaluate(const MotionPoint& point, const Eigen::VectorXd& q) const {
    ++*cam_->profile_points;
    return normalised(formula_.value(cam_at(q), state_of(point, cam_->scale)));
}

}  // namespace camopt
