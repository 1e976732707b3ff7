// SPDX-License-Identifier: MIT
// The end of a sweep whose chunks all stand in its folder.
#pragma once

#include "apps/exit_code.hpp"
#include "output/report/sweep_folder.hpp"

#include <string_view>

namespace camopt::apps {

/// Writes sweep.csv (of a whole sweep, not of a shard), prints the summary. failure where a row failed: an
/// infeasible row is a result, a failed one is none. `scene`: of the first row; `units`: "mm", "in" or empty,
/// of lengths in words and pictures.
[[nodiscard]] ExitCode finish_sweep(const SweepFolder& folder, const Scene* scene = nullptr,
                                    std::string_view units = {});

}  // namespace camopt::apps
