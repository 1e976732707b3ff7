// SPDX-License-Identifier: MIT
#include "objectives/rules/linear_bound.hpp"

namespace camopt {

LinearRule::LinearRule(const LinearBound& bound)
    : PointRule({.name = bound.key,
                 .highest_order = bound.order,
                 .limit = bound.peak < 0,
                 .linear = true,
                 .parameters = bound.peak < 0 ? std::vector<int>{} : std::vector{bound.peak},
                 .sign = bound.sign,
                 .remark = bound.remark,
                 .fields = bound.fields,
                 .places = bound.from == bound.until ? std::vector{bound.from} : std::vector<double>{},
                 .between = {bound.from, bound.until},
                 .starts_without_rows = bound.starts_without_rows}),
      bound_(bound) {}

double LinearRule::scale_at(double x) const {
    if (!bound_.touches()) return 1.0;
    // So close to the ends that y, which leaves them from rest, is below 1e-10 of its stroke.
    constexpr double at_the_end = 1e-9;
    const double along = std::clamp((x - bound_.begin) / (bound_.end - bound_.begin), 0.0, 1.0);
    const int begin = bound_.contact_begin, end = bound_.contact_end;
    const double scale = !bound_.touches_end     ? std::pow(along, begin)
                         : !bound_.touches_begin ? std::pow(1.0 - along, end)
                         : begin == end          ? std::pow(4.0 * along * (1.0 - along), begin)
                                        : std::pow(2.0 * along, begin) * std::pow(2.0 * (1.0 - along), end);
    return scale > at_the_end ? scale : 0.0;
}

double LinearRule::rounding() const {
    if (!bound_.touches()) return 0.0;
    // Of a polynomial by powers of the distance from its left breakpoint.
    constexpr double of_polynomial = 8.0 * std::numeric_limits<double>::epsilon();
    const double size = bound_.order == 0 ? std::max(1.0, std::abs(bound_.bound)) / bound_.scale : 1.0;
    return of_polynomial * size;
}

RuleValue LinearRule::evaluate(const MotionPoint& point, const Eigen::VectorXd& q) const {
    const Eigen::Index variables = bound_.peak < 0 ? 4 : 5;
    RuleValue rule{0.0, Eigen::VectorXd::Zero(variables), Eigen::MatrixXd::Zero(variables, variables)};
    if (bound_.of_motor()) {
        const auto& [velocity, acceleration, constant] = bound_.weights;
        rule.gradient[1] = velocity / bound_.scale;
        rule.gradient[2] = acceleration / bound_.scale;
        rule.value =
            (velocity * point.derivative[1] + acceleration * point.derivative[2] + constant - bound_.bound) /
            bound_.scale;
        return rule;
    }
    const double weight = bound_.sign / bound_.scale;
    rule.gradient[bound_.order] = weight;
    rule.value = weight * point.derivative[bound_.order] - bound_.bound / bound_.scale;
    if (bound_.peak < 0) return rule;
    rule.gradient[4] = -1.0;
    rule.value -= q[0];
    return rule;
}

std::optional<RangeAlong> LinearRule::range_along(const Interval&, const std::array<Interval, 5>& derivatives,
                                                  const Eigen::VectorXd& q) const {
    const RuleValue at_zero = evaluate({}, q);
    RangeAlong range(at_zero.value);
    const std::array<Interval*, 3> parts = {&range.value, &range.slope, &range.bend};
    for (std::size_t order = 0; order < 4; ++order) {
        const double weight = at_zero.gradient[static_cast<Eigen::Index>(order)];
        if (weight == 0.0) continue;
        for (std::size_t r = 0; r < parts.size(); ++r)
            *parts[r] = order + r < derivatives.size() ? *parts[r] + Interval(weight) * derivatives[order + r]
                                                       : Interval(-infinity, infinity);
    }
    return range;
}

PlacedRule LinearBound::rule() const {
    PlacedRule placed(std::make_shared<const LinearRule>(*this), stretch);
    placed.datum = datum;
    placed.on_copies = on_copies;
    placed.seen = seen;
    return placed;
}

}  // namespace camopt
