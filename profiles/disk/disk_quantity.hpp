// SPDX-License-Identifier: MIT
// Quantities of a disk cam: constants and variables of the formulas, and enclosures.
#pragma once

#include "core/numbers/enclosures.hpp"
#include "core/partials.hpp"
#include "profiles/disk/disk_cam.hpp"

#include <array>

namespace camopt {

// Constants and variables as quantities of a disk cam. Formulas use a QuantityValue like a RangeAlong or a
// RangeOver (core/partials.hpp).

/// The index of a dimension among the variables of a quantity; s, s', s'' have 0, 1, 2.
[[nodiscard]] constexpr int column_of(DimensionIndex dimension) {
    return 3 + static_cast<int>(dimension);
}

[[nodiscard]] QuantityValue constant_quantity(double value);
/// value with one partial 1: a variable. index: 0 s, 1 s', 2 s'', else column_of.
[[nodiscard]] QuantityValue variable_quantity(double value, int index);

// Enclosures of quantities of a disk cam over an interval of the cam angle, and over a box of motions and
// dimensions: of their values and derivatives, by the formulas of disk_cam.hpp (disk_cam_formulas.hpp).

/// Slopes and second derivatives by the cam angle. Unbounded where the formula may divide by zero somewhere
/// in the interval. Throws ModelError if the follower has no such quantity.
[[nodiscard]] RangeAlong quantity(const DiskCam& cam, const StateAlong& state, MechanismQuantity which);

/// s, s', s'' and the dimensions, each a number, a separate interval, or a function of the box's variables.
struct StateOver {
    RangeOver s, velocity, acceleration;
    std::array<RangeOver, dimension_count> dimensions;

    [[nodiscard]] const RangeOver& operator[](DimensionIndex index) const {
        return dimensions[static_cast<std::size_t>(index)];
    }
};

/// With first and second partials by the box's variables; unbounded results and errors as above. The
/// dimensions of `cam` do not matter.
[[nodiscard]] RangeOver quantity(const DiskCam& cam, const StateOver& state, MechanismQuantity which);

/// As those of disk_cam.hpp.
[[nodiscard]] RangeOver quantity(const DiskCam& cam, const StateOver& state, MechanismQuantity which,
                                 int side);
[[nodiscard]] RangeOver roller_on(const DiskCam& cam, const StateOver& state, int side);

/// (factor κ − share)(speed of the roller centre)³ over the coefficient of s'', of followers with a pitch
/// curve and with the curvature κ of a side: >= 0 where factor κ >= share, and linear in s''. Unbounded where
/// that coefficient may vanish.
[[nodiscard]] RangeOver curvature_excess(const DiskCam& cam, const StateOver& state, const RangeOver& factor,
                                         double share, int side);

}  // namespace camopt
