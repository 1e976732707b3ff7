// SPDX-License-Identifier: MIT
// The files that the shop makes of a solution, by name, for report/exports/exports.hpp.
//
//   with a motion          an electronic cam of each controller (codesys.st, …, shop/plc/plc_formats.hpp)
//   plane cam              profile.dxf
//   disk cam               drawing.pdf, drawing.svg, drawing.dxf (workshop drawing), cam.step, cam.stl,
//                          cam.nc, cam_nc_check.txt, cam_nc.svg; of the second disk of a conjugate cam
//                          drawing_second.pdf, cam_second.step, …
//   three-dimensional cam  drawing.pdf, drawing.svg, drawing.dxf, flanks.csv, flanks.step, groove.stl,
//   cam.svg,
//                          cam.nc, cam_nc_check.txt, cam_nc.svg;
//                          of an indexing cam and of a groove that closes cam.stl
//   of these NAME.check.json: what `verify-export` holds them to (docs/certificates.md)
#pragma once

#include "shop/exports/workshop_options.hpp"

namespace camopt {

/// The title of the scene; "cam" where it has none.
[[nodiscard]] std::string export_title(const Solution& solution);
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
                                                       const WorkshopOptions& options);

}  // namespace camopt
