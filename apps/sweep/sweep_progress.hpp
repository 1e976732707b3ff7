// SPDX-License-Identifier: MIT
// How far a sweep is and how long it will take, in one line for a terminal.
#pragma once

#include "studies/sweep/sweep_plan.hpp"

#include <chrono>

namespace camopt::apps {

class SweepProgress {
 public:
    /// `all`: the chunks of this run's folder; `missing`: those to be solved now.
    SweepProgress(const Chunking& chunking, const std::vector<int>& all, const std::vector<int>& missing);

    /// A row is solved. One that is solved again, since its worker died, counts once.
    void add(int row);

    /// "[######--------------]  1250 of 10011 rows, 12 s, about 84 s left"
    [[nodiscard]] std::string text() const { return text(seconds()); }
    [[nodiscard]] std::string text(double seconds_so_far) const;

 private:
    using Clock = std::chrono::steady_clock;
    [[nodiscard]] double seconds() const {
        return std::chrono::duration<double>(Clock::now() - begin_).count();
    }

    std::vector<bool> solved_;  ///< by row
    int total_ = 0, before_ = 0, now_ = 0;
    Clock::time_point begin_ = Clock::now();
};

/// "84 s", "12 min", "3.5 h"
[[nodiscard]] std::string duration_text(double seconds);

}  // namespace camopt::apps
