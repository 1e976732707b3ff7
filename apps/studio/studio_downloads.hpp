// SPDX-License-Identifier: MIT
// Files of a scene, made in memory: a request names one of a list, never a path.
#pragma once

#include "apps/studio/studio_scene.hpp"
#include "apps/studio/studio_server.hpp"
#include "solvers/solver.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace camopt::apps {

/// "scene", "motion", "cam", "dxf", "result", "report": what a request may ask for.
[[nodiscard]] std::vector<std::string_view> download_names();

/// The file, solved for where it needs a solve. Throws InputError for a name that is none, and for a file
/// this scene has not (the cam of a scene without one, anything of a scene without a motion).
[[nodiscard]] StudioAnswer studio_download(std::string_view what, const StudioScene& given,
                                           const SolveControl& control);

}  // namespace camopt::apps
