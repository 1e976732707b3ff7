// SPDX-License-Identifier: MIT
// Where a machine is in the middle of a move: all axes in proportion, on arcs the angle in proportion.
//
// An arc whose ends are not equally far from its centre, printed digits being what they are, changes its
// radius evenly. m, rad.
#pragma once

#include "output/nc/nc_reader.hpp"

#include <Eigen/Core>

namespace camopt {

/// Axis values at `share` (0 … 1) of the way from `from` to the move's end.
[[nodiscard]] Eigen::VectorXd values_along(const Eigen::VectorXd& from, const NcMove& move, double share);

/// How far X, Y and Z go, m: no point between two shares a and b is farther from another than |b − a| of it.
[[nodiscard]] double linear_length(const Eigen::VectorXd& from, const NcMove& move);

}  // namespace camopt
