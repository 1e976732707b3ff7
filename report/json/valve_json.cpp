// SPDX-License-Identifier: MIT
#include "report/json/json_text.hpp"
#include "report/valves/valve_tables.hpp"

namespace camopt {
namespace {

Json margin_json(const ValveMargin& margin, const char* force) {
    return {{force, number_json(margin.least_force)},
            {"at_crank_deg", number_json(degrees_shown.of(margin.at))},
            {"share_of_spring", number_json(margin.share)}};
}

/// The least of all at the top, then those of nose and flank.
Json margins_json(const ValveMargins& margins, const char* force) {
    Json json = margin_json(margins.least(), force);
    json["engine_speed_rpm"] = number_json(rpm_shown.of(margins.engine_speed));
    json["nose"] = margin_json(margins.nose, force);
    json["flank"] = margin_json(margins.flank, force);
    return json;
}

}  // namespace

Json valve_json(const Solution& solution) {
    const MotionSpec& motion = solution.scene.motion;
    const ValveReport report = valve_report(solution);
    Json json = {{"nose_deg", number_json(degrees_shown.of(nose_angle(*motion.valve)))},
                 {"centerline_crank_deg", motion.valve->centerline
                                              ? number_json(2.0 * degrees_shown.of(*motion.valve->centerline))
                                              : Json(nullptr)},
                 {"events", rows_json(valve_events(solution, report))}};
    json.update(figures_json(valve_figures(solution, report)));
    const char* const force = motion.lift_is_angle ? "least_moment_nm" : "least_force_n";
    for (const ValveMargins& margins : report.margins) json["spring"].push_back(margins_json(margins, force));
    return json;
}

}  // namespace camopt
