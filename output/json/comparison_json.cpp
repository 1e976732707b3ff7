// SPDX-License-Identifier: MIT
#include "output/json/comparison_json.hpp"

#include "core/units.hpp"
#include "core/version.hpp"
#include "output/json/json_text.hpp"
#include "output/json/segment_json.hpp"
#include "output/json/verdict_json.hpp"
#include "output/words/comparison_words.hpp"
#include "output/words/display_scale.hpp"
#include "studies/delivered/limit_activity.hpp"

namespace camopt {

namespace {

Json limits_json(const ComparisonRow& row, double degrees_per_x) {
    Json list = Json::array();
    for (const LimitOutcome& outcome : row.limits) {
        const ConstraintReport& reached = outcome.reached;
        list.push_back(
            {{"name", reached.name},
             {"limit", number_json(reached.limit)},
             {"worst", number_json(reached.worst)},
             {"unit", reached.unit},
             {"at_deg", is_nowhere(reached) ? Json(nullptr) : number_json(reached.at * degrees_per_x)},
             {"kept", outcome.kept},
             {"no_contact", reached.no_contact},
             {"excess", number_json(outcome.excess)},
             {"key", reached.key}});
    }
    return list;
}

Json base_json(const ComparisonRow& row) {
    if (!row.base) return nullptr;
    const std::optional<double>& radius = row.base->radius;
    return {{"needed_mm", radius ? number_json(*radius / units::millimetre) : Json(nullptr)},
            {"stays_broken", words_json(row.base->broken)}};
}

Json row_json(const ComparisonRow& row, double degrees_per_x) {
    Json json;
    json["law"] = words_json(row.key);
    json["title"] = row_title(row);
    json["fits"] = row.misfit.empty();
    json["misfit"] = words_json(row.misfit);
    json["feasible"] = row.feasible;
    json["objective"] = row.misfit.empty() ? number_json(row.objective) : Json(nullptr);
    json["loss_percent"] = number_json(row.loss_percent);
    json["peaks"] = peaks_json(row.misfit.empty() ? std::optional(row.peaks) : std::nullopt);
    json["limits"] = limits_json(row, degrees_per_x);
    json["base_radius"] = base_json(row);
    return json;
}

Json dimensions_json(const Comparison& comparison) {
    if (!comparison.cam) return nullptr;
    Json json = Json::object();
    for (int i = 0; i < dimension_count; ++i) {
        const auto index = static_cast<DimensionIndex>(i);
        if (!has_dimension(comparison.cam->follower, index)) continue;
        json[std::string(name_of(index)) + "_mm"] = number_json((*comparison.cam)[index] / units::millimetre);
    }
    return json;
}

}  // namespace

std::string comparison_json(const Comparison& comparison, const RunOrigin& origin) {
    const Solution& solution = comparison.optimum;
    const Certificate& certificate = solution.certificate;
    const double degrees_per_x = display_scale(solution.scene.motion).degrees_per_x;
    Json json;
    json["camopt"] = version();
    json["study"] = "compare";
    json["scene"] = words_json(origin.scene_file);
    json["title"] = words_json(solution.scene.title);
    json["command"] = words_json(origin.command);
    add_verdict(json, certificate);
    json["dimensions"] = dimensions_json(comparison);
    const ComparisonRow* best = best_law(comparison);
    json["best_law"] = best ? Json(best->key) : Json(nullptr);
    json["rows"] = Json::array();
    for (const ComparisonRow& row : comparison.rows) json["rows"].push_back(row_json(row, degrees_per_x));
    return json_text(json);
}

}  // namespace camopt
