// SPDX-License-Identifier: MIT
// Internal to solvers/structured/: how far a point of an Nlp is from its rows and from stationarity.
#pragma once

#include "solvers/structured/convexified_hessian.hpp"
#include "solvers/structured/linearized_problem.hpp"

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <vector>

namespace camopt::structured {

using RowMatrix = Eigen::SparseMatrix<double, Eigen::RowMajor>;

[[nodiscard]] inline const RowKind& kind_of(const NlpShape& shape, Eigen::Index row) {
    return shape.rows[static_cast<std::size_t>(row)];
}

/// Largest violation of the rows that are linear or of those that are not, each relative to its scale; >= 0.
[[nodiscard]] double violation_of(const NlpShape& shape, const Eigen::VectorXd& rows, bool linear);

/// Every row to the tolerance of its scale, or to what rounding leaves of it.
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
    /// ‖∇L + z‖∞ with the best z for the bounds that x is at.
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

}  // namespace camopt::structured
