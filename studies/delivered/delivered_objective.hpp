// SPDX-License-Identifier: MIT
// The objective as scene files define it, of what is delivered: nothing of the optimizer's takes part.
//
//   Σ w_k P_k / P̂_k  +  Σ_d w_d |d| / unit
//
// over the peaks and root mean squares P of the motion, normalised as the scene says, and the cam's
// dimensions d. The tie-break is no part of it.
#pragma once

#include "studies/delivered/solution.hpp"

namespace camopt {

/// From solution.peaks, solution.reference_peaks and the delivered dimensions (without a cam: without them).
[[nodiscard]] double defined_objective(const Solution& solution);

}  // namespace camopt
