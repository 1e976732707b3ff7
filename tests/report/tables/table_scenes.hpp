// SPDX-License-Identifier: MIT
// Scene files that the tests of the tables make for any row, so that a new row is tested without an edit.
#pragma once

#include "input/loading/known_scene.hpp"
#include "input/loading/load_scene.hpp"
#include "scene/limit_table.hpp"
#include "tests/support/refusal.hpp"

#include <fmt/format.h>

#include <cmath>
#include <string>

namespace camopt::tables {

/// A rise and return with a roller follower, a spring and a speed. `objective` and `limits`: lines of these
/// tables.
inline std::string scene_text(bool swings, const std::string& objective, const std::string& limits) {
    return fmt::format(
        "title = \"rows\"\n[motion]\ntype = \"RR\"\n{}\nrise_deg = 120\nspeed_rpm = 60\n"
        "[spline]\nsegments = 8\n[objective]\n{}\n[solver]\nstarts = 1\n"
        "[cam]\ntype = \"disk\"\nfollower = \"{}\"\nbase_radius_mm = 60\n"
        "roller_radius_mm = {{ min = 8, max = 10 }}\n{}\n[forces]\n{}\ncontact_width_mm = 12\n[limits]\n{}\n",
        swings ? "lift_deg = 10" : "lift_mm = 10", objective,
        swings ? "oscillating_roller" : "translating_roller",
        swings ? "center_distance_mm = 120\narm_length_mm = 90" : "offset_mm = 0",
        swings ? "inertia_kg_m2 = 0.01\nspring_rate_nm_rad = 20\npreload_nm = 10"
               : "mass_kg = 1\nspring_rate_n_mm = 5\npreload_n = 100",
        limits);
}

inline Scene read(const std::string& text) {
    return known_scene(text, "s.toml", known_names(), {});
}

/// What the reader says; empty where it takes the scene.
inline std::string refusal_of(const std::string& text) {
    return testing_support::refusal([&] { (void)read(text); }, "");
}

/// A number in the range that any good cam keeps, SI.
inline double loose_value(const LimitRow& row) {
    constexpr double little = 1e-3, much = 1e15, nearly = 0.99;
    if (row.is_least()) return row.range.low + little;
    return std::isfinite(row.range.high) ? nearly * row.range.high : much;
}

/// One that the range does not hold.
inline double value_outside(const LimitRow& row) {
    return row.range.low_included ? row.range.low - 1.0 : row.range.low;
}

/// Its name where the follower translates, or swings.
inline std::string name_of_limit(const LimitRow& row, bool swings) {
    return swings && row.swinging.name != nullptr ? row.swinging.name : row.name;
}
inline std::span<const Spelling> spellings_of(const LimitRow& row, bool swings) {
    return swings && row.swinging.name != nullptr ? row.swinging.spellings : row.spellings;
}
inline std::string limit_line(const LimitRow& row, bool swings, const Spelling& spelling, double value) {
    return fmt::format("{}{} = {}", name_of_limit(row, swings), spelling.suffix, value / spelling.factor);
}

}  // namespace camopt::tables
