// SPDX-License-Identifier: MIT
// "dynamics" of result.json. Private to output/.
#pragma once

#include "output/json/json_text.hpp"
#include "studies/delivered/solution.hpp"

namespace camopt {

/// null where the scene has no train, or there is no motion.
[[nodiscard]] Json train_json(const Solution& solution);

}  // namespace camopt
