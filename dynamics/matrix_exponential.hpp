// SPDX-License-Identifier: MIT
// The exponential of a small dense matrix.
#pragma once

#include <Eigen/Core>

namespace camopt {

/// e^A of a square matrix, to a backward error of round-off in A; not a number where A is not finite.
[[nodiscard]] Eigen::MatrixXd exponential_of(Eigen::MatrixXd matrix);

}  // namespace camopt
