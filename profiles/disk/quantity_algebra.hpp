// SPDX-License-Identifier: MIT
// Sums, products and quotients of quantities of a cam, with their first and second partials.
#pragma once

#include "profiles/disk/disk_cam.hpp"

namespace camopt {

/// Where a dimension stands among the variables of a quantity; s, s', s'' stand at 0, 1, 2.
[[nodiscard]] constexpr int column_of(DimensionIndex dimension) {
    return 3 + static_cast<int>(dimension);
}

[[nodiscard]] QuantityValue constant_quantity(double value);
/// value with one partial 1: a variable. index: 0 s, 1 s', 2 s'', else column_of.
[[nodiscard]] QuantityValue variable_quantity(double value, int index);

[[nodiscard]] QuantityValue sum(double factor_a, const QuantityValue& a, double factor_b,
                                const QuantityValue& b);
[[nodiscard]] QuantityValue product(const QuantityValue& a, const QuantityValue& b);
[[nodiscard]] QuantityValue quotient(const QuantityValue& a, const QuantityValue& b);
[[nodiscard]] inline QuantityValue shifted(QuantityValue a, double by) {
    a.value += by;
    return a;
}
[[nodiscard]] inline QuantityValue scaled(const QuantityValue& a, double factor) {
    return {factor * a.value, factor * a.gradient, factor * a.hessian};
}

}  // namespace camopt
