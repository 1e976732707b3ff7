// SPDX-License-Identifier: MIT
// The files of a three-dimensional cam: points, surfaces, solids, a picture. Frame of
// scene/cam_flanks.hpp; mm in files.
#pragma once

#include "output/nc/milling/milling_choice.hpp"
#include "output/surface/triangle_mesh.hpp"
#include "scene/cam_flanks.hpp"

namespace camopt {

struct CamExportOptions {
    bool csv = false;      ///< flanks.csv
    bool stl = false;      ///< groove.stl and, of an indexing cam, its whole body cam.stl
    bool step = false;     ///< flanks.step; needs Open CASCADE
    bool picture = false;  ///< cam.svg
    FlankSampling sampling = {9, 361, 0.0, 0.0};
    std::string title = "cam";
};

/// Over one turn the follower advances by one pitch: all rollers run through the cam one after the other.
/// Flanks and groove are then those of a roller from where it comes in to where it leaves.
[[nodiscard]] bool indexes(const CamFlanks& cam, const FollowerMotion& motion);

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

// The roller of a three-dimensional cam as the NC programs want it (output/nc/machine.hpp).

/// Stations are heights h along the roller; flank +1 is σ_f = +1, the D of paper 001.
[[nodiscard]] RollerPath roller_path(const CamFlanks& cam, const FollowerMotion& motion);

// Pictures of a three-dimensional cam in the style of all others: the drum, shaded, with its ribs or its
// groove, and its developed surface to scale.
//
// Developed: x = R ψ over z, R the mean radius of the roller's outer end, ψ the angle around the drum,
// counted from the roller at cam angle 0, as the cam angle grows; both flanks at both ends of the roller and
// the way of its axis. Frame of scene/cam_flanks.hpp.

struct Solution;

inline constexpr const char* drum_picture = "drum.svg";
inline constexpr const char* developed_picture = "developed.svg";

/// A drum with its motion over one revolution.
struct Drum {
    const Solution& solution;
    const CamFlanks& cam;
    const FollowerMotion& motion;
};

[[nodiscard]] std::string drum_svg(const Drum& drum);
[[nodiscard]] std::string developed_svg(const Drum& drum);

/// What is shown of it: an indexing cam with the rollers that hold it; of others both flanks around a core.
[[nodiscard]] std::vector<PaintedMesh> drum_parts(const CamFlanks& cam, const FollowerMotion& motion,
                                                  const FlankGrid& grid);
/// From the side on which the first part of the motion lies.
[[nodiscard]] MeshView drum_view(const CamFlanks& cam);

}  // namespace camopt
