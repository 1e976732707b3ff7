// SPDX-License-Identifier: MIT
// Quantities of a disk cam over a box of motions and dimensions: enclosures of their values and of their
// first and second partials, by the formulas of disk_cam.hpp.
//
// The functions here stand beside those of quantity_algebra.hpp and quantity_along.hpp under the same names,
// so that one generic text of a formula of (cam, state) gives its enclosure over a box too.
#pragma once

#include "core/numbers/range_over.hpp"
#include "profiles/disk/disk_cam.hpp"

#include <array>

namespace camopt {

/// s, s', s'' and the dimensions, each a number, a box of its own, or a function of what a box is of.
struct StateOver {
    RangeOver s, velocity, acceleration;
    std::array<RangeOver, dimension_count> dimensions;

    [[nodiscard]] const RangeOver& operator[](DimensionIndex index) const {
        return dimensions[static_cast<std::size_t>(index)];
    }
};

/// Everything where the formula may divide by zero somewhere in the box. Throws ModelError where the
/// follower has no such quantity.
[[nodiscard]] RangeOver quantity(const DiskCam& cam, const StateOver& state, MechanismQuantity which);

/// As those of disk_sides.hpp.
[[nodiscard]] RangeOver quantity(const DiskCam& cam, const StateOver& state, MechanismQuantity which, int side);
[[nodiscard]] RangeOver roller_on(const DiskCam& cam, const StateOver& state, int side);

/// (factor κ − share)(speed of the roller centre)³ over the coefficient of s'', of followers with a pitch
/// curve and with the curvature κ of a side: >= 0 where factor κ >= share, and linear in s''. Everything
/// where that coefficient may vanish.
[[nodiscard]] RangeOver curvature_excess(const DiskCam& cam, const StateOver& state, const RangeOver& factor,
                                         double share, int side);

[[nodiscard]] inline RangeOver sum(double factor_a, const RangeOver& a, double factor_b, const RangeOver& b) {
    return factor_a * a + factor_b * b;
}
[[nodiscard]] inline RangeOver product(const RangeOver& a, const RangeOver& b) {
    return a * b;
}
[[nodiscard]] inline RangeOver shifted(const RangeOver& a, double by) {
    return a + RangeOver(by);
}
[[nodiscard]] inline RangeOver scaled(const RangeOver& a, double factor) {
    return factor * a;
}
[[nodiscard]] inline const RangeOver& displacement(const StateOver& state) {
    return state.s;
}
[[nodiscard]] inline const RangeOver& velocity(const StateOver& state) {
    return state.velocity;
}
[[nodiscard]] inline const RangeOver& acceleration(const StateOver& state) {
    return state.acceleration;
}
[[nodiscard]] inline const RangeOver& dimension(const DiskCam&, const StateOver& state,
                                                DimensionIndex which) {
    return state[which];
}

}  // namespace camopt
