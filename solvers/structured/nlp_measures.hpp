// SPDX-License-Identifier: MIT
// Internal to solvers/structured/: constraint violation and stationarity of a point of an Nlp.
#pragma once

#include "solvers/structured/linearized_problem.hpp"

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <cmath>
#include <functional>
#include <vector>

namespace camopt::structured {

// Internal to solvers/structured/: a positive definite approximation of the Hessian H of the Lagrangian.
//
// Where H is not positive definite, first  H + c NᵀN  is tried, N the unit normals of the rows that carry a
// multiplier. With the term  c Nᵀr  in the slope (r: distance of those rows from their bounds) this adds c/2
// ‖N d + r‖², which is zero on the rows: the step remains that of the true Hessian, and convergence
// superlinear. Only where H has negative curvature along the rows too, a multiple of I is added. Source:
// Bertsekas, Constrained Optimization and Lagrange Multiplier Methods (1982), section 4.2.
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

using RowMatrix = Eigen::SparseMatrix<double, Eigen::RowMajor>;

[[nodiscard]] inline const RowKind& kind_of(const NlpShape& shape, Eigen::Index row) {
    return shape.rows[static_cast<std::size_t>(row)];
}

/// Largest violation of the rows that are linear or of those that are not, each relative to its scale; >= 0.
[[nodiscard]] double violation_of(const NlpShape& shape, const Eigen::VectorXd& rows, bool linear);

/// Every row to the tolerance of its scale, or to round-off.
[[nodiscard]] bool keeps_rows(const NlpShape& shape, const NlpPoint& point, const RowMatrix& jacobian,
                              double tolerance);

/// Σ |λ_i| scale_i of the nonlinear rows: the least ν that makes the penalty exact.
[[nodiscard]] double needed_penalty(const NlpShape& shape, const Eigen::VectorXd& multipliers);

/// A point, its Jacobian, and multipliers of its rows.
struct Stationarity {
    const NlpShape& shape;
    const NlpPoint& point;
    const RowMatrix& jacobian;
    const Eigen::VectorXd& multipliers;

    [[nodiscard]] Eigen::VectorXd lagrangian_gradient() const;
    /// ‖∇L + z‖∞ with the best z for the active bounds of x.
    [[nodiscard]] double error() const;
    /// Rows and bounds that carry a multiplier, unless the point is further than `reach` from them.
    [[nodiscard]] ActiveRows active_rows(double reach) const;
};

/// −gradient where a finite bound of the right side exists, 0 elsewhere.
[[nodiscard]] Eigen::VectorXd bound_multipliers(const NlpShape& shape, const Eigen::VectorXd& gradient);

/// Variables in which the cost or some row is not linear.
[[nodiscard]] std::vector<bool> curved_variables(const NlpShape& shape);

/// Lower triangle of ∇²f + Σ λ_i ∇²g_i; entries that are not finite count as 0.
[[nodiscard]] Eigen::SparseMatrix<double> lagrangian_hessian(const Nlp& problem, const Eigen::VectorXd& x,
                                                             const Eigen::VectorXd& multipliers);

// Internal to solvers/structured/: norms of vectors in the inner loop, written for vectorization.

/// max |v_i|, 0 for none. NaN may hide.
[[nodiscard]] inline double largest(const Eigen::VectorXd& v) {
    return v.size() > 0 ? v.cwiseAbs().maxCoeff() : 0.0;
}

/// Whether every entry is finite (and their sum, which is equivalent for practical numbers).
[[nodiscard]] inline bool finite(const Eigen::VectorXd& v) {
    return std::isfinite(v.sum());
}

}  // namespace camopt::structured
