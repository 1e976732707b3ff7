// SPDX-License-Identifier: MIT
// A paper's report for people, on the terminal or as a Markdown page, and for programs: CSV, JSON, pictures.
#pragma once

#include "output/chart/chart.hpp"
#include "studies/papers/paper_report.hpp"
#include "studies/papers/reference_table.hpp"

namespace camopt {

/// Figures are named by their titles.
[[nodiscard]] std::string paper_report_text(const PaperReport& report);

/// Names the figures' files: <key>.svg beside the page.
[[nodiscard]] std::string paper_report_markdown(const PaperReport& report);

// Tables and figures as CSV (RFC 4180, line feed). A table has its columns' keys as header; a figure has
// series,x,y.
[[nodiscard]] std::string paper_table_csv(const PaperTable& table);
[[nodiscard]] std::string paper_figure_csv(const PaperFigure& figure);

/// A figure: curves or points over two axes, with a legend. Nothing throws.
[[nodiscard]] Chart paper_chart(const PaperFigure& figure);
[[nodiscard]] inline std::string paper_figure_svg(const PaperFigure& figure) {
    return chart_svg(paper_chart(figure));
}

/// The files of a report by their names: report.md, a CSV for each table, CSV and SVG for each figure.
[[nodiscard]] std::vector<std::pair<std::string, std::string>> paper_report_files(const PaperReport& report);

// The reference table for programs: everything in it, as one JSON document.
//
// Numbers read back as the same double; what is infinite or absent is null, never NaN. "all_optimal" is true
// where every solve is proved; every solve carries its own verdict. Peaks are normalised. Nothing throws.
[[nodiscard]] std::string reference_table_json(const ReferenceTable& table);

}  // namespace camopt
