// SPDX-License-Identifier: MIT
// How a dimension looks on the paper: its lines, arrow heads and words (ISO 129-1). Pictures draw them; a DXF
// file keeps them in the dimension's block.
#pragma once

#include "output/sheet/sheet.hpp"

#include <array>
#include <vector>

namespace camopt {

inline constexpr double dimension_text_height = 2.5e-3;  ///< m

/// On the paper, m.
struct DimensionMarks {
    std::vector<SheetPath> lines;  ///< thin; arcs among them
    std::vector<std::array<Eigen::Vector2d, 3>> arrows;
    SheetText text;
};

[[nodiscard]] DimensionMarks dimension_marks(const SheetDimension& dimension, const SheetView& view);

}  // namespace camopt
