// SPDX-License-Identifier: MIT
// Two or more ways to do the same thing, timed in turns, so that what else the machine does falls on all of
// them alike.
#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

namespace camopt::benchmarks {

struct RunOutcome {
    std::string status;
    double seconds = 0.0;
    double objective = 0.0;  ///< true, of the curve found
    int iterations = 0, rounds = 0;
};

struct TimedWay {
    std::string name;
    std::function<RunOutcome()> once;
};

struct WayFigures {
    RunOutcome last;
    double median_seconds = 0.0, least_seconds = 0.0;
    int repeats = 0;
};

/// Every way once, then again in the same order, `repeats` times in all. One entry a way.
[[nodiscard]] std::vector<WayFigures> run_in_turns(std::span<const TimedWay> ways, int repeats);

}  // namespace camopt::benchmarks
