// SPDX-License-Identifier: MIT
#include "output/view/limit_spans.hpp"

#include "objectives/rules/cam_limits.hpp"
#include "scene/limit_table.hpp"
#include "splines/extrema.hpp"

#include <array>
#include <cmath>

namespace camopt {

namespace {

constexpr double at_rest = 1e-9;  // of a displacement: less than this over a piece is a dwell

}  // namespace

const std::optional<PeakLimit>& peak_limit_of(const LimitSpec& limits, int order) {
    static const std::optional<PeakLimit> none;
    for (const PeakLimitRow& row : peak_limit_rows())
        if (row.order() == order) return row.in(limits);
    return none;
}

/// A normalised limit holds for each spline segment by its own angle and displacement: the ratio of the
/// segment's two peaks is what brings it to the motion's own units.
std::vector<LimitSpan> segment_limits(const Solution& solution, const PeakLimit& limit, int order) {
    constexpr std::array peaks = {&Peaks::velocity, &Peaks::acceleration, &Peaks::jerk};
    const auto peak = peaks[static_cast<std::size_t>(order) - 1];
    std::vector<LimitSpan> spans;
    if (limit.in_time()) return spans;
    for (const SegmentReport& segment : solution.segments) {
        if (!segment.curve || !segment.peaks) continue;
        const double normalised = ((*segment.peaks).*peak).value;
        if (!(normalised > 0.0)) continue;
        const double own = (peaks_of(*segment.curve).*peak).value;
        spans.push_back({segment.begin, segment.end, limit.normalised * own / normalised});
    }
    return spans;
}

std::vector<PressureLimit> pressure_spans(const Scene& scene, const Motion& motion) {
    const PressureLimits limits = pressure_limits(scene.limits);
    const std::optional<WrittenLimit> at_standstill = limits.at_rest();
    if (!at_standstill) return {};
    const double angle = scene.motion.unit_angle();
    std::vector<PressureLimit> spans;
    const std::vector<double> places = motion.breakpoints();
    for (std::size_t i = 0; i + 1 < places.size(); ++i) {
        const double change = motion.at(places[i + 1], Side::left).derivative[0] -
                              motion.at(places[i], Side::right).derivative[0];
        const auto& own = std::abs(change) < at_rest ? at_standstill
                          : change > 0.0             ? limits.rise
                                                     : limits.back;
        if (!own) continue;
        const bool goes_on =
            !spans.empty() && spans.back().end == angle * places[i] && spans.back().limit == own->value;
        if (goes_on)
            spans.back().end = angle * places[i + 1];
        else
            spans.push_back({angle * places[i], angle * places[i + 1], own->value});
    }
    return spans;
}

}  // namespace camopt
