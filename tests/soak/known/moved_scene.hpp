// SPDX-License-Identifier: MIT
// Scenes at the edge: every number of one with a known answer is moved by as little as one unit in the last
// place, or a weight of 0 is written. How far the answer may move follows from its multipliers
// (known_scene.hpp).
#pragma once

#include "tests/soak/draw.hpp"
#include "tests/soak/known/known_scene.hpp"

namespace camopt::soak {

/// Changes text, `change` and `answer` of a scene that has a motion.
void move_scene(Draw& draw, KnownScene& scene);

/// The value with every number that has a decimal point moved by a relative `by`, up or down; by 0: to the
/// next double.
[[nodiscard]] std::string moved_numbers(Draw& draw, const std::string& value, double by);

}  // namespace camopt::soak
