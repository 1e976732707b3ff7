// SPDX-License-Identifier: MIT
// One linear bound on the motion between two angles: a limit of one side, an edge of a corridor, a limit of a
// motor that follows the motion.
#pragma once

#include "objectives/rules/peak_rule.hpp"

namespace camopt {

/// sign · y^{(order)} <= bound from `from` to `until`, both included. In lifts, by x of the whole motion. Of
/// a motor: a sum of y', y'' and 1 in SI units in place of sign · y^{(order)}.
struct MotionBound {
    std::string name;  ///< "acceleration_min", "corridor_displacement_max"
    std::string key;   ///< "limits.acceleration_m_s2.min", "motion.corridor[0].displacement_mm.min"
    std::string unit;  ///< of the key; empty: normalised
    int order = 0, sign = 1;
    double bound = 0.0;
    double given = 0.0;                         ///< in the unit
    double per_normalised = 1.0;                ///< the unit's number for y^{(order)} = 1
    double from = -infinity, until = infinity;  ///< x
    int stretch = -1;                           ///< of the family; -1: any
    int corridor = -1;                          ///< which one it is of; -1: a limit
    std::array<double, 3> weights{};            ///< of y', y'' and 1: of a motor
    double size = 0.0;                          ///< of a motor: what a violation is measured by
    bool magnitude = false;                     ///< its values are shown without their sign
    std::string remark = {};                    ///< as of BoundRule::Bound

    /// Exceeding the bound by this is a violation of 100 %.
    [[nodiscard]] double scale() const;
    [[nodiscard]] BoundRule::Bound rule(double most, double one) const {
        return {
            .order = order, .sign = sign, .bound = most, .scale = one, .weights = weights, .remark = remark};
    }
    [[nodiscard]] BoundRule::Bound rule() const { return rule(bound, scale()); }
    [[nodiscard]] bool of_motor() const { return weights != std::array<double, 3>{}; }
    /// Where the motion comes nearest to the bound, or exceeds it most: sign · y^{(order)}, or the sum.
    [[nodiscard]] Extremum extreme_of(const Motion& motion) const;
};

}  // namespace camopt
