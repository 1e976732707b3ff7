// SPDX-License-Identifier: MIT
// sweep.html: the picture and the table of all rows in one file. It loads nothing from anywhere; a little
// script shows a row's numbers under the pointer, marks it in the table, and sorts the table by a click on a
// head. Without scripts picture and table stand there all the same. Well-formed XML.
#pragma once

#include "output/chart/sweep/sweep_svg.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace camopt {

[[nodiscard]] std::string sweep_html(const SweepPicture& picture);

/// A page of a picture (SVG) above a table: heads, and rows of cells; the number of row i's marks in the
/// picture (class "rN") is `numbers[i]`. Cells are escaped.
struct PictureTable {
    std::vector<std::string> heads;
    std::vector<std::vector<std::string>> rows;
    std::vector<int> numbers;
};
[[nodiscard]] std::string picture_page(std::string_view title, std::string_view svg,
                                       const PictureTable& table);

}  // namespace camopt
