// SPDX-License-Identifier: MIT
// A rule over a box of its numbers (y, y', y'', y''', q_1 … q_m) at one cam angle, and planes that never lie
// above it there.
//
// With h the rule times something positive (PointRule::range_over), c the middle of the box and w half its
// widths,
//     L(z) = h(z) + ½ Σ_i a_i ((z_i − c_i)² − w_i²)  <=  h(z)   in the box, a_i >= 0,
// is convex where every a_i is at least −min h_ii + Σ_{j≠i} max |h_ij| w_j / w_i (Gershgorin's discs of the
// second partials, in units of w). Its tangent at any point of the box is the plane. Everything is enclosed
// and rounded outward; planes and rule differ by ½ Σ a_i w_i² at most beside the tangent's own error, a
// quantity that vanishes with the square of the widths.
// Source: C. Adjiman et al., A global optimization method, αBB, Comput. Chem. Eng. 22 (1998).
#pragma once

#include "objectives/rules/point_rule.hpp"

#include <Eigen/Core>

#include <optional>
#include <vector>

namespace camopt {

/// slope · z + constant <= h(z) for every z of the box: where the rule is kept that is <= 0.
struct RulePlane {
    Eigen::VectorXd slope;
    double constant = 0.0;
};

class RuleOverBox {
 public:
    /// `box`: 4 + m intervals; those of numbers the rule is curved in must be finite. Empty where the rule
    /// has no enclosure, or none that is finite in this box. The rule must outlive it.
    /// `at`: the cam angle's x.
    [[nodiscard]] static std::optional<RuleOverBox> make(const PointRule& rule, std::vector<Interval> box,
                                                         double at);

    [[nodiscard]] const std::vector<Interval>& box() const { return box_; }
    /// No value of h in the box is larger: below 0 the rule is kept by whatever lies in it.
    [[nodiscard]] double most() const { return most_; }
    /// ½ Σ a_i w_i², and the part of number i.
    [[nodiscard]] double secant_error() const;
    [[nodiscard]] double secant_error(int i) const;
    /// The rule is curved in number i.
    [[nodiscard]] bool is_curved(int i) const { return curved_[static_cast<std::size_t>(i)] != 0; }
    /// Tangent of L at the point of the box nearest to `at`; none where rounding leaves nothing finite.
    [[nodiscard]] std::optional<RulePlane> plane(const Eigen::VectorXd& at) const;

 private:
    RuleOverBox(const PointRule& rule, std::vector<Interval> box, double at)
        : rule_(&rule), at_(at), box_(std::move(box)) {}

    const PointRule* rule_;
    double at_;
    std::vector<Interval> box_;
    std::vector<char> curved_;
    std::vector<double> added_, middle_, half_;  ///< a, c, w
    double most_ = 0.0;
};

}  // namespace camopt
