// SPDX-License-Identifier: MIT
// Spring surge: harmonics of the lift over one revolution of the cam, and the limit on those that excite the
// return spring.
//
//   a_k = (1/π) ∫_0^2π y cos kθ dθ,   b_k = (1/π) ∫_0^2π y sin kθ dθ,   c_k = sqrt(a_k² + b_k²)
//
// y in lifts; θ in rad from the start of the motion, which c_k does not depend on; from the end of an RR
// motion to the end of the revolution y is 0. At the cam speed ω harmonic k excites the spring with kω: it
// meets its natural frequency (rad/s) at ω = frequency / k. a_k and b_k are affine in the free entries,
// dwells and laws being constants, so c_k <= level is a convex cone: linear rows a_k cos φ + b_k sin φ <=
// level for every φ, of which the exchange adds those of the φ that a motion has.
//
// Source: A. M. Wahl, Mechanical Springs, 2nd ed., 1963 (surge of valve springs).
#pragma once

#include "objectives/rules/model.hpp"
#include "scene/scene.hpp"

namespace camopt {

/// The first and the last harmonic that the limit holds for: those given, or the nearest to the natural
/// frequency of the spring and one to either side. The scene has such a frequency.
[[nodiscard]] std::array<int, 2> limited_harmonics(const Scene& scene);

/// c_k in lifts, of a motion that returns to 0 within a revolution.
[[nodiscard]] double harmonic_amplitude(const MotionSpec& spec, const Motion& motion, int order);

/// One linear rule a harmonic; none without the limit.
void add_spring_rules(CamModel& model, const Scene& scene);

}  // namespace camopt
