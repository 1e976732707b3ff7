// SPDX-License-Identifier: MIT
// Whether more segments would help a scene without a motion.
#pragma once

#include "studies/delivered/solution.hpp"
#include "studies/explain/feasibility_question.hpp"

#include <optional>

namespace camopt {

struct FinerSpline {
    std::optional<Relaxation> row;  ///< key spline.segments: the fewest that were solved; of given
                                    ///< breakpoints spline.breakpoints: every interval cut alike
    int finest = 0;                 ///< without a row: the most that were tried; 0: the time did not reach
};

/// Twice, four times, eight times the segments (and on to 64 where these are fewer, never above 512); between
/// the last that fails and the first that does bisection. Each halves the intervals of the one before, so it
/// keeps all motions of it. Told is a number that was solved, and the next one too: with an odd number a
/// breakpoint lies in the middle where with an even one there is none.
[[nodiscard]] FinerSpline finer_spline(const Scene& scene, const Budget& budget);

}  // namespace camopt
