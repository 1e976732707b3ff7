// SPDX-License-Identifier: MIT
#include "output/json/reference_table_json.hpp"

#include "core/version.hpp"
#include "output/json/json_text.hpp"
#include "output/json/verdict_json.hpp"
#include "output/words/tables/reference_table_rows.hpp"

namespace camopt {

namespace {

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
