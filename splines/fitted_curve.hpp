// SPDX-License-Identifier: MIT
// The spline through rows (x_k, y_k) with errors, by least squares.
//
//   min over curves of degree 5, C⁴ between breaks:  Σ_k (y(x_k) − y_k)²
//
// Segments hold as many rows each. Their number is that of least generalized cross-validation (m Σ r² / (m −
// p)², m rows, p free numbers; G. Wahba, Spline Models for Observational Data, 1990): rows without errors are
// followed to their rounding, noise is smoothed. Stretches between breaks are fitted separately: at a break y
// is continuous to the errors of the rows, and so is y' if the rows on both sides agree on it.
#pragma once

#include "splines/curve.hpp"

namespace camopt {

struct CurveRows {
    std::vector<double> x, y;  ///< x ascending
    /// Ascending: begin and end of the curve, and breakpoints that it must have.
    std::vector<double> joints;
    std::vector<double> breaks = {};  ///< inside, ascending; they are breakpoints, too
    /// The rows repeat after the length of the curve, but for `advance`, what y gains. Without breaks the
    /// curve then goes on smoothly from its end to its begin.
    bool periodic = false;
    double advance = 0.0;
};

struct FittedCurve {
    SplineCurve curve;
    int rows = 0, freedom = 0;      ///< rows between begin and end; free numbers
    double noise = 0.0;             ///< estimated standard deviation of a row: √(Σ r² / (m − p))
    std::array<double, 4> error{};  ///< standard errors of y to y''', root mean squares along the curve
};

/// Throws InputError where rows are missing: fewer than 12 on a stretch between breaks, or none over so long
/// a stretch that no spline is determined.
[[nodiscard]] FittedCurve fitted_curve(const CurveRows& rows);

}  // namespace camopt
