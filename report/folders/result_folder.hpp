// SPDX-License-Identifier: MIT
// The result folder: result.json, certificate.json, report.md and, where the scene was a text, scene.toml;
// with a motion motion.csv and motion.svg; with a cam profile.csv, profile.svg, profile_diagrams.svg and,
// where asked for, profile.dxf (shop/dxf/cam_dxf.hpp). result_folder_reader.hpp reads it back.
#pragma once

#include "report/json/result_json.hpp"
#include "report/solve/solution_document.hpp"
#include "report/view/view.hpp"
#include "studies/delivered/solution.hpp"

#include <filesystem>

namespace camopt {

struct WriteOptions {
    std::optional<int> points = {};     ///< of profile.csv, evenly by cam angle; none: by chord tolerance
    std::vector<FolderFile> also = {};  ///< written with them: report.html (report/page/result_page.hpp)
    bool for_programs = false;          ///< result.json, certificate.json and scene.toml alone
};

/// Within the folder of a scene that seeks a number, where a value was proved impossible: the scene with that
/// value, its result and its certificate. scene.toml of the folder itself has the value that was found.
inline constexpr const char* least_proof_folder = "least";

/// Creates the folder where it does not exist. All files are written aside first and then replace those of an
/// earlier run together; those that this one does not have (motion.*, profile*.*) are
/// removed. Returns the paths written. Throws InputError where the path is a file or cannot be written: the
/// folder is then as it was, or says by INCOMPLETE.txt that it is not.
std::vector<std::filesystem::path> write_result_folder(const std::filesystem::path& folder, const View& view,
                                                       const RunOrigin& origin = {},
                                                       const WriteOptions& options = {});

/// Creates the folder; throws InputError where it cannot. For commands that want to know before a long run.
void prepare_folder(const std::filesystem::path& folder);

// A set of files that replaces another in the same folder, so that files of two runs never lie side by side
// unsaid.
//
//   1. every file is written into a folder aside, `.camopt-<process>.tmp` within the result folder: where one
//      fails (a full disk), the folder is as it was;
//   2. `INCOMPLETE.txt` appears, the file written last (who sees it finds the rest complete) disappears, the
//      new files take their names, files that only the earlier run had are removed, the last one takes its
//      name, `INCOMPLETE.txt` disappears. Only renaming and removing: no space is needed any more.
// Killed within 2, the folder says so by INCOMPLETE.txt; the next run that ends well removes it.

/// Stands in a folder whose files may be of two runs.
inline constexpr const char* incomplete_mark = "INCOMPLETE.txt";

class FolderUpdate {
 public:
    /// Creates the folder and the one aside. Throws InputError where it cannot.
    explicit FolderUpdate(std::filesystem::path folder);
    /// Without `finish` nothing has changed.
    ~FolderUpdate();
    FolderUpdate(const FolderUpdate&) = delete;
    FolderUpdate& operator=(const FolderUpdate&) = delete;
    FolderUpdate(FolderUpdate&&) = delete;
    FolderUpdate& operator=(FolderUpdate&&) = delete;

    /// Throws InputError where it cannot be written.
    void write(const std::string& name, std::string_view text);
    /// Where a file is to be written by others; `add` its name then. Throws ModelError for a name twice.
    [[nodiscard]] const std::filesystem::path& aside() const { return aside_; }
    void add(const std::string& name);
    /// An earlier run's file of this name goes, unless this one has it too.
    void remove_earlier(const std::string& name) { earlier_.push_back(name); }

    /// Step 2. Paths of the files in the order in which they were added. Throws InputError where a name
    /// cannot be taken; the folder is incomplete then and says so.
    std::vector<std::filesystem::path> finish();

 private:
    std::filesystem::path folder_, aside_;
    std::vector<std::string> names_, earlier_;
};

}  // namespace camopt
