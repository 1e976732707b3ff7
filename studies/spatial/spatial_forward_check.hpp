// SPDX-License-Identifier: MIT
// The finished spatial cam, turned under its follower: does the follower move as designed?
//
// Each section of each flank, as points and nothing else, drives the follower by itself (flank_contact.hpp);
// the largest difference from the designed motion is the result. An undercut flank, or one that is not that
// of the follower, is found out. m, rad.
#pragma once

#include "profiles/spatial/flank_grid.hpp"

#include <functional>
#include <vector>

namespace camopt {

struct SpatialForwardCheckInput {
    /// Points of each section of each flank, cam frame, in the order of the cam angle.
    std::vector<std::vector<Eigen::Vector3d>> sections;
    std::vector<int> breaks;  ///< indices of points where the motion changes its formula; of every section
    SpatialCam follower;      ///< its numbers only
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

/// A row of the study of accuracy against points.
struct SpatialForwardCheckRow {
    int points = 0;                   ///< of one section
    double deviation_positive = 0.0;  ///< flank +1
    double deviation_negative = 0.0;  ///< flank −1
    double travel = 0.0;              ///< over the angles checked
    double seconds = 0.0;             ///< generation and check of both flanks
};
/// Sections at the near and the far end of the roller; about `count` points over the motion, its breakpoints
/// among them.
[[nodiscard]] SpatialForwardCheckRow spatial_forward_check_row(const SpatialCam& cam,
                                                               const FollowerMotion& motion, int count);

}  // namespace camopt
