// SPDX-License-Identifier: MIT
// A game of three columns: max over u of min over rows of row · u, with u >= 0 and Σ u = 1.
#pragma once

#include <array>
#include <span>

namespace camopt {

struct GameValue {
    std::array<double, 3> mix{};
    double value = 0.0;
};

/// Exact to rounding, by trying every corner: meant for some ten rows, at least one.
[[nodiscard]] GameValue solve_game(std::span<const std::array<double, 3>> rows);

}  // namespace camopt
