// SPDX-License-Identifier: MIT
// A paper's report as a document, and its reference table for programs.
#pragma once

#include "report/document/document_text.hpp"
#include "studies/papers/paper_report.hpp"
#include "studies/papers/reference_table.hpp"

namespace camopt {

/// Every table shown and as KEY.csv, every figure as KEY.svg and KEY.csv (series, x, y).
[[nodiscard]] Document paper_document(const PaperReport& report);

/// A figure: curves or points over two axes, with a legend. Nothing throws.
[[nodiscard]] Chart paper_chart(const PaperFigure& figure);

// The reference table for programs: everything in it, as one JSON document.
//
// Numbers read back as the same double; what is infinite or absent is null, never NaN. "all_optimal" is true
// where every solve is proved; every solve carries its own verdict. Peaks are normalised. Nothing throws.
[[nodiscard]] std::string reference_table_json(const ReferenceTable& table);

}  // namespace camopt
