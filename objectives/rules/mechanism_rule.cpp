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
    : LimitRule(static_cast<const LimitFrame&>(formula), mechanism->scale),
      mechanism_(std::move(mechanism)),
      formula_(std::move(formula)) {
    for (const CamVariables::Variable& variable : mechanism_->variables) {
        add_variable(3 + static_cast<int>(active_.size()), variable.parameter, variable.reference);
        active_.push_back(variable.dimension);
    }
}

std::optional<RangeOver> MechanismRule::range_over(std::span<const Interval> box, double at) const {
    if (!formula_.over || box.size() > RangeOver::most) return {};
    ++*mechanism_->profile_points;
    const double lift = mechanism_->scale.lift, angle = mechanism_->scale.unit_angle;
    const double slope = lift / angle;
    MechanismStateOver state{
        std::vector<RangeOver>(mechanism_->cam.dimensions.begin(), mechanism_->cam.dimensions.end()),
        RangeOver::variable(box[0], 0, lift), RangeOver::variable(box[1], 1, slope),
        RangeOver::variable(box[2], 2, slope / angle), Interval(angle) * Interval(at)};
    for (std::size_t k = 0; k < active_.size(); ++k)
        state.dimensions[static_cast<std::size_t>(active_[k])] =
            RangeOver::variable(box[4 + k], 4 + static_cast<int>(k), mechanism_->variables[k].reference);
    return formula_.over(*mechanism_->cam.formulas, state);
}

bool MechanismRule::at_every_station() const {
    return mechanism_->cam.formulas->has_all_stations(formula_.figure);
}

std::vector<double> MechanismRule::dimensions_at(const Eigen::VectorXd& q) const {
    std::vector<double> dimensions = mechanism_->cam.dimensions;
    for (std::size_t k = 0; k < active_.size(); ++k)
        dimensions[static_cast<std::size_t>(active_[k])] =
            mechanism_->variables[k].reference * q[static_cast<Eigen::Index>(k)];
    return dimensions;
}

std::optional<RangeAlong> MechanismRule::range_along(const Interval& x,
                                                     const std::array<Interval, 5>& derivatives,
                                                     const Eigen::VectorXd& q) const {
    if (!formula_.along) return {};
    ++*mechanism_->profile_points;
    // By x, as the rule's slope along the motion is.
    const auto along = [&](double unit, std::size_t order) {
        const Interval by(unit);
        return RangeAlong(by * derivatives[order], by * derivatives[order + 1], by * derivatives[order + 2]);
    };
    const std::vector<double> dimensions = dimensions_at(q);
    const double lift = mechanism_->scale.lift, angle = mechanism_->scale.unit_angle, slope = lift / angle;
    const RangeAlong theta(Interval(angle) * x, Interval(angle), Interval(0.0));
    return formula_.along(*mechanism_->cam.formulas,
                          {dimensions, along(lift, 0), along(slope, 1), along(slope / angle, 2), theta});
}

RuleValue MechanismRule::evaluate(const MotionPoint& point, const Eigen::VectorXd& q) const {
    ++*mechanism_->profile_points;
    const std::vector<double> dimensions = dimensions_at(q);
    const double theta = mechanism_->scale.unit_angle * point.x;
    const MechanismCall call{*mechanism_->cam.formulas,
                             {dimensions, state_of(point, mechanism_->scale), theta},
                             formula_.station,
                             active_};
    const MechanismValue physical = formula_.value(call);
    RuleValue rule = normalised(physical);
    rule.by_place = mechanism_->scale.unit_angle * physical.by_angle;
    return rule;
}

}  // namespace camopt
