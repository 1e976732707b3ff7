// SPDX-License-Identifier: MIT
//
// Contact of a roller with its flanks, by the two classical methods; they agree with spatial_point to
// round-off.
//
//   envelope           S(θ, h, β) = C + r (cos β b1 + sin β b2) is the roller's surface in the cam frame.
//                      The flank is where S_θ · (S_h × S_β) = 0: cos β S_θ·b1 + sin β S_θ·b2 = 0, with S_θ
//                      differentiated through the chain of transformations of the papers. (Paper 002.)
//   relative velocity  v = velocity of the axis point as a point of the follower − as a point of the cam, in
//                      the roller's frame (b, u, e): φ_z = atan2(v_u, v_b), and the contacts lie at
//                      φ_z ∓ 90° (σ_f = ±1). (Paper 001, with Q_z = 0.)
//
// Vectors of the cam frame, m. The contact line of one flank at one cam angle is the row of its contacts over
// the roller's length.
#pragma once

#include "profiles/spatial/spatial_cam.hpp"

#include <Eigen/Core>

#include <span>
#include <vector>

namespace camopt {

[[nodiscard]] Eigen::Vector3d envelope_contact(const SpatialCam& cam, double theta,
                                               const FollowerState& state, const RollerStation& station);
[[nodiscard]] Eigen::Vector3d relative_velocity_contact(const SpatialCam& cam, double theta,
                                                        const FollowerState& state,
                                                        const RollerStation& station);

/// The contact line at one cam angle, by the heights of its points.
[[nodiscard]] std::vector<SpatialPoint> contact_line(const SpatialCam& cam, double theta,
                                                     const FollowerState& state, int flank,
                                                     std::span<const double> heights);

}  // namespace camopt
