// SPDX-License-Identifier: MIT
// The parts of cam_limits.cpp: each adds the rules of its own kind of limit. Private.
#pragma once

#include "objectives/rules/cam_rule.hpp"
#include "profiles/disk/disk_sides.hpp"
#include "scene/scene.hpp"

#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace camopt::cam_limit_parts {

using Rules = std::vector<std::shared_ptr<const CamRule>>;
using Shared = std::shared_ptr<const DiskVariables>;

// A relative violation of something near zero says nothing: scales stay above this part of the whole.
inline constexpr double least_scale = 1e-3;

/// A length by which geometry is made dimensionless: the prime radius, or for an arm its pivot's distance.
[[nodiscard]] double length_of(const DiskCam& cam);

/// Of a rule that holds on one side of the cam (profiles/disk/disk_sides.hpp).
inline void add_on_side(Rules& rules, const Shared& cam, CamFormula formula, int side) {
    formula.remark = side_name(cam->cam.form, side);
    rules.push_back(std::make_shared<CamRule>(cam, std::move(formula)));
}

/// regularity >= margin on one side; nothing for a knife edge.
void add_regularity(Rules& rules, const Shared& cam, const WrittenLimit& limit, int side);
/// 1 + σψ' of an oscillating flat face stays positive: where it vanishes the face touches nothing.
void add_face_turn(Rules& rules, const Shared& cam, const std::string& key);
void add_pressure(Rules& rules, const Scene& scene, const Shared& cam);
void add_forces(Rules& rules, const Scene& scene, const Shared& cam);

}  // namespace camopt::cam_limit_parts
