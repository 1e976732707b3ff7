// SPDX-License-Identifier: MIT
#include "report/json/result_json.hpp"

#include "core/version.hpp"
#include "objectives/scene_family.hpp"
#include "report/document/common_figures.hpp"
#include "report/json/result_fields.hpp"
#include "report/view/columns.hpp"
#include "report/view/key_words.hpp"
#include "report/view/shown_units.hpp"
#include "studies/delivered/scene_limits.hpp"
#include "studies/delivered/solution_parts.hpp"
#include "studies/search/plan.hpp"

namespace camopt {

namespace {

/// The peaks in physical units, named like the columns of motion.csv.
Json physical_peaks_json(const Solution& solution) {
    if (!solution.motion) return nullptr;
    const auto derivatives = [](const Peaks& peaks) {
        return std::array{0.0, peaks.velocity.value, peaks.acceleration.value, peaks.jerk.value};
    };
    TableRow row;
    row.motion.derivative = derivatives(solution.cam_peaks);
    if (solution.output) row.output = MotionPoint{0.0, derivatives(solution.motion_peaks)};
    Json json = Json::object();
    for (const TableColumn* column : motion_columns(solution.scene))
        if (column->order > 0) json[column->key] = number_json(column->value(solution.scene.motion, row));
    return json;
}

/// What the objective divides by. Zero stands in a Solution for "not in use".
Json reference_json(const Solution& solution) {
    const Reference& reference = solution.scene.objective.reference;
    const Peaks& peaks = solution.reference_peaks;
    const auto used = [](double value) { return value > 0.0 ? number_json(value) : Json(nullptr); };
    Json json = {{"law", reference.numeric ? Json(nullptr) : Json(reference.law)}};
    for (const CostTerm& term : cost_terms()) json[term.name()] = used(term.measured.of(peaks));
    return json;
}

/// Numbers that the scene wants at a place or along a region, in the units they were written in.
Json set_points_json(const Solution& solution) {
    const double degrees_per_x = file_units(solution.scene).degrees_per_x;
    Json list = Json::array();
    for (const SetPointReport& report :
         set_point_reports(solution.scene.motion, solution.scene.spline.degree, solution.output_motion())) {
        const bool region = report.point.is_region();
        list.push_back(
            {{"key", report.key},
             {"wanted", number_json(report.wanted)},
             {"found", number_json(report.found)},
             {"unit", report.unit},
             {"from_deg", number_json(report.point.begin * degrees_per_x)},
             {"to_deg", number_json((region ? report.point.end : report.point.begin) * degrees_per_x)},
             {"at_deg", number_json(report.at * degrees_per_x)}});
    }
    return list;
}

/// A measured motion as a spline: its error, and what the optimum gains over it.
Json measured_json(const Solution& solution) {
    const MeasuredReport& measured = *solution.measured;
    const ShownUnits units = file_units(solution.scene);
    const MotionUnit& output = units.motion[0].first;
    Json laws = Json::array();
    for (const LawMatch& match : measured.laws)
        laws.push_back(
            {{"law", match.law},
             {"from_deg", number_json(match.begin * units.degrees_per_x)},
             {"to_deg", number_json(match.end * units.degrees_per_x)},
             {"largest_deviation_" + output.name, number_json(match.largest * output.per_normalised)},
             {"rms_deviation_" + output.name, number_json(match.rms * output.per_normalised)}});
    const MeasuredMotion& table = *solution.scene.measured;
    const ShownUnit displacement{output.name, solution.scene.motion.lift / output.per_normalised};
    Json outliers = Json::array(), place;
    for (const MeasuredOutlier& outlier : table.outliers)
        outliers.push_back({{"row", outlier.row},
                            {"at_deg", number_json(degrees_shown.of(outlier.angle))},
                            {"from_neighbours_" + output.name, number_json(displacement.of(outlier.off))}});
    const auto placed = [&](const std::string& name, const auto& number, const ShownUnit& unit) {
        place[name] = number ? number_json(unit.of(number->value)) : Json();
        place[name + "_standard_error"] = number ? number_json(unit.of(number->error)) : Json();
    };
    if (table.place) {
        place["law"] = words_json(table.place->law);
        place["counter_clockwise"] = table.place->points;
        placed("start_deg", table.place->angle, degrees_shown);
        place["residual_rms_" + output.name] = number_json(displacement.of(table.place->residual));
        place["noise_" + output.name] = number_json(displacement.of(table.place->noise));
        placed("zero_" + output.name, table.place->zero, displacement);
        place["base_radius_mm"] =
            table.place->base_radius ? number_json(millimetres_shown.of(*table.place->base_radius)) : Json();
    }
    Json json = {
        {"name", words_json(measured.name)},
        {"rows", measured.rows},
        {"free_numbers", measured.freedom},
        {"follows_noise", follows_noise(measured)},
        {"largest_error_" + output.name, number_json(measured.largest_error * output.per_normalised)},
        {"rms_error_" + output.name, number_json(measured.rms_error * output.per_normalised)},
        {"at_deg", number_json(measured.at * units.degrees_per_x)},
        {"peaks", peaks_json(measured.peaks)},
        {"objective", number_json(measured.objective)},
        {"gain_percent", number_json(gain_percent(solution))},
        {"nearest_laws", laws},
        {"outliers", outliers},
        {"outliers_excluded", table.excluded},
        {"untouched_points", table.untouched},
        {"register", place},
        {"started", measured.started}};
    if (measured.noise) {
        Json errors;
        for (std::size_t order = 0; order < measured.noise->error.size(); ++order) {
            const MotionUnit& unit = units.motion[order].first;
            errors[unit.name] = number_json(measured.noise->error[order] * unit.per_normalised);
        }
        json["noise_of_one_row_" + output.name] = number_json(measured.noise->row * output.per_normalised);
        json["standard_errors"] = errors;
    }
    return json;
}

Json constraints_json(const Solution& solution) {
    const double degrees_per_x = file_units(solution.scene).degrees_per_x;
    Json list = Json::array();
    for (const ConstraintReport& row : solution.constraints) {
        list.push_back({{"name", row.name},
                        {"limit", number_json(row.limit)},
                        {"worst", number_json(row.worst)},
                        {"unit", row.unit},
                        {"at_deg", is_nowhere(row) ? Json(nullptr) : number_json(row.at * degrees_per_x)},
                        {"active", row.active},
                        {"verified", row.verified},
                        {"no_contact", row.no_contact},
                        {"key", row.key}});
        if (!row.side.empty()) list.back()["side"] = row.side;
        if (!row.speed.empty()) list.back()["speed"] = row.speed;
    }
    return list;
}

/// Terms that the program brought; scene files have none.
Json own_terms_json(const Solution& solution) {
    const double degrees_per_x = file_units(solution.scene).degrees_per_x;
    Json list = Json::array();
    for (const OwnTermReport& term : solution.own_terms)
        list.push_back({{"name", term.name},
                        {"weight", number_json(term.weight)},
                        {"reference", number_json(term.reference)},
                        {"value", number_json(term.value)},
                        {"at_deg", number_json(term.at * degrees_per_x)}});
    return list;
}

/// What was planned before anything was solved (studies/search/plan.hpp).
Json plan_json(const SolvePlan& plan) {
    Json starts = Json::array();
    for (int k = 0; !plan.relaxations.empty() && k < plan.starts; ++k) {
        const char* const kind = name_of(start_kind(plan.from_measured, k));
        if (starts.empty() || starts.back() != kind) starts.push_back(kind);
    }
    return {{"searched",
             {{"angles", plan.angles},
              {"displacements", plan.displacements},
              {"breakpoints", plan.breakpoints},
              {"dimensions", plan.dimensions}}},
            {"solver", plan.solver},
            {"next_solver", plan.next_solver.empty() ? Json(nullptr) : Json(plan.next_solver)},
            {"design", name_of(plan.design)},
            {"convex", plan.convex},
            {"starts", plan.starts},
            {"start_kinds", std::move(starts)},
            {"seed", plan.seed},
            {"strokes_first_free", plan.strokes_first_free},
            {"relaxations", plan.relaxations.size()},
            {"cost_scale", number_json(plan.cost_scale)},
            {"tie_break", plan.tie_break},
            {"proof", name_of(plan.proof)},
            {"max_seconds", number_json(plan.seconds)},
            {"explain_seconds", number_json(plan.explain_seconds)}};
}

Json relaxation_json(const Solution& solution, const std::vector<Relaxation>& rows) {
    Json list = Json::array();
    for (const Relaxation& row : rows) {
        Json one = {{"key", row.key}, {"given", number_json(row.given)}, {"needed", number_json(row.needed)}};
        if (row.solved) one["solved"] = number_json(row.solved);
        if (row.needed) one["exact"] = &rows == &solution.relaxation && is_exact(solution, row);
        for (const CompanionChange& other : row.also)
            one["also"].push_back({{"key", other.key}, {"given", other.given}, {"solved", other.solved}});
        list.push_back(std::move(one));
    }
    return list;
}

Json explanation_json(const Solution& solution) {
    const Explanation& explanation = *solution.explanation;
    return {{"together", relaxation_json(solution, explanation.together)},
            {"any_motion", explanation.any_motion},
            {"alone", explanation.alone},
            {"set_points", explanation.set_points},
            {"end", name_of(explanation.end)},
            {"finest_segments", explanation.finest > 0 ? Json(explanation.finest) : Json(nullptr)},
            {"unsettled", explanation.unsettled},
            {"seconds", number_json(explanation.seconds)},
            {"allowed_seconds", number_json(explanation.allowed)}};
}

Json conflict_json(const Solution& solution) {
    const double degrees_per_x = file_units(solution.scene).degrees_per_x;
    Json list = Json::array();
    for (const ConflictReport& row : solution.conflict) {
        list.push_back({{"key", row.key},
                        {"at_deg", number_json(row.at * degrees_per_x)},
                        {"weight", number_json(row.weight)}});
        if (!row.remark.empty()) list.back()["remark"] = row.remark;
    }
    return list;
}

}  // namespace

std::string result_json(const Solution& solution, const RunOrigin& origin) {
    const Certificate& certificate = solution.certificate;
    Json json;
    const JsonFields writer(json);
    json["camopt"] = version();
    origin_fields(writer, to_write(origin), solution.scene.title);
    json.update(figures_json(verdict_figures(certificate)));
    std::optional<double> limit;
    if (solution.any_curve_limit) limit = solution.any_curve_limit->objective;
    bound_fields(writer.at("bound"), limit, to_write(solution.solver));
    json["peaks"] = peaks_json(solution.motion ? std::optional(solution.peaks) : std::nullopt);
    json["physical_peaks"] = physical_peaks_json(solution);
    if (solution.output)  // s = w_0 y + w_1 y' + w_2 y'', in lifts over x: "motion" is s, "peaks" are of y
        json["cam_of_output"] = {{"weights", cam_of_output(solution.scene).weights},
                                 {"peaks", peaks_json(solution.cam_peaks)}};
    json["reference"] = reference_json(solution);
    json["worst_violation"] = number_json(certificate.worst_violation);
    json["stationarity"] = number_json(certificate.stationarity);
    if (!solution.own_terms.empty()) json["own_terms"] = own_terms_json(solution);
    if (solution.train) json["dynamics"] = train_json(solution);
    if (solution.drive) json["drive"] = figures_json(drive_figures(solution.scene, *solution.drive));
    if (solution.motion && solution.scene.motion.valve) json["valve"] = valve_json(solution);
    if (solution.surge) json["surge"] = surge_json(solution);
    json["constraints"] = constraints_json(solution);
    if (solution.motion && !placed_points(solution.scene.motion).empty())
        json["set_points"] = set_points_json(solution);
    if (solution.measured) json["measured"] = measured_json(solution);
    if (certificate.verdict == Verdict::infeasible || !solution.relaxation.empty())
        json["relaxation"] = relaxation_json(solution, solution.relaxation);
    if (solution.explanation) json["explanation"] = explanation_json(solution);
    if (certificate.verdict == Verdict::infeasible) json["conflict"] = conflict_json(solution);
    json["spline"] = spline_json(solution.curve);
    json["segments"] = segments_json(solution);
    json["motion"] = solution.motion ? motion_json(*solution.motion) : Json(nullptr);
    json["design"] = solution.motion ? written(solution.design) : Json(nullptr);
    json["dimensions"] = dimensions_json(solution);
    json["cam"] = cam_json(solution);
    if (solution.plan) json["plan"] = plan_json(*solution.plan);
    run_fields(writer, to_write(solution));
    return json_text(json);
}

std::string export_check_json(const Solution& solution, Json claims) {
    const Json cam = cam_json(solution);
    claims["design"] = {{"reference", reference_json(solution)},
                        {"segments", segments_json(solution)},
                        {"motion", motion_json(*solution.motion)},
                        {"cam", cam.is_null() ? cam : Json{{"dimensions", cam["dimensions"]}}}};
    return json_text(claims);
}

}  // namespace camopt
