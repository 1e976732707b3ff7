// SPDX-License-Identifier: MIT
// A sheet as DXF: the model at true size, in mm, the paper around it as large as the scale makes it. Every
// dimension is a DIMENSION with its block, measured in the model. Layers are those of the sheet's elements; a
// layer's line is that of its first element.
#pragma once

#include "shop/sheet/sheet.hpp"

namespace camopt {

[[nodiscard]] std::string sheet_dxf(const Sheet& sheet);

// A sheet as SVG to scale: its width and height are those of the paper, so that it is printed at its scale.
[[nodiscard]] std::string sheet_svg(const Sheet& sheet);

// A sheet as PDF, one page of its size, lines and letters as such (the font is embedded). Made by cairo where
// this build has it: the same lines and words as the SVG, regardless of the reader's fonts.

/// False in a build without cairo.
[[nodiscard]] bool pdf_available();
/// Throws UnavailableError in a build without cairo.
void require_pdf();

/// The same bytes for the same sheet and fonts. Throws UnavailableError in a build without cairo, InputError
/// where cairo fails.
[[nodiscard]] std::string sheet_pdf(const Sheet& sheet);

}  // namespace camopt
