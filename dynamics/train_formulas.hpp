// SPDX-License-Identifier: MIT
// From the train a scene names to its formulas. Who links no camopt::dynamics has scenes without it.
#pragma once

#include "scene/scene.hpp"

#include <memory>

namespace camopt {

/// Throws InputError for a chain of more than four masses, or one without mass or stiffness.
[[nodiscard]] std::shared_ptr<const TrainFormulas> train_formulas(const DynamicsSpec& spec);

/// Gives the scene's train its formulas; nothing to do for a scene without one.
void complete_dynamics(Scene& scene);

}  // namespace camopt
