// SPDX-License-Identifier: MIT
// What a result folder holds beside the files of every result: the page for a browser, the pictures of a
// drum.
#pragma once

#include "output/report/result_folder.hpp"

#include <vector>

namespace camopt {

/// For WriteOptions::also: report.html, and of a three-dimensional cam drum.svg and developed.svg.
[[nodiscard]] std::vector<FolderFile> result_extras(const Solution& solution, const RunOrigin& origin = {});

}  // namespace camopt
