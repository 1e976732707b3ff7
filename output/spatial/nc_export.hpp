// SPDX-License-Identifier: MIT
// From a three-dimensional cam to its checked NC program.
//
// A cutter as large as the roller makes both flanks in one pass; a smaller one takes a pass for each. The
// program is printed, read back, and run against the flanks' own points: what the check found stands beside
// it. m, rad, s.
#pragma once

#include "output/nc/nc_check.hpp"
#include "output/nc/nc_program.hpp"
#include "output/nc/post_processor.hpp"
#include "profiles/spatial/follower_motion.hpp"
#include "profiles/spatial/spatial_cam.hpp"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace camopt {

struct NcExportOptions {
    std::optional<double> cutter_diameter = {};  ///< m; none: the roller's
    double stock = 0.0;                          ///< m, left on the flanks
    double tip_beyond = 5e-4;                    ///< m: the tip reaches so far below the roller's far end
    double z_offset = 0.0;                       ///< m: five axes, of Z (machine.hpp)
    double feed = 5e-3;                          ///< m/s
    double rotary_speed = 0.0;                   ///< rad/s; 0: no limit
    double spindle_rpm = 0.0;                    ///< rev/min; 0: no word
    double chord_tolerance = 1e-6;               ///< m
    std::optional<int> blocks = {};              ///< instead of the chord tolerance
    std::string title = "cam";
};

/// What one height of the roller looks like after machining; of both flanks.
struct NcHeightCheck {
    double height = 0.0;                                      ///< m
    double gouge = 0.0, most_stock = 0.0, least_stock = 0.0;  ///< m
};

struct NcExport {
    NcProgram program;
    double chord_deviation = 0.0;  ///< m, of the blocks
    NcPoseCheck poses;             ///< of the printed text, read back
    std::vector<NcHeightCheck> surface;
};

/// Four axes where the roller stands square to the cam's axis, else five.
[[nodiscard]] std::unique_ptr<Machine> machine_for(const SpatialCam& cam, double z_offset);

/// Throws InputError for options that are not valid.
[[nodiscard]] NcExport nc_export(const SpatialCam& cam, const FollowerMotion& motion, const Machine& machine,
                                 const PostProcessor& post, const NcExportOptions& options);

/// What the check found, in words for a machinist. mm, deg.
[[nodiscard]] std::string nc_check_text(const NcExport& result);

}  // namespace camopt
