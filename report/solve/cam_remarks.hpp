// SPDX-License-Identifier: MIT
// What an engineer must know about a cam besides its figures.
#pragma once

#include "studies/delivered/solution.hpp"

namespace camopt {

/// Undercut, what limits the cam, the smallest one, the rest of the turn, lift-off, the forward check: one
/// sentence or two each, of what there is to say about this kind. For a solution with a cam.
[[nodiscard]] std::vector<std::string> cam_remarks(const Solution& solution);

}  // namespace camopt
