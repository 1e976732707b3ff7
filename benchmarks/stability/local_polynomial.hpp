// SPDX-License-Identifier: MIT
// p(u) = Σ_m c_m u^m on [0, 1] in long double: values, roots, the largest magnitude.
#pragma once

#include <vector>

namespace camopt::stability {

using LocalPolynomial = std::vector<long double>;  ///< ascending powers; empty: 0

[[nodiscard]] long double value_at(const LocalPolynomial& polynomial, long double u);
[[nodiscard]] LocalPolynomial derivative_of(const LocalPolynomial& polynomial);
/// Ascending, where the polynomial changes its sign in (0, 1): between its stationary points by bisection.
[[nodiscard]] std::vector<long double> sign_changes(const LocalPolynomial& polynomial);
[[nodiscard]] long double largest_magnitude(const LocalPolynomial& polynomial);

}  // namespace camopt::stability
