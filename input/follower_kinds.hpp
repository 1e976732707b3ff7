// SPDX-License-Identifier: MIT
// Every follower a scene can name, with the keys that say its dimensions: for lists and tests.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace camopt::input {

struct FollowerKind {
    std::string cam_type;   ///< "disk", "remote", …: cam.type
    std::string chosen_by;  ///< "cam.follower", "linkage.type"; empty: by cam.type alone
    std::string word;       ///< what stands there: "translating_roller", "lever", "rotating"; else cam.type
    bool swings = false;    ///< its lift is an angle
    std::string touches_with;  ///< "a roller"
    /// Its dimensions as keys in their first unit: "base_radius_mm" of [cam], "linkage.coupler_mm" of
    /// another.
    std::vector<std::string> keys;
};

/// In the order of the manual.
[[nodiscard]] std::vector<FollowerKind> follower_kinds();

}  // namespace camopt::input
