// SPDX-License-Identifier: MIT
#include "output/json/study_json.hpp"

#include "core/version.hpp"
#include "output/json/json_text.hpp"
#include "output/view/shown_units.hpp"

namespace camopt {

namespace {

const char* force_name(const Scene& scene) {
    return scene.motion.lift_is_angle ? "least_force_nm" : "least_force_n";
}

Json train_row_json(const Scene& scene, const TrainRow& row) {
    return {{"motion", row.motion},
            {"stroke", row.stroke},
            {"speed_rpm", number_json(rpm_shown.of(row.speed))},
            {"frequency_ratio", number_json(row.frequency_ratio)},
            {"residual", number_json(row.residual)},
            {"peak_deflection", number_json(row.peak_deflection)},
            {"peak_acceleration", number_json(row.peak_acceleration)},
            {"lifts_off", row.lifts_off()},
            {force_name(scene), number_json(row.least_force)}};
}

Json motions_json(const TrainStudy& study) {
    const MotionSpec& motion = study.scene.motion;
    Json list = Json::array();
    for (std::size_t k = 0; k < study.lift_off_speeds.size(); ++k) {
        const std::optional<double>& speed = study.lift_off_speeds[k];
        const auto& [key, title] = study.motions[k % study.motions.size()];
        const std::size_t stroke = k / study.motions.size();
        const std::vector<MotionStretch>& moving = study.strokes[stroke].moving;
        list.push_back(
            {{"motion", key},
             {"title", title},
             {"stroke", stroke + 1},
             {"start_deg", number_json(degrees_shown.of(motion.master_angle(moving.front().begin)))},
             {"end_deg", number_json(degrees_shown.of(motion.master_angle(moving.back().end)))},
             {"lifts_off_at_rpm", speed ? number_json(rpm_shown.of(*speed)) : Json(nullptr)}});
    }
    return list;
}

Json steady_json(const TrainStudy& study) {
    Json list = Json::array();
    for (const SteadyRow& row : study.steady)
        list.push_back({{"speed_rpm", number_json(rpm_shown.of(row.speed))},
                        {"peak_deflection", number_json(row.peak_deflection)},
                        {"peak_acceleration", number_json(row.peak_acceleration)},
                        {force_name(study.scene), number_json(row.least_force)}});
    return list;
}

}  // namespace

std::string dynamics_json(const TrainStudy& study) {
    Json json;
    json["camopt"] = version();
    json["title"] = words_json(study.scene.title);
    json["natural_frequencies_hz"] = frequencies_json(study.natural_frequencies);
    json["motions"] = motions_json(study);
    json["rows"] = Json::array();
    for (const TrainRow& row : study.rows) json["rows"].push_back(train_row_json(study.scene, row));
    json["steady_state"] = steady_json(study);
    return json_text(json);
}

}  // namespace camopt
