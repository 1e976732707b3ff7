// SPDX-License-Identifier: MIT
// Internal to solvers/structured/: a positive definite stand-in for the Hessian H of the Lagrangian.
//
// Where H is not positive definite, first  H + c NᵀN  is tried, N the unit normals of the rows that carry a
// multiplier. With the term  c Nᵀr  in the slope (r: distance of those rows from their bounds) this adds
// c/2 ‖N d + r‖², which is zero where the rows are kept: the step stays that of the true Hessian, and the
// sequence stays superlinear. Only where H curves down along the rows too, a multiple of I is added.
// Source: Bertsekas, Constrained Optimization and Lagrange Multiplier Methods (1982), section 4.2.
#pragma once

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <functional>

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

/// `lower`: triangle of H. `least`: multiple of I that is added in any case; it makes the step unique.
[[nodiscard]] ConvexifiedHessian convexified(const Eigen::SparseMatrix<double>& lower,
                                             const ActiveRows& active, double least);

}  // namespace camopt::structured
