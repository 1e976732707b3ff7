// SPDX-License-Identifier: MIT
// What a scene asks for, in words: motion, spline, cam, forces, limits, objective.
#pragma once

#include "scene/scene.hpp"

#include <string>
#include <vector>

namespace camopt {

/// One line each, "Motion: rise between two dwells, lift 10 mm, …"; what the scene has not is left out.
[[nodiscard]] std::vector<std::string> scene_lines(const Scene& scene);

}  // namespace camopt
