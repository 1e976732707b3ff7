// SPDX-License-Identifier: MIT
// The finished cam, turned or moved along under its follower: does the follower move as designed?
//
// Knows the exported points of the cam and the follower's dimensions, no more: neither cam angles, normals
// nor curvatures of the points, nor any formula that made them. A smooth curve goes through the points
// (point_curve.hpp). At each cam angle the follower is put down on it: its lift is the largest at which it
// touches a point of the curve (touching_follower.hpp), searched around the contact of the angle before;
// that nothing of the cam then lies inside the follower is checked over the whole curve, and the whole curve
// is searched where it does. A knife edge stands on the highest crossing of its path. So a cam that is
// undercut, or hollower than its roller is round, is found out.
//
// Lengths m, angles rad; the frame that stands still is that of scene/follower.hpp, and the cam
// frame is it at cam angle 0, turned with the cam.
#pragma once

#include "scene/cam_spec.hpp"

namespace camopt {

struct ForwardCheckInput {
    std::vector<Eigen::Vector2d> points;  ///< of the cam's surface, cam frame, in the order of the cam angle
    std::vector<int> breaks;              ///< indices of points where the motion changes its formula
    bool closed = true;                   ///< false: a sector, between its first and its last point
    FollowerGeometry follower;
    /// Of the cam, seen in the follower's frame, if it does not slide.
    Rotation rotation = Rotation::counterclockwise;
    std::function<double(double theta)> designed;  ///< s of the output, m or rad
    /// From the follower's lift to s of the output, which is what is compared; NaN out of reach. Empty: the
    /// lift is the output.
    std::function<double(double lift)> output = {};
    double output_size = 1.0;                          ///< what a deviation is relative to, m or rad
    double begin = 0.0, end = 2.0 * std::numbers::pi;  ///< cam angles checked
    int angles = 4001;                                 ///< so many, evenly inside (begin, end); >= 1
    bool keep_found = false;                           ///< ForwardCheckResult::found

    void validate() const;  ///< throws InputError
};

struct ForwardCheckResult {
    double deviation =
        0.0;             ///< largest |s found − s designed|, m or rad; infinite where no contact was found
    double theta = 0.0;  ///< there
    double relative = 0.0;  ///< deviation / output_size
    int points = 0, angles = 0;
    int beyond = 0;                  ///< angles left out, their contact being the end of an open cam
    double seconds = 0.0;            ///< of wall time
    std::vector<double> found = {};  ///< s at each angle where it was asked for; NaN where left out
};

/// Throws InputError for input that cannot be checked at all (point_curve.hpp, validate).
[[nodiscard]] ForwardCheckResult forward_check(const ForwardCheckInput& input);

}  // namespace camopt
