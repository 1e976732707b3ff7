// SPDX-License-Identifier: MIT
// The time an explanation may take, and the user's wish to stop: a SolveControl, and the parts it is cut
// into. Everything a relaxation runs gets its time from here; nothing else of it looks at a clock.
#pragma once

#include "solvers/solver.hpp"

#include <algorithm>
#include <string_view>
#include <utility>

namespace camopt {

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

}  // namespace camopt
