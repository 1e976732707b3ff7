// SPDX-License-Identifier: MIT
//
// Affine underestimators of a rule over a box of its variables (y, y', y'', y''', q_1 … q_m) at one cam angle
// (αBB relaxation; McCormick's planes of a product).
//
// With h the rule times a positive factor (PointRule::range_over), c the middle of the box and w half its
// widths,
//     L(z) = h(z) + ½ Σ_i a_i ((z_i − c_i)² − w_i²)  <=  h(z)   in the box, a_i >= 0,
// is convex where every a_i is at least −min h_ii + Σ_{j≠i} max |h_ij| w_j / w_i (Gershgorin's discs of the
// second partials, in units of w). Its tangent at any point of the box is the plane. Everything is enclosed
// and rounded outward; plane and rule differ by at most ½ Σ a_i w_i² plus the tangent's error, which is of
// second order in the widths.
//
// A rule that is curved in the product of two variables alone, h_ij of one sign and every other second
// partial 0, lies above its tangent at two opposite corners p of the box, for there
//     h(z) − tangent(z) = h_ij (z_i − p_i) (z_j − p_j) >= 0.
// Both tangents together are the convex envelope where h_ij is constant (y' y'' of a torque).
// Sources: G. McCormick, Computability of global solutions to factorable nonconvex programs I, Math. Program.
// 10 (1976); C. Adjiman et al., A global optimization method, αBB, Comput. Chem. Eng. 22 (1998).
#pragma once

#include "objectives/rules/point_rule.hpp"

namespace camopt {

/// slope · z + constant <= h(z) for every z of the box: <= 0 wherever the rule is satisfied.
struct RulePlane {
    Eigen::VectorXd slope;
    double constant = 0.0;
};

class RuleOverBox {
 public:
    /// `box`: 4 + m intervals; those of variables in which the rule is curved must be finite. Nullopt if the
    /// rule has no enclosure, or no finite one in this box. The rule must outlive it. `at`: the cam angle's
    /// x.
    [[nodiscard]] static std::optional<RuleOverBox> make(const PointRule& rule, std::vector<Interval> box,
                                                         double at);

    [[nodiscard]] const std::vector<Interval>& box() const { return box_; }
    /// An upper bound of h in the box: below 0 every point satisfies the rule.
    [[nodiscard]] double most() const { return most_; }
    /// The term of variable i in ½ Σ a_i w_i².
    [[nodiscard]] double secant_error(int i) const;
    /// The rule is curved in variable i.
    [[nodiscard]] bool is_curved(int i) const { return curved_[static_cast<std::size_t>(i)] != 0; }
    /// Tangent of L at the point of the box nearest to `at`, or of a product at the corner whose tangent is
    /// the higher there; nullopt if rounding leaves nothing finite.
    [[nodiscard]] std::optional<RulePlane> plane(const Eigen::VectorXd& at) const;

 private:
    RuleOverBox(const PointRule& rule, std::vector<Interval> box, double at)
        : rule_(&rule), at_(at), box_(std::move(box)) {}

    /// The only two variables in whose product the rule is curved.
    struct Product {
        std::size_t one = 0, other = 0;
        bool rising = true;  ///< h_ij >= 0
    };
    [[nodiscard]] static std::optional<Product> product_of(const RangeOver& range);
    [[nodiscard]] std::vector<double> tangent_point(const Eigen::VectorXd& at) const;

    const PointRule* rule_;
    double at_;
    std::vector<Interval> box_;
    std::vector<char> curved_;
    std::vector<double> added_, middle_, half_;  ///< a, c, w
    std::optional<Product> product_;
    double most_ = 0.0;
};

}  // namespace camopt
