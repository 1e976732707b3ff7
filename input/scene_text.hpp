// SPDX-License-Identifier: MIT
// A scene as the text of a scene file.
#pragma once

#include "scene/scene.hpp"

namespace camopt::input {

/// TOML with every key that differs from its default, in the units in which the scene was read; of a scene
/// made by a program, or a key whose unit is not known, in that of the manual or in SI, whichever needs fewer
/// digits. read_scene of it is the same scene, bit for bit. Only a number that is normalised by others (a set
/// point in mm/s) and was not read from a file may differ in the last bit, where no written number gives it.
/// Measured rows of a table are written as numbers. Throws InputError for what no scene file says: own terms
/// and limits, limits of both and of one side of the same derivative, an unknown cam.
[[nodiscard]] std::string scene_text(const Scene& scene);

}  // namespace camopt::input
