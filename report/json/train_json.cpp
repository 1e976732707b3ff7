// SPDX-License-Identifier: MIT
#include "report/json/json_text.hpp"
#include "report/view/shown_units.hpp"

namespace camopt {

namespace {

Json worst_json(const Scene& scene, const char* name, const std::optional<ResponseReport>& worst) {
    if (!worst) return nullptr;
    return {{name, number_json(worst->value)},
            {"speed_rpm", number_json(rpm_shown.of(worst->speed))},
            {"at_deg", number_json(worst->at * file_units(scene).degrees_per_x)}};
}

}  // namespace

Json frequencies_json(const std::vector<double>& frequencies) {
    Json list = Json::array();
    for (const double one : frequencies) list.push_back(number_json(hertz_shown.of(one)));
    return list;
}

Json train_json(const Solution& solution) {
    if (!solution.train) return nullptr;
    const Scene& scene = solution.scene;
    const TrainReport& train = *solution.train;
    Json json;
    json["natural_frequencies_hz"] = frequencies_json(train.natural_frequencies);
    json["frequency_ratio"] = number_json(train.frequency_ratio);
    json["speed_range_rpm"] = {number_json(rpm_shown.of(train.speeds[0])),
                               number_json(rpm_shown.of(train.speeds[1]))};
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

Json surge_json(const Solution& solution) {
    const Scene& scene = solution.scene;
    const bool angle = scene.motion.lift_is_angle;
    const ShownUnit& unit = angle ? degrees_shown : millimetres_shown;
    Json harmonics = Json::array();
    for (const SurgeReport::Harmonic& one : solution.surge->harmonics)
        harmonics.push_back({{"order", one.order},
                             {angle ? "amplitude_deg" : "amplitude_mm", number_json(unit.of(one.amplitude))},
                             {"resonant_speed_rpm", number_json(rpm_shown.of(one.resonant_speed))},
                             {"near", one.near},
                             {"limited", one.limited}});
    return {{"spring_frequency_hz", number_json(hertz_shown.of(*scene.forces->spring_frequency))},
            {"frequency_ratio", number_json(solution.surge->frequency_ratio)},
            {"harmonics", std::move(harmonics)}};
}

}  // namespace camopt
