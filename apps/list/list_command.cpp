// SPDX-License-Identifier: MIT
// camopt list: the laws, followers, solvers, keys of a scene, columns of a table and controllers that this
// camopt knows.
#include "apps/commands.hpp"
#include "apps/list/described_keys.hpp"
#include "apps/shop/shop_commands.hpp"
#include "apps/terminal.hpp"
#include "input/keys/scene_keys.hpp"
#include "input/scene_reader.hpp"
#include "motions/laws/law_catalogue.hpp"
#include "report/json/json_text.hpp"
#include "report/view/columns.hpp"
#include "report/view/number_text.hpp"
#include "scene/machine_spec.hpp"
#include "solvers/registry.hpp"

#include <fmt/ranges.h>

namespace camopt::apps {

namespace {

// camopt list keys: every key of a file, from the rows that its reader checks against.

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
    if (row.availability == Availability::needs_drive) text += " Needs [drive].";
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
    if (availability == Availability::needs_drive) return "drive";
    return nullptr;
}

Json key_json(std::string_view file, const KeyRow& row) {
    Json keys = Json::array();
    for (const Spelling& spelling : row.spellings)
        keys.push_back({{"key", row.key(spelling)}, {"unit", or_null(spelling.unit)}});
    return {{"file", file},
            {"table", row.table},
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

std::string keys_text() {
    std::string text;
    for (const DescribedKeys& file : described_keys()) {
        text += fmt::format("{}{}\n", text.empty() ? "" : "\n", file.heading);
        const KeyRow* previous = nullptr;
        for (const KeyRow& row : file.rows) {
            if (!previous || previous->table != row.table) text += fmt::format("\n{}\n", table_heading(row));
            text += key_text(row);
            previous = &row;
        }
    }
    return text +
           "\nEach quantity is written once, in one of its units. --set TABLE.KEY=VALUE replaces one key of "
           "a scene.\n";
}

/// An array, one entry a row in their order: file ("scene", "machine", "post-processor"), table, name, keys
/// as they may be written with their units, type, allowed, choices, default, meaning, needs ("cam", "forces"
/// or null), cam_types (null: all), instead_of (a key or null).
Json keys_json() {
    Json list = Json::array();
    for (const DescribedKeys& file : described_keys())
        for (const KeyRow& row : file.rows) list.push_back(key_json(file.name, row));
    return list;
}

// camopt list columns: what `export --csv` knows, from its table.

std::string columns_text() {
    std::string text;
    for (const TableColumn& column : table_columns()) {
        const std::string needs = words_of_need(column.need);
        text += fmt::format("{:<20} {}{}{}\n", column.key, column.meaning, needs.empty() ? "" : "; ", needs);
    }
    return text + "For camopt export WHAT --out DIR --csv --columns KEY,KEY,…\n";
}

/// Each: key, meaning, needs (null: nothing).
Json columns_json() {
    Json list = Json::array();
    for (const TableColumn& column : table_columns()) {
        const std::string needs = words_of_need(column.need);
        list.push_back({{"key", column.key},
                        {"meaning", column.meaning},
                        {"needs", needs.empty() ? Json(nullptr) : Json(needs)}});
    }
    return list;
}

std::string laws_text() {
    std::string text = fmt::format("{:<30} {:>9} {:>9} {:>9} {:>9}  {}\n", "key", "V", "A", "J", "Q", "law");
    for (const LawInfo& info : law_catalogue()) {
        const Peaks peaks = make_law(info.key)->peaks();
        text += fmt::format("{:<30} {:>9} {:>9} {:>9} {:>9}  {}\n", info.key,
                            short_text(peaks.velocity.value), short_text(peaks.acceleration.value),
                            short_text(peaks.jerk.value), short_text(peaks.torque.value), info.title);
    }
    return text +
           "Peaks are normalised by lift and rise: V, A, J = max |y'|, |y''|, |y'''|; Q = max |y'·y''|.\n";
}

Json laws_json() {
    Json list = Json::array();
    for (const LawInfo& info : law_catalogue()) {
        const Peaks peaks = make_law(info.key)->peaks();
        Json parameters = Json::object();
        for (const LawParameter& parameter : info.parameters)
            parameters[parameter.name] = number_json(parameter.value);
        Json law = {{"key", info.key},
                    {"title", info.title},
                    {"source", info.source},
                    {"continuity", info.continuity},
                    {"parameters", parameters}};
        for (const PeakFigure& figure : peak_figures)
            law[std::string(figure.name)] = number_json(figure.of(peaks));
        list.push_back(std::move(law));
    }
    return list;
}

/// 'cam.type = "disk", cam.follower =': what chooses the kinds below.
std::string heading_of(const input::FollowerKind& kind) {
    if (kind.chosen_by.empty()) return fmt::format("cam.type = \"{}\"", kind.cam_type);
    return fmt::format("cam.type = \"{}\", {} =", kind.cam_type, kind.chosen_by);
}

/// Of the kinds of one type of cam: they stand below each other.
std::size_t longest_word(const std::vector<input::FollowerKind>& kinds, const std::string& cam_type) {
    std::size_t longest = 0;
    for (const input::FollowerKind& kind : kinds)
        if (kind.cam_type == cam_type) longest = std::max(longest, kind.word.size());
    return longest;
}

/// The key of its lift in the unit of the manual.
std::string lift_key(const input::FollowerKind& kind) {
    return input::find_row("motion", "lift")->key(kind.swings ? unit_named<"deg"> : unit_named<"mm">);
}

std::string followers_text() {
    constexpr std::size_t least_width = 20;
    const std::vector<input::FollowerKind> kinds = input::follower_kinds();
    std::string text, heading;
    for (const input::FollowerKind& kind : kinds) {
        if (heading_of(kind) != heading) {
            heading = heading_of(kind);
            text += fmt::format("{}{}\n", text.empty() ? "" : "\n", heading);
        }
        text += fmt::format("  {:<{}} {:<9} {:<13} {}\n", kind.word,
                            std::max(least_width, longest_word(kinds, kind.cam_type)), lift_key(kind),
                            kind.touches_with, fmt::join(kind.keys, ", "));
    }
    return text +
           "\nEach line: name, key of its lift, contact with the cam, its dimensions: keys of [cam] or of "
           "the table before the dot. Most are numbers or ranges { min = …, max = … }; docs/scene_file.md "
           "has every key with its unit, default and meaning.\n";
}

Json followers_json() {
    Json list = Json::array();
    for (const input::FollowerKind& kind : input::follower_kinds())
        list.push_back({{"key", kind.word},
                        {"cam", kind.cam_type},
                        {"chosen_by", kind.chosen_by.empty() ? "cam.type" : kind.chosen_by},
                        {"lift", lift_key(kind)},
                        {"touches_with", kind.touches_with},
                        {"dimensions", kind.keys}});
    return list;
}

std::string absent_text(const NativeOption& option) {
    if (option.absent.empty()) return "";
    return fmt::format("; not in this build: {} ({})", fmt::join(option.absent, ", "), option.remedy);
}

std::string solvers_text() {
    std::string text;
    for (const SolverEntry& entry : solver_entries()) {
        text += fmt::format("{:<23} {}\n", entry.name, entry.method);
        if (entry.available)
            text +=
                fmt::format("{:<23}   available{}{}{}{}{}\n", "", entry.version.empty() ? "" : ", version ",
                            entry.version, entry.gives_multipliers ? ", gives multipliers" : "",
                            entry.needs_derivatives ? "" : ", needs no derivatives",
                            entry.takes_equalities ? "" : ", takes no equality rows");
        else
            text += fmt::format("{:<23}   not available: {}\n", "", entry.remedy);
        for (const NativeOption& option : entry.options)
            text += fmt::format("{:<23}   {} = {} ({}): {}{}\n", "", option.name, option.default_value,
                                option.range, option.meaning, absent_text(option));
    }
    return text;
}

Json solvers_json() {
    Json list = Json::array();
    for (const SolverEntry& entry : solver_entries()) {
        Json options = Json::array();
        for (const NativeOption& option : entry.options)
            options.push_back({{"name", option.name},
                               {"kind", option.kind},
                               {"default", option.default_value},
                               {"range", option.range},
                               {"meaning", option.meaning}});
        list.push_back({{"name", entry.name},
                        {"method", entry.method},
                        {"available", entry.available},
                        {"version", entry.version.empty() ? Json(nullptr) : Json(entry.version)},
                        {"remedy", entry.remedy.empty() ? Json(nullptr) : Json(entry.remedy)},
                        {"gives_multipliers", entry.gives_multipliers},
                        {"needs_convex", entry.needs_convex},
                        {"needs_derivatives", entry.needs_derivatives},
                        {"takes_equalities", entry.takes_equalities},
                        {"options", options}});
    }
    return list;
}

std::vector<ListTopic> topics() {
    std::vector<ListTopic> all = {{"laws", laws_text, laws_json},
                                  {"followers", followers_text, followers_json},
                                  {"solvers", solvers_text, solvers_json},
                                  {"keys", keys_text, keys_json},
                                  {"columns", columns_text, columns_json}};
    std::ranges::move(shop_topics(), std::back_inserter(all));
    return all;
}

}  // namespace

std::vector<DescribedKeys> described_keys() {
    std::vector<DescribedKeys> all = {{"scene", "KEYS OF A SCENE", input::scene_keys()},
                                      {"machine", "KEYS OF A MACHINE", machine_rows()}};
    std::ranges::move(shop_keys(), std::back_inserter(all));
    return all;
}

std::string table_heading(const KeyRow& row) {
    return row.table.empty() ? std::string("Top level") : fmt::format("[{}]", row.table);
}

std::vector<std::string> list_topics() {
    std::vector<std::string> names;
    for (const ListTopic& topic : topics()) names.emplace_back(topic.name);
    return names;
}

ExitCode list_command(const ListRequest& request) {
    for (const ListTopic& topic : topics())
        if (request.what == topic.name) print(request.json ? json_text(topic.json()) : topic.text());
    return success;
}

}  // namespace camopt::apps
