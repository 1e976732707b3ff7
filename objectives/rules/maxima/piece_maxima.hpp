// SPDX-License-Identifier: MIT
// The parts of rule_maxima.cpp: maxima of a rule inside one piece of a motion. Private.
#pragma once

#include "core/numbers/extremum.hpp"
#include "objectives/rules/point_rule.hpp"
#include "splines/motion_chain.hpp"

#include <Eigen/Core>

#include <array>
#include <functional>
#include <optional>
#include <vector>

namespace camopt::piece_maxima {

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

/// What may be spent on the pieces of one rule together. A motion far outside everything that can be
/// delivered has thousands of maxima, all in rounding; nobody must wait for them.
struct Effort {
    int enclosures = 0;   ///< of stretches that are left
    int evaluations = 0;  ///< of samples and roots of the slope that are left

    /// Many times what motions need that keep their limits, or nearly.
    [[nodiscard]] static Effort of(std::size_t pieces);
};

/// Where the slope falls through zero between `left` (> 0) and `right` (< 0).
[[nodiscard]] double root_of_slope(const std::function<double(double x)>& slope, const Stretch& between,
                                   const std::array<double, 2>& slopes);

/// Both ends from inside and the maxima between, ascending: by samples, closer where a cubic through them
/// does not follow the rule. Not a proof. `least_samples`: of the slope, at the least; all of them are taken,
/// and each maximum is one of the samples, where the effort is used up.
[[nodiscard]] std::vector<Extremum> sampled(const Subject& subject, const Stretch& piece, int least_samples,
                                            Effort& effort);

/// A piece on which y is the polynomial `y` of x − begin, or that of a part of a chain whose shape says where
/// it ranges.
struct SmoothPiece {
    Stretch piece;
    Eigen::VectorXd y;
    const ChainPart* part = nullptr;  ///< then `y` is empty
};
/// Every maximum inside the piece that lies above `floor`, ascending, by enclosures of the rule, its slope
/// and its second derivative: none is missed, each value is right to `accuracy`. Empty option: the rule
/// cannot be enclosed, or not within a sensible number of steps.
[[nodiscard]] std::optional<std::vector<Extremum>> enclosed(const Subject& subject, const SmoothPiece& piece,
                                                            double floor, double accuracy, Effort& effort);

}  // namespace camopt::piece_maxima
