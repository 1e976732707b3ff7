// SPDX-License-Identifier: MIT
// The part "pdf": what sheet_pdf.cpp asks of cairo. Internal.
#pragma once

#include "shop/sheet/sheet.hpp"

namespace camopt {

struct PdfPart {
    /// A page of the sheet's size and title with `drawing` on it, the first style at the bottom: the file's
    /// bytes. Throws InputError where cairo failed.
    std::string (*page)(const Sheet& sheet, const Drawing& drawing, std::span<const SheetStyle> styles);
};

}  // namespace camopt
