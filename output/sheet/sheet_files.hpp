// SPDX-License-Identifier: MIT
// A sheet as DXF: the model at true size, in mm, the paper around it as large as the scale makes it. Every
// dimension is a DIMENSION with its block, measured in the model. Layers are those of the sheet's elements; a
// layer's line is that of its first element.
#pragma once

#include "output/sheet/sheet.hpp"

#include <string>

namespace camopt {

[[nodiscard]] std::string sheet_dxf(const Sheet& sheet);

// A sheet as SVG to scale: its width and height are those of the paper, so that it is printed at its scale.
[[nodiscard]] std::string sheet_svg(const Sheet& sheet);

}  // namespace camopt
