// SPDX-License-Identifier: MIT
// Look-up in the key table and its rows as words: error messages and the Markdown of docs/scene_file.md.
#include "input/scene_keys.hpp"

#include <fmt/format.h>

namespace camopt::input {
namespace {

std::string joined_name(const KeyRow& row) {
    return row.table.empty() ? std::string(row.name) : fmt::format("{}.{}", row.table, row.name);
}

std::string joined_choices(const KeyRow& row) {
    std::string joined;
    for (std::size_t i = 0; i < row.choices.size(); ++i) {
        if (i > 0) joined += i + 1 < row.choices.size() ? ", " : " or ";
        joined +=
            row.type == KeyType::text ? fmt::format("\"{}\"", row.choices[i]) : std::string(row.choices[i]);
    }
    return joined;
}

std::string_view type_name(const KeyRow& row) {
    switch (row.type) {
        case KeyType::text:
            return "text";
        case KeyType::boolean:
            return "boolean";
        case KeyType::integer:
            return "integer";
        case KeyType::number:
            return "number";
        case KeyType::number_or_range:
            return "number or range";
        case KeyType::numbers:
            return "array of numbers";
        case KeyType::table:
            return "table";
        case KeyType::tables:
            return "array of tables";
        case KeyType::text_or_table:
            return "text or table";
        case KeyType::options:
            break;
    }
    return "table of options";
}

std::string unit_text(const KeyRow& row) {
    std::string joined;
    for (const Spelling& spelling : row.spellings) {
        if (!joined.empty()) joined += ", ";
        joined += spelling.unit.empty() ? "–" : spelling.unit;
    }
    return joined;
}

std::string range_text(const KeyRow& row) {
    if (!row.choices.empty()) return joined_choices(row);
    return row.range.text();
}

std::string_view remark(const KeyRow& row) {
    switch (row.availability) {
        case Availability::needs_cam:
            return " *Needs a `[cam]` table.*";
        case Availability::needs_forces:
            return " *Needs a `[forces]` table.*";
        case Availability::now:
            break;
    }
    return "";
}

std::string markdown_row(const KeyRow& row) {
    std::string keys;
    for (const Spelling& spelling : row.spellings)
        keys += fmt::format("{}`{}`", keys.empty() ? "" : ", ", row.key(spelling));
    std::string later;
    if (!row.instead_of.empty()) later = fmt::format(" Instead of `{}`.", row.instead_of);
    if (!row.cam_type.empty() && row.table == "cam")
        later += fmt::format(" *Type {} only.*", row.cam_types('`'));
    return fmt::format("| {} | {} | {} | {} | {} | {}{}{} |\n", keys, type_name(row), unit_text(row),
                       range_text(row), row.default_text, row.meaning, later, remark(row));
}

}  // namespace

bool KeyRow::is_for(std::string_view type_of_cam) const {
    if (cam_type.empty()) return true;
    const std::string all = fmt::format("|{}|", cam_type);
    return !type_of_cam.empty() && all.find(fmt::format("|{}|", type_of_cam)) != std::string::npos;
}

std::string KeyRow::cam_types(char quote) const {
    std::string text(1, quote);
    for (const char c : cam_type)
        if (c == '|')
            text += fmt::format("{0} or {0}", quote);
        else
            text += c;
    return text + quote;
}

std::string KeyRow::key(const Spelling& spelling) const {
    return fmt::format("{}{}", name, spelling.suffix);
}

std::string KeyRow::allowed(const Spelling& spelling) const {
    if (!choices.empty()) return joined_choices(*this);
    const Range written = range.scaled(spellings.front().factor / spelling.factor);
    switch (type) {
        case KeyType::text:
            return "a text in quotes";
        case KeyType::boolean:
            return "true or false";
        case KeyType::integer:
            return range.integer_text();
        case KeyType::number:
            return written.number_text();
        case KeyType::number_or_range:
            return written.number_text() + ", or a range { min = …, max = … }";
        case KeyType::numbers:
            return "an array of numbers";
        case KeyType::table:
            return fmt::format("a [{}] table", joined_name(*this));
        case KeyType::tables:
            return "an array of tables";
        case KeyType::text_or_table:
            return "a text in quotes or a table";
        case KeyType::options:
            break;
    }
    return fmt::format("a [{}] table", joined_name(*this));
}

KeyMatch match_key(std::string_view table, std::string_view key) {
    for (const KeyRow& row : scene_keys()) {
        if (row.table != table || !key.starts_with(row.name)) continue;
        for (const Spelling& spelling : row.spellings)
            if (key.substr(row.name.size()) == spelling.suffix) return {&row, &spelling};
    }
    return {};
}

std::vector<std::string> written_keys(std::string_view table) {
    std::vector<std::string> keys;
    for (const KeyRow& row : scene_keys())
        if (row.table == table)
            for (const Spelling& spelling : row.spellings) keys.push_back(row.key(spelling));
    return keys;
}

std::string scene_keys_markdown() {
    std::string markdown;
    const KeyRow* previous = nullptr;
    for (const KeyRow& row : scene_keys()) {
        if (!previous || previous->table != row.table) {
            markdown += row.table.empty() ? std::string("\n### Top level\n\n")
                                          : fmt::format("\n### `[{}]`\n\n", row.table);
            markdown += "| key | type | unit | allowed | default | meaning |\n|---|---|---|---|---|---|\n";
        }
        markdown += markdown_row(row);
        previous = &row;
    }
    return markdown + "\n";
}

}  // namespace camopt::input
