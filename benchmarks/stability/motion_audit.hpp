// SPDX-License-Identifier: MIT
// A second opinion on a delivered motion, from its local polynomials alone: peaks, objective, every broken
// condition.
//
// Long double throughout, and none of the library's extrema, rules or cams: y on segment i is
// Σ_m a_{i,m} (x − x_i)^m, peaks come from the roots of the next derivative by bisection, the pressure angle
// and the curvature of a cam from the path of the roller's centre as complex numbers, at 64 places a segment
// refined by golden section. Known here: DRD, RR and programs; caps, exact points, symmetry; pressure angle
// of rollers and knife edges, convex radius of rollers and of sliding flat faces, least contact force.
#pragma once

#include "studies/delivered/solution.hpp"

#include <string>

namespace camopt::stability {

struct MotionAudit {
    long double velocity = 0, acceleration = 0, jerk = 0;  ///< normalised peaks
    long double objective = 0;
    long double violation = 0;  ///< the worst, relative to the limit (jumps, ends: to the peak); >= 0
    /// The worst jump of y''' where it should be continuous (C3, C4 splines), by its peak: rounding divided
    /// by the cube of the segments' width. Judged apart: largest_joint_jump in
    /// studies/delivered/delivered_audit.hpp.
    long double jerk_jump = 0;
    std::string worst;  ///< what it is: "joint 3, order 2", "pressure angle", …
};

/// The scene's demands against solution.motion. Throws InputError where no motion was delivered.
[[nodiscard]] MotionAudit audit(const Solution& solution);

}  // namespace camopt::stability
