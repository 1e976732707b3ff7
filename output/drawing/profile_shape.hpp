// SPDX-License-Identifier: MIT
// A whole cam as a function of the cam angle: what drawings are made from. Frames and signs as in
// profiles/disk/disk_cam.hpp; SI units.
#pragma once

#include "core/motion.hpp"
#include "core/units.hpp"
#include "output/words/shown_units.hpp"
#include "profiles/disk/disk_cam.hpp"
#include "profiles/sampling.hpp"
#include "studies/delivered/solution.hpp"

#include <Eigen/Core>

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace camopt {

struct ProfileShape {
    DiskCam cam;
    std::function<ProfilePoint(double theta)> at;
    /// The other side of a cam that drives both ways (profiles/disk/disk_sides.hpp); empty: there is none.
    std::function<ProfilePoint(double theta)> other = {};
    std::vector<double> knots;  ///< θ where the motion changes its formula, begin and end included; ascending
    bool closed = true;         ///< the end of the cam is its beginning; false: it is open
    double start = 0.0;         ///< θ where the motion begins: dwell may lie before it
    std::string open_because = {};  ///< what is missing where it is open; empty: nothing is said of it
    /// m: of a flat face that is pushed straight; none: it is drawn as wide as the contact needs, and wider.
    std::optional<double> face_half_width = {};
    ShownUnit length = {"mm", 1.0 / units::millimetre};  ///< in which its drawings are labelled

    [[nodiscard]] double begin() const { return knots.front(); }
    [[nodiscard]] double end() const { return knots.back(); }
};

/// The other side as a shape of its own; the shape must have one.
[[nodiscard]] ProfileShape other_side(const ProfileShape& shape);

/// Of the disk that a groove is cut into, m: the greatest of its outer flank and the wall; none: no groove.
[[nodiscard]] std::optional<double> rim_radius(const ProfileShape& shape);

/// What is made in one piece: either disk of a conjugate cam as an open cam of its own, with its least radius
/// as its base circle, any other cam as it is. Keeps what the shape keeps.
[[nodiscard]] std::vector<ProfileShape> made_pieces(const ProfileShape& shape);

/// Keeps a reference to the motion. Closed where the motion takes a whole turn and its end meets its begin.
[[nodiscard]] ProfileShape profile_shape(const DiskCam& cam, const Motion& motion, const MotionScale& scale);

/// Of a delivered disk cam along its whole motion (drawn_motion of studies/check/check_cam.hpp), to which it
/// keeps a reference; none: the solution has no disk cam.
[[nodiscard]] std::optional<ProfileShape> disk_shape(const Solution& solution, const Motion& motion);

/// `steps` angles or more, evenly over the shape, with every knot seen from inside its two neighbours:
/// piece by piece, both ends included.
[[nodiscard]] std::vector<std::vector<ProfilePoint>> profile_pieces(const ProfileShape& shape, int steps);

/// Where the cam is about to undercut: θ of each sign change of the regularity, ascending.
[[nodiscard]] std::vector<double> cusp_angles(const ProfileShape& shape);

/// Where the follower stands in the cam frame.
struct FollowerPose {
    Eigen::Vector2d lift = {0.0, 1.0};   ///< translating: unit direction of the lift
    Eigen::Vector2d pivot = {0.0, 0.0};  ///< oscillating
    Eigen::Vector2d foot = {0.0, 0.0};   ///< oscillating flat: foot of the perpendicular from pivot to face
};

[[nodiscard]] FollowerPose follower_pose(const DiskCam& cam, const ProfilePoint& point);

}  // namespace camopt
