// SPDX-License-Identifier: MIT
// The one linear rule on the motion between two angles: a limit of either side, an edge of a corridor, the
// range of a stroke or of a displacement that is free, a limit of a motor that follows the motion, the
// epigraph of a peak. Of several motions on one master: a clearance (objectives/machine/machine_problem.hpp).
//
//   (sign · y^{(order)} − bound) / scale − q <= 0   or, of a motor,   (w · (y', y'', 1) − bound) / scale <= 0
//
// y in lifts, x in unit angles. q: a peak in units of `scale`; with bound 0 and both signs q is at least
// max |y^{(order)}| / scale. A limit has none.
#pragma once

#include "objectives/rules/model.hpp"

namespace camopt {

struct LinearBound {
    std::string key;  ///< "limits.acceleration_m_s2.min", "motion.corridor[0].displacement_mm.min"
    int order = 0, sign = 1;
    double bound = 0.0;
    double scale = 1.0;               ///< exceeding the bound by this is a violation of 100 %; > 0
    std::array<double, 3> weights{};  ///< of y', y'' and 1: of a motor, whose order is 2
    std::string remark = {};          ///< tells rows of one key apart
    int peak = -1;                    ///< the parameter of the problem that is q; −1: a limit

    double from = -infinity, until = infinity;  ///< x; the same: at this x alone
    int stretch = -1;                           ///< of the family; −1: any
    PlacedRule::Datum datum = PlacedRule::Datum::zero;
    bool on_copies = false;  ///< as in PlacedRule
    SeenMotion seen = SeenMotion::output;

    RowFields fields = {};             ///< as in RuleData
    bool starts_without_rows = false;  ///< as in RuleData
    /// Of a rule that is active at both ends of a stroke, from `begin` to `end`, and leaves its bound there
    /// with the powers b and e of the distance: violations are scaled by (2 ξ)^b (2 (1 − ξ))^e, ξ = 0 … 1
    /// along the stroke. Active at one end only: by ξ^b or (1 − ξ)^e, so that the other end counts.
    int contact_begin = 0, contact_end = 0;
    double begin = 0.0, end = 1.0;
    bool touches_begin = true, touches_end = true;

    [[nodiscard]] bool touches() const { return contact_begin > 0 || contact_end > 0; }
    [[nodiscard]] bool of_motor() const { return weights != std::array<double, 3>{}; }
    [[nodiscard]] PlacedRule rule() const;
};

/// A limit as the scene has it.
struct WrittenBound : LinearBound {
    std::string name;             ///< "acceleration_min", "corridor_displacement_max"
    std::string unit;             ///< of the key; empty: normalised
    double given = 0.0;           ///< in the unit
    double per_normalised = 1.0;  ///< the unit's number for y^{(order)} = 1
    int corridor = -1;            ///< which one it is of; −1: a limit
    bool magnitude = false;       ///< its values are shown without their sign
};

class LinearRule final : public PointRule {
 public:
    explicit LinearRule(const LinearBound& bound);

    [[nodiscard]] double scale_at(double x) const override;
    [[nodiscard]] double rounding() const override;
    [[nodiscard]] RuleValue evaluate(const MotionPoint& point, const Eigen::VectorXd& q) const override;
    /// Of a jerk without its second derivative, which needs the fifth of y.
    [[nodiscard]] std::optional<RangeAlong> range_along(const Interval& x,
                                                        const std::array<Interval, 5>& derivatives,
                                                        const Eigen::VectorXd& q) const override;

 private:
    LinearBound bound_;
};

}  // namespace camopt
