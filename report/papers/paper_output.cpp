// SPDX-License-Identifier: MIT
#include "report/papers/paper_output.hpp"

#include "core/version.hpp"
#include "report/document/common_figures.hpp"
#include "report/json/json_text.hpp"

#include <fmt/format.h>

namespace camopt {

namespace {

bool holds_words(const PaperTable& table, std::size_t column) {
    return std::ranges::any_of(table.rows, [&](const auto& row) {
        return column < row.size() && std::holds_alternative<std::string>(row[column]);
    });
}

Cell document_cell(const PaperCell& cell, int digits) {
    if (const double* number = std::get_if<double>(&cell))
        return std::isnan(*number) ? Cell() : Cell(*number, digits);
    const std::string* words = std::get_if<std::string>(&cell);
    return words != nullptr ? Cell(*words) : Cell();
}

/// Shown, and as KEY.csv.
void add_table(std::vector<Table>& tables, const PaperTable& paper) {
    Table table{.key = paper.key, .title = paper.title, .note = paper.introduction};
    for (std::size_t i = 0; i < paper.columns.size(); ++i) {
        const PaperColumn& column = paper.columns[i];
        table.columns.push_back({column.key,
                                 column.title + (column.unit.empty() ? "" : " [" + column.unit + "]"),
                                 {},
                                 holds_words(paper, i)});
    }
    for (const auto& row : paper.rows) {
        std::vector<Cell>& cells = table.rows.emplace_back(table.columns.size());
        for (std::size_t i = 0; i < std::min(row.size(), cells.size()); ++i)
            cells[i] = document_cell(row[i], paper.columns[i].digits);
    }
    Table file = table;
    file.file = paper.key + ".csv";
    tables.push_back(std::move(table));
    tables.push_back(std::move(file));
}

/// Its points as KEY.csv.
Table point_table(const PaperFigure& figure) {
    Table table{.key = figure.key, .columns = {{"series"}, {"x"}, {"y"}}, .file = figure.key + ".csv"};
    for (const PaperSeries& series : figure.series)
        for (std::size_t i = 0; i < series.x.size() && i < series.y.size(); ++i)
            table.rows.push_back({series.title, Cell(series.x[i]), Cell(series.y[i])});
    return table;
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
    json.update(figures_json(verdict_figures(certificate)));
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

Document paper_document(const PaperReport& report) {
    Document document{fmt::format("Paper {}: {}", report.id, report.title),
                      report.faults.empty() ? "good" : "bad"};
    document.kind = "Paper";
    Section shown, drawn;
    for (const PaperTable& table : report.tables) add_table(shown.tables, table);
    for (const PaperFigure& figure : report.figures) {
        drawn.pictures.push_back({figure.key, figure.title, paper_chart(figure)});
        drawn.tables.push_back(point_table(figure));
    }
    document.sections = {listing("paper", {}, {report.source, report.introduction}),
                         listing("faults", "NOT COMPUTED OR NOT PROVED", report.faults),
                         listing("assumptions", "Chosen by us, not given by the paper", report.assumptions),
                         std::move(shown),
                         std::move(drawn),
                         listing("notes", "Notes", report.notes)};
    return document;
}

Chart paper_chart(const PaperFigure& figure) {
    ChartPanel panel{.width = 752, .height = 436, .equal_scales = figure.equal_scales};
    panel.frame.horizontal_title = figure.x_title;
    panel.frame.vertical_title = figure.y_title;
    panel.frame.horizontal.logarithmic = panel.frame.vertical.logarithmic = figure.logarithmic;
    for (const PaperSeries& series : figure.series) {
        const Look look = series.markers ? Look::dot : Look::line;
        ChartSeries drawn{look, palette_class(look, panel.series.size()), {}, 3.2, series.title};
        for (std::size_t i = 0; i < series.x.size() && i < series.y.size(); ++i)
            drawn.points.push_back({series.x[i], series.y[i]});
        panel.series.push_back(std::move(drawn));
    }
    return {figure.title, {}, {std::move(panel)}};
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
