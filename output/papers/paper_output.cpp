// SPDX-License-Identifier: MIT
#include "output/papers/paper_output.hpp"

#include "core/version.hpp"
#include "output/csv/csv_line.hpp"
#include "output/document/common_figures.hpp"
#include "output/json/json_text.hpp"
#include "output/view/number_text.hpp"

#include <fmt/format.h>

namespace camopt {

namespace {

constexpr int paper_line_width = 100;

std::string title_of(const PaperReport& report) {
    return fmt::format("Paper {}: {}", report.id, report.title);
}

bool holds_words(const PaperTable& table, std::size_t column) {
    return std::ranges::any_of(table.rows, [&](const auto& row) {
        return column < row.size() && std::holds_alternative<std::string>(row[column]);
    });
}

std::string cell_text(const PaperCell& cell, int digits) {
    if (const double* number = std::get_if<double>(&cell))
        return std::isnan(*number) ? std::string("–") : short_text(*number, digits);
    if (const std::string* words = std::get_if<std::string>(&cell)) return *words;
    return "–";
}

TextTable text_table_of(const PaperTable& table) {
    TextTable text;
    for (std::size_t i = 0; i < table.columns.size(); ++i) {
        const PaperColumn& column = table.columns[i];
        const std::string title =
            column.unit.empty() ? column.title : fmt::format("{} [{}]", column.title, column.unit);
        text.columns.push_back({title, holds_words(table, i)});
    }
    for (const auto& row : table.rows) {
        std::vector<std::string> cells;
        for (std::size_t i = 0; i < row.size() && i < table.columns.size(); ++i)
            cells.push_back(cell_text(row[i], table.columns[i].digits));
        text.rows.push_back(std::move(cells));
    }
    return text;
}

std::string numbered(const std::string& title, const std::vector<std::string>& sentences) {
    if (sentences.empty()) return {};
    std::string text = fmt::format("\n{}\n", title);
    for (std::size_t i = 0; i < sentences.size(); ++i)
        text += wrapped_text(sentences[i], fmt::format("{}. ", i + 1), paper_line_width);
    return text;
}

std::string numbered_markdown(const std::string& title, const std::vector<std::string>& sentences) {
    if (sentences.empty()) return {};
    std::string text = fmt::format("\n## {}\n\n", title);
    for (std::size_t i = 0; i < sentences.size(); ++i) text += fmt::format("{}. {}\n", i + 1, sentences[i]);
    return text;
}

constexpr const char* faults_title = "NOT COMPUTED OR NOT PROVED";
constexpr const char* assumptions_title = "Chosen by us, not given by the paper";

void add_cell(CsvLine& line, const PaperCell& cell) {
    if (const double* number = std::get_if<double>(&cell))
        line.number(*number);
    else if (const std::string* words = std::get_if<std::string>(&cell))
        line.words(*words);
    else
        line.blank();
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

std::string paper_report_text(const PaperReport& report) {
    std::string text = title_of(report) + "\n" + wrapped_text(report.source, "", paper_line_width);
    text += "\n" + wrapped_text(report.introduction, "", paper_line_width);
    text += numbered(faults_title, report.faults);
    text += numbered(assumptions_title, report.assumptions);
    for (const PaperTable& table : report.tables) {
        text += fmt::format("\n{}\n", table.title);
        if (!table.introduction.empty()) text += wrapped_text(table.introduction, "", paper_line_width);
        text += aligned_text(text_table_of(table));
    }
    if (!report.figures.empty()) text += "\nFigures (--out DIR writes them)\n";
    for (const PaperFigure& figure : report.figures)
        text += wrapped_text(fmt::format("{}.svg  {}", figure.key, figure.title), "  ", paper_line_width);
    return text + numbered("Notes", report.notes);
}

std::string paper_report_markdown(const PaperReport& report) {
    std::string text =
        fmt::format("# {}\n\n{}\n\n{}\n", title_of(report), report.source, report.introduction);
    text += numbered_markdown(faults_title, report.faults);
    text += numbered_markdown(assumptions_title, report.assumptions);
    for (const PaperTable& table : report.tables) {
        text += fmt::format("\n## {}\n\n", table.title);
        if (!table.introduction.empty()) text += table.introduction + "\n\n";
        text += markdown_text(text_table_of(table));
    }
    for (const PaperFigure& figure : report.figures)
        text += fmt::format("\n## {}\n\n![{}]({}.svg)\n", figure.title, figure.title, figure.key);
    return text + numbered_markdown("Notes", report.notes);
}

std::string paper_table_csv(const PaperTable& table) {
    CsvLine header;
    for (const PaperColumn& column : table.columns) header.words(column.key);
    std::string text = header.finish();
    for (const auto& row : table.rows) {
        CsvLine line;
        for (std::size_t i = 0; i < table.columns.size(); ++i)
            add_cell(line, i < row.size() ? row[i] : PaperCell{});
        text += line.finish();
    }
    return text;
}

std::string paper_figure_csv(const PaperFigure& figure) {
    std::string text = "series,x,y\n";
    for (const PaperSeries& series : figure.series)
        for (std::size_t i = 0; i < series.x.size() && i < series.y.size(); ++i)
            text += CsvLine{}.words(series.title).number(series.x[i]).number(series.y[i]).finish();
    return text;
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

std::vector<std::pair<std::string, std::string>> paper_report_files(const PaperReport& report) {
    std::vector<std::pair<std::string, std::string>> files = {{"report.md", paper_report_markdown(report)}};
    for (const PaperTable& table : report.tables)
        files.emplace_back(table.key + ".csv", paper_table_csv(table));
    for (const PaperFigure& figure : report.figures) {
        files.emplace_back(figure.key + ".csv", paper_figure_csv(figure));
        files.emplace_back(figure.key + ".svg", paper_figure_svg(figure));
    }
    return files;
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
