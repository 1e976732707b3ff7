// SPDX-License-Identifier: MIT
// result.json: everything a program needs to know of a solve. Keys, units and order: docs/results.md.
//
// null stands where a value does not exist (no curve, no proof); there is never a NaN or an Infinity. Numbers
// read back as the same double. Never throws for what a Solution holds.
#pragma once

#include "studies/delivered/solution.hpp"

namespace camopt {

// Where a result comes from, so that the run can be repeated from its folder.

struct RunOrigin {
    std::string scene_file;  ///< as given; empty for a scene built in C++
    std::string command;     ///< the command line; empty where there was none
    /// The scene as solved, in TOML (input::scene_with_overrides). Empty for a scene built in C++: then the
    /// folder cannot be read back.
    std::string scene_text = {};
};

[[nodiscard]] std::string result_json(const Solution& solution, const RunOrigin& origin = {});

}  // namespace camopt
