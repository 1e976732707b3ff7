// SPDX-License-Identifier: MIT
#include "core/errors.hpp"
#include "core/platform/parts.hpp"
#include "shop/sheet/dimension_marks.hpp"
#include "shop/sheet/pdf/pdf_part.hpp"
#include "shop/sheet/sheet_files.hpp"

extern "C" const void* camopt_part_pdf(const char* build);  // pdf_cairo.cpp

namespace camopt {

namespace {

constexpr PartInfo pdf_info = {"pdf",
                               "PDF drawings",
                               "cairo",
                               "camopt-parts",
                               "libcairo2-dev",
                               "CAMOPT_WITH_CAIRO",
                               PartBuild::CAMOPT_PART_PDF};

const PdfPart& pdf_part() {
    return opened_part<PdfPart, pdf_info, camopt_part_pdf>();
}

}  // namespace

bool pdf_available() {
    return part_available(pdf_info);
}

void require_pdf() {
    try {
        require_part(pdf_info);
    } catch (const UnavailableError& error) {
        throw UnavailableError(error.what() +
                               std::string(", or take --drawing svg, which prints to the same scale"));
    }
}

std::string sheet_pdf(const Sheet& sheet) {
    return pdf_part().page(sheet, drawing_with_marks(sheet), sheet_styles);
}

}  // namespace camopt
