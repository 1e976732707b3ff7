// SPDX-License-Identifier: MIT
// The result folder: result.json, certificate.json, report.md and, where the scene was a text, scene.toml;
// with a motion motion.csv and motion.svg; with a cam profile.csv, profile.svg, profile_diagrams.svg and,
// where asked for, profile.dxf. read_result_folder reads it back.
#pragma once

#include "output/json/result_json.hpp"
#include "output/view/view.hpp"
#include "studies/delivered/solution.hpp"

#include <filesystem>
#include <functional>
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
    bool for_programs = false;          ///< result.json, certificate.json and scene.toml alone
};

/// Creates the folder where it does not exist. All files are written aside first and then replace those of an
/// earlier run together (folder_update.hpp); those that this one does not have (motion.*, profile*.*) are
/// removed. Returns the paths written. Throws InputError where the path is a file or cannot be written: the
/// folder is then as it was, or says by INCOMPLETE.txt that it is not.
std::vector<std::filesystem::path> write_result_folder(const std::filesystem::path& folder, const View& view,
                                                       const RunOrigin& origin = {},
                                                       const WriteOptions& options = {});

/// Creates the folder; throws InputError where it cannot. For commands that want to know before a long run.
void prepare_folder(const std::filesystem::path& folder);

// A result folder read back: the very motion, cam and verdict that were delivered, without solving.
//
// scene.toml gives the scene, result.json the motion and the dimensions bit for bit, certificate.json the
// verdict and its proof. All else is made from these, and what result.json says of it must be that: a file
// that was changed by hand, or belongs to another scene, is refused with the first number that is not its
// own.
struct ResultFolder {
    Solution solution;
    RunOrigin origin;
};

/// What makes a scene of its text (the name is for messages), with the formulas of its mechanism.
using SceneLoader = std::function<Scene(const std::string& text, const std::string& name)>;

/// Throws InputError for a folder that is no result folder, is not complete, holds no motion (infeasible,
/// failed), is of another version of camopt, or whose files say different things.
[[nodiscard]] ResultFolder read_result_folder(const std::filesystem::path& folder, const SceneLoader& load);

// report.md: the result for a cam engineer, in words, tables and the picture motion.svg beside it.

[[nodiscard]] std::string report_markdown(const Solution& solution, const RunOrigin& origin = {});

}  // namespace camopt
