// SPDX-License-Identifier: MIT
// camopt sweep SCENE --surface ERROR: every weight of V, A and J to a proved error, and its look-up.
#pragma once

#include "apps/commands.hpp"

namespace camopt::apps {

/// Writes surface.csv, surface.svg, surface.html, surface.obj and surface.json into request.out and prints
/// what was reached. After Ctrl-C what is finished is written, and --resume goes on from it.
[[nodiscard]] ExitCode surface_run(const SweepRequest& request);

/// request.scene is such a folder: prints between which two values the objective lies at request.surface.at.
[[nodiscard]] ExitCode surface_look_up(const SweepRequest& request);

}  // namespace camopt::apps
