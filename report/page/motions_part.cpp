// SPDX-License-Identifier: MIT
#include "core/text/parsing.hpp"
#include "input/scene_reader.hpp"
#include "report/page/page_parts.hpp"

#include <fmt/format.h>

namespace camopt {

namespace {

constexpr int drawn_digits = 5;

std::vector<std::string> lines_of(const std::string& text) {
    const std::vector<std::string_view> lines = split_text(text, '\n', "");
    return {lines.begin(), lines.end()};
}

Json overlay_json(const Table& table) {
    if (table.overlays.empty()) return nullptr;
    Json angles = Json::array(), curves = Json::array();
    for (const double angle : table.overlay_angles) angles.push_back(rounded_json(angle));
    for (const Overlay& overlay : table.overlays) {
        Json lines = Json::array();
        for (const std::vector<double>& values : overlay.lines) {
            Json& line = lines.emplace_back();
            for (const double value : values) line.push_back(rounded_json(value, drawn_digits));
        }
        curves.push_back({{"title", overlay.title},
                          {"symbol", overlay.symbol},
                          {"unit", overlay.unit.name},
                          {"lines", std::move(lines)}});
    }
    return {{"angles", std::move(angles)}, {"curves", std::move(curves)}};
}

/// What stands otherwise in a text of as many lines; a text of other length replaces the whole by its first
/// line.
Json edits_between(const std::vector<std::string>& base, const std::string& text) {
    const std::vector<std::string> lines = lines_of(text);
    Json edits = Json::array();
    if (lines.size() != base.size()) return {{-1, text}};
    for (std::size_t i = 0; i < lines.size(); ++i)
        if (lines[i] != base[i]) edits.push_back({i, lines[i]});
    return edits;
}

Json scenes_json(const Table& table, const RunOrigin& origin) {
    if (origin.scene_text.empty()) return nullptr;
    std::vector<std::string> base;
    Json scenes = nullptr, edits = Json::array();
    for (const RowMotion& motion : table.motions) {
        if (!motion.settings) {
            edits.push_back(nullptr);
            continue;
        }
        const std::string text =
            motion.settings->empty()
                ? origin.scene_text
                : input::scene_with_overrides(origin.scene_text, origin.scene_file, *motion.settings);
        if (base.empty()) {
            base = lines_of(text);
            scenes["base"] = text;
        }
        edits.push_back(edits_between(base, text));
    }
    if (!base.empty()) scenes["edits"] = std::move(edits);
    return scenes;
}

/// A number that the page writes as `numberText`, a text, or both as a list.
Json value_json(const Cell& cell, const Field& field) {
    const std::string text = cell.value || cell.holds ? shown_text(cell, field) : cell.words;
    if (!cell.value || !std::isfinite(*cell.value)) return words_json(text);
    const Json number = rounded_json(field.unit.of(*cell.value));
    return cell.words.empty() && !field.decimals ? number : Json({number, text});
}

}  // namespace

Json motions_json(const Table& table, const RunOrigin& origin) {
    Json columns = Json::array(), names = Json::array(), numbers = Json::array(), tones = Json::array();
    for (std::size_t i = 0; i < table.columns.size(); ++i) {
        const Field& field = table.columns[i];
        if ((field.where & Where::page) == 0) continue;
        Json values = Json::array();
        for (const std::vector<Cell>& row : table.rows) values.push_back(value_json(row[i], field));
        columns.push_back({{"key", field.key},
                           {"title", field.shown_title()},
                           {"left", field.left},
                           {"values", std::move(values)}});
    }
    for (const RowMotion& motion : table.motions) {
        names.push_back(motion.name);
        numbers.push_back(motion.number);
        tones.push_back(motion.tone);
    }
    return {{"key", table.key},
            {"title", table.title},
            {"note", table.note},
            {"columns", std::move(columns)},
            {"items", {{"names", std::move(names)}, {"numbers", std::move(numbers)}, {"tones", tones}}},
            {"axes", {{"x", table.axes[0]}, {"y", table.axes[1]}}},
            {"overlay", overlay_json(table)},
            {"scenes", scenes_json(table, origin)},
            {"without_scenes", table.without_scenes.empty() ? Json(nullptr)
                                                            : Json({{"words", table.without_scenes},
                                                                    {"command", table.scene_command}})}};
}

}  // namespace camopt
