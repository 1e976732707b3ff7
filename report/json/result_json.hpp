// SPDX-License-Identifier: MIT
// result.json: everything a program needs to know of a solve. Keys, units and order: docs/results.md.
//
// null stands where a value does not exist (no curve, no proof); there is never a NaN or an Infinity. Numbers
// read back as the same double. Never throws for what a Solution holds.
#pragma once

#include "report/document/run_origin.hpp"
#include "studies/delivered/solution.hpp"

namespace camopt {

[[nodiscard]] std::string result_json(const Solution& solution, const RunOrigin& origin = {});

}  // namespace camopt
