// SPDX-License-Identifier: MIT
// Look-up in the key table, and its rows in words: error messages and the Markdown of docs/scene_file.md.
#include "core/text/list_text.hpp"
#include "core/word_of.hpp"
#include "input/keys/scene_keys.hpp"

#include <fmt/format.h>

namespace camopt::input {

std::string_view type_words(KeyType type) {
    return word_of<KeyType::options>(
        type, {"text", "boolean", "integer", "number", "number or range", "number or table of `min`, `max`",
               "table of `min`, `max`", "number or array of pairs", "array of pairs", "array of numbers",
               "array of texts", "table", "array of tables", "text or table", "boolean or text",
               "table of options"});
}

namespace {

std::string unit_text(const KeyRow& row) {
    std::string joined;
    for (const Spelling& spelling : row.spellings) {
        if (!joined.empty()) joined += ", ";
        joined += spelling.unit.empty() ? "–" : spelling.unit;
    }
    return joined;
}

std::string range_text(const KeyRow& row) {
    if (row.type == KeyType::boolean_or_text) return row.allowed(row.spellings.front());
    if (!row.choices.empty()) return row.choices_text();
    return row.range.text();
}

std::string_view remark(const KeyRow& row) {
    switch (row.availability) {
        case Availability::needs_cam:
            return " *Needs a `[cam]` table.*";
        case Availability::needs_forces:
            return " *Needs a `[forces]` table.*";
        case Availability::needs_dynamics:
            return " *Needs a `[dynamics]` table.*";
        case Availability::needs_drive:
            return " *Needs a `[drive]` table.*";
        case Availability::now:
            break;
    }
    return "";
}

std::string markdown_row(const KeyRow& row) {
    std::string keys;
    for (const Spelling& spelling : row.spellings) append_item(keys, fmt::format("`{}`", row.key(spelling)));
    std::string later;
    if (!row.instead_of.empty()) later = fmt::format(" Instead of `{}`.", row.instead_of);
    if (!row.cam_types.empty() && row.table == "cam")
        later += fmt::format(" *Type {} only.*", row.cam_types_text('`'));
    return fmt::format("| {} | {} | {} | {} | {} | {}{}{} |\n", keys, type_words(row.type), unit_text(row),
                       range_text(row), row.default_text, row.meaning, later, remark(row));
}

}  // namespace

const KeyRow* find_row(std::string_view table, std::string_view name, KeyRows rows) {
    for (const KeyRow& row : rows)
        if (row.table == table && row.name == name) return &row;
    return nullptr;
}

KeyMatch match_key(std::string_view table, std::string_view key, KeyRows rows) {
    for (const KeyRow& row : rows) {
        if (row.table != table || !key.starts_with(row.name)) continue;
        for (const Spelling& spelling : row.spellings)
            if (key.substr(row.name.size()) == spelling.suffix) return {&row, &spelling};
    }
    return {};
}

std::vector<std::string> written_keys(std::string_view table, KeyRows rows) {
    std::vector<std::string> keys;
    for (const KeyRow& row : rows)
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
