// SPDX-License-Identifier: MIT
// The nearest point that satisfies A x + a = 0: x − Aᵀ (A Aᵀ)⁻¹ (A x + a), repeated until round-off.
#pragma once

#include "splines/design_vector.hpp"

#include <Eigen/Core>
#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>

#include <vector>

namespace camopt {

/// The row over x = x_physical / column_scale, divided by its largest weight.
[[nodiscard]] AffineRow unit_row(const AffineRow& row, const Eigen::VectorXd& column_scale);

class EqualityProjection {
 public:
    /// rows: independent. column_scale: x_physical = column_scale · x.
    EqualityProjection(const std::vector<Equality>& rows, const Eigen::VectorXd& column_scale);

    [[nodiscard]] Eigen::VectorXd project(Eigen::VectorXd x) const;
    [[nodiscard]] const Eigen::SparseMatrix<double>& matrix() const { return matrix_; }
    [[nodiscard]] const Eigen::VectorXd& offset() const { return offset_; }

 private:
    Eigen::SparseMatrix<double> matrix_;
    Eigen::VectorXd offset_;
    Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> normal_;
};

}  // namespace camopt
