// SPDX-License-Identifier: MIT
#include "core/version.hpp"
#include "report/document/document_text.hpp"
#include "report/json/json_text.hpp"

namespace camopt {

namespace {

constexpr std::array kind_names = {"headline", "verdict", "remark", "warning", "note", "effort"};

Json cell_json(const Cell& cell, const Field& field) {
    if (cell.holds) return *cell.holds;
    if (cell.object) return figures_json(*cell.object);
    if (!cell.numbers.empty()) return numbers_json(cell.numbers);
    if (cell.list) {
        Json list = Json::array();
        for (const std::vector<Figure>& one : *cell.list) list.push_back(figures_json(one));
        return list;
    }
    const std::optional<double> value = file_number(cell, field);
    const bool counts =
        value && field.unit.name.empty() && *value == std::round(*value) && std::abs(*value) < 1e9;
    const Json number = counts ? Json(static_cast<long>(*value)) : number_json(value);
    if (has_own_unit(cell, field)) return {{"value", number}, {"unit", cell.unit->name}};
    return cell.value ? number : words_json(file_words(cell));
}

/// An object becomes null where all in it is.
void close_empty(Json& json) {
    if (!json.is_object()) return;
    for (Json& one : json) close_empty(one);
    if (std::all_of(json.begin(), json.end(), [](const Json& one) { return one.is_null(); })) json = nullptr;
}

/// At "peaks.velocity.at" in the objects that its points name.
void add_cell(Json& json, const Cell& cell, const Field& field) {
    Json* place = &json;
    std::string key = field.file_key();
    for (std::size_t point = key.find('.'); point != std::string::npos; point = key.find('.')) {
        place = &(*place)[key.substr(0, point)];
        key.erase(0, point + 1);
    }
    (*place)[key] = cell_json(cell, field);
}

}  // namespace

Json figures_json(std::span<const Figure> figures) {
    Json json = Json::object();
    for (const Figure& figure : figures) {
        add_cell(json, figure.cell, figure.field);
        if (!figure.at) continue;
        const Figure place = place_figure(figure);
        add_cell(json, place.cell, place.field);
    }
    return json;
}

Json rows_json(const Table& table) {
    Json rows = Json::array();
    for (const std::vector<Cell>& row : table.rows) {
        Json& one = rows.emplace_back(Json::object());
        for (std::size_t i = 0; i < row.size(); ++i) add_cell(one, row[i], table.columns[i]);
        for (Json& part : one) close_empty(part);
    }
    return rows;
}

std::string document_json(const Document& document) {
    Json json = {{"camopt", version()}, {"title", document.title}};
    for (const Section& section : document.sections) json.update(figures_json(section.figures));
    json["sentences"] = Json::array();
    for (const Section& section : document.sections)
        for (const auto& [kind, key, text, where] : section.sentences)
            if (kind != Sentence::Kind::effort)
                json["sentences"].push_back(
                    {{"kind", kind_names[static_cast<std::size_t>(kind)]}, {"key", key}, {"text", text}});
    for (const Section& section : document.sections)
        for (const Table& table : section.tables)
            if (table.file.empty() || table.in_json) {
                Json& rows = json.emplace(table.key, Json::array()).first.value();
                for (Json& row : rows_json(table)) rows.push_back(std::move(row));
            }
    return json_text(json);
}

}  // namespace camopt
