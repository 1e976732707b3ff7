// SPDX-License-Identifier: MIT
// Sums, products and quotients of quantities of a disk cam, with their first and second partials: a
// QuantityValue is written in formulas as a RangeAlong and a RangeOver are.
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

[[nodiscard]] QuantityValue operator+(QuantityValue a, const QuantityValue& b);
[[nodiscard]] QuantityValue operator+(QuantityValue a, double by);
[[nodiscard]] QuantityValue operator*(double factor, QuantityValue a);
[[nodiscard]] QuantityValue operator*(const QuantityValue& a, const QuantityValue& b);

}  // namespace camopt
