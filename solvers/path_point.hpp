// SPDX-License-Identifier: MIT
// Where an interior point came by: a point near the central path of a problem, in the problem's own terms,
// from which a neighbouring problem (rows appended, the cost a little changed) is a few iterations away.
//
// Near the path the gap of every bound times its multiplier is about `mu`. The optimum itself is no such
// place: there gaps and multipliers are zero, and nothing can move.
#pragma once

#include <Eigen/Core>

#include <vector>

namespace camopt {

struct PathPoint {
    Eigen::VectorXd x;
    Eigen::VectorXd row_multipliers;  ///< as in BackendResult; rows appended later have none
    double mu = 0.0;                  ///< in units of the cost
    double gap = 0.0;                 ///< sum of gaps times multipliers, relative to the cost
};

/// The last point whose gap is at least `gap`; the first where none is that far off; null where there is
/// none.
[[nodiscard]] inline const PathPoint* point_before(const std::vector<PathPoint>& path, double gap) {
    const PathPoint* found = path.empty() ? nullptr : &path.front();
    for (const PathPoint& point : path)
        if (point.gap >= gap) found = &point;
    return found;
}

}  // namespace camopt
