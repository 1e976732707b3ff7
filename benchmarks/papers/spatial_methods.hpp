// SPDX-License-Identifier: MIT
// Of the papers on spatial cams alone: their two methods of contact, and their critical dimensions.
#pragma once

#include "profiles/spatial/spatial_analysis.hpp"

namespace camopt {

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
// Vectors of the cam frame, m.

[[nodiscard]] Eigen::Vector3d envelope_contact(const SpatialCam& cam, double theta,
                                               const FollowerState& state, const RollerStation& station);
[[nodiscard]] Eigen::Vector3d relative_velocity_contact(const SpatialCam& cam, double theta,
                                                        const FollowerState& state,
                                                        const RollerStation& station);

// Critical dimensions for undercut.
//
// At one station g decreases from 1 with a growing roller radius; the critical radius is the least positive
// root over all cam angles of 1 − σ_f r bend − (r twist)² = 0. The critical centre distance is where the
// least g over the motion vanishes. Lengths m, angles rad.

/// The roller radius at which the flank begins to be undercut at this station, others unchanged; none: never.
[[nodiscard]] std::optional<SpatialExtreme> critical_roller_radius(const SpatialCam& cam,
                                                                   const FollowerMotion& motion,
                                                                   const RollerStation& station);

/// The centre distance below the cam's own at which the flank begins to be undercut at this station;
/// `value` is it, `theta` where. None: not down to where the roller's axis meets the cam's, or the cam is
/// undercut already.
[[nodiscard]] std::optional<SpatialExtreme> critical_center_distance(const SpatialCam& cam,
                                                                     const FollowerMotion& motion,
                                                                     const RollerStation& station);

}  // namespace camopt
