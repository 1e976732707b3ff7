// SPDX-License-Identifier: MIT
// camopt list: the laws, followers and solvers that this camopt knows.
#include "apps/commands.hpp"
#include "core/cam_spec.hpp"
#include "motions/law_catalogue.hpp"
#include "output/json_text.hpp"
#include "output/number_text.hpp"
#include "solvers/registry.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <array>
#include <cstdio>
#include <string>
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
        list.push_back({{"key", info.key},
                        {"title", info.title},
                        {"source", info.source},
                        {"continuity", info.continuity},
                        {"parameters", parameters},
                        {"velocity", number_json(peaks.velocity.value)},
                        {"acceleration", number_json(peaks.acceleration.value)},
                        {"jerk", number_json(peaks.jerk.value)},
                        {"torque", number_json(peaks.torque.value)},
                        {"rms_velocity", number_json(peaks.rms_velocity)},
                        {"rms_acceleration", number_json(peaks.rms_acceleration)},
                        {"rms_jerk", number_json(peaks.rms_jerk)}});
    }
    return list;
}

constexpr std::array all_followers = {FollowerType::translating_roller, FollowerType::translating_knife,
                                      FollowerType::translating_flat, FollowerType::oscillating_roller,
                                      FollowerType::oscillating_flat};

/// The keys of the scene's table [cam] that this follower has, in the order of the key table.
std::vector<std::string> keys_of(FollowerType follower) {
    std::vector<std::string> keys;
    for (int i = 0; i < dimension_count; ++i) {
        const auto which = static_cast<DimensionIndex>(i);
        if (has_dimension(follower, which)) keys.push_back(fmt::format("{}_mm", name_of(which)));
    }
    if (follower == FollowerType::translating_flat) keys.emplace_back("face_half_width_mm");
    return keys;
}

const char* touches_with(FollowerType follower) {
    if (has_roller(follower)) return "a roller";
    return has_flat_face(follower) ? "a flat face" : "a knife edge";
}

std::string followers_text() {
    std::string text = fmt::format("{:<20} {:<9} {:<13} {}\n", "key", "lift", "touches with", "dimensions");
    for (const FollowerType follower : all_followers)
        text += fmt::format("{:<20} {:<9} {:<13} {}\n", name_of(follower),
                            is_oscillating(follower) ? "lift_deg" : "lift_mm", touches_with(follower),
                            fmt::join(keys_of(follower), ", "));
    return text +
           "Dimensions are numbers or ranges { min = …, max = … }, keys of [cam]; face_half_width_mm is a "
           "number.\n";
}

Json followers_json() {
    Json list = Json::array();
    for (const FollowerType follower : all_followers)
        list.push_back({{"key", name_of(follower)},
                        {"lift", is_oscillating(follower) ? "lift_deg" : "lift_mm"},
                        {"touches_with", touches_with(follower)},
                        {"dimensions", keys_of(follower)}});
    return list;
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
            text += fmt::format("{:<23}   {} = {} ({}): {}\n", "", option.name, option.default_value,
                                option.range, option.meaning);
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

}  // namespace

ExitCode list_command(const ListRequest& request) {
    std::string text;
    if (request.what == "laws")
        text = request.json ? json_text(laws_json()) : laws_text();
    else if (request.what == "solvers")
        text = request.json ? json_text(solvers_json()) : solvers_text();
    else
        text = request.json ? json_text(followers_json()) : followers_text();
    std::fputs(text.c_str(), stdout);
    return success;
}

}  // namespace camopt::apps
