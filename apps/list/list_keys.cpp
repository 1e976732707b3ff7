// SPDX-License-Identifier: MIT
#include "apps/list/list_keys.hpp"

#include "input/keys/scene_keys.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <string_view>
#include <vector>

namespace camopt::apps {

namespace {

using input::Availability;
using input::KeyRow;
using input::Spelling;

std::vector<std::string> spellings_of(const KeyRow& row) {
    std::vector<std::string> keys;
    for (const Spelling& spelling : row.spellings) keys.push_back(row.key(spelling));
    return keys;
}

std::string conditions_text(const KeyRow& row) {
    std::string text;
    if (!row.cam_types.empty()) text += fmt::format(" Cam type {} only.", row.cam_types_text('"'));
    if (!row.instead_of.empty()) text += fmt::format(" Instead of {}.", row.instead_of);
    if (row.availability == Availability::needs_cam) text += " Needs [cam].";
    if (row.availability == Availability::needs_forces) text += " Needs [forces].";
    if (row.availability == Availability::needs_dynamics) text += " Needs [dynamics].";
    return text;
}

std::string key_text(const KeyRow& row) {
    return fmt::format("  {}\n      {}; default: {}. {}{}\n", fmt::join(spellings_of(row), ", "),
                       row.allowed(row.spellings.front()), row.default_text, row.meaning,
                       conditions_text(row));
}

Json or_null(std::string_view text) {
    return text.empty() ? Json(nullptr) : Json(text);
}

Json needs_json(Availability availability) {
    if (availability == Availability::needs_cam) return "cam";
    if (availability == Availability::needs_forces) return "forces";
    if (availability == Availability::needs_dynamics) return "dynamics";
    return nullptr;
}

Json key_json(const KeyRow& row) {
    Json keys = Json::array();
    for (const Spelling& spelling : row.spellings)
        keys.push_back({{"key", row.key(spelling)}, {"unit", or_null(spelling.unit)}});
    return {{"table", row.table},
            {"name", row.name},
            {"keys", keys},
            {"type", input::type_words(row.type)},
            {"allowed", row.allowed(row.spellings.front())},
            {"choices", row.choices},
            {"default", row.default_text},
            {"meaning", row.meaning},
            {"needs", needs_json(row.availability)},
            {"cam_types", row.cam_types.empty() ? Json(nullptr) : Json(row.cam_types)},
            {"instead_of", or_null(row.instead_of)}};
}

}  // namespace

std::string keys_text() {
    std::string text;
    const KeyRow* previous = nullptr;
    for (const KeyRow& row : input::scene_keys()) {
        if (!previous || previous->table != row.table)
            text += row.table.empty() ? std::string("Top level\n") : fmt::format("\n[{}]\n", row.table);
        text += key_text(row);
        previous = &row;
    }
    return text +
           "\nEach quantity is written once, in one of its units. --set TABLE.KEY=VALUE replaces one key of "
           "a "
           "scene.\n";
}

Json keys_json() {
    Json list = Json::array();
    for (const KeyRow& row : input::scene_keys()) list.push_back(key_json(row));
    return list;
}

}  // namespace camopt::apps
