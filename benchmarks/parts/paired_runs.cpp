// SPDX-License-Identifier: MIT
#include "benchmarks/parts/paired_runs.hpp"

#include "benchmarks/parts/measurement.hpp"

#include <algorithm>

namespace camopt::benchmarks {

std::vector<WayFigures> run_in_turns(std::span<const TimedWay> ways, int repeats) {
    std::vector<WayFigures> figures(ways.size());
    std::vector<std::vector<double>> seconds(ways.size());
    for (int repeat = 0; repeat < repeats; ++repeat) {
        for (std::size_t k = 0; k < ways.size(); ++k) {
            figures[k].last = ways[k].once();
            seconds[k].push_back(figures[k].last.seconds);
        }
    }
    for (std::size_t k = 0; k < ways.size(); ++k) {
        figures[k].repeats = repeats;
        if (repeats == 0) continue;
        figures[k].median_seconds = median(seconds[k]);
        figures[k].least_seconds = *std::ranges::min_element(seconds[k]);
    }
    return figures;
}

}  // namespace camopt::benchmarks
