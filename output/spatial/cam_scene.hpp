// SPDX-License-Identifier: MIT
// A three-dimensional cam with its rollers as what is drawn and moved: meshes that turn with the cam, and
// where every roller stands at given cam angles. Frames of profiles/spatial/spatial_cam.hpp; m, rad.
//
//   the motion takes a turn and ends one pitch on   the body (indexing_body.hpp), all rollers of the index
//   the groove closes after one turn                the grooved drum as a solid
//   else                                            both flanks as surfaces around a core
// How far a drum reaches beyond its groove, its bore and its core are choices of drawing.
#pragma once

#include "output/surface/triangle_mesh.hpp"
#include "profiles/spatial/follower_motion.hpp"
#include "profiles/spatial/spatial_cam.hpp"

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace camopt {

/// The near end of a roller's axis and its unit direction, in the frame that stands still.
struct RollerPlace {
    Eigen::Vector3d foot, direction;
};

struct CamScene {
    struct Part {
        std::string name;  ///< "cam", "drum", "core", "flank +1"
        TriangleMesh mesh;
        bool closed = true;  ///< a solid; false: a surface, seen from both sides
    };
    std::vector<Part> parts;  ///< in the cam frame at cam angle 0; they turn by σθ about z
    double roller_radius = 0.0, roller_length = 0.0;
    /// By roller, then by angle.
    std::vector<std::vector<RollerPlace>> rollers;
    std::optional<Eigen::Vector3d> pivot;  ///< about which the rollers swing; none: they slide
};

/// angles: cam angles within the motion, rad.
[[nodiscard]] CamScene cam_scene(const SpatialCam& cam, const FollowerMotion& motion,
                                 std::span<const double> angles);

}  // namespace camopt
