// SPDX-License-Identifier: MIT
#include "tests/soak/scenes/scene_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <sstream>
#include <stdexcept>

namespace camopt::soak {

namespace {

std::string trimmed(std::string_view text) {
    const auto begin = text.find_first_not_of(" \t\r");
    if (begin == std::string_view::npos) return {};
    return std::string(text.substr(begin, text.find_last_not_of(" \t\r") - begin + 1));
}

/// What stands before the comment of a line; a # within quotes is none.
std::string without_comment(std::string_view line) {
    bool within_quotes = false;
    for (std::size_t k = 0; k < line.size(); ++k) {
        if (line[k] == '"') within_quotes = !within_quotes;
        if (line[k] == '#' && !within_quotes) return trimmed(line.substr(0, k));
    }
    return trimmed(line);
}

/// Split at the commas that stand in no bracket, brace or quote.
std::vector<std::string> parts_of(std::string_view text) {
    std::vector<std::string> parts;
    int depth = 0;
    bool within_quotes = false;
    std::string part;
    for (const char letter : text) {
        if (letter == '"') within_quotes = !within_quotes;
        if (!within_quotes && (letter == '[' || letter == '{')) ++depth;
        if (!within_quotes && (letter == ']' || letter == '}')) --depth;
        if (letter == ',' && depth == 0 && !within_quotes) {
            parts.push_back(trimmed(part));
            part.clear();
        } else {
            part += letter;
        }
    }
    if (!trimmed(part).empty()) parts.push_back(trimmed(part));
    return parts;
}

std::pair<std::string, std::string> member_of(std::string_view text) {
    const auto equals = text.find('=');
    if (equals == std::string_view::npos) throw std::runtime_error(fmt::format("no key = value: {}", text));
    return {trimmed(text.substr(0, equals)), trimmed(text.substr(equals + 1))};
}

std::string_view inside(std::string_view text) {
    return text.size() < 2 ? std::string_view() : text.substr(1, text.size() - 2);
}

}  // namespace

std::string number_text(double value) {
    std::string text = fmt::format("{:.17g}", value);
    if (text.find_first_of(".en") == std::string::npos) text += ".0";
    return text;
}

std::string list_text(const std::vector<double>& values) {
    std::string text = "[";
    for (const double value : values) text += (text.size() > 1 ? ", " : "") + number_text(value);
    return text + "]";
}

std::string quoted(std::string_view word) {
    return fmt::format("\"{}\"", word);
}

std::optional<std::string> SceneTable::find(std::string_view key) const {
    for (const auto& [member, value] : members)
        if (member == key) return value;
    return std::nullopt;
}

std::string SceneTable::word(std::string_view key, std::string_view missing) const {
    const auto value = find(key);
    if (!value) return std::string(missing);
    return value->starts_with('"') ? std::string(inside(*value)) : *value;
}

void SceneTable::set(std::string_view key, std::string value) {
    for (auto& [member, old] : members) {
        if (member != key) continue;
        old = std::move(value);
        return;
    }
    members.emplace_back(key, std::move(value));
}

void SceneTable::erase(std::string_view key) {
    std::erase_if(members, [&](const auto& member) { return member.first == key; });
}

SceneText SceneText::parse(std::string_view text) {
    SceneText scene;
    std::istringstream lines{std::string(text)};
    std::string line;
    while (std::getline(lines, line)) {
        if (line.starts_with("# ")) scene.remarks.push_back(trimmed(line.substr(2)));
        line = without_comment(line);
        if (line.empty()) continue;
        if (line.front() != '[') {
            if (scene.tables_.empty()) scene.tables_.push_back({});
            scene.tables_.back().members.push_back(member_of(line));
        } else if (line.starts_with("[[")) {
            scene.append(trimmed(line.substr(2, line.size() - 4)));
        } else {
            scene.tables_.push_back({trimmed(line.substr(1, line.size() - 2)), false, {}});
        }
    }
    return scene;
}

std::string SceneText::text() const {
    std::string text;
    for (const std::string& remark : remarks) text += "# " + remark + "\n";
    for (const SceneTable& table : tables_) {
        if (table.repeated)
            text += fmt::format("[[{}]]\n", table.name);
        else if (!table.name.empty())
            text += fmt::format("[{}]\n", table.name);
        for (const auto& [key, value] : table.members) text += key + " = " + value + "\n";
    }
    return text;
}

const SceneTable* SceneText::find(std::string_view table) const {
    for (const SceneTable& each : tables_)
        if (each.name == table) return &each;
    return nullptr;
}

SceneTable& SceneText::at(std::string_view table) {
    for (SceneTable& each : tables_)
        if (each.name == table) return each;
    tables_.push_back({std::string(table), false, {}});
    return tables_.back();
}

void SceneText::erase(std::string_view table) {
    std::erase_if(tables_, [&](const SceneTable& each) { return each.name == table; });
}

SceneTable& SceneText::append(std::string_view repeated_table) {
    // Beside the tables of the same name, or behind the one that holds them.
    auto place = tables_.end();
    for (auto each = tables_.begin(); each != tables_.end(); ++each)
        if (each->name == repeated_table) place = each + 1;
    return *tables_.insert(place, {std::string(repeated_table), true, {}});
}

std::vector<const SceneTable*> SceneText::all(std::string_view repeated_table) const {
    std::vector<const SceneTable*> found;
    for (const SceneTable& each : tables_)
        if (each.name == repeated_table) found.push_back(&each);
    return found;
}

std::optional<std::string> SceneText::find(std::string_view table, std::string_view key) const {
    const SceneTable* found = find(table);
    return found ? found->find(key) : std::nullopt;
}

std::string SceneText::word(std::string_view table, std::string_view key, std::string_view missing) const {
    const SceneTable* found = find(table);
    return found ? found->word(key, missing) : std::string(missing);
}

double SceneText::number(std::string_view table, std::string_view key, double missing) const {
    const auto value = find(table, key);
    return value ? std::strtod(value->c_str(), nullptr) : missing;
}

std::vector<double> SceneText::list(std::string_view table, std::string_view key) const {
    std::vector<double> values;
    const auto text = find(table, key);
    if (!text) return values;
    for (const std::string& part : parts_of(inside(*text)))
        values.push_back(std::strtod(part.c_str(), nullptr));
    return values;
}

SceneTable inline_table(std::string_view text) {
    SceneTable table;
    const std::string whole = trimmed(text);
    for (const std::string& part : parts_of(inside(whole))) table.members.push_back(member_of(part));
    return table;
}

std::vector<SceneTable> inline_tables(std::string_view text) {
    std::vector<SceneTable> tables;
    const std::string whole = trimmed(text);
    for (const std::string& part : parts_of(inside(whole))) tables.push_back(inline_table(part));
    return tables;
}

std::string inline_text(const SceneTable& table) {
    std::string text = "{ ";
    for (const auto& [key, value] : table.members)
        text += (text.size() > 2 ? ", " : "") + key + " = " + value;
    return text + " }";
}

std::string inline_text(const std::vector<SceneTable>& tables) {
    std::string text = "[";
    for (const SceneTable& table : tables) text += (text.size() > 1 ? ", " : "") + inline_text(table);
    return text + "]";
}

}  // namespace camopt::soak
