// SPDX-License-Identifier: MIT
// A comparison for spreadsheets: one line a law, the optimum among them with an empty key.
//
// Peaks are normalised. One column a limit holds what the motion reaches, in the unit of its key. Numbers
// read back as the same double; what is infinite or absent is an empty cell. Nothing throws.
#pragma once

#include "studies/compare/comparison.hpp"

#include <string>

namespace camopt {

[[nodiscard]] std::string comparison_csv(const Comparison& comparison);

}  // namespace camopt
