// SPDX-License-Identifier: MIT
// Pictures of a three-dimensional cam in the style of all others: the drum, shaded, with its ribs or its
// groove, and its developed surface to scale.
//
// Developed: x = R ψ over z, R the mean radius of the roller's outer end, ψ the angle around the drum,
// counted from the roller at cam angle 0, as the cam angle grows; both flanks at both ends of the roller and
// the way of its axis. Frame of scene/cam_flanks.hpp.
#pragma once

#include "report/surface/triangle_mesh.hpp"
#include "scene/cam_flanks.hpp"

namespace camopt {

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
