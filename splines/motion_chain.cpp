// SPDX-License-Identifier: MIT
#include "splines/motion_chain.hpp"

#include "core/errors.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace camopt {

namespace {
// Joints that differ by less than this part of the whole are the same place.
constexpr double same_place = 1e-12;

MotionPoint point_of(const ChainPart& part, double x, Side side) {
    MotionPoint point{x, {part.y0, 0.0, 0.0, 0.0}};
    if (!part.shape) return point;
    const double own = std::clamp((x - part.x0) / part.x_scale, part.shape->begin(), part.shape->end());
    const MotionPoint shape = part.shape->at(own, side);
    double scale = part.y_scale;
    for (std::size_t order = 0; order < 4; ++order) {
        point.derivative[order] += scale * shape.derivative[order];
        scale /= part.x_scale;
    }
    return point;
}
}  // namespace

int interval_of(const std::vector<double>& begins, double x, Side side) {
    const auto next =
        side == Side::right ? std::ranges::upper_bound(begins, x) : std::ranges::lower_bound(begins, x);
    const auto index = next - begins.begin() - 1;
    return static_cast<int>(
        std::clamp<std::ptrdiff_t>(index, 0, static_cast<std::ptrdiff_t>(begins.size()) - 1));
}

MotionChain::MotionChain(std::vector<ChainPart> parts) : parts_(std::move(parts)) {
    if (parts_.empty()) throw InputError("a chain of motions: found no part; allowed: one or more");
    const double tolerance = same_place * std::max(1.0, std::abs(end() - begin()));
    for (std::size_t i = 0; i < parts_.size(); ++i) {
        const bool joined = i == 0 || std::abs(parts_[i].begin - parts_[i - 1].end) <= tolerance;
        if (!joined || !(parts_[i].end > parts_[i].begin)) {
            throw InputError(
                fmt::format("a chain of motions: found part {} from {} to {}; allowed: ascending parts "
                            "without gaps",
                            i, parts_[i].begin, parts_[i].end));
        }
    }
}

MotionPoint MotionChain::at(double x, Side side) const {
    std::size_t index = 0;
    while (index + 1 < parts_.size() &&
           (side == Side::right ? x >= parts_[index + 1].begin : x > parts_[index + 1].begin)) {
        ++index;
    }
    return point_of(parts_[index], x, side);
}

std::vector<double> MotionChain::breakpoints() const {
    std::vector<double> points;
    const double tolerance = same_place * std::max(1.0, std::abs(end() - begin()));
    const auto add = [&](double x) {
        if (points.empty() || x > points.back() + tolerance) points.push_back(x);
    };
    for (const ChainPart& part : parts_) {
        add(part.begin);
        if (!part.shape) continue;
        for (const double own : part.shape->breakpoints()) {
            const double x = part.x0 + part.x_scale * own;
            if (x > part.begin && x < part.end - tolerance) add(x);
        }
    }
    add(parts_.back().end);
    return points;
}

}  // namespace camopt
