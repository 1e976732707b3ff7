// SPDX-License-Identifier: MIT
// camopt sweep SCENE --pareto first,second: a front by limits.
#pragma once

#include "apps/commands.hpp"

namespace camopt::apps {

/// Writes pareto.csv, pareto.svg and pareto.html into request.out and prints the front. After Ctrl-C the
/// points that are finished are written.
[[nodiscard]] ExitCode pareto_run(const SweepRequest& request);

}  // namespace camopt::apps
