// SPDX-License-Identifier: MIT
// A figure of a paper's report as a picture: curves or points over two axes, with a legend.
#pragma once

#include "studies/papers/paper_report.hpp"

#include <string>

namespace camopt {

[[nodiscard]] std::string paper_figure_svg(const PaperFigure& figure);

}  // namespace camopt
