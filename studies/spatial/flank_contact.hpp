// SPDX-License-Identifier: MIT
// A finished flank pushes its follower: where does the follower stand?
//
// Knows points of one section of one flank, a smooth curve through them (point_curve.hpp), the follower's own
// dimensions and how it is mounted; no motion, no normal, no formula that made the points, not even the
// height of the section. At a cam angle the follower stands where the distance between the curve and its
// roller's axis is, at its least, the roller's radius. That place is followed from the angle before
// (tracking). Frames of profiles/spatial/spatial_cam.hpp; m, rad.
#pragma once

#include "profiles/spatial/spatial_cam.hpp"
#include "studies/check/point_curve.hpp"

#include <Eigen/Core>

#include <cstddef>
#include <span>
#include <vector>

namespace camopt {

class FlankContact {
 public:
    /// breaks: indices of points where the flank may be less smooth. s: where the follower stands at first.
    FlankContact(const SpatialCam& follower, std::span<const Eigen::Vector3d> points,
                 std::span<const int> breaks, double s);

    struct Stand {
        double s = 0.0;       ///< m or rad; NaN where no contact is found
        bool at_end = false;  ///< the contact is the end of the points
    };
    /// Angles are to follow one another in small steps.
    [[nodiscard]] Stand at(double theta);

 private:
    struct Nearest {
        double distance = 0.0;
        bool at_end = false;
    };
    /// Least distance between the curve and the roller's axis, near the place of the time before.
    [[nodiscard]] Nearest nearest(double theta, double s);

    SpatialCam follower_;
    SpacePointCurve curve_;
    std::vector<Eigen::Vector3d> places_;  ///< the curve at its nodes
    std::size_t place_ = 0;
    double s_;
    bool placed_ = false;
};

}  // namespace camopt
