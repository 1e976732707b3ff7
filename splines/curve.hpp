// SPDX-License-Identifier: MIT
// A piecewise polynomial motion y(x) of degree p on breakpoints x_0 < … < x_n with continuity C^k.
//
// On segment i, with t = x − x_i:  y = Σ_{m=0}^{p} a_{i,m} t^m.  Its B-spline form has clamped knots: end
// knots of multiplicity p + 1, interior breakpoints of multiplicity p − k. No units: x in rises, y in lifts.
// Outside [x_0, x_n]: InputError.
#pragma once

#include "core/motion.hpp"
#include "splines/space.hpp"

#include <Eigen/Core>

#include <vector>

namespace camopt {

class SplineCurve final : public Motion {
 public:
    /// pieces: (degree + 1) x segments, column i holds a_{i,0} … a_{i,p}. The caller guarantees the
    /// continuity (to round-off); throws InputError for sizes that do not match or values that are not
    /// finite.
    SplineCurve(SplineSpace space, Eigen::MatrixXd pieces);

    /// From B-spline control points over the clamped knots of the space.
    [[nodiscard]] static SplineCurve from_coefficients(const SplineSpace& space,
                                                       const Eigen::VectorXd& coefficients);

    [[nodiscard]] const SplineSpace& space() const { return space_; }
    [[nodiscard]] int degree() const { return space_.degree(); }
    [[nodiscard]] int continuity() const { return space_.continuity(); }
    [[nodiscard]] int segments() const { return space_.segments(); }
    [[nodiscard]] const Eigen::MatrixXd& pieces() const { return pieces_; }

    [[nodiscard]] double begin() const override { return space_.begin(); }
    [[nodiscard]] double end() const override { return space_.end(); }
    [[nodiscard]] MotionPoint at(double x, Side side = Side::right) const override;
    [[nodiscard]] std::vector<double> breakpoints() const override { return space_.breakpoints(); }

    /// The r-th derivative at x, any r >= 0 (zero above the degree), as seen from `side`.
    [[nodiscard]] double derivative(double x, int order, Side side = Side::right) const;
    /// Coefficients (ascending powers of t) of the r-th derivative on segment i; degree − r + 1 of them, at
    /// least 1.
    [[nodiscard]] Eigen::VectorXd derivative_polynomial(int segment, int order) const;
    /// The same into `out`, which has the right size.
    void derivative_polynomial(int segment, int order, Eigen::Ref<Eigen::VectorXd> out) const;

    [[nodiscard]] std::vector<double> knots() const { return space_.knots(); }
    /// Control points over knots(), by the blossom of the local polynomial.
    [[nodiscard]] Eigen::VectorXd coefficients() const;

 private:
    SplineSpace space_;
    Eigen::MatrixXd pieces_;
};

}  // namespace camopt
