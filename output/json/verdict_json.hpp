// SPDX-License-Identifier: MIT
// The verdict of a solve, alike in every file that holds one.
#pragma once

#include "output/json/json_text.hpp"
#include "solvers/certificate/certificate.hpp"

namespace camopt {

/// {lower, gap, proof}: what the objective is proved to be no less than, and how.
[[nodiscard]] Json bound_json(const Certificate& certificate);

/// Adds verdict, reason, objective and bound.
void add_verdict(Json& json, const Certificate& certificate);

}  // namespace camopt
