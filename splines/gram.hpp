// SPDX-License-Identifier: MIT
//
// Energies of a spline as exact quadratic forms of its design vector.
//
//   (1/L) ∫ (y^{(r)})² dx = |R x + r|² = xᵀ Q x + 2 bᵀ x + c,   L = end − begin,
// from the local polynomials in closed form, without quadrature error. Values and slopes come from R x + r,
// which is y^{(r)} in orthonormal polynomials on each segment: a sum of squares. The three parts of
// xᵀ Q x + 2 bᵀ x + c exceed their sum by the square of (width of a motion / width of a segment)^r, and their
// sum suffers that cancellation.
#pragma once

#include "splines/design_vector.hpp"

#include <Eigen/SparseCore>

namespace camopt {

struct QuadraticForm {
    Eigen::SparseMatrix<double> matrix;                  ///< Q = Rᵀ R, symmetric, both triangles
    Eigen::VectorXd linear;                              ///< b = Rᵀ r
    Eigen::SparseMatrix<double, Eigen::RowMajor> roots;  ///< R
    Eigen::VectorXd offset;                              ///< r

    [[nodiscard]] double value(const Eigen::VectorXd& x) const { return (roots * x + offset).squaredNorm(); }
    /// Half the gradient: Q x + b.
    [[nodiscard]] Eigen::VectorXd slope(const Eigen::VectorXd& x) const {
        return roots.transpose() * (roots * x + offset);
    }
    /// factor times the form, in units of x: x = units · (new x). factor >= 0.
    void scale(double factor, const Eigen::VectorXd& units);
};

/// Sums energies of local polynomials into one form.
class EnergySum {
 public:
    explicit EnergySum(Eigen::Index variables) : variables_(variables) {}
    /// Adds weight · ∫_0^width (y^{(order)})² dt of one local polynomial.
    void add(const LocalMap& map, int order, double width, double weight);
    /// Adds weight · (row)² of a value of the design.
    void add(const AffineRow& row, double weight);
    /// `factor` times the sum.
    [[nodiscard]] QuadraticForm form(double factor) const;

 private:
    Eigen::Index variables_;
    std::vector<Eigen::Triplet<double>> roots_;
    std::vector<double> offset_;
};

}  // namespace camopt
