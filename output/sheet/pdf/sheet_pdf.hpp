// SPDX-License-Identifier: MIT
// A sheet as PDF, one page of its size, lines and letters as such (the font is embedded). Made by cairo where
// this build has it: the same lines and words as the SVG, whatever fonts the reader has.
#pragma once

#include "output/sheet/sheet.hpp"

#include <string>

namespace camopt {

/// False in a build without cairo.
[[nodiscard]] bool pdf_available();
/// Throws UnavailableError in a build without cairo.
void require_pdf();

/// The same bytes for the same sheet and fonts. Throws UnavailableError in a build without cairo, InputError
/// where cairo fails.
[[nodiscard]] std::string sheet_pdf(const Sheet& sheet);

}  // namespace camopt
