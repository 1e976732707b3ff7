// SPDX-License-Identifier: MIT
// Trials in worker processes (core/platform/workers.hpp): one that crashes or hangs, twice, is one failure,
// and the others go on.
#pragma once

#include <algorithm>
#include <chrono>
#include <functional>
#include <string>

namespace camopt::soak {

struct Worker {
    /// In the worker: does trial `number` and tells lines.
    std::function<void(int number, const std::function<void(const std::string&)>& tell)> work;
    /// In the parent: a line that trial `number` told.
    std::function<void(int number, const std::string& line)> heard;
    /// In the parent, after its lines: the trial is over; `fault`: how it died, empty where it did not.
    std::function<void(int number, const std::string& fault)> ended;
};

/// How long a worker was waited for, by a clock that is looked at every half second. A look that comes much
/// later was held up with the whole machine, and the worker with it: it counts as a second.
class Patience {
 public:
    using Clock = std::chrono::steady_clock;
    static constexpr std::chrono::milliseconds turn{500};

    explicit Patience(Clock::time_point now) : last_(now) {}
    void look(Clock::time_point now) {
        waited_ += std::min<Clock::duration>(now - last_, 2 * turn);
        last_ = now;
    }
    [[nodiscard]] Clock::duration waited() const { return waited_; }

 private:
    Clock::time_point last_;
    Clock::duration waited_{};
};

/// Trials 0 … count − 1, `jobs` at a time; one that takes longer than `most_seconds` is ended.
void run_in_processes(int count, int jobs, double most_seconds, const Worker& worker);

}  // namespace camopt::soak
