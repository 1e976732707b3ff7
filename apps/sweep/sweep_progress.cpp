// SPDX-License-Identifier: MIT
#include "apps/sweep/sweep_progress.hpp"

#include <fmt/format.h>

namespace camopt::apps {

namespace {

constexpr int bar_width = 24;

int rows_of(const Chunking& chunking, const std::vector<int>& chunks) {
    int rows = 0;
    for (const int chunk : chunks) rows += chunking.range(chunk).size();
    return rows;
}

}  // namespace

SweepProgress::SweepProgress(const Chunking& chunking, const std::vector<int>& all,
                             const std::vector<int>& missing)
    : solved_(static_cast<std::size_t>(chunking.rows), false),
      total_(rows_of(chunking, all)),
      before_(total_ - rows_of(chunking, missing)) {}

void SweepProgress::add(int row) {
    const auto index = static_cast<std::size_t>(row);
    if (index >= solved_.size() || solved_[index]) return;
    solved_[index] = true;
    ++now_;
}

std::string SweepProgress::text(double seconds_so_far) const {
    const int done = before_ + now_;
    const int filled =
        total_ > 0 ? static_cast<int>(static_cast<long>(bar_width) * done / total_) : bar_width;
    std::string line = fmt::format("[{:#>{}}{:->{}}] {} of {} rows, {}", "", filled, "", bar_width - filled,
                                   done, total_, duration_text(seconds_so_far));
    if (now_ > 0 && done < total_)
        line += fmt::format(", about {} left", duration_text(seconds_so_far * (total_ - done) / now_));
    return line;
}

std::string duration_text(double seconds) {
    constexpr double minute = 60.0, hour = 3600.0;
    if (seconds < 2.0 * minute) return fmt::format("{:.0f} s", seconds);
    if (seconds < 2.0 * hour) return fmt::format("{:.0f} min", seconds / minute);
    return fmt::format("{:.1f} h", seconds / hour);
}

}  // namespace camopt::apps
