// SPDX-License-Identifier: MIT
// Extremes of a spatial cam over its motion, and the critical dimensions for undercut.
//
// A flank is locally regular where g > 0 (spatial_cam.hpp). At one station g decreases from 1 with a growing
// roller radius; the critical radius is the least positive root over all cam angles of 1 − σ_f r bend − (r
// twist)² = 0. The critical centre distance is where the least g over the motion vanishes. g has to hold over
// the whole CUTTER: one longer than the roller also sweeps beyond it. Lengths m, angles rad. Values are those
// between samples, accurate to round-off; locations to about 1e-9 rad.
#pragma once

#include "profiles/spatial/spatial_cam.hpp"

#include <optional>

namespace camopt {

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
