// SPDX-License-Identifier: MIT
#include "output/page/page_data.hpp"

#include "core/version.hpp"
#include "output/page/page_parts.hpp"
#include "output/words/cam_remarks.hpp"
#include "output/words/scene_words.hpp"
#include "output/words/tables/segment_table.hpp"
#include "studies/check/check_cam.hpp"
#include "studies/spatial/solved_cam.hpp"

#include <cmath>

namespace camopt {

namespace {

constexpr int dwell_steps = 24;  // rows over the dwell that closes a cam

Json angle_part(const Solution& solution, const PageRows& rows) {
    const double degrees = shown_units(solution.scene).degrees_per_x;
    Json values = Json::array();
    for (const MotionRow& row : rows.rows) values.push_back(rounded_json(degrees * row.x));
    return {{"unit", "deg"}, {"from", values.front()}, {"to", values.back()}, {"values", values}};
}

Json segments_part(const Solution& solution) {
    Json all = Json::array();
    const double degrees = shown_units(solution.scene).degrees_per_x;
    for (const SegmentReport& segment : solution.segments)
        all.push_back({{"from", rounded_json(degrees * segment.begin)},
                       {"to", rounded_json(degrees * segment.end)},
                       {"title", segment_title(segment)}});
    return all;
}

Json breakpoints_part(const Solution& solution) {
    Json all = Json::array();
    const double degrees = shown_units(solution.scene).degrees_per_x;
    for (const double x : solution.motion->breakpoints()) all.push_back(rounded_json(degrees * x));
    return all;
}

}  // namespace

Json rounded_json(double value, int digits) {
    if (!std::isfinite(value)) return nullptr;
    if (value == 0.0) return 0;
    const double power =
        std::pow(10.0, digits - 1 - static_cast<int>(std::floor(std::log10(std::abs(value)))));
    const double rounded = std::isfinite(power) && power > 0.0 ? std::round(value * power) / power : value;
    return rounded;
}

PageRows page_rows(const Solution& solution) {
    PageRows rows;
    if (!solution.motion) return rows;
    rows.rows = motion_rows(*solution.motion, solution.motion_peaks);
    rows.own = rows.rows.size();
    if (!solution.cam) return rows;
    rows.whole = cam_motion(solution);
    const double begin = solution.motion->end(), end = rows.whole->end();
    if (!(end > begin)) return rows;
    rows.rows.push_back({begin, Side::right});
    for (int i = 1; i <= dwell_steps; ++i)
        rows.rows.push_back(
            {begin + (end - begin) * i / dwell_steps, i < dwell_steps ? Side::right : Side::left});
    return rows;
}

MotionPoint page_motion_at(const Solution& solution, const PageRows& rows, std::size_t index) {
    const MotionRow& row = rows.rows[index];
    const Motion& motion = index < rows.own ? *solution.motion : *rows.whole;
    return motion.at(row.x, row.side);
}

bool page_needs_solids(const Solution& solution) {
    return solution.motion && solution.cam && has_spatial_cam(solution);
}

std::string page_data(const Solution& solution, const RunOrigin& origin, const PageDataOptions& options) {
    Json page = Json::object();
    page["page"] = "report";
    page["camopt"] = version();
    page["title"] = solution.scene.title.empty() ? "Motion" : solution.scene.title;
    page["verdict"] = options.proof ? verdict_part(solution) : open_verdict_part(solution);
    page["figures"] = figures_part(solution);
    page["reference"] = options.proof ? reference_part(solution, options.reference) : Json(nullptr);
    const PageRows rows = page_rows(solution);
    page["angle"] = solution.motion ? angle_part(solution, rows) : Json(nullptr);
    page["curves"] = motion_curves(solution, rows);
    for (Json& curve : cam_curves(solution, rows)) page["curves"].push_back(std::move(curve));
    page["segments"] = segments_part(solution);
    page["breakpoints"] = solution.motion ? breakpoints_part(solution) : Json::array();
    page["drawing"] = plane_drawing(solution, rows);
    page["solid"] = options.solid ? solid_drawing(solution, rows) : Json(nullptr);
    page["tables"] = options.proof ? tables_part(solution) : Json::array();
    page["remarks"] = options.proof && solution.cam ? Json(cam_remarks(solution)) : Json::array();
    page["notes"] = solution.notes;
    page["appendix"] = options.proof ? appendix_part(solution, origin) : Json(nullptr);
    page["scene"] = {
        {"file", origin.scene_file}, {"text", origin.scene_text}, {"lines", scene_lines(solution.scene)}};
    return page.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace camopt
