// SPDX-License-Identifier: MIT
#include "output/json/mechanism_json.hpp"

#include "core/units.hpp"

namespace camopt {

namespace {

using units::degree, units::millimetre;

Json extreme_json(const Solution& solution, const std::optional<CamExtreme>& extreme, double unit) {
    if (!extreme) return nullptr;
    return {{"value", number_json(extreme->value / unit)},
            {"at_deg", number_json(extreme->at * solution.scene.motion.unit_angle() / degree)}};
}

/// In SI, bit for bit: millimetres may not read back as the same metres.
Json exact_dimensions_json(const MechanismSpec& spec, const std::vector<double>& numbers) {
    Json json = Json::object();
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        const MechanismDimension& dimension = spec.dimensions[i];
        json[dimension.name + (dimension.is_angle ? "_rad" : "_m")] = number_json(numbers[i]);
    }
    return json;
}

Json check_json(const Solution& solution) {
    const std::optional<ForwardCheckReport>& check = solution.mechanism->forward_check;
    if (!check) return nullptr;
    const bool swings = solution.scene.motion.lift_is_angle;
    return {{swings ? "deviation_deg" : "deviation_mm",
             number_json(check->deviation / (swings ? degree : millimetre))},
            {"relative", number_json(check->relative)},
            {"points", check->points},
            {"seconds", number_json(check->seconds)},
            {"at_deg", number_json(check->at * solution.scene.motion.unit_angle() / degree)}};
}

}  // namespace

Json mechanism_dimensions_json(const Solution& solution) {
    Json json = Json::object();
    const auto& all = solution.scene.mechanism->dimensions;
    for (std::size_t i = 0; i < all.size(); ++i) {
        const Dimension& value = all[i].value;
        if (value.key.empty()) continue;  // this linkage has no such dimension
        const std::string key = all[i].name + (all[i].is_angle ? "_deg" : "_mm");
        std::optional<double> number;
        if (!value.is_variable()) number = value.low;
        if (solution.mechanism) number = solution.mechanism->mechanism.dimensions[i];
        json[key] = number ? number_json(*number / (all[i].is_angle ? degree : millimetre)) : Json(nullptr);
    }
    return json;
}

Json mechanism_json(const Solution& solution) {
    if (!solution.mechanism) return nullptr;
    const MechanismSpec& spec = *solution.scene.mechanism;
    const MechanismSummary& summary = solution.mechanism->summary;
    Json json = Json::object();
    json["type"] = spec.type;
    for (const auto& [name, choice] : spec.choices) json[name] = choice;
    json["rotation"] = name_of(spec.rotation);
    json["pressure_angle_deg"] = extreme_json(solution, summary.pressure_angle, degree);
    json["convex_radius_mm"] = extreme_json(solution, summary.convex_radius, millimetre);
    json["concave_radius_mm"] = extreme_json(solution, summary.concave_radius, millimetre);
    json["regularity"] = extreme_json(solution, summary.regularity, 1.0);
    json["undercut"] = summary.undercut();
    json["base_radius_mm"] = number_json(summary.base_radius / millimetre);
    json["dimensions"] = exact_dimensions_json(spec, solution.mechanism->mechanism.dimensions);
    json["forward_check"] = check_json(solution);
    return json;
}

}  // namespace camopt
