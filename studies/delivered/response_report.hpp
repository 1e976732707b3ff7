// SPDX-License-Identifier: MIT
// What the elastic follower train makes of the delivered motion: terms and limits of the scene.
#pragma once

#include "studies/delivered/solution.hpp"

#include <vector>

namespace camopt {

/// Fills `train` and appends the limits to constraints; nothing for a scene without dynamics.
void report_responses(Solution& solution);

/// Of any motion of the scene's kind. The scene has dynamics.
[[nodiscard]] TrainReport train_report(const Scene& scene, const Motion& motion);

/// The limits of the scene on its train, as the motion of the report keeps them.
[[nodiscard]] std::vector<ConstraintReport> response_constraints(const Scene& scene,
                                                                 const TrainReport& train);

}  // namespace camopt
