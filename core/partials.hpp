// SPDX-License-Identifier: MIT
// Sums and products of values with their first and second partials, for every type with the members value,
// gradient (n) and hessian (n x n, symmetric). by_angle, if present: the partial by a further variable
// without second partials.
#pragma once

namespace camopt {

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

}  // namespace camopt
