// SPDX-License-Identifier: MIT
#include "output/json/study_json.hpp"

#include "core/version.hpp"
#include "output/json/json_text.hpp"
#include "output/view/shown_units.hpp"
#include "output/words/study_text.hpp"

namespace camopt {

namespace {

Json frequencies_json(const std::vector<double>& frequencies) {
    Json list = Json::array();
    for (const double one : frequencies) list.push_back(number_json(hertz_shown.of(one)));
    return list;
}

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

Json worst_json(const Scene& scene, const char* name, const std::optional<ResponseReport>& worst) {
    if (!worst) return nullptr;
    return {{name, number_json(worst->value)},
            {"speed_rpm", number_json(rpm_shown.of(worst->speed))},
            {"at_deg", number_json(worst->at * file_units(scene).degrees_per_x)}};
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
        json[dimension.name + (dimension.is_angle ? "_deg" : "_mm")] =
            number_json(unit.of(comparison.cam->dimensions[i]));
    }
    return json;
}

Json figures_json(const std::optional<PeakFigures>& figures, bool with_objective = true) {
    if (!figures) return nullptr;
    Json json = {{"velocity", number_json(figures->velocity)},
                 {"acceleration", number_json(figures->acceleration)},
                 {"jerk", number_json(figures->jerk)}};
    if (with_objective) json["objective"] = number_json(figures->objective);
    return json;
}

Json limit_json(const LimitCurve& limit) {
    return {{"objective", number_json(limit.objective)},
            {"velocity", number_json(limit.velocity)},
            {"acceleration", number_json(limit.acceleration)},
            {"jerk", number_json(limit.jerk)}};
}

Json solution_json(const Solution& solution) {
    const Certificate& certificate = solution.certificate;
    Json json;
    add_verdict(json, certificate);
    json["peaks"] = nullptr;
    if (solution.curve) {
        json["peaks"] = {{"velocity", extremum_json(solution.peaks.velocity)},
                         {"acceleration", extremum_json(solution.peaks.acceleration)},
                         {"jerk", extremum_json(solution.peaks.jerk)},
                         {"torque", extremum_json(solution.peaks.torque)}};
    }
    json["solver"] = {{"name", solution.solver.name},
                      {"termination", name_of(solution.solver.termination)},
                      {"iterations", solution.solver.iterations},
                      {"exchange_rounds", solution.solver.exchange_rounds}};
    json["seconds"] = number_json(solution.seconds_total);
    return json;
}

Json convergence_json(const ReferenceTable& table) {
    Json rows = Json::array();
    for (const ConvergenceRow& row : table.convergence) {
        Json json;
        json["segments"] = row.segments;
        json["printed"] = figures_json(row.printed);
        json["printed_points"] =
            row.printed_points.empty() ? Json(nullptr) : numbers_json(row.printed_points);
        json["points_exact"] = figures_json(row.points_exact);
        json["points_end_acceleration"] = number_json(row.points_end_acceleration);
        json["corrected_exact"] = figures_json(row.corrected_exact);
        json["optimum"] = solution_json(row.optimum);
        json["optimum_points"] =
            row.optimum_points.empty() ? Json(nullptr) : numbers_json(row.optimum_points);
        json["note"] = row.note;
        rows.push_back(std::move(json));
    }
    return rows;
}

Json laws_json(const ReferenceTable& table) {
    Json rows = Json::array();
    for (const LawComparisonRow& row : table.laws) {
        rows.push_back({{"name", row.name},
                        {"key", words_json(row.key)},
                        {"printed", figures_json(row.printed, false)},
                        {"exact", figures_json(row.exact)},
                        {"loss_percent", number_json(row.loss_percent)}});
    }
    return rows;
}

Json weights_json(const ReferenceTable& table) {
    Json rows = Json::array();
    for (const WeightEffectRow& row : table.weights) {
        Json json;
        json["weights"] = {{"velocity", number_json(row.velocity)},
                           {"acceleration", number_json(row.acceleration)},
                           {"jerk", number_json(row.jerk)}};
        json["printed_fourth_ordinate"] = number_json(row.printed_fourth_ordinate);
        json["printed_objective"] = number_json(row.printed_objective);
        json["fourth_ordinate"] = row.optimum.curve ? number_json(row.fourth_ordinate) : Json(nullptr);
        json["optimum"] = solution_json(row.optimum);
        json["limit"] = limit_json(row.limit);
        rows.push_back(std::move(json));
    }
    return rows;
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

Json drive_json(const Scene& scene, const DriveFigures& drive) {
    const double degrees_per_x = file_units(scene).degrees_per_x;
    const auto at = [&](const Extremum& one) { return number_json(one.at * degrees_per_x); };
    Json json = {{"peak_torque_nm", number_json(drive.torque.value)},
                 {"peak_torque_at_deg", at(drive.torque)},
                 {"rms_torque_nm", number_json(drive.rms_torque)},
                 {"peak_speed_rpm", number_json(rpm_shown.of(drive.speed.value))},
                 {"peak_speed_at_deg", at(drive.speed)},
                 {"peak_power_w", number_json(drive.power.value)},
                 {"peak_power_at_deg", at(drive.power)},
                 {"inertia_ratio", number_json(scene.drive->inertia_ratio())}};
    if (!scene.limits.motor_curve.empty()) {
        json["share_of_curve"] = number_json(drive.share_of_curve.value);
        json["share_of_curve_at_deg"] = at(drive.share_of_curve);
    }
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

std::string reference_table_json(const ReferenceTable& table) {
    Json json;
    json["camopt"] = version();
    json["study"] = "spline-vs-modified-sine";
    json["all_optimal"] = unproved_rows(table).empty();
    json["unproved"] = unproved_rows(table);
    json["limit"] = limit_json(table.limit);
    json["modified_sine_exact"] = figures_json(table.modified_sine_exact);
    json["convergence"] = convergence_json(table);
    json["laws"] = laws_json(table);
    json["weights"] = weights_json(table);
    json["notes"] = table.notes;
    return json_text(json);
}

}  // namespace camopt
