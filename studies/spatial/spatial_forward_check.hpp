// SPDX-License-Identifier: MIT
// The finished three-dimensional cam, turned under its follower: does the follower move as designed?
//
// Each section of each flank, as points and nothing else, drives the follower by itself;
// the largest difference from the designed motion is the result. An undercut flank, or one that is not that
// of the follower, is found out. m, rad.
#pragma once

#include "scene/cam_flanks.hpp"
#include "studies/check/point_curve.hpp"
#include "studies/delivered/solution.hpp"

namespace camopt {

struct SpatialForwardCheckInput {
    /// Points of each section of each flank, cam frame, in the order of the cam angle.
    std::vector<std::vector<Eigen::Vector3d>> sections;
    std::vector<int> breaks;  ///< indices of points where the motion changes its formula; of every section
    CamFlanks follower;       ///< its roller and how it is mounted
    std::function<double(double theta)> designed;  ///< s; its value at `begin` is where the follower starts
    double begin = 0.0, end = 0.0;                 ///< cam angles checked
    int angles = 2001;                             ///< so many, evenly inside (begin, end); >= 2

    void validate() const;  ///< throws InputError
};

/// The sections of both flanks of a grid, and nothing else of it.
[[nodiscard]] std::vector<std::vector<Eigen::Vector3d>> sections_of(const FlankGrid& grid);

struct SpatialForwardCheckResult {
    double deviation = 0.0;  ///< largest |s found − s designed|, m or rad; infinite where contact was lost
    double theta = 0.0;      ///< there
    int section = 0;         ///< there; index in the input
    double travel = 0.0;     ///< s at the last angle − s at the first one, of the first section
    int points = 0;          ///< of one section
    int angles = 0;          ///< checked, over all sections
    int beyond = 0;          ///< left out, their contact being the end of the points
    double seconds = 0.0;    ///< of wall time
};

/// Throws InputError for input that cannot be checked at all.
[[nodiscard]] SpatialForwardCheckResult spatial_forward_check(const SpatialForwardCheckInput& input);

// A finished flank pushes its follower: where does the follower stand?
//
// Knows points of one section of one flank, a smooth curve through them (point_curve.hpp), the follower's own
// dimensions and how it is mounted; no motion, no normal, no formula that made the points, not even the
// height of the section. At a cam angle the follower stands where the distance between the curve and its
// roller's axis is, at its least, the roller's radius. That place is followed from the angle before
// (tracking). Frames of scene/cam_flanks.hpp; m, rad.
class FlankContact {
 public:
    /// breaks: indices of points where the flank may be less smooth. s: where the follower stands at first.
    FlankContact(const CamFlanks& follower, std::span<const Eigen::Vector3d> points,
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

    CamFlanks follower_;
    SpacePointCurve curve_;
    std::vector<Eigen::Vector3d> places_;  ///< the curve at its nodes
    std::size_t place_ = 0;
    double s_;
    bool placed_ = false;
};

// The three-dimensional cam of a solved scene: its dimensions, its motion in SI, its forward check.

/// The motion must outlive what is returned. Of a cam: its whole_turn (studies/delivered/delivered.hpp).
[[nodiscard]] FollowerMotion follower_motion(const Motion& motion, const MotionScale& scale);

/// Whether the scene's cam has flanks: whether it is three-dimensional.
[[nodiscard]] bool has_flanks(const Solution& solution);

/// Of a solution with such a cam, with the dimensions that were chosen. Throws InputError for another.
[[nodiscard]] CamFlanks solved_flanks(const Solution& solution);

/// Both flanks at both ends of the roller drive the follower over the whole turn: about `points` (2000)
/// points a section (spatial_forward_check.hpp). The deviation is that of the output, m or rad; relative: by
/// the lift. As if the roller filled its groove; of a groove with a clearance also its lost motion, from the
/// same points: how far the roller itself can be moved to and fro before a section of either flank stops it.
[[nodiscard]] ForwardCheckReport check_flanks(const Solution& solution, std::optional<int> points = {});

}  // namespace camopt
