// SPDX-License-Identifier: MIT
// Internal to solvers/structured/: a positive definite approximation of the Hessian H of the Lagrangian.
//
// Where H is not positive definite, first  H + c NᵀN  is tried, N the unit normals of the rows that carry a
// multiplier. With the term  c Nᵀr  in the slope (r: distance of those rows from their bounds) this adds c/2
// ‖N d + r‖², which is zero on the rows: the step remains that of the true Hessian, and convergence
// superlinear. Only where H has negative curvature along the rows too, a multiple of I is added. Source:
// Bertsekas, Constrained Optimization and Lagrange Multiplier Methods (1982), section 4.2.
#pragma once

#include "linear/sparse_symmetric.hpp"

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <functional>
#include <memory>
#include <vector>

namespace camopt::structured {

struct ActiveRows {
    Eigen::SparseMatrix<double, Eigen::RowMajor> normals;  ///< N
    Eigen::VectorXd residuals;                             ///< r

    /// Those of its rows that `chosen` names.
    [[nodiscard]] ActiveRows part(const std::function<bool(Eigen::Index)>& chosen) const;
};

struct ConvexifiedHessian {
    Eigen::SparseMatrix<double> lower;  ///< triangle
    Eigen::VectorXd slope;              ///< c Nᵀr
    double shift = 0.0;                 ///< multiple of I, beyond the proximal one
    bool holds = false;                 ///< to the active rows: c > 0
};

/// Keeps the pattern of the matrices tried, and its analysis, from one pass to the next: it grows where a row
/// is active for the first time.
class HessianConvexifier {
 public:
    using Matrix = Eigen::SparseMatrix<double>;
    /// `lower`: triangle of H. `least`: multiple of I that is added in any case; it makes the step unique.
    [[nodiscard]] ConvexifiedHessian convexified(const Matrix& lower, const ActiveRows& active, double least);

 private:
    void read(const Matrix& lower, const ActiveRows& active, double least);
    [[nodiscard]] bool read_values(const Matrix& lower, const ActiveRows& active);
    void grow(const Matrix& lower, const ActiveRows& active);
    /// H + weight NᵀN + shift I, left in trial_ without the shift.
    [[nodiscard]] bool is_definite(double weight, double shift);
    [[nodiscard]] double least_shift(double weight, double bound);

    Matrix trial_;                ///< lower triangle, every diagonal entry stored
    Eigen::VectorXd own_, gram_;  ///< values of H + least I, and of NᵀN, in the order of trial_
    std::unique_ptr<SymmetricFactor> factor_;
    std::vector<int> place_;  ///< of every row in a column of trial_; −1: no entry
};

}  // namespace camopt::structured
