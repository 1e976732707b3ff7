// SPDX-License-Identifier: MIT
// Has a scene a motion? Asked in two ways: quickly, by the least common violation, to close in on a value;
// and by a solve, before that value is told to anyone.
#pragma once

#include "scene/scene.hpp"
#include "solvers/solver.hpp"
#include "splines/motion_chain.hpp"

#include <algorithm>
#include <memory>
#include <string_view>
#include <utility>

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

/// The motion that a solve of the scene ended with: optimal, local or feasible; null: none. By the backend
/// that "auto" takes and without a proof that it is the best.
[[nodiscard]] std::shared_ptr<const MotionChain> solved_motion(const Scene& scene, const Budget& budget);

[[nodiscard]] inline bool is_solved(const Scene& scene, const Budget& budget) {
    return solved_motion(scene, budget) != nullptr;
}

/// A solve of the scene ended with a proof that it has no motion. Of free breakpoints: the limits on its
/// peaks leave no curve.
[[nodiscard]] bool is_proved_infeasible(const Scene& scene, const Budget& budget);

}  // namespace camopt
