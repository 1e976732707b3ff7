// SPDX-License-Identifier: MIT
// The largest value of a smooth figure along a motion: samples between its breakpoints, and closer wherever
// the figure bends so much that it may be larger than the best of them. Samples, not a proof. A top inside a
// piece is known to rounding, its place to about 1e-10 of the piece.
#pragma once

#include "core/numbers/extremum.hpp"

#include <cstddef>
#include <functional>
#include <vector>

namespace camopt {

/// A figure at x; where the motion jumps, as seen from `side`.
using FigureAlong = std::function<double(double x, Side side)>;

/// breakpoints: ascending, at least two; between neighbours the figure is smooth. NaN (nothing to say there)
/// counts as nothing; where there is nothing at all: -infinity.
[[nodiscard]] Extremum largest_along(const std::vector<double>& breakpoints, const FigureAlong& figure);

/// Where largest_along looks first, piece by piece: what several figures of one motion share there can be
/// made once for all of them.
struct SamplePlace {
    double at = 0.0;
    Side side = Side::right;
};
[[nodiscard]] std::vector<SamplePlace> sample_places(const std::vector<double>& breakpoints);
/// The figure at the k-th of them.
using FigureAtSample = std::function<double(std::size_t k)>;
[[nodiscard]] Extremum largest_along(const std::vector<double>& breakpoints, const FigureAlong& figure,
                                     const FigureAtSample& at_sample);

[[nodiscard]] Extremum least_along(const std::vector<double>& breakpoints, const FigureAlong& figure);

}  // namespace camopt
