// SPDX-License-Identifier: MIT
// Displacements of a program that the scene leaves open.
//
// A stroke whose displacement is open may pass 0, so V, A and J of it are measured by the lift: measured by
// what is found, a stroke that vanishes would cost nothing. A free displacement lies within one span beyond
// the given ones: [least − span, most + span], span = max(1 lift, most − least). Displacements in lifts.
#pragma once

#include "scene/scene.hpp"
#include "splines/motion_family.hpp"

#include <array>
#include <vector>

namespace camopt {

struct FreeDisplacements {
    std::vector<int> joints;         ///< joint j: the end of segment j − 1, which moves; the levels open
    double least = 0.0, most = 0.0;  ///< range of the levels
};

/// The least and the largest of the displacements that are known, 0 among them.
[[nodiscard]] std::array<double, 2> known_range(const MotionFamily& family);

/// No joints where the displacement of every spline is known, and for DRD and RR.
[[nodiscard]] FreeDisplacements free_displacements(const Scene& scene, const MotionFamily& family);

}  // namespace camopt
