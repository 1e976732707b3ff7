// SPDX-License-Identifier: MIT
// An inspection for people and programs: deviations in µm, of displacements that are angles in mdeg.
#pragma once

#include "output/report/result_folder.hpp"
#include "studies/inspect/inspection.hpp"

namespace camopt {

struct InspectionOutput {
    std::string text, json;
    std::vector<FolderFile> files;  ///< inspection.csv (row by row), .svg, .html and .json
};
/// title: what was compared with what.
[[nodiscard]] InspectionOutput inspection_output(const Inspection& found, const std::string& title,
                                                 const RunOrigin& origin);

}  // namespace camopt
