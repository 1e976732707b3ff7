// SPDX-License-Identifier: MIT
// Displacements of a program that the scene leaves open, and what can be said of them.
//
// V, A and J of a spline segment are measured by its displacement h = s(end) − s(begin) as found, by the lift
// where it is 0: |s^{(r)}| β^r <= P |h| is not convex in (s, P). For given displacements it is, and with |h|
// replaced by the largest that a box leaves it is a relaxation. A free displacement lies within one span
// beyond the given ones: [least − span, most + span], span = max(1 lift, most − least), so that there is a
// largest. Displacements in lifts.
#pragma once

#include "scene/scene.hpp"
#include "splines/motion_family.hpp"

#include <array>
#include <span>
#include <string>
#include <vector>

namespace camopt {

/// Bounds on the displacement h of one segment.
struct DisplacementBox {
    enum class Sign {
        any,
        falls,   ///< h < 0
        stands,  ///< h = 0
        rises    ///< h > 0
    };
    int stretch = 0;
    double least = 0.0, most = 0.0;
    Sign sign = Sign::any;

    /// Of all displacements inside, the largest they are measured by.
    [[nodiscard]] double largest_measure() const;
    /// "0.25 <= displacement of motion.segments[1] <= 0.5"
    [[nodiscard]] std::string words() const;
};

struct FreeDisplacements {
    std::vector<int> stretches;      ///< splines whose displacement is open
    std::vector<bool> rest_to_rest;  ///< of these: rests at both ends, so only its shape counts
    std::vector<int> joints;         ///< joint j: the end of segment j − 1, which moves; the levels open
    double least = 0.0, most = 0.0;  ///< range of the levels
};

/// The least and the largest of the displacements that are known, 0 among them.
[[nodiscard]] std::array<double, 2> known_range(const MotionFamily& family);

/// Empty where every spline's displacement is known, and for DRD and RR.
[[nodiscard]] FreeDisplacements free_displacements(const Scene& scene, const MotionFamily& family);

/// A box for each free stretch, as large as the range allows.
[[nodiscard]] std::vector<DisplacementBox> whole_range(const FreeDisplacements& free,
                                                       const MotionFamily& family);

/// Narrows boxes to what the others and the known levels leave. False: they leave nothing.
[[nodiscard]] bool narrow(std::vector<DisplacementBox>& boxes, const FreeDisplacements& free,
                          const MotionFamily& family);

}  // namespace camopt
