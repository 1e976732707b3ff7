// SPDX-License-Identifier: MIT
#include "output/json/segment_json.hpp"

#include "output/words/display_scale.hpp"
#include "output/words/segment_table.hpp"

namespace camopt {

namespace {}  // namespace

Json spline_json(const std::optional<SplineCurve>& curve) {
    if (!curve) return nullptr;
    return {{"degree", curve->degree()},
            {"continuity", curve->continuity()},
            {"breakpoints", numbers_json(curve->breakpoints())},
            {"knots", numbers_json(curve->knots())},
            {"coefficients", numbers_json(curve->coefficients())}};
}

Json peaks_json(const std::optional<Peaks>& peaks) {
    if (!peaks) return nullptr;
    return {{"velocity", extremum_json(peaks->velocity)},
            {"acceleration", extremum_json(peaks->acceleration)},
            {"jerk", extremum_json(peaks->jerk)},
            {"torque", extremum_json(peaks->torque)},
            {"rms_velocity", number_json(peaks->rms_velocity)},
            {"rms_acceleration", number_json(peaks->rms_acceleration)},
            {"rms_jerk", number_json(peaks->rms_jerk)}};
}

Json segments_json(const Solution& solution) {
    if (solution.segments.empty()) return nullptr;
    const double degrees_per_x = display_scale(solution.scene.motion).degrees_per_x;
    Json list = Json::array();
    for (const SegmentReport& segment : solution.segments) {
        const bool open = segment.continuity < 0;
        list.push_back({{"kind", name_of(segment.kind)},
                        {"start_deg", number_json(degrees_per_x * segment.begin)},
                        {"angle_deg", number_json(degrees_per_x * (segment.end - segment.begin))},
                        {"from", number_json(segment.from)},
                        {"to", number_json(segment.to)},
                        {"continuity", open ? Json(nullptr) : Json(segment.continuity)},
                        {"peaks", peaks_json(segment_peaks(segment))},
                        {"spline", spline_json(segment.curve)},
                        {"law", segment.law.empty() ? Json(nullptr) : Json(segment.law)}});
    }
    return list;
}

}  // namespace camopt
