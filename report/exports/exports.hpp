// SPDX-License-Identifier: MIT
// The files of a solved scene by their names, as `camopt export` and `camopt solve --out` write them: bytes
// in memory, or files in a folder.
//
//   always                 report.html, report.md, result.json, certificate.json
//   with a motion          motion.csv, motion.svg
//   plane cam              its points and pictures (report/cam/cam_files.hpp)
//   of the shop (shop/exports/workshop_files.hpp), where this build has it: drawings, solids, NC programs,
//   electronic cams
//
// Files are in mm and degrees. No file depends on another, nothing is solved.
#pragma once

#include "report/exports/export_options.hpp"
#include "report/folders/result_folder.hpp"

namespace camopt {

/// The names of the files that this solution has, in the order above.
[[nodiscard]] std::vector<std::string> export_names(const Solution& solution);

/// The bytes of one of them. Throws InputError for a name that is none of export_names, an NC program that
/// fails its check, an open or undercut cam, options that are not valid; UnavailableError for STEP or PDF in
/// a build without the library.
[[nodiscard]] std::string exported_file(const Solution& solution, std::string_view name,
                                        const ExportOptions& options = {});

/// The STEP file of a cam: its flanks where the solution has them, else this solid.
[[nodiscard]] std::string step_name(const Solution& solution, const std::string& solid = "cam.step");

/// Writes them into the folder, which is created: all or none. Returns their paths. Throws as exported_file,
/// and InputError where a file cannot be written.
std::vector<std::filesystem::path> write_exports(const std::filesystem::path& folder,
                                                 const Solution& solution, std::span<const std::string> names,
                                                 const ExportOptions& options = {});

}  // namespace camopt
