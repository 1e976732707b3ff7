// SPDX-License-Identifier: MIT
// Splines: the space of piecewise polynomials on given breakpoints, its B-splines, a curve of it as a motion,
// and bounds on derivatives of such curves.
#pragma once

#include "core/motion.hpp"

#include <Eigen/Core>

namespace camopt {

/// Of the number nearest to the value; there is one.
[[nodiscard]] std::size_t nearest_index(const std::vector<double>& ascending, double value);

// The space of piecewise polynomials of degree p on breakpoints x_0 < … < x_n that are C^k at the interior
// ones.
//
// Dimension N = (p + 1) + (n − 1)(p − k). Clamped knots: ends of multiplicity p + 1, interior breakpoints of
// multiplicity p − k.

class SplineSpace {
 public:
    /// Throws InputError: degree < 1, continuity not in 0 … degree − 1, fewer than two breakpoints, not
    /// ascending.
    SplineSpace(int degree, int continuity, std::vector<double> breakpoints);
    [[nodiscard]] static SplineSpace uniform(int degree, int continuity, int segments, double length);

    [[nodiscard]] int degree() const { return degree_; }
    [[nodiscard]] int continuity() const { return continuity_; }
    [[nodiscard]] int segments() const { return static_cast<int>(breakpoints_.size()) - 1; }
    [[nodiscard]] int dimension() const { return degree_ + 1 + (segments() - 1) * (degree_ - continuity_); }
    [[nodiscard]] const std::vector<double>& breakpoints() const { return breakpoints_; }
    [[nodiscard]] double begin() const { return breakpoints_.front(); }
    [[nodiscard]] double end() const { return breakpoints_.back(); }
    [[nodiscard]] double width(int segment) const {
        return breakpoints_[segment + 1] - breakpoints_[segment];
    }

    [[nodiscard]] double knot(int index) const;
    [[nodiscard]] std::vector<double> knots() const;
    /// First of the degree + 1 basis functions with support on a segment.
    [[nodiscard]] int first_basis_function(int segment) const { return segment * (degree_ - continuity_); }

    /// The segment that contains x; at a breakpoint the one on `side`. Throws InputError outside [begin, end]
    /// (a round-off excess is clamped).
    [[nodiscard]] int segment_of(double x, Side side = Side::right) const;

    /// The index of the breakpoint nearest to x: that of one from which rounding has moved it.
    [[nodiscard]] int breakpoint_at(double x) const;

    /// Whether the breakpoints lie symmetrically about the middle, to round-off.
    [[nodiscard]] bool is_symmetric() const;

 private:
    int degree_, continuity_;
    std::vector<double> breakpoints_;
};

// Conversion between B-splines and local polynomials.
//
// On segment i with t = x − x_i a spline is Σ_m a_m t^m and also Σ_j c_j N_j(x) over the degree + 1 basis
// functions with support there, j = first_basis_function(i) … + degree. Source: de Boor, A Practical Guide to
// Splines (recurrence, blossom); nothing here is specific to a degree.

/// M, (degree + 1) x (degree + 1), with a = M c on this segment: column j holds N_j^{(m)}(x_i+) / m!.
[[nodiscard]] Eigen::MatrixXd monomials_of_basis(const SplineSpace& space, int segment);

/// w with c_j = wᵀ a: the blossom of t^m at the knots of basis function j, for a segment in its support.
[[nodiscard]] Eigen::RowVectorXd blossom_weights(const SplineSpace& space, int function, int segment);

// A piecewise polynomial motion y(x) of degree p on breakpoints x_0 < … < x_n with continuity C^k.
//
// On segment i, with t = x − x_i:  y = Σ_{m=0}^{p} a_{i,m} t^m.  Its B-spline form has clamped knots: end
// knots of multiplicity p + 1, interior breakpoints of multiplicity p − k. No units: x in rises, y in lifts.
// Outside [x_0, x_n]: InputError.

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

    [[nodiscard]] std::vector<double> knots() const { return space_.knots(); }
    /// Control points over knots(), by the blossom of the local polynomial.
    [[nodiscard]] Eigen::VectorXd coefficients() const;

 private:
    SplineSpace space_;
    Eigen::MatrixXd pieces_;
};

// Bounds on the derivatives of a spline from bounds on some of them.
//
// Lower derivatives by integration from either end, where the end states are known: |y^{(r-1)}| <= |end
// value| + L B_r / 2 (from the nearer end). Higher ones by V. A. Markov's inequality (1892) on each segment
// of width h: a polynomial of degree d with |p| <= B has |p^(r)| <= T_d^(r)(1) (2 / h)^r B, T_d the Chebyshev
// polynomial, T_d^(r)(1) = Π_{k < r} (d² − k²) / (2 k + 1). The mean square of y^{(r)} bounds y^{(r-1)} by
// the Cauchy–Schwarz inequality: |y^{(r-1)}| <= |end value| + L rms.

struct KnownBounds {
    std::array<double, 4> sup{};  ///< bounds on |y^{(r)}|, r = 0 … 3; infinity: no bound
    std::array<double, 4> rms{};  ///< bounds on the root mean square, likewise
    std::array<double, 3> begin_state{}, end_state{};
};

/// (degree + 1) x segments: |y^{(m)}| on segment i is at most result(m, i). Infinite without a bound.
[[nodiscard]] Eigen::MatrixXd derivative_bounds(const SplineSpace& space, const KnownBounds& known);

// Exact extrema of piecewise polynomials: ends of every segment from both sides, and every stationary point
// inside.

/// Coefficients, ascending in t = x − x_i, of a function on one segment.
using SegmentFunction = std::function<Eigen::VectorXd(int segment)>;

/// Appends to `all` where a polynomial of x − begin may be largest or least: the two ends (from inside) and
/// the stationary points, ascending.
void add_candidates(double begin, double end, const Eigen::VectorXd& polynomial, std::vector<Extremum>& all);

/// The extremum of largest magnitude; `value` is that magnitude. Of locations within 1e-8 of it, of which an
/// optimum has many, `at` is the first.
[[nodiscard]] Extremum largest_magnitude(const SplineSpace& space, const SegmentFunction& function);

/// Exact: max |y^{(order)}|, its root mean square, and max |y' y''|. order >= 1.
[[nodiscard]] Extremum peak_of(const SplineCurve& curve, int order);
[[nodiscard]] double mean_of(const SplineCurve& curve, int order);
[[nodiscard]] Extremum torque_peak_of(const SplineCurve& curve);

/// V, A, J, Q exactly, and the root mean squares.
[[nodiscard]] Peaks peaks_of(const SplineCurve& curve);

}  // namespace camopt
