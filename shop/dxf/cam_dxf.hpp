// SPDX-License-Identifier: MIT
// profile.dxf of a delivered plane cam of any kind: what report/drawing/plane_cam.hpp draws of it, as arcs
// within a tolerance (arc_chain.hpp), in layers; mm.
//
//   disk     CAM, PITCH (roller centre), BASE_CIRCLE, PRIME_CIRCLE, ROLLER, FACE (flat face), AXES
//   linear   CAM (the plate: surface, sides, bottom), PITCH, ROLLER, AXES
//   remote   CAM, PITCH, ROLLER, AXES
//   inverse  WALLS (both of the slot), PITCH, ROLLER, AXES; frame of the body, its pivot at the origin
//
// Those that are used. Cam frame (report/drawing/profile_shape.hpp), the cam's centre at the origin; the
// follower where the motion begins.
#pragma once

#include "report/document/run_origin.hpp"
#include "report/drawing/profile_shape.hpp"
#include "shop/dxf/arc_chain.hpp"

namespace camopt {

struct ProfileDxf {
    std::string text;
    int arcs = 0;            ///< of the cam's outline
    double deviation = 0.0;  ///< m: the outline from the true cam, along its normal
    int pitch_arcs = 0;      ///< 0 where there is no pitch curve beside the cam
    double pitch_deviation = 0.0;
};

/// The cam's outline, or its pitch curve, as arcs. Throws as below.
[[nodiscard]] ArcChain outline_chain(const ProfileShape& shape, bool of_cam, double tolerance);

/// tolerance: m, > 0. Closed polylines for a closed cam. An undercut cam is drawn with its loops, as it is.
/// Throws InputError for a tolerance that is not positive and a cam that is not finite.
[[nodiscard]] ProfileDxf profile_dxf(const ProfileShape& shape, double tolerance = 1e-6);

/// profile.dxf, and profile.check.json with what `verify-export` holds it to. None of a solution without a
/// plane cam. tolerance: m, > 0.
[[nodiscard]] std::vector<FolderFile> dxf_files(const View& view, double tolerance = 1e-6);

/// tolerance: m, > 0. An undercut cam is drawn with its loops, as it is. Throws InputError for a solution
/// without such a cam and a tolerance that is not positive.
[[nodiscard]] ProfileDxf cam_dxf(const View& view, double tolerance = 1e-6);

}  // namespace camopt
