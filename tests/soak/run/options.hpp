// SPDX-License-Identifier: MIT
// The command line of camopt_soak.
#pragma once

#include "tests/soak/scenes/drawn_scene.hpp"

#include <cstdint>
#include <optional>
#include <string>

namespace camopt::soak {

struct Options {
    std::uint64_t seed = 1;
    int motions = 200, cams = 20;
    int first = 0;  ///< number of the first trial of either kind: how a long run is cut into ranges
    int jobs = 1;
    int comparisons = 2;              ///< changed scenes a trial
    std::string only;                 ///< one relation; empty: all
    std::string folder = "out/soak";  ///< where scenes of failures go
    std::string replay;               ///< a scene file in place of random ones
    bool list = false, help = false;
    SceneBudget budget;
};

/// Throws std::invalid_argument with what is wrong.
[[nodiscard]] Options read_options(int count, const char* const* words);
[[nodiscard]] const char* usage();

}  // namespace camopt::soak
