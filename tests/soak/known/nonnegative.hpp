// SPDX-License-Identifier: MIT
// Non-negative least squares: which of many rows balance each other, and with which multipliers.
#pragma once

#include <Eigen/Core>

#include <optional>

namespace camopt::soak {

/// x >= 0 with A x = b, by Lawson and Hanson's active sets (Solving Least Squares Problems, 1974, chapter
/// 23): the columns with x > 0 are linearly independent. Columns with large norms are taken first. Nullopt:
/// there is none to 1e-11 of b.
[[nodiscard]] std::optional<Eigen::VectorXd> balanced(const Eigen::MatrixXd& a, const Eigen::VectorXd& b);

}  // namespace camopt::soak
