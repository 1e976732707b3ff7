// SPDX-License-Identifier: MIT
// What exported files may be asked for, and one row an option: options of `camopt export`, keywords in
// Python, lines of text in C.
//
// m, rad, s in options; each row has its units ("cutter_mm", "cutter_in").
#pragma once

#include "scene/key_row.hpp"
#include "shop/nc/milling/milling_choice.hpp"
#include "shop/plc/plc_formats.hpp"
#include "shop/sheet/cam_sheet.hpp"

namespace camopt {

/// How a cam is milled, of any kind. The title of the program is that of the scene.
struct NcChoice : MillingOptions {
    std::optional<double> cutter_diameter = {};  ///< m; none: the roller's, of a plane cam 16 mm
    double z_offset = 0.0;                       ///< m: five axes, subtracted from Z
    double rotary_speed = 0.0;                   ///< rad/s, of three-dimensional cams; 0: no limit
    std::string post = {};  ///< file of a post-processor (docs/nc.md); empty: the generic one
};

struct WorkshopOptions {
    double dxf_tolerance = 1e-6;  ///< m: of the arcs of profile.dxf
    CamSheetOptions plate;        ///< bore and thickness of a disk cam, in place of the scene's
    int sections = 9;             ///< points of a flank along the roller
    /// Evenly over the turn; none: an electronic cam the joints of the motion, a flank 361, a solid as many
    /// as it needs.
    std::optional<int> points = {};
    NcChoice nc;
};

/// What is made with an option.
enum class WorkGroup { plate, controller, program };

/// Of one group; all of them in this order.
[[nodiscard]] std::span<const KeyRow> workshop_rows(WorkGroup group);
[[nodiscard]] std::span<const KeyRow> workshop_rows();

/// {"cutter_mm", "12"}, {"direction", "conventional"}. Throws InputError "KEY: found …; allowed: …" for a
/// key that is none, for a value that is not allowed, and for one option in two units.
[[nodiscard]] WorkshopOptions workshop_options(std::span<const std::pair<std::string, std::string>> settings);

}  // namespace camopt
