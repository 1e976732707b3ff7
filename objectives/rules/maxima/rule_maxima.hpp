// SPDX-License-Identifier: MIT
// The continuous maxima of a rule along a motion.
//
// On a spline: of linear rules and the torque polynomials, exact; of rules that say how they range over a
// stretch (PointRule::range_along) enclosed, so that none is missed that lies near the largest or above 0. Of
// the rest, and on given laws, sampled: the slope along the motion, dg/dx = g_y y' + g_{y'} y'' + g_{y''}
// y''', is bracketed and its root found to round-off, with samples the closer the worse a cubic follows the
// rule.
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
    /// None is missed that lies near the largest or above 0, each is as large as said: everything was
    /// enclosed.
    bool complete = true;
};

/// The same along any motion, between its breakpoints; complete where the rule and
/// the shapes say how they range.
[[nodiscard]] MaximaAlong maxima_along(const PointRule& rule, const Motion& motion, const Eigen::VectorXd& q);
[[nodiscard]] std::vector<Extremum> rule_maxima(const PointRule& rule, const Motion& motion,
                                                const Eigen::VectorXd& q);

/// The largest of them; value -infinity where there is none, infinity at one that has no value.
[[nodiscard]] Extremum largest_of(const std::vector<Extremum>& maxima);

}  // namespace camopt
