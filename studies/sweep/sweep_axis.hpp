// SPDX-License-Identifier: MIT
// One direction of a sweep: keys of the scene that vary together, and the points they take.
//
// Keys are dotted scene keys as `--set` takes them ("objective.velocity", "cam.base_radius_mm",
// "spline.segments"), values are in the unit of the key. Every function throws InputError saying what was
// found and what is allowed.
#pragma once

#include "scene/cost_table.hpp"

namespace camopt {

/// A slip of the keyboard is told before it fills the disk.
inline constexpr int most_sweep_rows = 1'000'000;

struct SweepAxis {
    std::vector<std::string> keys;
    std::vector<double> values;  ///< point after point, one value a key

    [[nodiscard]] int points() const {
        return keys.empty() ? 0 : static_cast<int>(values.size() / keys.size());
    }
    [[nodiscard]] std::span<const double> point(int index) const {
        return std::span(values).subspan(static_cast<std::size_t>(index) * keys.size(), keys.size());
    }
};

/// All weights i/N, j/N, k/N with i + j + k = N of velocity, acceleration and jerk: (N + 1)(N + 2)/2 points.
/// In boustrophedon order: from one point to the next 1/N moves from one weight to another.
[[nodiscard]] SweepAxis simplex_weights(int divisions);

/// A table of weights. The first line names them (the cost terms of scene/cost_table.hpp, base_radius, …;
/// "objective." may stand before), every other line is a point: numbers >= 0. Empty lines and lines that
/// begin with # are skipped. Errors begin with "NAME:LINE: ".
[[nodiscard]] SweepAxis weights_of_csv(std::string_view text, std::string_view name);

/// "KEY=a:b:count" (evenly, both ends included), "KEY=a:b:count:log" (by equal factors), "KEY=v1,v2,…".
/// Values in between are rounded to 15 digits (by factors to 12), so that 0.1:0.5:5 has 0.3 in it.
[[nodiscard]] SweepAxis varied_key(std::string_view text);

/// Whether the key is a weight of the objective: "objective.velocity", not "objective.tie_break".
[[nodiscard]] bool is_weight_key(std::string_view key);

/// Every weight that an objective can have, with its key.
struct ObjectiveWeight {
    std::string key;  ///< "objective.velocity", "objective.residual", "objective.base_radius"
    std::function<double&(ObjectiveSpec&)> in;
};
[[nodiscard]] const std::vector<ObjectiveWeight>& objective_weights();
/// None: the key is no weight.
[[nodiscard]] const ObjectiveWeight* weight_of_key(std::string_view key);

}  // namespace camopt
