// SPDX-License-Identifier: MIT
// Exact extrema of piecewise polynomials: ends of every segment from both sides, and every stationary point
// inside.
#pragma once

#include "core/motion.hpp"
#include "core/numbers/extremum.hpp"
#include "splines/curve.hpp"

#include <Eigen/Core>

#include <functional>
#include <vector>

namespace camopt {

/// Coefficients, ascending in t = x − x_i, of a function on one segment.
using SegmentFunction = std::function<Eigen::VectorXd(int segment)>;

/// Appends to `all` where the function may be largest or least on a segment: its two ends (from inside) and
/// the stationary points, ascending.
void add_candidates_on_segment(const SplineSpace& space, int segment, const Eigen::VectorXd& polynomial,
                               std::vector<Extremum>& all);

/// The extremum of largest magnitude; `value` is that magnitude. Of locations within 1e-8 of it, of which an
/// optimum has many, `at` is the first.
[[nodiscard]] Extremum largest_magnitude(const SplineSpace& space, const SegmentFunction& function);

/// Exact: max |y^{(order)}|, its root mean square, and max |y' y''|. order 1 … 3.
[[nodiscard]] Extremum peak_of(const SplineCurve& curve, int order);
[[nodiscard]] double mean_of(const SplineCurve& curve, int order);
[[nodiscard]] Extremum torque_peak_of(const SplineCurve& curve);

/// V, A, J, Q exactly, and the root mean squares.
[[nodiscard]] Peaks peaks_of(const SplineCurve& curve);

}  // namespace camopt
