// SPDX-License-Identifier: MIT
// What the tolerances of a scene cost and which of them decides (studies/tolerance/tolerance_study.hpp), in
// words.
#pragma once

#include "studies/delivered/solution.hpp"

namespace camopt {

/// Empty where the scene has no tolerances, or there is no motion.
[[nodiscard]] std::vector<std::string> tolerance_sentences(const Solution& solution);

}  // namespace camopt
