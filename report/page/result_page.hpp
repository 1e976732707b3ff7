// SPDX-License-Identifier: MIT
// The page of a solution with any kind of cam, and what its folder holds beside.
#pragma once

#include "report/folders/result_folder.hpp"
#include "report/page/page_html.hpp"

namespace camopt {

/// Ends in a line feed. Any text of the scene stands in it as a JSON string and nowhere else.
[[nodiscard]] std::string page_data(const View& view, const RunOrigin& origin = {},
                                    const SolutionWishes& wishes = {});

/// The page of the solution needs a library for three dimensions.
[[nodiscard]] bool page_needs_solids(const Solution& solution);

/// report.html: the report of a solution.
[[nodiscard]] std::string report_html(const View& view, const RunOrigin& origin = {});

// What a result folder holds beside the files of every result: the page for a browser, the pictures of a
// drum.

/// For WriteOptions::also: report.html, and of a three-dimensional cam drum.svg and developed.svg.
[[nodiscard]] std::vector<FolderFile> result_extras(const View& view, const RunOrigin& origin = {});

}  // namespace camopt
