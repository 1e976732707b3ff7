// SPDX-License-Identifier: MIT
#include "objectives/rules/cam_rule.hpp"

#include "profiles/disk/quantity_algebra.hpp"

namespace camopt {

CamRule::CamRule(std::shared_ptr<const DiskVariables> cam, CamFormula formula)
    : cam_(std::move(cam)), formula_(std::move(formula)) {
    const MotionScale& scale = cam_->scale;
    const double slope = scale.lift / scale.unit_angle;
    slots_ = {{0, 0, scale.lift}, {1, 1, slope}, {2, 2, slope / scale.unit_angle}};
    for (const DiskVariables::Variable& variable : cam_->variables) {
        slots_.push_back({column_of(variable.dimension), static_cast<Eigen::Index>(slots_.size()) + 1,
                          variable.reference});
        parameters_.push_back(variable.parameter);
    }
}

Curvature CamRule::curvature(double least, double most) const {
    if (formula_.linear) return Curvature::linear;
    return formula_.convex && formula_.convex(least, most) ? Curvature::convex : Curvature::general;
}

RowOrigin CamRule::origin() const {
    RowOrigin origin = PointRule::origin();
    origin.remark = formula_.remark;
    return origin;
}

SlopeRange CamRule::slope_range() const {
    if (!parameters_.empty()) return {};
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

std::optional<RangeAlong> CamRule::range_along(const std::array<Interval, 5>& derivatives,
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

RuleValue CamRule::evaluate(const MotionPoint& point, const Eigen::VectorXd& q) const {
    ++*cam_->profile_points;
    const QuantityValue physical = formula_.value(cam_at(q), state_of(point, cam_->scale));

    const Eigen::Index size = 4 + static_cast<Eigen::Index>(cam_->variables.size());
    RuleValue rule{physical.value, Eigen::VectorXd::Zero(size), Eigen::MatrixXd::Zero(size, size)};
    for (const Slot& a : slots_) {
        rule.gradient[a.to] = a.unit * physical.gradient[a.from];
        for (const Slot& b : slots_)
            rule.hessian(a.to, b.to) = a.unit * b.unit * physical.hessian(a.from, b.from);
    }
    return rule;
}

}  // namespace camopt
