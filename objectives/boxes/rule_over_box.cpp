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

std::optional<RuleOverBox::Product> RuleOverBox::product_of(const RangeOver& range) {
    std::optional<Product> found;
    for (int i = 0; i < range.size(); ++i) {
        for (int j = i; j < range.size(); ++j) {
            const Interval& second = range.second(i, j);
            if (magnitude_of(second) == 0.0) continue;
            if (i == j || found || (second.lower < 0.0 && second.upper > 0.0)) return {};
            found = Product{static_cast<std::size_t>(i), static_cast<std::size_t>(j), second.lower >= 0.0};
        }
    }
    return found;
}

std::optional<RuleOverBox> RuleOverBox::make(const PointRule& rule, std::vector<Interval> box, double at) {
    const std::optional<RangeOver> range = rule.range_over(box, at);
    if (!range || !std::isfinite(range->value.lower)) return {};
    RuleOverBox result(rule, std::move(box), at);
    const std::size_t size = result.box_.size();
    result.most_ = range->value.upper;
    result.product_ = product_of(*range);
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

std::vector<double> RuleOverBox::tangent_point(const Eigen::VectorXd& at) const {
    std::vector<double> point(box_.size());
    for (std::size_t i = 0; i < point.size(); ++i)
        point[i] = std::clamp(at[static_cast<Eigen::Index>(i)], box_[i].lower, box_[i].upper);
    if (!product_) return point;
    double &one = point[product_->one], &other = point[product_->other];
    const Interval &ones = box_[product_->one], &others = box_[product_->other];
    // Opposite corners: of the two distances from each, the product is what its tangent falls short.
    const double below = product_->rising ? others.lower : others.upper;
    const double above = product_->rising ? others.upper : others.lower;
    const bool upper =
        (ones.upper - one) * std::abs(above - other) < (one - ones.lower) * std::abs(other - below);
    one = upper ? ones.upper : ones.lower;
    other = upper ? above : below;
    return point;
}

std::optional<RulePlane> RuleOverBox::plane(const Eigen::VectorXd& at) const {
    const std::size_t size = box_.size();
    const std::vector<double> numbers = tangent_point(at);
    const std::vector<Interval> point(numbers.begin(), numbers.end());
    const std::optional<RangeOver> range = rule_->range_over(point, at_);
    if (!range) return {};
    RulePlane plane{Eigen::VectorXd::Zero(static_cast<Eigen::Index>(size)), 0.0};
    Interval constant = range->value;
    for (std::size_t i = 0; i < size; ++i) {
        const auto k = static_cast<int>(i);
        Interval slope = k < range->size() ? range->first(k) : Interval(0.0);
        if (!product_ && added_[i] > 0.0) {
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
