// SPDX-License-Identifier: MIT
// The guide as points, for drawings and manufacturing: its middle line and the two walls of the slot for a
// roller of radius r, middle ± r n, n the left normal. Body's frame, m.
#pragma once

#include "profiles/inverse/guide.hpp"

#include <Eigen/Core>

#include <string>
#include <vector>

namespace camopt {

/// Whole only where r |curvature| < 1 on the concave side of every point (wall_fault).
struct GuidePoints {
    std::vector<double> distances;  ///< L
    std::vector<Eigen::Vector2d> points;
    std::vector<int> breaks;  ///< indices of the guide's joints, without the ends
};

/// About `count` points evenly by L, the joints besides. offset: 0 the middle line, +r the left wall, -r the
/// right. Throws InputError for fewer than 2.
[[nodiscard]] GuidePoints guide_points(const Guide& guide, int count, double offset = 0.0);

/// Why a roller of this radius cannot run in the guide: its radius of curvature is smaller somewhere. Empty:
/// it can. Curvature is sampled on a fine grid (1000 points per piece), both sides of every joint.
[[nodiscard]] std::string wall_fault(const Guide& guide, double roller_radius);

}  // namespace camopt
