// SPDX-License-Identifier: MIT
#include "objectives/rules/cam_rule.hpp"

#include <fmt/format.h>

namespace camopt {

namespace {

/// Of the variables, those that a formula depends on: the first ones.
std::size_t count_of(const CamFormula& formula, const CamVariables& cam) {
    return formula.of_loads ? cam.variables.size() : cam.own_variables();
}

RuleData data_of(const CamFormula& formula, const CamVariables& cam) {
    RuleData data = static_cast<const RuleData&>(formula);
    for (std::size_t k = 0; k < count_of(formula, cam); ++k)
        data.parameters.push_back(cam.variables[k].parameter);
    return data;
}

/// An error of 0 leaves every bit.
RangeOver moved(const RangeOver& number, double error) {
    return error == 0.0 ? number : number + RangeOver(error);
}

}  // namespace

CamRule::CamRule(std::shared_ptr<const CamVariables> cam, CamFormula formula)
    : PointRule(data_of(formula, *cam)), cam_(std::move(cam)), formula_(std::move(formula)) {
    const std::size_t count = count_of(formula_, *cam_);
    active_.reserve(count);
    for (std::size_t k = 0; k < count; ++k) active_.push_back(cam_->variables[k].dimension);
    if (active_.size() > MechanismValue::most_active)
        throw ModelError(fmt::format("cam: found {} dimensions that are ranges; allowed: at most {}",
                                     active_.size(), MechanismValue::most_active));
}

Curvature CamRule::curvature(double least, double most) const {
    if (formula_.linear) return Curvature::linear;
    const double lift = cam_->scale.lift;
    return formula_.shape ? formula_.shape(lift * least, lift * most) : Curvature::general;
}

SlopeRange CamRule::slope_range() const {
    if (!parameters().empty()) return {};
    const double unit = cam_->scale.lift / cam_->scale.unit_angle;
    return {formula_.slopes.lower / unit, formula_.slopes.upper / unit};
}

std::array<double, 3> CamRule::units() const {
    const double lift = cam_->scale.lift, angle = cam_->scale.unit_angle;
    return {lift, lift / angle, lift / angle / angle};
}

std::optional<RangeAlong> CamRule::range_along(const Interval& x, const std::array<Interval, 5>& derivatives,
                                               const Eigen::VectorXd& q) const {
    if (!formula_.along) return {};
    ++*cam_->profile_points;
    // By x, like the rule's slope along the motion: only s', s'' are by the cam angle.
    const std::array<double, 3> unit = units();
    const auto along = [&](std::size_t order) {
        const Interval by(unit[order]), error(cam_->motion_error[order]);
        const Interval own = by * derivatives[order];
        return RangeAlong(cam_->motion_error[order] == 0.0 ? own : own + error, by * derivatives[order + 1],
                          by * derivatives[order + 2]);
    };
    const Interval angle(cam_->scale.unit_angle);
    const std::vector<double> dimensions = cam_->dimensions_for(q);
    const MechanismStateAlong state{dimensions, along(0), along(1), along(2),
                                    RangeAlong(angle * x, angle, Interval(0.0))};
    return formula_.along({*cam_->cam.formulas, state});
}

std::optional<RangeOver> CamRule::range_over(std::span<const Interval> box, const Interval& at) const {
    if (!formula_.over || box.size() > RangeOver::most) return {};
    ++*cam_->profile_points;
    const std::array<double, 3> unit = units();
    const auto motion = [&](int order) {
        const auto place = static_cast<std::size_t>(order);
        return moved(RangeOver::variable(box[place], order, unit[place]), cam_->motion_error[place]);
    };
    MechanismStateOver state{std::vector<RangeOver>(cam_->cam.dimensions.begin(), cam_->cam.dimensions.end()),
                             motion(0), motion(1), motion(2), Interval(cam_->scale.unit_angle) * at};
    for (std::size_t k = 0; k < active_.size(); ++k)
        state.dimensions[active_[k]] =
            moved(RangeOver::variable(box[4 + k], 4 + static_cast<int>(k), cam_->variables[k].reference),
                  cam_->variables[k].error);
    return formula_.over({*cam_->cam.formulas, state});
}

RuleValue CamRule::normalised(const MechanismValue& physical) const {
    const auto size = static_cast<Eigen::Index>(4 + active_.size());
    RuleValue rule{physical.value, Eigen::VectorXd::Zero(size), Eigen::MatrixXd::Zero(size, size)};
    const std::array<double, 3> unit = units();
    const auto unit_of = [&](Eigen::Index i) {
        const auto place = static_cast<std::size_t>(i);
        return i < 3 ? unit[place] : cam_->variables[place - 3].reference;
    };
    // y''' is between y'' and the parameters, and no quantity depends on it.
    const auto place_of = [](Eigen::Index i) { return i < 3 ? i : i + 1; };
    for (Eigen::Index i = 0; i + 1 < size; ++i) {
        rule.gradient[place_of(i)] = unit_of(i) * physical.gradient[i];
        for (Eigen::Index j = 0; j + 1 < size; ++j)
            rule.hessian(place_of(i), place_of(j)) = unit_of(i) * unit_of(j) * physical.hessian(i, j);
    }
    rule.by_place = cam_->scale.unit_angle * physical.by_angle;
    return rule;
}

RuleValue CamRule::evaluate(const MotionPoint& point, const Eigen::VectorXd& q) const {
    ++*cam_->profile_points;
    const std::vector<double> dimensions = cam_->dimensions_for(q);
    FollowerState output = state_of(point, cam_->scale);
    output.s += cam_->motion_error[0];
    output.velocity += cam_->motion_error[1];
    output.acceleration += cam_->motion_error[2];
    const MechanismState state{dimensions, output, cam_->scale.unit_angle * point.x};
    return normalised(formula_.value({*cam_->cam.formulas, state, active_, cam_->own_variables()}));
}

}  // namespace camopt
