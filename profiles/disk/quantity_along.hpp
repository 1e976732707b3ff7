// SPDX-License-Identifier: MIT
// Quantities of a disk cam over a stretch of the cam angle: enclosures of their values, slopes and second
// derivatives, by the formulas of disk_cam.hpp.
//
// The functions here stand beside those of quantity_algebra.hpp under the same names, so that one generic
// text of a formula of (cam, state) gives its partials (FollowerState) and its enclosure (StateAlong).
#pragma once

#include "core/numbers/range_along.hpp"
#include "profiles/disk/disk_cam.hpp"
#include "profiles/disk/quantity_algebra.hpp"

namespace camopt {

/// Everything where the formula may divide by zero somewhere in the stretch. Throws ModelError where the
/// follower has no such quantity.
[[nodiscard]] RangeAlong quantity(const DiskCam& cam, const StateAlong& state, MechanismQuantity which);

[[nodiscard]] inline RangeAlong sum(double factor_a, const RangeAlong& a, double factor_b,
                                    const RangeAlong& b) {
    return factor_a * a + factor_b * b;
}
[[nodiscard]] inline RangeAlong product(const RangeAlong& a, const RangeAlong& b) {
    return a * b;
}
[[nodiscard]] inline RangeAlong shifted(const RangeAlong& a, double by) {
    return a + RangeAlong(by);
}
[[nodiscard]] inline RangeAlong scaled(const RangeAlong& a, double factor) {
    return factor * a;
}

// What a formula is made of besides the quantities.
[[nodiscard]] inline QuantityValue displacement(const FollowerState& state) {
    return variable_quantity(state.s, 0);
}
[[nodiscard]] inline QuantityValue velocity(const FollowerState& state) {
    return variable_quantity(state.velocity, 1);
}
[[nodiscard]] inline QuantityValue acceleration(const FollowerState& state) {
    return variable_quantity(state.acceleration, 2);
}
[[nodiscard]] inline QuantityValue dimension(const DiskCam& cam, const FollowerState&, DimensionIndex which) {
    return variable_quantity(cam[which], column_of(which));
}
[[nodiscard]] inline const RangeAlong& displacement(const StateAlong& state) {
    return state.s;
}
[[nodiscard]] inline const RangeAlong& velocity(const StateAlong& state) {
    return state.velocity;
}
[[nodiscard]] inline const RangeAlong& acceleration(const StateAlong& state) {
    return state.acceleration;
}
[[nodiscard]] inline RangeAlong dimension(const DiskCam& cam, const StateAlong&, DimensionIndex which) {
    return {cam[which]};
}

}  // namespace camopt
