// SPDX-License-Identifier: MIT
// A fixed combination of derivatives of a motion: what a cam must do so that the output of an elastic train
// moves as is wanted.
//
//   s = w_0 y + w_1 y' + w_2 y''      and with it      s^{(r)} = w_0 y^{(r)} + w_1 y^{(r+1)} + w_2 y^{(r+2)}
//
// y: the output's motion, s: the cam's, both in lifts over x. A spline y of degree p and continuity k makes a
// spline s of degree p and continuity k − 2 on the same breakpoints, and s determines y: polynomial by
// polynomial, from the highest power down. Source: W. M. Dudley 1948 and D. A. Stoddart 1953 (polydyne), R.
// L. Norton et al. 2002 (splinedyne).
#pragma once

#include "splines/affine_row.hpp"
#include "splines/curve.hpp"
#include "splines/motion_chain.hpp"

namespace camopt {

struct DerivativeCombination {
    std::array<double, 3> weights = {1.0, 0.0, 0.0};  ///< of y, y', y''; the first is > 0

    /// The order of the highest derivative that takes part.
    [[nodiscard]] int highest_order() const { return weights[2] != 0.0 ? 2 : weights[1] != 0.0 ? 1 : 0; }
};

/// Of polynomials, one a column, by ascending powers.
[[nodiscard]] Eigen::MatrixXd combined(const Eigen::MatrixXd& polynomials, const DerivativeCombination& of);

/// The local polynomial of s from that of y, as affine maps of the same entries.
[[nodiscard]] LocalMap combined(LocalMap map, const DerivativeCombination& of);

/// The space of s for that of y. Throws InputError where y is less smooth than the combination needs.
[[nodiscard]] SplineSpace combined(const SplineSpace& space, const DerivativeCombination& of);

/// s of y, over the parts of a motion. Throws ModelError for a part that is neither dwell nor spline.
[[nodiscard]] MotionChain combined(const MotionChain& motion, const DerivativeCombination& of);

/// y with combined(y) = s, over the parts of a motion: dwells and splines that are neither scaled nor
/// mirrored. Throws ModelError for other parts.
[[nodiscard]] MotionChain solved(const MotionChain& motion, const DerivativeCombination& of);

}  // namespace camopt
