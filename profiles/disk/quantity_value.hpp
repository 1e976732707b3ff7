// SPDX-License-Identifier: MIT
// A quantity of a disk cam with its partials; constants and variables of the formulas. Formulas use a
// QuantityValue like a RangeAlong or a RangeOver (core/partials.hpp).
#pragma once

#include "profiles/disk/disk_spec.hpp"

#include <Eigen/Core>

namespace camopt {

/// Variables of the partials: (s, s', s'', six dimensions by DimensionIndex).
inline constexpr int quantity_variables = 3 + dimension_count;

/// A quantity with exact first and second partials (automatic differentiation of the formulas above).
struct QuantityValue {
    double value = 0.0;
    Eigen::Matrix<double, quantity_variables, 1> gradient;
    Eigen::Matrix<double, quantity_variables, quantity_variables> hessian;
};

/// The index of a dimension among the variables of a quantity; s, s', s'' have 0, 1, 2.
[[nodiscard]] constexpr int column_of(DimensionIndex dimension) {
    return 3 + static_cast<int>(dimension);
}

[[nodiscard]] QuantityValue constant_quantity(double value);
/// value with one partial 1: a variable. index: 0 s, 1 s', 2 s'', else column_of.
[[nodiscard]] QuantityValue variable_quantity(double value, int index);

}  // namespace camopt
