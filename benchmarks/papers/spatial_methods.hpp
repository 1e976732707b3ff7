// SPDX-License-Identifier: MIT
// Of the papers on spatial cams alone: extremes over a motion, interference with the cutter, two methods of
// contact, critical dimensions.
#pragma once

#include "profiles/spatial/spatial_cam.hpp"
#include "scene/cam_flanks.hpp"

#include <Eigen/Core>

namespace camopt {

// Extremes of a spatial cam over its motion.
//
// A flank is locally regular where g > 0 (spatial_cam.hpp). g has to hold over the whole CUTTER: one longer
// than the roller also sweeps beyond it. Lengths m, angles rad. Values are those between samples, accurate to
// round-off; locations to about 1e-9 rad.

struct SpatialExtreme {
    double value = 0.0;
    double theta = 0.0;
    double height = 0.0;
};

/// The largest |φ| at one height.
[[nodiscard]] SpatialExtreme largest_pressure_angle(const SpatialCam& cam, const FollowerMotion& motion,
                                                    double height);

/// A stretch of the roller or of a cutter.
struct HeightRange {
    double from = 0.0, to = 0.0;
};
/// The least g of one flank over a stretch; for undercut the stretch is the cutter's full length.
[[nodiscard]] SpatialExtreme least_undercut(const SpatialCam& cam, const FollowerMotion& motion, int flank,
                                            const HeightRange& heights);

// Global interference: whether a cutter that moves like the roller removes material of the flanks.
//
// g > 0 is a local condition, tested only where it is evaluated. Here a flank's points are compared with the
// whole sweep of a cutter of the roller's radius, from `cutter.from` to `cutter.to` along the roller's axis:
// a point lies by d inside the cutter at cam angle θ', when
//   d = min(r − distance from the cutter's axis, its distance from either end of the cutter) > 0.
// The largest d over all θ' of the motion is found between samples too. A correct flank is touched, not
// entered: d = 0 to round-off (1e-13 m). Where g changes sign on the flank, its grid folds: the triangle of
// neighbouring points reverses its orientation.
// Lengths m, angles rad.

struct InterferenceOptions {
    HeightRange cutter = {};  ///< its two ends along the roller's axis; to = 0: the roller
    HeightRange flank = {};   ///< the stretch of the flanks that is checked; to = 0: the roller
    int sections = 9;         ///< of that stretch; >= 1 (one: its far end)
    int angles = 361;         ///< at which flank points are taken; >= 2
    int cutter_angles = 721;  ///< of the sweep, before refinement; >= 3

    void validate() const;  ///< throws InputError
};

struct Interference {
    double depth = 0.0;         ///< the largest d
    double theta = 0.0;         ///< where the flank's point is generated
    double cutter_theta = 0.0;  ///< where the cutter removes it
    double height = 0.0;        ///< h of the flank's point
    int flank = 1;
    long points = 0;  ///< flank points checked
};

/// Of both flanks.
[[nodiscard]] Interference interference(const SpatialCam& cam, const FollowerMotion& motion,
                                        const InterferenceOptions& options);
/// Of one flank's points at given cam angles, against the cutter while it passes the whole motion.
[[nodiscard]] Interference interference(const SpatialCam& cam, const FollowerMotion& motion,
                                        const InterferenceOptions& options, const FlankGrid& grid);

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
