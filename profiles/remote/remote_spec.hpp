// SPDX-License-Identifier: MIT
// The dimensions and choices of a disk cam with a remote follower: their names, once for the scene reader and
// the formulas (profiles/remote).
#pragma once

#include "scene/cam_spec.hpp"

namespace camopt {

struct CamKind;

/// cam.type of such a cam.
inline constexpr const char* remote_type = "remote";

/// The linkages between the cam's lever and the output, by their components.
enum class RemoteLinkage {
    lever,                              ///< the lever itself is the output; it swings
    lever_coupler_slider,               ///< one dyad; the output slides
    lever_coupler_lever,                ///< one dyad; the output, a rocker, swings
    lever_coupler_lever_coupler_slider  ///< two dyads; the output slides
};
[[nodiscard]] const char* name_of(RemoteLinkage value);
[[nodiscard]] bool output_swings(RemoteLinkage value);

/// Coordinates are in one fixed frame. m, rad.
enum class RemoteDimension {
    roller_radius,
    roller_arm,  ///< l: from the lever's pivot to the roller's centre
    lever_pivot_x,
    lever_pivot_y,
    center_x,  ///< of the cam
    center_y,
    lever_arm,    ///< from the lever's pivot to the coupler's joint
    lever_angle,  ///< from the roller's arm to that arm, counterclockwise
    coupler,
    rocker_pivot_x,
    rocker_pivot_y,
    rocker_input_arm,   ///< to the first coupler's joint
    rocker_output_arm,  ///< to the second coupler's joint
    rocker_angle,       ///< from the output arm to the input arm, counterclockwise
    second_coupler,
    slider_x,  ///< the coupler's joint on the slider at displacement 0
    slider_y,
    slider_angle,  ///< of the slider's path, from +x
    output_angle   ///< of the swinging output at displacement 0, from +x
};
inline constexpr int remote_dimension_count = 19;
[[nodiscard]] const char* name_of(RemoteDimension value);  ///< "roller_radius", …
[[nodiscard]] bool has_dimension(RemoteLinkage linkage, RemoteDimension dimension);
[[nodiscard]] bool is_angle(RemoteDimension dimension);
/// Coordinates and angles may be negative; arms, couplers and radii are positive.
[[nodiscard]] bool has_sign(RemoteDimension dimension);
/// Tables of a scene file: "cam" or "linkage".
[[nodiscard]] const char* table_of(RemoteDimension dimension);

/// On which side of the line from a link's pivot to the far joint of its coupler the link's joint lies.
enum class RemoteBranch { left, right };
[[nodiscard]] const char* name_of(RemoteBranch value);

/// The point at which the pressure angle is measured.
enum class PressurePoint {
    roller_center,  ///< the usual definition: the roller turns freely
    contact_point   ///< the contact point, taken as fixed to the lever (paper 003)
};
[[nodiscard]] const char* name_of(PressurePoint value);

/// A cam of this kind with every dimension at 0 and every choice at its default (lever and rocker branches
/// "left", pressure_angle_at "roller_center"), without formulas: remote_spec of remote_cam.hpp adds them.
[[nodiscard]] CamSpec blank_remote_spec(RemoteLinkage linkage);

/// Disk cams with a remote follower, as scene files know them.
[[nodiscard]] CamKind remote_kind();

}  // namespace camopt
