// SPDX-License-Identifier: MIT
// Constants and variables as quantities of a disk cam. A QuantityValue is written in formulas as a RangeAlong
// and a RangeOver are (core/partials.hpp).
#pragma once

#include "core/partials.hpp"
#include "profiles/disk/disk_cam.hpp"

namespace camopt {

/// Where a dimension stands among the variables of a quantity; s, s', s'' stand at 0, 1, 2.
[[nodiscard]] constexpr int column_of(DimensionIndex dimension) {
    return 3 + static_cast<int>(dimension);
}

[[nodiscard]] QuantityValue constant_quantity(double value);
/// value with one partial 1: a variable. index: 0 s, 1 s', 2 s'', else column_of.
[[nodiscard]] QuantityValue variable_quantity(double value, int index);

}  // namespace camopt
