// SPDX-License-Identifier: MIT
// What is reported of a cam of any mechanism but the disk cam: figures, and the scene's limits on it.
#pragma once

#include "scene/scene.hpp"
#include "studies/delivered/solution.hpp"

#include <vector>

namespace camopt {

/// Whether an inverse cam was delivered.
[[nodiscard]] bool has_inverse_cam(const Solution& solution);

/// The scene's mechanism with these dimensions, driven by the motion. Throws InputError where its formulas
/// are missing.
[[nodiscard]] MechanismReport mechanism_report(const Scene& scene, std::vector<double> dimensions,
                                               const Motion& motion);

/// Every limit of the scene on it, as written and as kept.
[[nodiscard]] std::vector<ConstraintReport> mechanism_constraints(const Scene& scene,
                                                                  const MechanismReport& report);

/// Exports about `points` points of the delivered cam and runs its lever and linkage over them
/// (mechanism_check.hpp). Throws InputError where the solution has no such cam, or nothing can be checked.
[[nodiscard]] ForwardCheckReport check_mechanism(const Solution& solution, int points = 6000);

}  // namespace camopt
