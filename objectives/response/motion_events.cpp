// SPDX-License-Identifier: MIT
#include "objectives/response/motion_events.hpp"

#include "core/units.hpp"

namespace camopt {
namespace {

constexpr double no_dwell = 1e-9;  // of x: a shorter dwell is round-off of a full revolution

MotionEvent event_before_dwell(double end, double turn) {
    MotionEvent event;
    event.moving = {{0.0, end}};
    if (turn > end + no_dwell) event.dwell = {{end, turn}};
    return event;
}

/// Segment by segment from the one after a dwell on, cyclically.
std::vector<MotionEvent> program_events(const MotionSpec& motion) {
    const auto& segments = motion.segments;
    const std::size_t count = segments.size();
    const auto dwells = [&](std::size_t i) { return segments[i % count].kind == SegmentKind::dwell; };
    std::vector<double> begins(1, 0.0);
    double angle = 0.0;
    for (const ProgramSegment& segment : segments) {
        angle += segment.angle;
        begins.push_back(angle / motion.unit_angle());
    }
    std::vector<MotionEvent> events;
    for (std::size_t i = 0; i < count; ++i) {
        if (dwells(i)) continue;
        const bool first = i == 0 ? !motion.closed || dwells(count - 1) : dwells(i - 1);
        if (!first) continue;
        MotionEvent event;
        for (std::size_t k = i; k < i + count; ++k) {
            if (k >= count && !motion.closed) break;
            const MotionStretch stretch{begins[k % count], begins[k % count + 1]};
            if (!dwells(k) && !event.dwell.empty()) break;
            (dwells(k) ? event.dwell : event.moving).push_back(stretch);
        }
        events.push_back(std::move(event));
    }
    return events;
}

}  // namespace

std::vector<MotionEvent> motion_events(const MotionSpec& motion) {
    if (motion.type == MotionType::program) return program_events(motion);
    return {event_before_dwell(motion.length(), units::turn / motion.unit_angle())};
}

MotionEvent single_rise(double unit_angle) {
    return event_before_dwell(1.0, units::turn / unit_angle);
}

}  // namespace camopt
