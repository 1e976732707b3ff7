// SPDX-License-Identifier: MIT
// Suggested changes that were solved: of one number, of all limits together, of the number of segments.
#pragma once

#include "studies/least/adjustment.hpp"
#include "studies/least/violation.hpp"

namespace camopt {

/// The row of a needed value: rounded, solved, and where the solve fails, tried again further off, then
/// without rounding (a value that other conditions determine has no room). None where no solve succeeded.
[[nodiscard]] std::optional<Relaxation> solved_relaxation(const Scene& scene, const Adjustment& adjustment,
                                                          double needed, const Budget& budget);

// Several limits that have to give way together.
//
// All are relaxed by one common part r, the least that does: upper limits times 1 + r, lower ones divided by
// it. Of these, limits that may stay as they are at that r do so, and each
// of the others gives way by no more than the rest requires. The values are rounded away from the edge and
// the scene with all of them is solved.

/// Empty where no common part does, or the time does not reach. A member that has no room (a least radius of
/// 0) stays as it is.
[[nodiscard]] std::vector<Relaxation> joint_relaxation(const Scene& scene,
                                                       const std::vector<Adjustment>& members,
                                                       const Budget& budget);

// Whether more segments would help a scene without a motion.

struct FinerSpline {
    std::optional<Relaxation> row;  ///< key spline.segments: the fewest that were solved; of given
                                    ///< breakpoints spline.breakpoints: every interval cut into equal parts
    int finest = 0;                 ///< without a row: the most that were tried; 0: the time did not reach
};

/// Twice, four times, eight times the segments (and on to 64 where these are fewer, never above 512), then
/// numbers between the last that fails and the first that does. Each halves the intervals of the one before,
/// so it keeps all motions of it. Told is a number that was solved, and the next one too: with an odd number
/// a breakpoint lies in the middle where with an even one there is none.
[[nodiscard]] FinerSpline finer_spline(const Scene& scene, const Budget& budget);

}  // namespace camopt
