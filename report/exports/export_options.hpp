// SPDX-License-Identifier: MIT
// What a user may ask of the files of a solution.
#pragma once

#include "report/document/run_origin.hpp"

namespace camopt {

struct ExportOptions {
    RunOrigin origin = {};  ///< for the reports and result.json
    /// Of the shop's files: {"cutter_mm", "12"}, {"direction", "conventional"}; the keys are those of
    /// Workshop::option_rows (report/exports/workshop.hpp), as `camopt list keys` names them.
    std::vector<std::pair<std::string, std::string>> settings = {};
};

}  // namespace camopt
