// SPDX-License-Identifier: MIT
// The continuous maxima of a rule along a motion.
//
// On a spline: exact for linear rules and the torque polynomials. Elsewhere enclosed for rules with
// PointRule::range_along and shapes with Motion::ranges, so that none near the largest or above 0 is missed.
// Otherwise sampled: the slope along the motion, dg/dx = g_y y' + g_{y'} y'' + g_{y''} y''', is bracketed and
// its root found to round-off, with denser samples where a cubic approximates the rule poorly.
#pragma once

#include "objectives/rules/linear_bound.hpp"

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

/// Where a motion comes nearest to a bound, or exceeds it most: sign · y^{(order)}, or the sum.
[[nodiscard]] Extremum extreme_of(const LinearBound& bound, const Motion& motion);

}  // namespace camopt

namespace camopt::piece_maxima {

// The parts of rule_maxima.cpp: maxima of a rule inside one piece of a motion. Private.

/// One rule along one motion.
struct Subject {
    const PointRule& rule;
    const Motion& motion;
    const Eigen::VectorXd& q;

    [[nodiscard]] double value(double x, Side side) const {
        return rule.evaluate(motion.at(x, side), q).value;
    }
};

struct Stretch {
    double begin = 0.0, end = 0.0;
};

/// Effort limit for the pieces of one rule together. A motion far outside everything deliverable has
/// thousands of maxima within round-off, which must not take seconds.
struct Effort {
    int enclosures = 0;   ///< remaining stretches
    int evaluations = 0;  ///< remaining samples and roots of the slope

    /// Many times the need of motions that satisfy, or nearly satisfy, their limits.
    [[nodiscard]] static Effort of(std::size_t pieces);
};

/// Where the slope decreases through zero between `left` (> 0) and `right` (< 0).
[[nodiscard]] double root_of_slope(const std::function<double(double x)>& slope, const Stretch& between,
                                   const std::array<double, 2>& slopes);

/// Both ends from inside and the maxima between, ascending: by samples, refined where a cubic through them
/// does not approximate the rule. Not an enclosure. `least_samples`: of the slope, at least; all of them are
/// evaluated, and each maximum is one of the samples, once the effort limit is reached.
[[nodiscard]] std::vector<Extremum> sampled(const Subject& subject, const Stretch& piece, int least_samples,
                                            Effort& effort);

/// A piece on which y is the polynomial `y` of x − begin, or that of a part of a chain whose shape has
/// enclosures.
struct SmoothPiece {
    Stretch piece;
    Eigen::VectorXd y;
    const ChainPart* part = nullptr;  ///< then `y` is empty
};
/// The pieces of a part of a chain between its breakpoints.
[[nodiscard]] std::vector<SmoothPiece> pieces_of(const ChainPart& part);
/// Enclosures of y to its fourth derivative over x, inside the piece; nullopt: its shape has none.
[[nodiscard]] std::optional<std::array<Interval, 5>> ranges_on(const SmoothPiece& piece, const Interval& x);

/// Every maximum inside the piece above `floor`, ascending, by enclosures of the rule, its slope and its
/// second derivative: none is missed, each value is accurate to `accuracy`. Nullopt if the rule cannot be
/// enclosed within the effort limit.
[[nodiscard]] std::optional<std::vector<Extremum>> enclosed(const Subject& subject, const SmoothPiece& piece,
                                                            double floor, double accuracy, Effort& effort);

}  // namespace camopt::piece_maxima
