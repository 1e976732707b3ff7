// SPDX-License-Identifier: MIT
// Numbers that carry their first and second partials by n variables (forward automatic
// differentiation of Eigen, nested).
#pragma once

#include <Eigen/Core>
#include <unsupported/Eigen/AutoDiff>

namespace camopt {

template <int n>
using FirstOrder = Eigen::AutoDiffScalar<Eigen::Matrix<double, n, 1>>;
template <int n>
using SecondOrder = Eigen::AutoDiffScalar<Eigen::Matrix<FirstOrder<n>, n, 1>>;

/// Depends on none of the n variables.
template <int n>
[[nodiscard]] SecondOrder<n> constant(double value) {
    SecondOrder<n> result;
    result.value() = FirstOrder<n>(value);
    for (int i = 0; i < n; ++i) result.derivatives()(i) = FirstOrder<n>(0.0);
    return result;
}

/// The variable `index` of n.
template <int n>
[[nodiscard]] SecondOrder<n> variable(double value, int index) {
    SecondOrder<n> result = constant<n>(value);
    result.value() = FirstOrder<n>(value, n, index);
    result.derivatives()(index) = FirstOrder<n>(1.0);
    return result;
}

/// Second partials; mixed ones differ by rounding in the order they are taken.
template <int n>
[[nodiscard]] Eigen::Matrix<double, n, n> second_partials(const SecondOrder<n>& result) {
    Eigen::Matrix<double, n, n> partials;
    for (int i = 0; i < n; ++i) partials.col(i) = result.derivatives()(i).derivatives();
    return partials;
}

}  // namespace camopt
