// SPDX-License-Identifier: MIT
// The files of a three-dimensional cam: points, surfaces, solids, a picture. Frame of
// scene/cam_flanks.hpp; mm in files.
#pragma once

#include "scene/cam_flanks.hpp"
#include "shop/nc/milling/milling_choice.hpp"

namespace camopt {

struct CamExportOptions {
    bool csv = false;  ///< flanks.csv
    bool stl = false;  ///< groove.stl and, of an indexing cam or a groove that closes, the whole body cam.stl
    bool step = false;     ///< flanks.step; needs Open CASCADE
    bool picture = false;  ///< cam.svg
    FlankSampling sampling = {9, 361, 0.0, 0.0};
    std::string title = "cam";
};

/// Writes what is asked for into the folder, which exists; returns the paths. Throws InputError where a file
/// cannot be written, UnavailableError for STEP in a build without it.
std::vector<std::filesystem::path> write_cam_files(const std::filesystem::path& folder, const CamFlanks& cam,
                                                   const FollowerMotion& motion,
                                                   const CamExportOptions& options);

// From a three-dimensional cam to its checked NC program.
//
// A cutter as large as the roller makes both flanks in one pass; a smaller one takes a pass for each. m, rad,
// s.

struct NcExportOptions : MillingOptions {
    std::optional<double> cutter_diameter = {};  ///< m; none: the roller's
    double tip_beyond = 5e-4;                    ///< m: the tip reaches so far below the roller's far end
    double z_offset = 0.0;                       ///< m: five axes, of Z (machine.hpp)
    double rotary_speed = 0.0;                   ///< rad/s; 0: no limit
    std::optional<int> blocks = {};              ///< instead of the chord tolerance
};

/// Four axes where the roller stands square to the cam's axis, else five.
[[nodiscard]] std::unique_ptr<Machine> machine_for(const CamFlanks& cam, double z_offset);

/// What is cut and what it is checked against, for checked_program(): at five heights of the roller, both
/// flanks. The cam's extent is that of both flanks along the whole roller and, of an indexing cam, that of
/// its body (indexing_body.hpp). Throws InputError for options that are not valid and for a blank that the
/// groove does not reach into.
[[nodiscard]] NcWork nc_work(const CamFlanks& cam, const FollowerMotion& motion,
                             const NcExportOptions& options);

// The roller of a three-dimensional cam as the NC programs want it (shop/nc/machine.hpp).

/// Stations are heights h along the roller; flank +1 is σ_f = +1, the D of paper 001.
[[nodiscard]] RollerPath roller_path(const CamFlanks& cam, const FollowerMotion& motion);

}  // namespace camopt
