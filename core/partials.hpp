// SPDX-License-Identifier: MIT
// Values with their first and second partials: sums and products of any type that has them, and numbers for
// automatic differentiation.
#pragma once

#include <Eigen/Core>

#include <array>
#include <cmath>

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

// Numbers that carry their first and second partials by n variables (forward automatic differentiation).

/// f(u) by the chain rule. Where a function is not smooth its partials are those of one side, or not finite.
template <int n>
struct SecondOrder {
    static constexpr std::size_t variables = n, pairs = n * (n + 1) / 2;

    double value = 0.0;
    std::array<double, variables> first = {};
    std::array<double, pairs> second = {};  ///< ∂²/∂i∂j for j <= i, row by row

    SecondOrder() = default;
    SecondOrder(double constant) : value(constant) {}  // NOLINT(google-explicit-constructor): a number is one

    [[nodiscard]] static constexpr std::size_t pair(std::size_t i, std::size_t j) {
        return i < j ? pair(j, i) : i * (i + 1) / 2 + j;
    }
    [[nodiscard]] Eigen::Matrix<double, n, 1> gradient() const {
        return Eigen::Map<const Eigen::Matrix<double, n, 1>>(first.data());
    }
    [[nodiscard]] Eigen::Matrix<double, n, n> hessian() const {
        Eigen::Matrix<double, n, n> full;
        for (std::size_t i = 0; i < variables; ++i)
            for (std::size_t j = 0; j <= i; ++j) full(i, j) = full(j, i) = second[pair(i, j)];
        return full;
    }

    SecondOrder& operator+=(const SecondOrder& by) {
        value += by.value;
        for (std::size_t i = 0; i < variables; ++i) first[i] += by.first[i];
        for (std::size_t k = 0; k < pairs; ++k) second[k] += by.second[k];
        return *this;
    }
    SecondOrder& operator-=(const SecondOrder& by) {
        value -= by.value;
        for (std::size_t i = 0; i < variables; ++i) first[i] -= by.first[i];
        for (std::size_t k = 0; k < pairs; ++k) second[k] -= by.second[k];
        return *this;
    }
    SecondOrder& operator*=(double factor) {
        value *= factor;
        for (double& one : first) one *= factor;
        for (double& one : second) one *= factor;
        return *this;
    }
    SecondOrder& operator*=(const SecondOrder& by) { return *this = *this * by; }
    SecondOrder& operator/=(const SecondOrder& by) { return *this = *this / by; }

    friend SecondOrder operator+(SecondOrder a, const SecondOrder& b) { return a += b; }
    friend SecondOrder operator+(SecondOrder a, double b) {
        a.value += b;
        return a;
    }
    friend SecondOrder operator+(double a, SecondOrder b) { return std::move(b) + a; }
    friend SecondOrder operator-(SecondOrder a, const SecondOrder& b) { return a -= b; }
    friend SecondOrder operator-(SecondOrder a, double b) { return std::move(a) + -b; }
    friend SecondOrder operator-(double a, const SecondOrder& b) { return -b + a; }
    friend SecondOrder operator+(const SecondOrder& a) { return a; }
    friend SecondOrder operator-(SecondOrder a) { return a *= -1.0; }
    friend SecondOrder operator*(SecondOrder a, double b) { return a *= b; }
    friend SecondOrder operator*(double a, SecondOrder b) { return b *= a; }
    friend SecondOrder operator*(const SecondOrder& a, const SecondOrder& b) {
        SecondOrder product(a.value * b.value);
        std::size_t k = 0;
        for (std::size_t i = 0; i < variables; ++i) {
            product.first[i] = a.value * b.first[i] + b.value * a.first[i];
            for (std::size_t j = 0; j <= i; ++j, ++k)
                product.second[k] = a.value * b.second[k] + b.value * a.second[k] + a.first[i] * b.first[j] +
                                    a.first[j] * b.first[i];
        }
        return product;
    }
    friend SecondOrder operator/(SecondOrder a, double b) { return a *= 1.0 / b; }
    friend SecondOrder operator/(const SecondOrder& a, const SecondOrder& b) {
        const double inverse = 1.0 / b.value;
        SecondOrder quotient(a.value * inverse);
        std::size_t k = 0;
        for (std::size_t i = 0; i < variables; ++i) {
            quotient.first[i] = (a.first[i] - quotient.value * b.first[i]) * inverse;
            for (std::size_t j = 0; j <= i; ++j, ++k)
                quotient.second[k] = (a.second[k] - quotient.value * b.second[k] -
                                      quotient.first[i] * b.first[j] - quotient.first[j] * b.first[i]) *
                                     inverse;
        }
        return quotient;
    }

    friend bool operator<(const SecondOrder& a, const SecondOrder& b) { return a.value < b.value; }
    friend bool operator>(const SecondOrder& a, const SecondOrder& b) { return a.value > b.value; }
    friend bool operator<=(const SecondOrder& a, const SecondOrder& b) { return a.value <= b.value; }
    friend bool operator>=(const SecondOrder& a, const SecondOrder& b) { return a.value >= b.value; }

    /// f(u) with f, f' and f'' there.
    [[nodiscard]] static SecondOrder chained(const SecondOrder& u, double f, double slope, double bend) {
        SecondOrder result(f);
        std::size_t k = 0;
        for (std::size_t i = 0; i < variables; ++i) {
            result.first[i] = slope * u.first[i];
            const double bent = bend * u.first[i];
            for (std::size_t j = 0; j <= i; ++j, ++k)
                result.second[k] = slope * u.second[k] + bent * u.first[j];
        }
        return result;
    }

    friend SecondOrder sqrt(const SecondOrder& u) {
        const double root = std::sqrt(u.value), slope = 0.5 / root;
        return chained(u, root, slope, -0.5 * slope / u.value);
    }
    friend SecondOrder exp(const SecondOrder& u) {
        const double e = std::exp(u.value);
        return chained(u, e, e, e);
    }
    friend SecondOrder log(const SecondOrder& u) {
        return chained(u, std::log(u.value), 1.0 / u.value, -1.0 / (u.value * u.value));
    }
    /// For b = 0, 1, 2, … everywhere.
    friend SecondOrder pow(const SecondOrder& u, double b) {
        return chained(u, std::pow(u.value, b), b == 0.0 ? 0.0 : b * std::pow(u.value, b - 1.0),
                       b == 0.0 || b == 1.0 ? 0.0 : b * (b - 1.0) * std::pow(u.value, b - 2.0));
    }
    friend SecondOrder pow(const SecondOrder& u, const SecondOrder& b) { return exp(b * log(u)); }
    friend SecondOrder pow(double u, const SecondOrder& b) { return exp(b * std::log(u)); }
    friend SecondOrder sin(const SecondOrder& u) {
        const double sine = std::sin(u.value);
        return chained(u, sine, std::cos(u.value), -sine);
    }
    friend SecondOrder cos(const SecondOrder& u) {
        const double cosine = std::cos(u.value);
        return chained(u, cosine, -std::sin(u.value), -cosine);
    }
    friend SecondOrder tan(const SecondOrder& u) {
        const double tangent = std::tan(u.value), slope = 1.0 + tangent * tangent;
        return chained(u, tangent, slope, 2.0 * tangent * slope);
    }
    friend SecondOrder asin(const SecondOrder& u) {
        const double rest = 1.0 - u.value * u.value, root = std::sqrt(rest);
        return chained(u, std::asin(u.value), 1.0 / root, u.value / (rest * root));
    }
    friend SecondOrder acos(const SecondOrder& u) {
        const double rest = 1.0 - u.value * u.value, root = std::sqrt(rest);
        return chained(u, std::acos(u.value), -1.0 / root, -u.value / (rest * root));
    }
    friend SecondOrder atan(const SecondOrder& u) {
        const double sum = 1.0 + u.value * u.value;
        return chained(u, std::atan(u.value), 1.0 / sum, -2.0 * u.value / (sum * sum));
    }
    friend SecondOrder atan2(const SecondOrder& y, const SecondOrder& x) {
        // Its partials are those of atan(y / x), or of −atan(x / y) where x is the smaller one.
        const bool steep = std::abs(y.value) > std::abs(x.value);
        SecondOrder angle = steep ? -atan(x / y) : atan(y / x);
        angle.value = std::atan2(y.value, x.value);
        return angle;
    }
    friend SecondOrder sinh(const SecondOrder& u) {
        const double sine = std::sinh(u.value);
        return chained(u, sine, std::cosh(u.value), sine);
    }
    friend SecondOrder cosh(const SecondOrder& u) {
        const double cosine = std::cosh(u.value);
        return chained(u, cosine, std::sinh(u.value), cosine);
    }
    friend SecondOrder tanh(const SecondOrder& u) {
        const double tangent = std::tanh(u.value), slope = 1.0 - tangent * tangent;
        return chained(u, tangent, slope, -2.0 * tangent * slope);
    }
    friend SecondOrder abs(const SecondOrder& u) { return u.value < 0.0 ? -u : u; }
    friend SecondOrder min(const SecondOrder& a, const SecondOrder& b) { return b.value < a.value ? b : a; }
    friend SecondOrder max(const SecondOrder& a, const SecondOrder& b) { return a.value < b.value ? b : a; }
};

/// Depends on none of the n variables.
template <int n>
[[nodiscard]] SecondOrder<n> constant(double value) {
    return SecondOrder<n>(value);
}

/// The variable `index` of n.
template <int n>
[[nodiscard]] SecondOrder<n> variable(double value, int index) {
    SecondOrder<n> result(value);
    result.first[static_cast<std::size_t>(index)] = 1.0;
    return result;
}

}  // namespace camopt
