// SPDX-License-Identifier: MIT
// What the shop adds to the files of a solution, as what writes results sees it. A build without the shop
// (CAMOPT_SHOP=OFF) has none.
#pragma once

#include "report/exports/export_options.hpp"
#include "report/view/view.hpp"
#include "scene/key_row.hpp"

namespace camopt {

/// The bytes of a file, and what the console says of it: lines, or nothing.
struct MadeFile {
    std::string bytes, words = {};

    MadeFile(std::string made,
             std::string said = {})  // NOLINT(google-explicit-constructor): most say nothing
        : bytes(std::move(made)), words(std::move(said)) {}
};

/// A file of a solution, made when it is asked for.
struct ExportFile {
    std::string name;
    std::function<MadeFile()> make;
};

/// A controller that takes electronic cams.
struct Controller {
    std::string key, name, file;  ///< "codesys", "CODESYS SoftMotion, …", "codesys.st"
};

struct Workshop {
    /// Both must outlive the files.
    std::vector<ExportFile> (*files)(const Solution& solution, const ExportOptions& options);
    /// One row an option of ExportOptions::settings.
    std::span<const KeyRow> (*option_rows)();
    /// profile.dxf and profile.check.json; none without a plane cam.
    std::vector<FolderFile> (*dxf_files)(const View& view);
    std::vector<Controller> (*controllers)();
    /// Throws InputError for a key that is none.
    Controller (*controller)(std::string_view key);
    /// Electronic cams of every solution, in these formats.
    std::vector<std::vector<FolderFile>> (*controller_files)(std::span<const Solution> solutions,
                                                             const std::vector<std::string>& formats);
    /// Throws InputError where a format holds too few elements for any motion of the scene.
    void (*check_formats)(const Scene& scene, const std::vector<std::string>& formats);
    /// This build has the library.
    bool (*has_pdf)();
    bool (*has_step)();
};

/// Null in a build without the shop.
[[nodiscard]] const Workshop* workshop();
/// For `what` ("electronic cams"). Throws UnavailableError in a build without it.
[[nodiscard]] const Workshop& needed_workshop(std::string_view what);

/// The keys of its controllers; none without it.
[[nodiscard]] std::vector<std::string> controller_keys();

/// Workshop::controller_files; empty without a format. Throws UnavailableError without the shop.
[[nodiscard]] std::vector<std::vector<FolderFile>> controller_files(std::span<const Solution> solutions,
                                                                    const std::vector<std::string>& formats);

}  // namespace camopt
