// SPDX-License-Identifier: MIT
// The result folder: result.json, certificate.json, report.md and, where the scene was a text, scene.toml;
// with a motion motion.csv and motion.svg; with a cam profile.csv, profile.svg, profile_diagrams.svg and,
// where asked for, profile.dxf. report/result_folder_reader.hpp reads it back.
#pragma once

#include "output/json/certificate/run_origin.hpp"
#include "studies/delivered/solution.hpp"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace camopt {

struct FolderFile {
    std::string name, text;
};

struct WriteOptions {
    std::optional<int> points = {};     ///< of profile.csv, evenly by cam angle; none: by chord tolerance
    bool dxf = false;                   ///< profile.dxf too
    std::vector<FolderFile> also = {};  ///< written with them: report.html (output/page/page_html.hpp)
};

/// Creates the folder where it does not exist. All files are written aside first and then replace those of an
/// earlier run together (folder_update.hpp); those that this one does not have (motion.*, profile*.*) are
/// removed. Returns the paths written. Throws InputError where the path is a file or cannot be written: the
/// folder is then as it was, or says by INCOMPLETE.txt that it is not.
std::vector<std::filesystem::path> write_result_folder(const std::filesystem::path& folder,
                                                       const Solution& solution, const RunOrigin& origin = {},
                                                       const WriteOptions& options = {});

/// Creates the folder; throws InputError where it cannot. For commands that want to know before a long run.
void prepare_folder(const std::filesystem::path& folder);

}  // namespace camopt
