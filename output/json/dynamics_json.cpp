// SPDX-License-Identifier: MIT
#include "output/json/dynamics_json.hpp"

#include "core/units.hpp"
#include "core/version.hpp"
#include "output/json/train_json.hpp"
#include "output/words/display_scale.hpp"

namespace camopt {
namespace {

double rpm_of(double speed) {
    return speed / units::revolution_per_minute;
}

Json frequencies_json(const std::vector<double>& frequencies) {
    Json list = Json::array();
    for (const double one : frequencies) list.push_back(number_json(one / units::turn));
    return list;
}

const char* force_name(const Scene& scene) {
    return scene.motion.lift_is_angle ? "least_force_nm" : "least_force_n";
}

Json train_row_json(const Scene& scene, const TrainRow& row) {
    return {{"motion", row.motion},
            {"speed_rpm", number_json(rpm_of(row.speed))},
            {"frequency_ratio", number_json(row.frequency_ratio)},
            {"residual", number_json(row.residual)},
            {"peak_deflection", number_json(row.peak_deflection)},
            {"peak_acceleration", number_json(row.peak_acceleration)},
            {"lifts_off", row.lifts_off()},
            {force_name(scene), number_json(row.least_force)}};
}

Json motions_json(const TrainStudy& study) {
    Json list = Json::array();
    for (std::size_t i = 0; i < study.motions.size(); ++i) {
        const std::optional<double>& speed = study.lift_off_speeds[i];
        list.push_back({{"motion", study.motions[i].first},
                        {"title", study.motions[i].second},
                        {"lifts_off_at_rpm", speed ? number_json(rpm_of(*speed)) : Json(nullptr)}});
    }
    return list;
}

Json steady_json(const TrainStudy& study) {
    Json list = Json::array();
    for (const SteadyRow& row : study.steady)
        list.push_back({{"speed_rpm", number_json(rpm_of(row.speed))},
                        {"peak_deflection", number_json(row.peak_deflection)},
                        {"peak_acceleration", number_json(row.peak_acceleration)},
                        {force_name(study.scene), number_json(row.least_force)}});
    return list;
}

Json worst_json(const Scene& scene, const char* name, const std::optional<ResponseReport>& worst) {
    if (!worst) return nullptr;
    return {{name, number_json(worst->value)},
            {"speed_rpm", number_json(rpm_of(worst->speed))},
            {"at_deg", number_json(worst->at * display_scale(scene.motion).degrees_per_x)}};
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

Json train_json(const Solution& solution) {
    if (!solution.train) return nullptr;
    const Scene& scene = solution.scene;
    const TrainReport& train = *solution.train;
    Json json;
    json["natural_frequencies_hz"] = frequencies_json(train.natural_frequencies);
    json["frequency_ratio"] = number_json(train.frequency_ratio);
    json["speed_range_rpm"] = {number_json(rpm_of(train.speeds[0])), number_json(rpm_of(train.speeds[1]))};
    json["residual"] = worst_json(scene, "lifts", train.residual);
    json["acceleration"] = worst_json(scene, "normalised", train.acceleration);
    json["contact_force"] =
        worst_json(scene, scene.motion.lift_is_angle ? "least_nm" : "least_n", train.least_force);
    json["terms"] = Json::array();
    for (const ResponseTermReport& term : train.terms)
        json["terms"].push_back({{"name", term.name},
                                 {"weight", number_json(term.weight)},
                                 {"reference", number_json(term.reference)},
                                 {"value", number_json(term.worst.value)}});
    return json;
}

}  // namespace camopt
