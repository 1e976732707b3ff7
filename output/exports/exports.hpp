// SPDX-License-Identifier: MIT
// The files of a solved scene by their names, as `camopt export` and `camopt solve --out` write them: bytes
// in memory, or files in a folder.
//
//   always                 report.html, report.md, result.json, certificate.json
//   with a motion          motion.csv, motion.svg; an electronic cam of each controller (codesys.st, …,
//                          output/plc/plc_format.hpp)
//   plane cam              its points and pictures (output/cam/cam_files.hpp), profile.dxf
//   of these and cam.nc    NAME.check.json (docs/certificates.md)
//   disk cam               drawing.pdf, drawing.svg, drawing.dxf (workshop drawing), cam.step, cam.stl,
//   cam.nc,
//                          cam_nc_check.txt, cam_nc.svg; of the second disk of a conjugate cam
//                          drawing_second.pdf, cam_second.step, …
//   three-dimensional cam  flanks.csv, flanks.step, groove.stl, cam.nc, cam_nc_check.txt, cam_nc.svg
//
// m, rad, s in options; files are in mm and degrees. No file depends on another, nothing is solved.
#pragma once

#include "output/nc/milling/milling_choice.hpp"
#include "output/plc/plc_format.hpp"
#include "output/report/result_folder.hpp"
#include "output/sheet/cam_sheet.hpp"

namespace camopt {

/// How a cam is milled, of any kind. The title of the program is that of the scene.
struct NcChoice : MillingOptions {
    std::optional<double> cutter_diameter = {};  ///< m; none: the roller's, of a plane cam 16 mm
    double z_offset = 0.0;                       ///< m: five axes, subtracted from Z
    double rotary_speed = 0.0;                   ///< rad/s, of three-dimensional cams; 0: no limit
    std::filesystem::path post = {};  ///< file of a post-processor (docs/nc.md); empty: the generic one
};

struct ExportOptions {
    CamSheetOptions plate;  ///< bore and thickness of a disk cam, in place of the scene's
    NcChoice nc;
    PlcOptions plc;
    RunOrigin origin;  ///< for the reports and result.json
};

/// The title of the scene; "cam" where it has none.
[[nodiscard]] std::string export_title(const Solution& solution);
/// What a title says of a piece: ", second disk"; of the first nothing.
[[nodiscard]] const char* piece_words(std::size_t piece);

/// A program with what its check found, as texts.
struct ExportedProgram {
    std::string name;     ///< "cam"; of the second disk of a conjugate cam "cam_second"
    std::string program;  ///< G-code
    std::string check;    ///< words for a machinist
    std::string picture;  ///< SVG: the path of the cutter
    std::string claims;   ///< NAME.check.json
    std::string fault;    ///< why it must not run; empty: no reason was found
};

/// One a piece of the cam. Throws InputError for a solution whose cam has no program, and for options that
/// are not valid.
[[nodiscard]] std::vector<ExportedProgram> nc_programs(const Solution& solution,
                                                       const ExportOptions& options);

/// The workshop drawing, one file a piece; format: "pdf", "svg" or "dxf". Throws as cam_sheets
/// (output/sheet/cam_sheet.hpp) and sheet_pdf, InputError for another format.
[[nodiscard]] std::vector<FolderFile> drawing_files(const Solution& solution, std::string_view format,
                                                    const CamSheetOptions& options = {});

/// The names of the files that this solution has, in the order above.
[[nodiscard]] std::vector<std::string> export_names(const Solution& solution);

/// The bytes of one of them. Throws InputError for a name that is none of export_names, an NC program that
/// fails its check, an open or undercut cam, options that are not valid; UnavailableError for STEP or PDF in
/// a build without the library.
[[nodiscard]] std::string exported_file(const Solution& solution, std::string_view name,
                                        const ExportOptions& options = {});

/// Writes them into the folder, which is created: all or none. Returns their paths. Throws as exported_file,
/// and InputError where a file cannot be written.
std::vector<std::filesystem::path> write_exports(const std::filesystem::path& folder,
                                                 const Solution& solution, std::span<const std::string> names,
                                                 const ExportOptions& options = {});

}  // namespace camopt
