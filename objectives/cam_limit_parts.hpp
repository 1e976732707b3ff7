// SPDX-License-Identifier: MIT
// The parts of cam_limits.cpp: each adds the rules of its own kind of limit. Private.
#pragma once

#include "core/scene.hpp"
#include "objectives/cam_rule.hpp"

#include <memory>
#include <vector>

namespace camopt::cam_limit_parts {

using Rules = std::vector<std::shared_ptr<const CamRule>>;
using Shared = std::shared_ptr<const CamVariables>;

// A relative violation of something near zero says nothing: scales stay above this part of the whole.
inline constexpr double least_scale = 1e-3;

void add_pressure(Rules& rules, const Scene& scene, const Shared& cam);
void add_forces(Rules& rules, const Scene& scene, const Shared& cam);

}  // namespace camopt::cam_limit_parts
