// SPDX-License-Identifier: MIT
// The largest value of a polynomial on [0, 1], between bounds: in Bernstein form a polynomial never leaves
// the range of its coefficients, and halves of the interval are looked at until the bounds meet.
#pragma once

#include <Eigen/Core>

#include <optional>

namespace camopt {

struct PolynomialMaximum {
    double value = 0.0, at = 0.0;
};

/// Right to rounding; empty where the polynomial is nowhere above `floor`. Coefficients ascending, from one
/// to 28 of them.
[[nodiscard]] std::optional<PolynomialMaximum> bounded_maximum(
    const Eigen::Ref<const Eigen::VectorXd>& polynomial, double floor);

}  // namespace camopt
