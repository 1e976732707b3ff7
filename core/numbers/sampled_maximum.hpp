// SPDX-License-Identifier: MIT
// The largest value of a smooth figure along a motion: samples between its breakpoints, refined where the
// second difference allows a larger value than the best sample. Not an enclosure. A maximum inside a piece is
// accurate to round-off, its location to about 1e-10 of the piece.
#pragma once

#include "core/numbers/extremum.hpp"

#include <cstddef>
#include <functional>
#include <vector>

namespace camopt {

/// A figure at x; where the motion jumps, as seen from `side`.
using FigureAlong = std::function<double(double x, Side side)>;

/// breakpoints: ascending, at least two; between neighbours the figure is smooth. NaN (undefined there) is
/// skipped; if it is undefined everywhere: -infinity.
[[nodiscard]] Extremum largest_along(const std::vector<double>& breakpoints, const FigureAlong& figure);

/// The first samples of largest_along, piece by piece: what several figures of one motion share at them can
/// be computed once.
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
