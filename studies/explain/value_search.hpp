// SPDX-License-Identifier: MIT
// The nearest value of one number that makes a scene feasible.
//
// The least violation t(v) of the scene with the value v is brought to zero, first by steps that double, then
// by regula falsi; v is taken from the feasible side. What is told of it is rounded away from the edge and
// solved.
#pragma once

#include "studies/delivered/solution.hpp"
#include "studies/explain/adjustment.hpp"
#include "studies/explain/feasibility_question.hpp"

#include <optional>
#include <vector>

namespace camopt {

/// given: least_violation() of the scene as it is. Of two directions the nearer value.
[[nodiscard]] std::optional<double> nearest_value(const Scene& scene, const Adjustment& adjustment,
                                                  double given, const Budget& budget);

/// The value nearest to the given one that is feasible, on the way to `feasible`, which is.
[[nodiscard]] double value_towards(const Scene& scene, const Adjustment& adjustment, double feasible,
                                   const Budget& budget);

/// `needed` as it is told: to five digits of itself, or of `size` where that is larger, on the side away from
/// the edge, and a millionth of that size beyond it at least.
[[nodiscard]] double safe_value(double needed, bool up, double size);

/// The row of a needed value: rounded, solved, and where the solve fails, tried again further off, then
/// without rounding (a value that other conditions determine has no room). None where no solve succeeded.
[[nodiscard]] std::optional<Relaxation> solved_relaxation(const Scene& scene, const Adjustment& adjustment,
                                                          double needed, const Budget& budget);

// Several limits that have to give way together.
//
// All are relaxed by one common part r, the least that does: upper limits times 1 + r, lower ones divided by
// it. First r doubles, then bisection. Of these, limits that may stay as they are at that r do so. The values
// are rounded away from the edge and the scene with all of them is solved.

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

/// Twice, four times, eight times the segments (and on to 64 where these are fewer, never above 512); between
/// the last that fails and the first that does bisection. Each halves the intervals of the one before, so it
/// keeps all motions of it. Told is a number that was solved, and the next one too: with an odd number a
/// breakpoint lies in the middle where with an even one there is none.
[[nodiscard]] FinerSpline finer_spline(const Scene& scene, const Budget& budget);

}  // namespace camopt
