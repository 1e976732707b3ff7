// SPDX-License-Identifier: MIT
// What the handles of the C face hold.
#pragma once

#include "bindings/c/failure.hpp"
#include "input/scene_document.hpp"
#include "output/json/result_json.hpp"
#include "studies/delivered/solution.hpp"

#include <span>
#include <string>
#include <vector>

struct camopt_scene {
    camopt::input::SceneDocument document;
};

struct camopt_solution {
    camopt::Solution solution;
    camopt::RunOrigin origin;
    std::vector<std::string> stations;  ///< names; one "" of a plane cam, none without a cam
};

namespace camopt::c {

/// Complete and validated.
[[nodiscard]] Scene complete_scene(const camopt_scene& scene, std::span<const std::string> settings = {});

/// Throws Failure for NULL, and ABSENT where there is no motion.
[[nodiscard]] const MotionChain& motion_of(const camopt_solution* solution);

[[nodiscard]] camopt_verdict verdict_of(Verdict verdict);

}  // namespace camopt::c
