// SPDX-License-Identifier: MIT
// The structured solver and Ipopt as they compete on linear programs: each with the options worth trying.
#pragma once

#include "scene/scene.hpp"

#include <map>
#include <string>
#include <vector>

namespace camopt::benchmarks {

struct SolverVariant {
    std::string solver;
    std::string words;  ///< what sets it apart: "predictor-corrector, chained columns"
    std::map<std::string, OptionValue> options;
};

/// Those that this build has.
[[nodiscard]] std::vector<SolverVariant> solver_variants();

[[nodiscard]] bool is_available(const std::string& backend);

}  // namespace camopt::benchmarks
