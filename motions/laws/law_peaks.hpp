// SPDX-License-Identifier: MIT
// Exact peaks of a law: every stationary point of y', y'', y''' and y'·y'' on every piece, and its ends.
//
// A piece is divided into cells far shorter than the shortest wave of any law of the catalogue; in a cell
// where the function's derivative (closed form) changes sign it is bisected down to neighbouring doubles. The
// peak's value is then exact to round-off. Mean squares: five-point Gauss quadrature per cell, exact to
// round-off for such analytic pieces. Normalised quantities, no units; signs and impulses as in law.hpp.
#pragma once

#include "motions/laws/law.hpp"

namespace camopt {

[[nodiscard]] Peaks find_peaks(const Law& law);
/// Inside the law's pieces only: impulses at its ends are omitted.
[[nodiscard]] Peaks find_peaks_without_impulses(const Law& law);
[[nodiscard]] JerkExtrema find_jerk_extrema(const Law& law);

}  // namespace camopt
