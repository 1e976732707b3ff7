// SPDX-License-Identifier: MIT
// Exact peaks of a law: every stationary point of y', y'', y''' and y'·y'' on every piece, and its ends.
//
// A piece is cut into cells far shorter than the shortest wave of any law of the catalogue; in a cell where
// the function's derivative (closed form) changes sign it is bisected down to neighbouring numbers. The
// peak's value is then exact to rounding. Mean squares: five-point Gauss quadrature a cell, exact to rounding
// for such analytic pieces. Normalised quantities, no units; signs and impulses as in law.hpp.
#pragma once

#include "motions/laws/law.hpp"

namespace camopt {

[[nodiscard]] Peaks find_peaks(const Law& law);
/// From inside the law's pieces alone: impulses are left out, whatever precedes and follows the law.
[[nodiscard]] Peaks find_peaks_without_impulses(const Law& law);
[[nodiscard]] JerkExtrema find_jerk_extrema(const Law& law);

}  // namespace camopt
