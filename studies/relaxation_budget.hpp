// SPDX-License-Identifier: MIT
// The time an explanation may take, and the user's wish to stop. Everything a relaxation runs gets its time
// from here; nothing else of it looks at a clock.
#pragma once

#include "core/deadline.hpp"
#include "solvers/solver.hpp"

#include <algorithm>
#include <string_view>

namespace camopt {

class Budget {
 public:
    Budget(double seconds, const SolveControl& control)
        : seconds_(seconds), control_(control.sooner(seconds)) {}

    [[nodiscard]] double used() const { return watch_.seconds(); }
    [[nodiscard]] double left() const { return control_.deadline.seconds_left(); }
    /// What a solve may take: more than nothing, or its scene would be refused.
    [[nodiscard]] double seconds_for_solve() const { return std::max(left(), least_seconds); }
    [[nodiscard]] bool spent() const { return control_.ending().has_value(); }
    [[nodiscard]] double seconds() const { return seconds_; }
    [[nodiscard]] const SolveControl& control() const { return control_; }

    /// A part of what is left, so that one slow search does not starve those after it.
    [[nodiscard]] Budget part(double fraction) const {
        return {std::max(0.0, std::min(1.0, fraction) * left()), control_};
    }
    void say(std::string_view message) const {
        if (control_.progress) control_.progress(message);
    }

 private:
    static constexpr double least_seconds = 1e-3;
    Stopwatch watch_;
    double seconds_;
    SolveControl control_;
};

}  // namespace camopt
