// SPDX-License-Identifier: MIT
// The continuous maxima of a rule along a motion.
//
// On a spline: exact for linear rules and the torque polynomials; enclosed for rules with
// PointRule::range_along, so that none near the largest or above 0 is missed. For other rules, and on laws,
// sampled: the slope along the motion, dg/dx = g_y y' + g_{y'} y'' + g_{y''} y''', is bracketed and its root
// found to round-off, with denser samples where a cubic approximates the rule poorly.
#pragma once

#include "objectives/rules/model.hpp"

#include <Eigen/Core>

#include <vector>

namespace camopt {

/// Local maxima of the rule along the motion of a family at `x` (design entries in their own units), in the
/// order of the cam angle. `motion` is family.motion(x). q: the rule's own parameters.
[[nodiscard]] std::vector<Extremum> rule_maxima(const PlacedRule& rule, const MotionFamily& family,
                                                const MotionChain& motion, const Eigen::VectorXd& q);

struct MaximaAlong {
    std::vector<Extremum> maxima;
    /// None near the largest or above 0 is missed, and each value is accurate: everything was enclosed.
    bool complete = true;
};

/// The same along any motion, between its breakpoints; complete if the rule and the shapes have enclosures.
[[nodiscard]] MaximaAlong maxima_along(const PointRule& rule, const Motion& motion, const Eigen::VectorXd& q);
[[nodiscard]] std::vector<Extremum> rule_maxima(const PointRule& rule, const Motion& motion,
                                                const Eigen::VectorXd& q);

/// The largest of them; value -infinity if there is none, infinity if one is undefined.
[[nodiscard]] Extremum largest_of(const std::vector<Extremum>& maxima);

}  // namespace camopt
