// SPDX-License-Identifier: MIT
// From the mechanism a scene names to its formulas: the one place that knows every kind. Who links a single
// kind does without it and sets Scene::mechanism->formulas himself.
#pragma once

#include "scene/scene.hpp"

namespace camopt {

/// Gives the scene's mechanism its formulas; nothing to do for a scene without one. Throws InputError for a
/// kind or a choice that does not exist, and for a scene that does not fit its mechanism (find_fault: a dyad
/// that does not reach, …).
void complete_mechanism(Scene& scene);

}  // namespace camopt
