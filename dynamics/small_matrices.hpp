// SPDX-License-Identifier: MIT
// Factors of dense matrices of a few rows, of which a train needs a handful: in one source, compiled with
// -O1, since Eigen's templates cost the compiler far more time than they ever run.
#pragma once

#include <Eigen/Core>

namespace camopt {

/// e^A of a square matrix, to a backward error of round-off in A; not a number where A is not finite.
[[nodiscard]] Eigen::MatrixXd exponential_of(Eigen::MatrixXd matrix);

/// R of A = Q R: square, upper triangular, RᵀR = AᵀA. At least as many rows as columns.
[[nodiscard]] Eigen::MatrixXd triangular_root(const Eigen::MatrixXd& matrix);

/// Of a regular square matrix.
[[nodiscard]] Eigen::MatrixXd inverse_of(const Eigen::MatrixXd& matrix);

/// x of A x = b with both pivots; the component along a direction that a singular A loses is 0.
[[nodiscard]] Eigen::VectorXd solution_of(const Eigen::MatrixXd& matrix, const Eigen::VectorXd& right);

/// Ascending.
[[nodiscard]] Eigen::VectorXd singular_values(const Eigen::MatrixXd& matrix);

/// A = right · diag(values) · left, of a matrix that has a basis of eigenvectors.
struct Eigenvectors {
    Eigen::VectorXcd values;
    Eigen::MatrixXcd right, left;
};
[[nodiscard]] Eigenvectors eigenvectors_of(const Eigen::MatrixXd& matrix);

}  // namespace camopt
