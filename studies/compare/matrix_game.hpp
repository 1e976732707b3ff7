// SPDX-License-Identifier: MIT
// A game of three columns: max over u of min over rows of row · u, with u >= 0 and Σ u = 1.
#pragma once

#include <array>
#include <span>

namespace camopt {

struct GameValue {
    std::array<double, 3> mix{};
    double value = 0.0;
    double bound = 0.0;  ///< no mix has more: from the rows' own mix, whatever was rounded on the way here
};

/// Exact to rounding, by trying every corner: meant for some ten rows, at least one.
[[nodiscard]] GameValue solve_game(std::span<const std::array<double, 3>> rows);

/// Of any number of rows, at least one: over the few that matter, found one by one. To 1e-12 of the value.
[[nodiscard]] GameValue solve_game_by_cuts(std::span<const std::array<double, 3>> rows);

}  // namespace camopt
