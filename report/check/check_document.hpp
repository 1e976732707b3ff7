// SPDX-License-Identifier: MIT
// What `camopt check` says of a scene: its keys, the plan of its solve, its limits and derivatives.
#pragma once

#include "report/document/document.hpp"
#include "studies/check/scene_check.hpp"

namespace camopt {

/// name: of the scene, as it was given.
[[nodiscard]] Document check_document(const Scene& scene, const SceneCheck& check, const std::string& name);

}  // namespace camopt
