// SPDX-License-Identifier: MIT
// The result folder: result.json, certificate.json, report.md, and with a curve motion.csv and motion.svg.
#pragma once

#include "output/run_origin.hpp"
#include "studies/solution.hpp"

#include <filesystem>
#include <vector>

namespace camopt {

/// Creates the folder where it does not exist and writes each file in one step (text_file.hpp). A motion.csv
/// or motion.svg of an earlier run is removed where this one has no curve. Returns the paths written. Throws
/// InputError where the path is a file or cannot be written.
std::vector<std::filesystem::path> write_result_folder(const std::filesystem::path& folder,
                                                       const Solution& solution,
                                                       const RunOrigin& origin = {});

/// Creates the folder; throws InputError where it cannot. For commands that want to know before a long run.
void prepare_folder(const std::filesystem::path& folder);

}  // namespace camopt
