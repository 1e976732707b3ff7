// SPDX-License-Identifier: MIT
// How a dimension looks: its lines, arrow heads and words (ISO 129-1). Pictures draw them; a DXF file keeps
// them in the dimension's block.
#pragma once

#include "shop/sheet/sheet.hpp"

namespace camopt {

/// "⌀25", "R40.5", "30°": lengths as drawn_length, degrees with two decimals.
[[nodiscard]] std::string words_of(const DrawnDimension& dimension);

/// Styles of sheet_styles: dimension, arrow and, last, one text, measure. `paper`: m of the model in one of
/// the paper.
[[nodiscard]] Drawing dimension_marks(const DrawnDimension& dimension, double paper);

/// What is on the sheet, with the marks of all its dimensions.
[[nodiscard]] Drawing drawing_with_marks(const Sheet& sheet);

/// Gives the dimensions the sheet's unit, and moves them, one after another, outwards or about the circle
/// that they measure, until no words lie on the words or lines of those before. One that finds no such place
/// stays.
void separate_dimensions(Sheet& sheet);

}  // namespace camopt
