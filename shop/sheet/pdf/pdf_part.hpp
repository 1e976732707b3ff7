// SPDX-License-Identifier: MIT
// The part "pdf": what sheet_pdf.cpp asks of cairo. Internal.
#pragma once

#include "shop/sheet/sheet_painter.hpp"

namespace camopt {

class PdfPainter : public SheetPainter {
 public:
    /// The file's bytes. Throws InputError where cairo failed.
    [[nodiscard]] virtual std::string finish() = 0;
};

struct PdfPart {
    /// An empty page of the sheet's size and title.
    std::unique_ptr<PdfPainter> (*page)(const Sheet& sheet);
};

}  // namespace camopt
