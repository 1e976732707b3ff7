// SPDX-License-Identifier: MIT
// The files of a three-dimensional cam: points, surfaces, solids, a picture. Frame of
// scene/cam_flanks.hpp; mm in files.
#pragma once

#include "scene/cam_flanks.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace camopt {

struct CamExportOptions {
    bool csv = false;      ///< flanks.csv
    bool stl = false;      ///< groove.stl and, of an indexing cam, its whole body cam.stl
    bool obj = false;      ///< cam.obj: both flanks; of an indexing cam its body too
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

}  // namespace camopt
