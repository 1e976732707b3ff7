// SPDX-License-Identifier: MIT
// Has a scene a motion? Asked in two ways: quickly, by the least common violation, to close in on a value;
// and by a solve, before that value is reported.
#pragma once

#include "studies/delivered/solution.hpp"

namespace camopt {

/// The time that a search may take, and the user's wish to stop: a SolveControl, and the parts it is cut
/// into. Every trial of a search gets its time from here; nothing else of it looks at a clock.
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

}  // namespace camopt
