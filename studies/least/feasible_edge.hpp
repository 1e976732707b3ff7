// SPDX-License-Identifier: MIT
// Where the values of a number end with which motions exist: one search for the least value of a number,
// suggested changes, the number of segments, the speed of a machine.
//
// t(v) is the least common violation of the limits with the value v: t <= 0 where there are motions. Its zero
// is bracketed by steps that double; then the bracket is closed in on from both sides by the secant of the
// last two trials. Where steps shorten it little, its middle is tried.
#pragma once

#include "studies/least/adjustment.hpp"
#include "studies/least/violation.hpp"

namespace camopt {

/// A value that was tried.
struct ValueTrial {
    double value = 0.0;
    double violation = infinity;  ///< t(v)
    [[nodiscard]] bool feasible() const { return violation <= 0.0; }
};

/// Two values between which t changes its sign.
struct ValueBracket {
    ValueTrial inside, outside;  ///< feasible, and not
    [[nodiscard]] double width() const { return std::abs(inside.value - outside.value); }
};

/// What is searched.
struct ValueSearch {
    std::function<double(double value)> violation;  ///< t(v)
    std::function<bool()> is_over = [] { return false; };
    /// The value tried in place of one that the search asks for: whole, or of few digits. None: that itself.
    std::function<double(double value)> rounded = {};
    double slope = 0.0;  ///< |dt/dv| before two values say it, > 0; 0: not known

    [[nodiscard]] ValueTrial at(double value) const { return {value, violation(value)}; }
};

/// `changed` by steps from a value: the first one whose feasibility is another; `last`: the one before.
struct ValueMarch {
    ValueTrial last;
    std::optional<ValueTrial> changed = {};
    bool at_end = false;  ///< none, up to the end of the range
};
/// step: of the first one, with the sign of the direction; then it doubles.
[[nodiscard]] ValueMarch marched(const ValueSearch& search, const ValueTrial& from, double step, double end);

/// accuracy: the width at which the search ends, > 0.
[[nodiscard]] ValueBracket closed_in(const ValueSearch& search, ValueBracket bracket, double accuracy);

// Values that people read.

/// To so many decimals (below 0: tens, hundreds, …), on one side of the value.
[[nodiscard]] double rounded_away(double value, int decimals, bool up);

/// `needed` as it is told: to five digits of itself, or of `size` where that is larger, on the side away from
/// the edge, and a millionth of that size beyond it at least.
[[nodiscard]] double safe_value(double needed, bool up, double size);

/// The number with the fewest decimals (below 0: tens, hundreds, …) from `near` on to `far`, of these the one
/// next to `near`.
[[nodiscard]] double shortest_decimal(double near, double far);

// The same of one number of a scene.

/// The nearest feasible value. given: least_violation() of the scene as it is, > 0. Of two directions the
/// nearer one.
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

}  // namespace camopt
