// SPDX-License-Identifier: MIT
// Constants and variables as quantities of a disk cam. Formulas use a QuantityValue like a RangeAlong or a
// RangeOver (core/partials.hpp).
#pragma once

#include "core/partials.hpp"
#include "profiles/disk/disk_cam.hpp"

namespace camopt {

/// The index of a dimension among the variables of a quantity; s, s', s'' have 0, 1, 2.
[[nodiscard]] constexpr int column_of(DimensionIndex dimension) {
    return 3 + static_cast<int>(dimension);
}

[[nodiscard]] QuantityValue constant_quantity(double value);
/// value with one partial 1: a variable. index: 0 s, 1 s', 2 s'', else column_of.
[[nodiscard]] QuantityValue variable_quantity(double value, int index);

}  // namespace camopt
