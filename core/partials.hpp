// SPDX-License-Identifier: MIT
// Values with their first and second partials: sums and products of any type that has them, and numbers for
// automatic differentiation.
#pragma once

#include <Eigen/Core>
#include <unsupported/Eigen/AutoDiff>

namespace camopt {

// Sums and products of values with their first and second partials, for every type with the members value,
// gradient (n) and hessian (n x n, symmetric). by_angle, if present: the partial by a further variable
// without second partials.

template <class Value>
concept WithPartials = requires(Value value) {
    value.value;
    value.gradient;
    value.hessian;
};

template <WithPartials Value>
[[nodiscard]] Value operator+(Value a, const Value& b) {
    a.value += b.value;
    a.gradient += b.gradient;
    a.hessian += b.hessian;
    if constexpr (requires { a.by_angle; }) a.by_angle += b.by_angle;
    return a;
}

template <WithPartials Value>
[[nodiscard]] Value operator+(Value a, double by) {
    a.value += by;
    return a;
}

template <WithPartials Value>
[[nodiscard]] Value operator*(double factor, Value a) {
    a.value *= factor;
    a.gradient *= factor;
    a.hessian *= factor;
    if constexpr (requires { a.by_angle; }) a.by_angle *= factor;
    return a;
}

template <WithPartials Value>
[[nodiscard]] Value operator*(const Value& a, const Value& b) {
    Value result{a.value * b.value, a.value * b.gradient + b.value * a.gradient,
                 a.value * b.hessian + b.value * a.hessian};
    // Eigen would call its kernels for large matrices for products of this size.
    const auto cross = a.gradient.lazyProduct(b.gradient.transpose()).eval();
    result.hessian += cross + cross.transpose();
    if constexpr (requires { a.by_angle; }) result.by_angle = a.value * b.by_angle + b.value * a.by_angle;
    return result;
}

// Numbers that carry their first and second partials by n variables (forward automatic
// differentiation of Eigen, nested).

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
