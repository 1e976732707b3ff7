// SPDX-License-Identifier: MIT
//
// Set points and regions of constant velocity as conditions on a spline, and the breakpoints that regions
// need.
//
// On a region [a, b] the motion is one polynomial of degree p, since a and b are breakpoints and there is
// none
// between. It is y(a) + v (x − a) exactly if
//   p = 3:  y'(a) = v, y''(a) = y''(b) = 0   (y'' is linear, so it vanishes; y' is constant),
//   p = 5:  these, y'(b) = v and y'((a + b)/2) = v   (y' − v is quartic with double zeros at both ends, so a
//           multiple of (x − a)²(b − x)²; the middle makes that multiple 0).
// All of them are linear in the design vector, in any form, and of the order of its entries.
#pragma once

#include "scene/motion/set_points.hpp"
#include "splines/design_vector.hpp"

#include <array>
#include <vector>

namespace camopt {

/// `end`: of the motion, x: there a point is seen from the left.
[[nodiscard]] std::vector<PointCondition> conditions_of(const MotionSpec& motion, const PlacedPoint& point,
                                                        int degree, double end);

/// Begin and end of each region of one stretch (segment −1: DRD and RR; with their mirror images where the
/// motion is symmetric), x.
[[nodiscard]] std::vector<std::array<double, 2>> regions_of(const MotionSpec& motion,
                                                            const std::vector<PlacedPoint>& points,
                                                            int segment);

/// The breakpoints of a stretch from `begin` to `end`: uniform or the scene's own, replaced by those of
/// regions where they overlap.
[[nodiscard]] std::vector<double> breakpoints_of(const SplineSpec& spline, double begin, double end,
                                                 const std::vector<std::array<double, 2>>& regions);

}  // namespace camopt
