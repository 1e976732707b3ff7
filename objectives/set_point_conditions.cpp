// SPDX-License-Identifier: MIT
#include "objectives/set_point_conditions.hpp"

#include <algorithm>

namespace camopt {
namespace {

// Of a uniform segment: a breakpoint this close to a region would leave a very short segment between them.
constexpr double sliver = 0.25;
// x: a breakpoint of the scene this close to the end of a region coincides with it.
constexpr double same_breakpoint = 1e-12;

void add_region(std::vector<PointCondition>& all, const PlacedPoint& region, int degree,
                const std::string& name) {
    const auto add = [&](double at, int order, Side side, double value) {
        all.push_back({at, order, side, value, name, true, true});
    };
    const double velocity = *region.wanted[1];
    add(region.begin, 1, Side::right, velocity);
    add(region.begin, 2, Side::right, 0.0);
    add(region.end, 2, Side::left, 0.0);
    if (degree <= 3) return;
    add(region.end, 1, Side::left, velocity);
    add(0.5 * (region.begin + region.end), 1, Side::right, velocity);
}

}  // namespace

std::vector<PointCondition> conditions_of(const MotionSpec& motion, const PlacedPoint& point, int degree,
                                          double end) {
    std::vector<PointCondition> conditions;
    const Side side = point.begin < end ? Side::right : Side::left;
    for (int order = 0; order < 3; ++order) {
        const std::optional<double>& value = point.wanted[static_cast<std::size_t>(order)];
        if (!value) continue;
        const std::string name = words_of(motion, point, order);
        if (point.is_region() && order == 1)
            add_region(conditions, point, degree, name);
        else
            conditions.push_back({point.begin, order, side, *value, name});
    }
    return conditions;
}

std::vector<std::array<double, 2>> regions_of(const MotionSpec& motion,
                                              const std::vector<PlacedPoint>& points, int segment) {
    std::vector<std::array<double, 2>> regions;
    const double length = motion.length();
    for (const PlacedPoint& point : points) {
        if (point.segment != segment || !point.is_region()) continue;
        regions.push_back({point.begin, point.end});
        if (motion.symmetric) regions.push_back({length - point.end, length - point.begin});
    }
    return regions;
}

std::vector<double> breakpoints_of(const SplineSpec& spline, double begin, double end,
                                   const std::vector<std::array<double, 2>>& regions) {
    std::vector<double> points;
    const double width = end - begin;
    if (spline.breakpoints.empty()) {
        for (int i = 0; i <= spline.segments; ++i)
            points.push_back(begin + width * static_cast<double>(i) / spline.segments);
        points.front() = begin;
        points.back() = end;
        return with_regions(std::move(points), regions, sliver * width / spline.segments);
    }
    const double unit = width / (spline.breakpoints.back() - spline.breakpoints.front());
    for (const double at : spline.breakpoints)
        points.push_back(begin + unit * (at - spline.breakpoints.front()));
    points.front() = begin;
    points.back() = end;
    return with_regions(std::move(points), regions, same_breakpoint);
}

}  // namespace camopt
