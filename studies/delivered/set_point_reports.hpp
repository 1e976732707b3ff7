// SPDX-License-Identifier: MIT
// Set points and regions of a scene beside what a motion makes of them, in the units they were written in.
#pragma once

#include "core/motion.hpp"
#include "scene/motion/set_points.hpp"

#include <string>
#include <vector>

namespace camopt {

/// One wanted number. A region's velocity is looked at along all of it: `found` is the farthest from it.
struct SetPointReport {
    PlacedPoint point;
    int order = 0;                      ///< of the derivative
    std::string key;                    ///< "motion.via[0].velocity_mm_s"
    std::string unit;                   ///< "mm/s"; empty: normalised
    double wanted = 0.0, found = 0.0;   ///< in the unit
    double at = 0.0;                    ///< x of `found`
    double distance = 0.0, size = 1.0;  ///< |found − wanted| and |wanted| of y^(order) over x of the motion
};

/// In the order of the scene. `degree`: of the motion's polynomials, by whose values a region is judged.
[[nodiscard]] std::vector<SetPointReport> set_point_reports(const MotionSpec& spec, int degree,
                                                            const Motion& motion);

/// The name a constraint on the derivative of this order has: "via_velocity".
[[nodiscard]] const char* set_point_name(int order);

}  // namespace camopt
