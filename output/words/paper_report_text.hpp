// SPDX-License-Identifier: MIT
// A paper's report for people: on the terminal, or as a Markdown page. Figures are named by their titles;
// their pictures are paper_figure_svg.hpp.
#pragma once

#include "studies/papers/paper_report.hpp"

#include <string>

namespace camopt {

[[nodiscard]] std::string paper_report_text(const PaperReport& report);

/// Names the figures' files: <key>.svg beside the page.
[[nodiscard]] std::string paper_report_markdown(const PaperReport& report);

}  // namespace camopt
