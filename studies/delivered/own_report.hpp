// SPDX-License-Identifier: MIT
// What a motion makes of the terms and limits that the program brought (scene/own_rule.hpp).
#pragma once

#include "core/motion.hpp"
#include "studies/delivered/solution.hpp"

#include <vector>

namespace camopt {

/// In the order of the scene.
[[nodiscard]] std::vector<OwnTermReport> own_term_reports(const Scene& scene, const Motion& motion);
[[nodiscard]] std::vector<ConstraintReport> own_constraints(const Scene& scene, const Motion& motion);

}  // namespace camopt
