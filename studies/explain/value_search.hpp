// SPDX-License-Identifier: MIT
// Has a scene a motion? Asked in two ways: quickly, by the least common violation, to close in on a value;
// and by a solve, before that value is told to anyone.
#pragma once

#include "studies/explain/adjustment.hpp"

namespace camopt {

// The time an explanation may take, and the user's wish to stop: a SolveControl, and the parts it is cut
// into. Everything a relaxation runs gets its time from here; nothing else of it looks at a clock.
class Budget {
 public:
    explicit Budget(SolveControl control) : control_(std::move(control)) {}

    [[nodiscard]] double left() const { return control_.deadline.seconds_left(); }
    [[nodiscard]] bool spent() const { return control_.ending().has_value(); }
    [[nodiscard]] const SolveControl& control() const { return control_; }

    /// A part of what is left, so that one slow search does not starve those after it.
    [[nodiscard]] Budget part(double fraction) const {
        return Budget(control_.sooner(std::min(1.0, fraction) * left()));
    }
    void say(std::string_view message) const {
        if (control_.progress) control_.progress(message);
    }

 private:
    SolveControl control_;
};

/// <= 0: the scene is feasible. Infinite where the cam cannot be built or the conditions contradict each
/// other. The limits that are linear or convex come first: they are quick, and may settle it. For the others
/// it is what one search found. Of free breakpoints that of the first ones, unless the limit of any curve
/// decides: then 0 or infinite.
[[nodiscard]] double least_violation(const Scene& scene, const Budget& budget);

/// The same of any angles that the scene lets the search choose, by a solve: 0 or infinite. least_violation
/// takes the angles it would start from.
[[nodiscard]] double violation_of_any(const Scene& scene, const Budget& budget);

/// The motion that a solve of the scene ended with: optimal, local or feasible; null: none. By the backend
/// that "auto" takes and without a proof that it is the best.
[[nodiscard]] std::shared_ptr<const MotionChain> solved_motion(const Scene& scene, const Budget& budget);

[[nodiscard]] inline bool is_solved(const Scene& scene, const Budget& budget) {
    return solved_motion(scene, budget) != nullptr;
}

/// The conflict that a solve of the scene ended with, where it proved that there is no motion. Without rows
/// of free breakpoints, where the limits on its peaks leave no curve.
[[nodiscard]] std::optional<std::vector<ConflictReport>> proved_conflict(const Scene& scene,
                                                                         const Budget& budget);

// The nearest value of one number that makes a scene feasible.
//
// The least violation t(v) of the scene with the value v is brought to zero, first by steps that double, then
// by regula falsi; v is taken from the feasible side. What is told of it is rounded away from the edge and
// solved.

/// given: least_violation() of the scene as it is. Of two directions the nearer value.
[[nodiscard]] std::optional<double> nearest_value(const Scene& scene, const Adjustment& adjustment,
                                                  double given, const Budget& budget);

/// The last feasible value in one direction, ±1, from a feasible one on, and one beyond it that is not.
struct FeasibleEdge {
    double inside = 0.0;
    std::optional<double> outside = {};  ///< none: `at_end`, or the search ended before it found one
    bool at_end = false;                 ///< feasible up to `end`
};
[[nodiscard]] FeasibleEdge feasible_edge(const Scene& scene, const Adjustment& adjustment, double feasible,
                                         int direction, double end, const Budget& budget);

/// The value nearest to the given one that is feasible, on the way to `feasible`, which is.
[[nodiscard]] double value_towards(const Scene& scene, const Adjustment& adjustment, double feasible,
                                   const Budget& budget);

/// To so many decimals (below 0: tens, hundreds, …), on one side of the value.
[[nodiscard]] double rounded_away(double value, int decimals, bool up);

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
// it. First r doubles, then bisection. Of these, limits that may stay as they are at that r do so, and each
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

/// Twice, four times, eight times the segments (and on to 64 where these are fewer, never above 512); between
/// the last that fails and the first that does bisection. Each halves the intervals of the one before, so it
/// keeps all motions of it. Told is a number that was solved, and the next one too: with an odd number a
/// breakpoint lies in the middle where with an even one there is none.
[[nodiscard]] FinerSpline finer_spline(const Scene& scene, const Budget& budget);

}  // namespace camopt
