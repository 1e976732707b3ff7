// SPDX-License-Identifier: MIT
// Bounds on the derivatives of a spline from bounds on some of them.
//
// Lower derivatives by integration from either end, where the end states are known: |y^{(r-1)}| <= |end
// value| + L B_r / 2 (from the nearer end). Higher ones by Markov's inequality on each segment of width h: a
// polynomial of degree d with |p| <= B has |p'| <= 2 d² B / h. The mean square of y^{(r)} bounds y^{(r-1)} by
// the Cauchy–Schwarz inequality: |y^{(r-1)}| <= |end value| + L rms.
#pragma once

#include "splines/space.hpp"

#include <Eigen/Core>

#include <array>

namespace camopt {

struct KnownBounds {
    std::array<double, 4> sup{};  ///< bounds on |y^{(r)}|, r = 0 … 3; infinity: no bound
    std::array<double, 4> rms{};  ///< bounds on the root mean square, likewise
    std::array<double, 3> begin_state{}, end_state{};
};

/// (degree + 1) x segments: |y^{(m)}| on segment i is at most result(m, i). Infinite without a bound.
[[nodiscard]] Eigen::MatrixXd derivative_bounds(const SplineSpace& space, const KnownBounds& known);

}  // namespace camopt
