// SPDX-License-Identifier: MIT
#include "objectives/boxes/rule_over_box.hpp"

namespace camopt {

namespace {

double magnitude_of(const Interval& a) {
    return std::max(std::abs(a.lower), std::abs(a.upper));
}

// Relative round-off of sums of a few products, rounded up generously.
constexpr double outward = 1.0 + 1e-12;

}  // namespace

std::optional<RuleOverBox> RuleOverBox::make(const PointRule& rule, std::vector<Interval> box, double at) {
    const std::optional<RangeOver> range = rule.range_over(box, at);
    if (!range || !std::isfinite(range->value.lower)) return {};
    RuleOverBox result(rule, std::move(box), at);
    const std::size_t size = result.box_.size();
    result.most_ = range->value.upper;
    result.curved_.assign(size, 0);
    result.added_.assign(size, 0.0);
    for (const Interval& number : result.box_) {
        result.middle_.push_back(std::isfinite(number.width()) ? 0.5 * (number.lower + number.upper) : 0.0);
        result.half_.push_back(outward * 0.5 * number.width());
    }
    const auto index = [](int i) { return static_cast<std::size_t>(i); };
    for (int i = 0; i < range->size(); ++i) {
        double discs = 0.0;
        for (int j = 0; j < range->size(); ++j) {
            const double size_of = magnitude_of(range->second(i, j));
            if (size_of == 0.0) continue;
            if (!std::isfinite(size_of) || !std::isfinite(result.half_[index(j)])) return {};
            result.curved_[index(i)] = 1;
            if (i != j) discs += size_of * result.half_[index(j)];
        }
        if (result.half_[index(i)] == 0.0) continue;  // a number, not a variable
        const double diagonal = range->second(i, i).lower;
        result.added_[index(i)] = std::max(0.0, outward * (discs / result.half_[index(i)]) - diagonal);
        if (result.added_[index(i)] > 0.0) result.added_[index(i)] *= outward;
    }
    return result;
}

double RuleOverBox::secant_error(int i) const {
    const auto at = static_cast<std::size_t>(i);
    return added_[at] == 0.0 ? 0.0 : 0.5 * added_[at] * half_[at] * half_[at];
}

std::optional<RulePlane> RuleOverBox::plane(const Eigen::VectorXd& at) const {
    const std::size_t size = box_.size();
    std::vector<Interval> point(size);
    for (std::size_t i = 0; i < size; ++i)
        point[i] = std::clamp(at[static_cast<Eigen::Index>(i)], box_[i].lower, box_[i].upper);
    const std::optional<RangeOver> range = rule_->range_over(point, at_);
    if (!range) return {};
    RulePlane plane{Eigen::VectorXd::Zero(static_cast<Eigen::Index>(size)), 0.0};
    Interval constant = range->value;
    for (std::size_t i = 0; i < size; ++i) {
        const auto k = static_cast<int>(i);
        Interval slope = k < range->size() ? range->first(k) : Interval(0.0);
        if (added_[i] > 0.0) {
            const Interval away = point[i] - Interval(middle_[i]), by(added_[i]);
            slope = slope + by * away;
            constant = constant + Interval(0.5) * by * (square(away) - square(Interval(half_[i])));
        }
        if (slope.lower == 0.0 && slope.upper == 0.0) continue;
        const double middle = 0.5 * (slope.lower + slope.upper);
        plane.slope[k] = middle;
        constant = constant - Interval(middle) * point[i];
        if (slope.lower != slope.upper)
            constant = constant + (slope - Interval(middle)) * (box_[i] - point[i]);
    }
    plane.constant = constant.lower;
    if (!plane.slope.allFinite() || !std::isfinite(plane.constant)) return {};
    return plane;
}

}  // namespace camopt
