// SPDX-License-Identifier: MIT
// Private to studies/papers/: what the barrel cam of paper 002 gains by an optimised motion: the pressure
// angle at the same distance of the axes, and the smallest distance for a pressure angle.
#pragma once

#include "studies/papers/paper_catalogue.hpp"
#include "studies/papers/spatial_tables.hpp"

#include <string>
#include <vector>

namespace camopt::spatial_tables {

struct BarrelOptima {
    PaperTable table;
    PaperFigure figure;  ///< pressure angle at the roller's tip, both motions
    std::vector<std::string> faults;
};

/// Two solves, some seconds each; as scenes/barrel_paper_cup.toml and scenes/barrel_smallest.toml.
[[nodiscard]] BarrelOptima barrel_optima(const Example& example, const SolveControl& control,
                                         const PaperProgress& finished);

}  // namespace camopt::spatial_tables
