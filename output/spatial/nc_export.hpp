// SPDX-License-Identifier: MIT
// From a three-dimensional cam to its checked NC program.
//
// A cutter as large as the roller makes both flanks in one pass; a smaller one takes a pass for each. m, rad,
// s.
#pragma once

#include "output/nc/checked_program.hpp"
#include "output/nc/milling/milling_choice.hpp"
#include "profiles/spatial/follower_motion.hpp"
#include "profiles/spatial/spatial_cam.hpp"

#include <memory>
#include <optional>
#include <string>

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
    double gouge_tolerance = 1e-5;               ///< m: checked_program.hpp
    BlankChoice blank;                           ///< what is left out: the cam's extent and the allowance
    double clearance = 0.02;                     ///< m: of the clearance plane above the blank
    double safe_distance = 2e-3;                 ///< m: rapids keep so far from the blank
    MillingChoice milling;
    std::string title = "cam";
};

/// Four axes where the roller stands square to the cam's axis, else five.
[[nodiscard]] std::unique_ptr<Machine> machine_for(const SpatialCam& cam, double z_offset);

/// What is cut and what it is checked against. The cam's extent is that of both flanks along the whole roller
/// and, of an indexing cam, that of its body (indexing_body.hpp). Throws InputError for options that are not
/// valid and for a blank that the groove does not reach into.
[[nodiscard]] NcWork nc_work(const SpatialCam& cam, const FollowerMotion& motion,
                             const NcExportOptions& options);

/// Checked at five heights of the roller, both flanks. Throws InputError for options that are not valid.
[[nodiscard]] CheckedProgram nc_export(const SpatialCam& cam, const FollowerMotion& motion,
                                       const Machine& machine, const PostProcessor& post,
                                       const NcExportOptions& options);

}  // namespace camopt
