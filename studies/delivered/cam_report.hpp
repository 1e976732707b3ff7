// SPDX-License-Identifier: MIT
// What is reported of a cam of any kind: figures, and the scene's limits on it.
#pragma once

#include "studies/delivered/solution.hpp"

namespace camopt {

/// The scene's cam with these dimensions (in the order of scene.cam), driven by
/// the motion: its figures, and the smallest any motion would allow where that is known. Throws InputError
/// where its formulas are missing.
[[nodiscard]] CamReport cam_report(const Scene& scene, std::vector<double> dimensions, const Motion& motion);

/// Every limit of the scene on the cam, as written and as kept by that cam.
[[nodiscard]] std::vector<ConstraintReport> cam_constraints(const Scene& scene, const CamReport& report);

}  // namespace camopt
