// SPDX-License-Identifier: MIT
#include "report/view/view.hpp"

#include <iterator>

namespace camopt {

View::View(const Solution& shown)
    : solution(shown), units(shown_units(shown.scene)), delivered(sample_delivered(shown)) {
    if (!solution.motion) return;
    for (const DeliveredRow& row : delivered.rows) angles.push_back(degrees(row.x));
    for (const double x : solution.motion->breakpoints()) breakpoints.push_back(degrees(x));
    for (const SegmentReport& segment : solution.segments)
        segments.push_back({degrees(segment.begin), degrees(segment.end), segment_title(segment)});
    curves = motion_curves(*this);
    const auto add = [&](std::vector<Curve> more) {
        curves.insert(curves.end(), std::move_iterator(more.begin()), std::move_iterator(more.end()));
    };
    if (solution.drive) add(drive_curves(*this));
    if (solution.cam) add(cam_curves(*this));
    if (solution.scene.tolerance) add_made_bands(*this);
}

std::string segment_title(const SegmentReport& segment) {
    return segment.kind == SegmentKind::law ? words_of(segment.law) : std::string(name_of(segment.kind));
}

std::vector<double> View::along(const Motion& motion, const MotionUnit& unit) const {
    constexpr double rounding = 1e-9;  // of its length: its ends may be sums of other angles
    std::vector<double> values;
    for (const DeliveredRow& row : delivered.rows) {
        const double x = std::clamp(row.x, motion.begin(), motion.end());
        const bool inside = !row.closing && std::abs(row.x - x) <= rounding * (motion.end() - motion.begin());
        values.push_back(inside ? unit.per_normalised * motion.at(x, row.side).derivative[unit.order]
                                : std::nan(""));
    }
    return values;
}

}  // namespace camopt
