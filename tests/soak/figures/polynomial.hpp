// SPDX-License-Identifier: MIT
// Polynomials of low degree in long double, with extremes by the roots of their derivatives.
#pragma once

#include <vector>

namespace camopt::soak {

/// c[0] + c[1] u + c[2] u² + …
using Polynomial = std::vector<long double>;

[[nodiscard]] long double value_at(const Polynomial& polynomial, long double u);
[[nodiscard]] Polynomial derivative_of(const Polynomial& polynomial);
[[nodiscard]] Polynomial product_of(const Polynomial& left, const Polynomial& right);
/// Roots in (low, high) where the sign changes, ascending: between neighbouring extremes, by bisection.
[[nodiscard]] std::vector<long double> roots_within(const Polynomial& polynomial, long double low,
                                                    long double high);
/// The largest magnitude in [low, high].
[[nodiscard]] long double largest_magnitude(const Polynomial& polynomial, long double low, long double high);

}  // namespace camopt::soak
