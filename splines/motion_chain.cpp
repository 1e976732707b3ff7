// SPDX-License-Identifier: MIT
#include "splines/motion_chain.hpp"

#include "core/errors.hpp"
#include "splines/curve.hpp"

#include <fmt/format.h>

namespace camopt {

namespace {
// Joints that differ by less than this part of the whole coincide.
constexpr double same_joint = 1e-12;
// Relative round-off of x = x0 + x_scale · own and its inverse.
constexpr double rounding = 4.0 * std::numeric_limits<double>::epsilon();

Side opposite(Side side) {
    return side == Side::left ? Side::right : Side::left;
}

/// x in the shape's units. Round-off is moved back to a breakpoint, so that each side of a jump stays on its
/// side.
double own_place(const ChainPart& part, const std::vector<double>& own_breakpoints, double x) {
    const double own = (x - part.x0) / part.x_scale;
    const double rounded = rounding * (std::abs(x) + std::abs(part.x0)) / std::abs(part.x_scale);
    const auto next = std::ranges::lower_bound(own_breakpoints, own - rounded);
    if (next != own_breakpoints.end() && *next <= own + rounded) return *next;
    return std::clamp(own, own_breakpoints.front(), own_breakpoints.back());
}

MotionPoint point_of(const ChainPart& part, const std::vector<double>& own_breakpoints, double x, Side side) {
    MotionPoint point{x, {part.y0, 0.0, 0.0, 0.0}};
    if (!part.shape) return point;
    const double own = own_place(part, own_breakpoints, x);
    const Side own_side = part.x_scale > 0.0 ? side : opposite(side);
    const MotionPoint shape = part.shape->at(own, own_side);
    double scale = part.y_scale;
    for (std::size_t order = 0; order < 4; ++order) {
        point.derivative[order] += scale * shape.derivative[order];
        scale /= part.x_scale;
    }
    return point;
}
}  // namespace

std::optional<std::array<Interval, 5>> ranges_of(const ChainPart& part, const Interval& x) {
    std::array<Interval, 5> own{Interval(part.y0)};
    if (!part.shape) return own;
    // Clamped to the shape's end against round-off.
    const auto place = [&](double at) {
        return std::clamp((at - part.x0) / part.x_scale, part.shape->begin(), part.shape->end());
    };
    const double one = place(x.lower), other = place(x.upper);
    const auto shape = part.shape->ranges({std::min(one, other), std::max(one, other)});
    if (!shape) return {};
    const Interval slower = Interval(1.0) / Interval(part.x_scale);
    Interval scale(part.y_scale);
    for (std::size_t r = 0; r < own.size(); ++r) {
        own[r] = own[r] + scale * (*shape)[r];
        scale = scale * slower;
    }
    return own;
}

int interval_of(const std::vector<double>& begins, double x, Side side) {
    const auto next =
        side == Side::right ? std::ranges::upper_bound(begins, x) : std::ranges::lower_bound(begins, x);
    const auto index = next - begins.begin() - 1;
    return static_cast<int>(
        std::clamp<std::ptrdiff_t>(index, 0, static_cast<std::ptrdiff_t>(begins.size()) - 1));
}

MotionChain::MotionChain(std::vector<ChainPart> parts) : parts_(std::move(parts)) {
    if (parts_.empty()) throw InputError("a chain of motions: found no part; allowed: one or more");
    const double tolerance = same_joint * std::max(1.0, std::abs(end() - begin()));
    for (std::size_t i = 0; i < parts_.size(); ++i) {
        const bool joined = i == 0 || std::abs(parts_[i].begin - parts_[i - 1].end) <= tolerance;
        if (!joined || !(parts_[i].end > parts_[i].begin))
            throw InputError(
                fmt::format("a chain of motions: found part {} from {} to {}; allowed: ascending parts "
                            "without gaps",
                            i, parts_[i].begin, parts_[i].end));
        own_breakpoints_.push_back(parts_[i].shape ? parts_[i].shape->breakpoints() : std::vector<double>{});
    }
}

/// At its ends a chain has one side only, even if a part continues past them.
std::size_t MotionChain::part_at(double x, Side& side) const {
    if (x <= begin()) side = Side::right;
    if (x >= end()) side = Side::left;
    std::size_t index = 0;
    while (index + 1 < parts_.size() &&
           (side == Side::right ? x >= parts_[index + 1].begin : x > parts_[index + 1].begin)) {
        ++index;
    }
    return index;
}

MotionPoint MotionChain::at(double x, Side side) const {
    const std::size_t index = part_at(x, side);
    return point_of(parts_[index], own_breakpoints_[index], x, side);
}

double MotionChain::higher_derivative(double x, int order, Side side) const {
    const std::size_t index = part_at(x, side);
    const ChainPart& part = parts_[index];
    if (!part.shape) return 0.0;
    const auto* const spline = dynamic_cast<const SplineCurve*>(part.shape.get());
    if (spline == nullptr)
        return order == 3 ? point_of(part, own_breakpoints_[index], x, side).derivative[3] : std::nan("");
    const double own = own_place(part, own_breakpoints_[index], x);
    const Side own_side = part.x_scale > 0.0 ? side : opposite(side);
    return part.y_scale / std::pow(part.x_scale, order) * spline->derivative(own, order, own_side);
}

std::vector<double> MotionChain::breakpoints() const {
    std::vector<double> points;
    const double tolerance = same_joint * std::max(1.0, std::abs(end() - begin()));
    const auto add = [&](double x) {
        if (points.empty() || x > points.back() + tolerance) points.push_back(x);
    };
    for (std::size_t i = 0; i < parts_.size(); ++i) {
        const ChainPart& part = parts_[i];
        add(part.begin);
        std::vector<double> own_points = own_breakpoints_[i];
        if (part.x_scale < 0.0) std::ranges::reverse(own_points);
        for (const double own : own_points) {
            const double x = part.x0 + part.x_scale * own;
            if (x > part.begin && x < part.end - tolerance) add(x);
        }
    }
    add(parts_.back().end);
    return points;
}

}  // namespace camopt
