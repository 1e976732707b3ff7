// SPDX-License-Identifier: MIT
#include "benchmarks/papers/paper_json.hpp"

#include "core/version.hpp"
#include "report/json/json_text.hpp"

namespace camopt {

namespace {

Json cell_json(const PaperCell& cell) {
    if (const double* number = std::get_if<double>(&cell)) return number_json(*number);
    if (const std::string* words = std::get_if<std::string>(&cell)) return *words;
    return nullptr;
}

Json table_json(const PaperTable& table) {
    Json json = {
        {"key", table.key}, {"title", table.title}, {"introduction", words_json(table.introduction)}};
    Json columns = Json::array(), rows = Json::array();
    for (const PaperColumn& column : table.columns)
        columns.push_back({{"key", column.key}, {"title", column.title}, {"unit", words_json(column.unit)}});
    for (const auto& cells : table.rows) {
        Json row = Json::object();
        for (std::size_t i = 0; i < cells.size() && i < table.columns.size(); ++i)
            row[table.columns[i].key] = cell_json(cells[i]);
        rows.push_back(std::move(row));
    }
    json["columns"] = std::move(columns);
    json["rows"] = std::move(rows);
    return json;
}

Json figure_json(const PaperFigure& figure) {
    Json json = {{"key", figure.key},
                 {"title", figure.title},
                 {"x_title", figure.x_title},
                 {"y_title", figure.y_title}};
    Json series = Json::array();
    for (const PaperSeries& one : figure.series)
        series.push_back({{"title", one.title}, {"x", numbers_json(one.x)}, {"y", numbers_json(one.y)}});
    json["series"] = std::move(series);
    return json;
}

}  // namespace

std::string paper_report_json(const PaperReport& report) {
    Json json;
    json["camopt"] = version();
    json["paper"] = report.id;
    json["title"] = report.title;
    json["source"] = report.source;
    json["introduction"] = report.introduction;
    json["faults"] = report.faults;
    json["assumptions"] = report.assumptions;
    json["tables"] = Json::array();
    for (const PaperTable& table : report.tables) json["tables"].push_back(table_json(table));
    json["figures"] = Json::array();
    for (const PaperFigure& figure : report.figures) json["figures"].push_back(figure_json(figure));
    json["notes"] = report.notes;
    return json_text(json);
}

}  // namespace camopt
