// SPDX-License-Identifier: MIT
// Stands in for pdf_cairo.cpp in a build without cairo.
#include "core/errors.hpp"
#include "output/sheet/sheet_files.hpp"

namespace camopt {

bool pdf_available() {
    return false;
}

void require_pdf() {
    throw UnavailableError(
        "PDF drawings need cairo, which this build of camopt does not have: install libcairo2-dev and "
        "configure again, or take --drawing svg, which prints to the same scale");
}

std::string sheet_pdf(const Sheet& /*sheet*/) {
    require_pdf();
    return {};
}

}  // namespace camopt
