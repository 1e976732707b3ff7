// SPDX-License-Identifier: MIT
#include "output/json/segment_json.hpp"

#include "core/peak_figures.hpp"
#include "output/words/display_scale.hpp"
#include "output/words/tables/segment_table.hpp"

namespace camopt {

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
    Json json = Json::object();
    for (const PeakFigure& figure : peak_figures)
        json[std::string(figure.name)] = figure.extremum != nullptr ? extremum_json((*peaks).*figure.extremum)
                                                                    : number_json(figure.of(*peaks));
    return json;
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
