// SPDX-License-Identifier: MIT
// The finished guide of a cam that is one, pushed by its roller: does the body swing as designed?
//
// A simulation that knows exported points and the roller, and no formula of the guide: a roller of radius r
// touches one wall of the slot, a smooth curve through the wall's points (point_curve.hpp). At each place of
// the roller the body is turned until the wall's nearest point is at the distance r, from the angle of the
// place before.
// Lengths m, angles rad, the guide's frame (its body's, the pivot at the origin). Errors: InputError for
// points that cannot be used.
#pragma once

#include "studies/delivered/solution.hpp"

namespace camopt {

struct GuideCheckInput {
    std::vector<Eigen::Vector2d> points;              ///< of the wall, by growing distance from the pivot
    std::vector<int> breaks;                          ///< indices where the guide changes its formula
    double roller_radius = 0.0;                       ///< > 0
    std::function<double(double distance)> designed;  ///< psi by L
    double begin = 0.0, end = 0.0;                    ///< places of the roller that are checked, L
    int places = 400;                                 ///< so many, evenly; >= 2
};

struct GuideCheckResult {
    double deviation = 0.0;  ///< largest |psi found - psi designed|, rad; infinite where nothing was found
    double distance = 0.0;   ///< there
    int points = 0;
    double seconds = 0.0;  ///< of wall time
};

[[nodiscard]] GuideCheckResult slot_check(const GuideCheckInput& input);

// The guide of a solved scene, pushed by its roller.

/// The roller touches either wall of the slot, of `points` (2000) points each (slot_check of
/// inverse_forward.hpp), at as many places of its stroke. The deviation is that of the feeder, m: the body's
/// by dY/dpsi at that place; relative: by the lift. Throws InputError for a solution without such a cam or
/// whose wall cannot be used.
[[nodiscard]] ForwardCheckReport check_guide(const Solution& solution, std::optional<int> points = {});

}  // namespace camopt
