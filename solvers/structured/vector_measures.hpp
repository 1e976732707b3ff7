// SPDX-License-Identifier: MIT
// Internal to solvers/structured/: measures of vectors in the inner loop, written so that they become vector
// instructions.
#pragma once

#include <Eigen/Core>

#include <cmath>

namespace camopt::structured {

/// max |v_i|, 0 for none. NaN may hide.
[[nodiscard]] inline double largest(const Eigen::VectorXd& v) {
    return v.size() > 0 ? v.cwiseAbs().maxCoeff() : 0.0;
}

/// Whether every entry is finite (and their sum, which for numbers of any use is the same).
[[nodiscard]] inline bool finite(const Eigen::VectorXd& v) {
    return std::isfinite(v.sum());
}

}  // namespace camopt::structured
