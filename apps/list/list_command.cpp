// SPDX-License-Identifier: MIT
// camopt list: the laws, followers, solvers, keys of a scene, columns of a table and controllers that this
// camopt knows.
#include "apps/commands.hpp"
#include "apps/list/list_exports.hpp"
#include "apps/list/list_keys.hpp"
#include "apps/terminal.hpp"
#include "core/peak_figures.hpp"
#include "input/follower_kinds.hpp"
#include "motions/laws/law_catalogue.hpp"
#include "output/json/json_text.hpp"
#include "output/words/number_text.hpp"
#include "solvers/registry.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace camopt::apps {

namespace {

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

std::string followers_text() {
    constexpr std::size_t least_width = 20;
    const std::vector<input::FollowerKind> kinds = input::follower_kinds();
    std::string text, heading;
    for (const input::FollowerKind& kind : kinds) {
        if (heading_of(kind) != heading) {
            heading = heading_of(kind);
            text += fmt::format("{}{}\n", text.empty() ? "" : "\n", heading);
        }
        text +=
            fmt::format("  {:<{}} {:<9} {:<13} {}\n", kind.word,
                        std::max(least_width, longest_word(kinds, kind.cam_type)),
                        kind.swings ? "lift_deg" : "lift_mm", kind.touches_with, fmt::join(kind.keys, ", "));
    }
    return text +
           "\nEach line: name, key of its lift, what touches the cam, its dimensions: keys of [cam] or of "
           "the "
           "table before the dot. Most are numbers or ranges { min = …, max = … }; docs/scene_file.md has "
           "every key with its unit, default and meaning.\n";
}

Json followers_json() {
    Json list = Json::array();
    for (const input::FollowerKind& kind : input::follower_kinds())
        list.push_back({{"key", kind.word},
                        {"cam", kind.cam_type},
                        {"chosen_by", kind.chosen_by.empty() ? "cam.type" : kind.chosen_by},
                        {"lift", kind.swings ? "lift_deg" : "lift_mm"},
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
            text += fmt::format("{:<23}   not in this build: {}\n", "", entry.remedy);
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

struct Topic {
    const char* name;
    std::string (*text)();
    Json (*json)();
};

constexpr Topic topics[] = {
    {"laws", laws_text, laws_json},          {"followers", followers_text, followers_json},
    {"solvers", solvers_text, solvers_json}, {"keys", keys_text, keys_json},
    {"columns", columns_text, columns_json}, {"controllers", controllers_text, controllers_json}};

}  // namespace

std::vector<std::string> list_topics() {
    std::vector<std::string> names;
    for (const Topic& topic : topics) names.emplace_back(topic.name);
    return names;
}

ExitCode list_command(const ListRequest& request) {
    for (const Topic& topic : topics)
        if (request.what == topic.name) print(request.json ? json_text(topic.json()) : topic.text());
    return success;
}

}  // namespace camopt::apps
