// SPDX-License-Identifier: MIT
// A long computation with its progress on the terminal, which Ctrl-C stops.
#pragma once

#include "apps/interrupt.hpp"
#include "apps/progress.hpp"
#include "apps/terminal.hpp"
#include "solvers/solver.hpp"

#include <functional>
#include <optional>
#include <string>

namespace camopt::apps {

/// What compute(control, finished) returns; none where it was interrupted, for "the table" is incomplete
/// then, and that is said. What `finished` hears of is shown behind `words`.
template <class Compute>
auto interruptible_run(const std::string& what, const std::string& words, const Compute& compute) {
    const InterruptWatch watch;
    const auto progress = terminal_progress();
    const std::function<void(const std::string&)> finished = [&](const std::string& part) {
        if (progress) progress(words + part);
    };
    std::optional result = compute(SolveControl{InterruptWatch::interrupted, {}}, finished);
    end_progress();
    if (!InterruptWatch::interrupted()) return result;
    print_error("camopt: interrupted; " + what + " is incomplete and was not written\n");
    result.reset();
    return result;
}

}  // namespace camopt::apps
