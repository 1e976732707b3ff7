// SPDX-License-Identifier: MIT
// A paper's tables and figures as CSV (RFC 4180, line feed). A table has its columns' keys as header; a
// figure has series,x,y.
#pragma once

#include "studies/papers/paper_report.hpp"

#include <string>

namespace camopt {

[[nodiscard]] std::string paper_table_csv(const PaperTable& table);
[[nodiscard]] std::string paper_figure_csv(const PaperFigure& figure);

}  // namespace camopt
