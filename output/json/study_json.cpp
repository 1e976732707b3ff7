// SPDX-License-Identifier: MIT
#include "output/json/study_json.hpp"

#include "core/version.hpp"
#include "output/json/json_text.hpp"
#include "output/view/shown_units.hpp"
#include "output/words/study_text.hpp"

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
    return {{"needed_mm", radius ? number_json(millimetres_shown.of(*radius)) : Json(nullptr)},
            {"stays_broken", words_json(row.base->broken)}};
}

Json row_json(const Scene& scene, const ComparisonRow& row) {
    Json json;
    json["law"] = words_json(row.key);
    json["title"] = row_title(row);
    json["fits"] = row.misfit.empty();
    json["misfit"] = words_json(row.misfit);
    json["feasible"] = row.feasible;
    json["objective"] = row.misfit.empty() ? number_json(row.objective) : Json(nullptr);
    json["loss_percent"] = number_json(row.loss_percent);
    json["peaks"] = peaks_json(row.misfit.empty() ? std::optional(row.peaks) : std::nullopt);
    json["limits"] = limits_json(row, file_units(scene).degrees_per_x);
    json["base_radius"] = base_json(row);
    if (scene.drive) json["drive"] = row.drive ? drive_json(scene, *row.drive) : Json(nullptr);
    return json;
}

Json dimensions_json(const Comparison& comparison) {
    const std::optional<CamSpec>& spec = comparison.optimum.scene.cam;
    if (!comparison.cam || !spec) return nullptr;
    Json json = Json::object();
    for (std::size_t i = 0; i < spec->dimensions.size(); ++i) {
        const CamDimension& dimension = spec->dimensions[i];
        if (dimension.value.key.empty()) continue;  // this variant has no such dimension
        const ShownUnit& unit = dimension.is_angle ? degrees_shown : millimetres_shown;
        json[dimension.name + unit.suffix] = number_json(unit.of(comparison.cam->dimensions[i]));
    }
    return json;
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

std::string comparison_json(const Comparison& comparison, const RunOrigin& origin) {
    const Solution& solution = comparison.optimum;
    const Certificate& certificate = solution.certificate;
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
    for (const ComparisonRow& row : comparison.rows) json["rows"].push_back(row_json(solution.scene, row));
    return json_text(json);
}

}  // namespace camopt
