// SPDX-License-Identifier: MIT
// The formulas of the follower train of a scene. Programs without camopt::dynamics use scenes without one.
#pragma once

#include "scene/scene.hpp"

namespace camopt {

/// Throws InputError for a chain of more than four masses, or one without mass or stiffness.
[[nodiscard]] std::shared_ptr<const TrainFormulas> train_formulas(const DynamicsSpec& spec);

/// Gives the scene's train its formulas; nothing to do for a scene without one.
void complete_dynamics(Scene& scene);

}  // namespace camopt
