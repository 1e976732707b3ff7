// SPDX-License-Identifier: MIT
// report.md: the result for a cam engineer, in words, tables and the picture motion.svg beside it.
#pragma once

#include "output/json/run_origin.hpp"
#include "studies/delivered/solution.hpp"

#include <string>

namespace camopt {

[[nodiscard]] std::string report_markdown(const Solution& solution, const RunOrigin& origin = {});

}  // namespace camopt
