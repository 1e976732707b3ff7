// SPDX-License-Identifier: MIT
// From a three-dimensional cam to its checked NC program.
//
// A cutter as large as the roller makes both flanks in one pass; a smaller one takes a pass for each. m, rad,
// s.
#pragma once

#include "output/nc/cutter_location.hpp"
#include "output/nc/milling/milling_choice.hpp"
#include "scene/cam_flanks.hpp"

#include <memory>
#include <optional>

namespace camopt {

struct NcExportOptions : MillingOptions {
    std::optional<double> cutter_diameter = {};  ///< m; none: the roller's
    double tip_beyond = 5e-4;                    ///< m: the tip reaches so far below the roller's far end
    double z_offset = 0.0;                       ///< m: five axes, of Z (machine.hpp)
    double rotary_speed = 0.0;                   ///< rad/s; 0: no limit
    std::optional<int> blocks = {};              ///< instead of the chord tolerance
};

/// Four axes where the roller stands square to the cam's axis, else five.
[[nodiscard]] std::unique_ptr<Machine> machine_for(const CamFlanks& cam, double z_offset);

/// What is cut and what it is checked against. The cam's extent is that of both flanks along the whole roller
/// and, of an indexing cam, that of its body (indexing_body.hpp). Throws InputError for options that are not
/// valid and for a blank that the groove does not reach into.
[[nodiscard]] NcWork nc_work(const CamFlanks& cam, const FollowerMotion& motion,
                             const NcExportOptions& options);

/// Checked at five heights of the roller, both flanks. Throws InputError for options that are not valid.
[[nodiscard]] CheckedProgram nc_export(const CamFlanks& cam, const FollowerMotion& motion,
                                       const Machine& machine, const PostProcessor& post,
                                       const NcExportOptions& options);

// The roller of a three-dimensional cam as the NC programs want it (output/nc/cutter_location.hpp).

/// Stations are heights h along the roller; flank +1 is σ_f = +1, the D of paper 001.
[[nodiscard]] RollerPath roller_path(const CamFlanks& cam, const FollowerMotion& motion);

}  // namespace camopt
