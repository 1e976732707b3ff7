// SPDX-License-Identifier: MIT
// The mechanism of a solution (any cam but the disk cam) in words: dimensions, figures, remarks. mm, deg.
#pragma once

#include "output/words/cam_words.hpp"
#include "studies/delivered/solution.hpp"

#include <string>
#include <vector>

namespace camopt {

/// "cam with a remote follower (lever, coupler, slider), the cam turning clockwise"
[[nodiscard]] std::string mechanism_text(const MechanismSpec& spec);

/// "roller radius 30 mm, roller arm 160 mm, …": the dimensions this mechanism has; variable ones as
/// delivered, or as a range where nothing was.
[[nodiscard]] std::string mechanism_dimensions_text(const Solution& solution);

/// Pressure angle, radii, regularity. For a solution with a mechanism.
[[nodiscard]] std::vector<CamFigure> mechanism_figures(const Solution& solution);

/// Undercut, what limits it, the forward check.
[[nodiscard]] std::vector<std::string> mechanism_remarks(const Solution& solution);

}  // namespace camopt
