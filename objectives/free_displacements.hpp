// SPDX-License-Identifier: MIT
// Displacements of a program that the scene leaves free.
//
// A stroke with a free displacement may pass through 0, so its V, A and J are normalised by the lift:
// normalised by its own displacement, a vanishing stroke would cost nothing. A free displacement lies within
// one span beyond the given ones: [least − span, most + span], span = max(1 lift, most − least).
// Displacements in lifts.
#pragma once

#include "scene/scene.hpp"
#include "splines/motion_family.hpp"

#include <array>
#include <vector>

namespace camopt {

struct FreeDisplacements {
    std::vector<int> joints;         ///< joint j: the end of segment j − 1, which moves; free levels
    double least = 0.0, most = 0.0;  ///< range of the levels
};

/// The smallest and the largest of the known displacements and 0.
[[nodiscard]] std::array<double, 2> known_range(const MotionFamily& family);

/// No joints if the displacement of every spline is known, and for DRD and RR.
[[nodiscard]] FreeDisplacements free_displacements(const Scene& scene, const MotionFamily& family);

}  // namespace camopt
