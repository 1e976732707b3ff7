// SPDX-License-Identifier: MIT
// Trials in processes of their own: one that crashes or hangs is one failure, and the others go on.
#pragma once

#include <functional>
#include <string>

namespace camopt::soak {

struct Worker {
    /// In the child: does trial `number` and tells lines.
    std::function<void(int number, const std::function<void(const std::string&)>& tell)> work;
    /// In the parent: a line that trial `number` told.
    std::function<void(int number, const std::string& line)> heard;
    /// In the parent: the trial is over; `fault`: how it died, empty where it did not.
    std::function<void(int number, const std::string& fault)> ended;
};

/// Trials 0 … count − 1, `jobs` at a time; one that takes longer than `most_seconds` is killed.
void run_in_processes(int count, int jobs, double most_seconds, const Worker& worker);

}  // namespace camopt::soak
