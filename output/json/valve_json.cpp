// SPDX-License-Identifier: MIT
#include "output/json/json_text.hpp"
#include "output/view/shown_units.hpp"
#include "studies/valve/valve_report.hpp"

#include <fmt/format.h>

namespace camopt {
namespace {

Json event_json(const ValveEvent& event) {
    return {{"height_mm", number_json(millimetres_shown.of(event.height))},
            {"opens_crank_deg", number_json(degrees_shown.of(event.opens))},
            {"closes_crank_deg", number_json(degrees_shown.of(event.closes))},
            {"duration_crank_deg", number_json(degrees_shown.of(event.duration()))},
            {"area_mm_crank_deg", number_json(degrees_shown.of(millimetres_shown.of(event.area)))}};
}

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
    const ShownUnits shown = file_units(solution.scene);
    const std::string unit = motion.lift_is_angle ? "deg" : "mm";
    const ShownUnit velocity = unit_named<"mm/deg">,
                    acceleration = motion.lift_is_angle ? unit_named<"deg/deg^2"> : unit_named<"mm/deg^2">;
    Json json = {{"nose_deg", number_json(degrees_shown.of(nose_angle(*motion.valve)))},
                 {"centerline_crank_deg", motion.valve->centerline
                                              ? number_json(2.0 * degrees_shown.of(*motion.valve->centerline))
                                              : Json(nullptr)},
                 {"lobe_lift_" + unit, number_json(shown.motion[0].first.of(motion.lift))}};
    json["events"] = Json::array();
    for (const ValveEvent& event : report.events) json["events"].push_back(event_json(event));
    json["opening_velocity_mm_deg"] = number_json(velocity.of(report.opening_velocity));
    json["closing_velocity_mm_deg"] = number_json(velocity.of(report.closing_velocity));
    const std::string by_angle = fmt::format("acceleration_{}_deg2", unit);
    json["opening_" + by_angle] = number_json(acceleration.of(report.opening_acceleration));
    json["nose_" + by_angle] = number_json(acceleration.of(report.nose_acceleration));
    json["closing_" + by_angle] = number_json(acceleration.of(report.closing_acceleration));
    const auto add_length = [&](const char* key, const std::optional<double>& value) {
        if (value) json[key] = number_json(millimetres_shown.of(*value));
    };
    if (report.nose_radius) {
        add_length("nose_radius_mm", report.nose_radius->value);
        json["nose_radius_at_crank_deg"] = number_json(degrees_shown.of(report.nose_radius->at));
    }
    add_length("contact_eccentricity_mm", report.contact_offset);
    const char* const force = motion.lift_is_angle ? "least_moment_nm" : "least_force_n";
    for (const ValveMargins& margins : report.margins) json["spring"].push_back(margins_json(margins, force));
    if (report.lift_off_speed)
        json["lift_off_engine_speed_rpm"] = number_json(rpm_shown.of(*report.lift_off_speed));
    return json;
}

}  // namespace camopt
