// SPDX-License-Identifier: MIT
// The peaks of the optimum beside those of the reference and of the best curve of any kind: one row a peak.
#pragma once

#include "output/reference_motion.hpp"
#include "studies/solution.hpp"

#include <optional>
#include <string>
#include <vector>

namespace camopt {

struct PeakRow {
    std::string name;                 ///< "velocity"
    std::string symbol;               ///< "V"
    Extremum optimum;                 ///< normalised; of a program the largest over its spline segments
    Extremum motion;                  ///< of the whole motion, in lifts and units of x: what `factor` is for
    std::optional<double> reference;  ///< normalised; infinite for a law with impulses
    std::optional<double> any_curve;  ///< at the limit no curve can pass
    double factor = 0.0;              ///< from `motion` to `unit`; 0 where there is none
    std::string unit;                 ///< "mm/rad"
};

/// V, A, J, and the torque max |y' y''|. For a solution with a curve.
[[nodiscard]] std::vector<PeakRow> peak_comparison(const Solution& solution,
                                                   const ReferenceMotion& reference);

/// "modified sine", or "reference" where it was given as numbers.
[[nodiscard]] std::string reference_title(const ReferenceMotion& reference);

}  // namespace camopt
