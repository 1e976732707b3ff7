// SPDX-License-Identifier: MIT
#include "profiles/remote/remote_spec.hpp"
#include "tests/input/scene_key_cases.hpp"

#include <algorithm>
#include <iterator>

namespace camopt::input {
namespace remote_key_cases {

using enum RemoteDimension;
using enum RemoteLinkage;

/// A remote cam's scene, without one of its quantities.
std::string remote(RemoteLinkage linkage, const std::string& except = "") {
    std::string toml = output_swings(linkage) ? "motion.lift_deg = 20\n" : "motion.lift_mm = 20\n";
    if (except != "cam.type") toml += "cam.type = \"remote\"\n";
    if (except != "linkage.type") toml += "linkage.type = \"" + std::string(name_of(linkage)) + "\"\n";
    for (int i = 0; i < remote_dimension_count; ++i) {
        const auto which = static_cast<RemoteDimension>(i);
        const std::string key = std::string(table_of(which)) + "." + name_of(which);
        if (has_dimension(linkage, which) && key != except)
            toml += key + (is_angle(which) ? "_deg = 90\n" : "_mm = 100\n");
    }
    return toml;
}

std::function<double(const Scene&)> low(RemoteDimension which) {
    return [which](const Scene& s) {
        return s.cam.value().dimensions.at(static_cast<std::size_t>(which)).value.low;
    };
}

std::function<double(const Scene&)> chosen(const char* name, const char* value) {
    return [name, value](const Scene& s) { return s.cam.value().choices.at(name) == value ? 1.0 : 0.0; };
}

RemoteLinkage linkage_with(RemoteDimension which) {
    if (has_dimension(lever_coupler_lever_coupler_slider, which)) return lever_coupler_lever_coupler_slider;
    return lever;
}

}  // namespace remote_key_cases

std::vector<KeyCase> remote_cases() {
    using namespace remote_key_cases;
    const auto two_dyads = lever_coupler_lever_coupler_slider;
    std::vector<KeyCase> all = {
        {"cam.type", "\"remote\"", 1,
         [](const Scene& s) { return s.cam.value().type == "remote" ? 1.0 : 0.0; },
         remote(two_dyads, "cam.type")},
        {"linkage.type", "\"lever_coupler_slider\"", 1, chosen("linkage", "lever_coupler_slider"),
         remote(lever_coupler_slider, "linkage.type")},
        {"linkage.lever_branch", "\"right\"", 1, chosen("lever_branch", "right"), remote(two_dyads)},
        {"linkage.rocker_branch", "\"right\"", 1, chosen("rocker_branch", "right"), remote(two_dyads)},
        {"cam.pressure_angle_at", "\"contact_point\"", 1, chosen("pressure_angle_at", "contact_point"),
         remote(two_dyads)},
        {"cam.rotation", "\"clockwise\"", 1,
         [](const Scene& s) { return s.cam.value().rotation == Rotation::clockwise ? 1.0 : 0.0; },
         remote(two_dyads)},
        {"linkage.coupler_mm", "{ min = 20, max = 60 }", 0.06,
         [](const Scene& s) { return s.cam.value().dimensions.at(std::size_t(coupler)).value.high; },
         remote(two_dyads, "linkage.coupler")},
    };
    for (int i = 0; i < remote_dimension_count; ++i) {
        const auto which = static_cast<RemoteDimension>(i);
        const std::string key = std::string(table_of(which)) + "." + name_of(which);
        const std::string rest = remote(linkage_with(which), key);
        std::ranges::move(dimension_cases(key, is_angle(which), low(which), rest), std::back_inserter(all));
    }
    return all;
}

}  // namespace camopt::input
