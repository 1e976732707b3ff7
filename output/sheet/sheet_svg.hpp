// SPDX-License-Identifier: MIT
// A sheet as SVG to scale: its width and height are those of the paper, so that it is printed at its scale.
#pragma once

#include "output/sheet/sheet.hpp"

#include <string>

namespace camopt {

[[nodiscard]] std::string sheet_svg(const Sheet& sheet);

}  // namespace camopt
