// SPDX-License-Identifier: MIT
#include "studies/delivered/set_point_reports.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace camopt {
namespace {

/// The value farthest from `wanted`, from either side.
void look_at(SetPointReport& report, const Motion& motion, double wanted, double x) {
    for (const Side side : {Side::left, Side::right}) {
        // Outside of a region its velocity does not hold.
        const bool region = report.point.is_region() && report.order > 0;
        if (region && ((side == Side::left && x <= report.point.begin) ||
                       (side == Side::right && x >= report.point.end)))
            continue;
        const double found = motion.at(x, side).derivative[static_cast<std::size_t>(report.order)];
        const double distance = std::abs(found - wanted);
        if (distance < report.distance) continue;
        report.distance = distance;
        report.found = found;
        report.at = x;
    }
}

/// The motion is a polynomial on each piece of a region: where its velocity is right at degree places of a
/// piece and one more, it is right everywhere.
void look_along(SetPointReport& report, const Motion& motion, double wanted, int degree) {
    const PlacedPoint& region = report.point;
    std::vector<double> ends = {region.begin, region.end};
    for (const double point : motion.breakpoints())
        if (point > region.begin && point < region.end) ends.push_back(point);
    std::ranges::sort(ends);
    const int places = degree + 1;
    for (std::size_t i = 0; i + 1 < ends.size(); ++i)
        for (int k = 0; k <= places; ++k)
            look_at(report, motion, wanted, std::lerp(ends[i], ends[i + 1], static_cast<double>(k) / places));
}

}  // namespace

const char* set_point_name(int order) {
    constexpr std::array<const char*, 3> names = {"via_displacement", "via_velocity", "via_acceleration"};
    return names.at(static_cast<std::size_t>(order));
}

std::vector<SetPointReport> set_point_reports(const MotionSpec& spec, int degree, const Motion& motion) {
    std::vector<SetPointReport> all;
    for (const PlacedPoint& point : placed_points(spec)) {
        for (int order = 0; order < 3; ++order) {
            const std::optional<double>& wanted = point.wanted[static_cast<std::size_t>(order)];
            if (!wanted) continue;
            const WrittenValue written = written_value(spec, point, order);
            SetPointReport report;
            report.point = point;
            report.order = order;
            report.key = written.key;
            report.unit = written.unit;
            report.size = std::abs(*wanted);
            if (point.is_region() && order == 1)
                look_along(report, motion, *wanted, degree);
            else
                look_at(report, motion, *wanted, std::clamp(point.begin, motion.begin(), motion.end()));
            report.wanted = as_written(*wanted * written.per_normalised);
            report.found *= written.per_normalised;
            all.push_back(std::move(report));
        }
    }
    return all;
}

}  // namespace camopt
