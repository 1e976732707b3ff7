// SPDX-License-Identifier: MIT
// A scene as the text of a scene file, in SI units and radians: what a row solved, for others to look at
// (scripts/verify-certificate).
#pragma once

#include "scene/scene.hpp"

#include <optional>
#include <string>

namespace camopt::stability {

/// Every number with all its digits: read again it is the same scene. Title, options of backends and what
/// shows units to people are left out. None where the scene has parts that no row of the table has
/// (mechanisms, elastic followers, measured motions, own rules, free breakpoints, forms of a disk cam).
[[nodiscard]] std::optional<std::string> scene_text(const Scene& scene);

}  // namespace camopt::stability
