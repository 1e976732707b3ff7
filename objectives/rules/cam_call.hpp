// SPDX-License-Identifier: MIT
// One state of a cam, the argument of the formula of a limit, in one of three algebras: values with first and
// second partials, enclosures over a box, enclosures along a stretch of a motion. A formula that is generic
// over the call gives all three.
//
// SI: m, rad, s' and s'' by the cam angle.
#pragma once

#include "scene/cam_mechanism.hpp"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace camopt {

/// Partials are by (s, s', s'', the active dimensions in their order).
struct CamCall {
    const CamMechanism& cam;
    MechanismState state;
    std::span<const int> active;

    [[nodiscard]] MechanismValue quantity(MechanismQuantity which, int station) const {
        return cam.quantity(which, state, station, active);
    }
    [[nodiscard]] MechanismValue displacement() const { return variable(state.output.s, 0); }
    [[nodiscard]] MechanismValue velocity() const { return variable(state.output.velocity, 1); }
    [[nodiscard]] MechanismValue acceleration() const { return variable(state.output.acceleration, 2); }
    /// One of the cam's dimensions.
    [[nodiscard]] MechanismValue dimension(int index) const {
        const auto place = std::ranges::find(active, index) - active.begin();
        const bool moves = place < static_cast<std::ptrdiff_t>(active.size());
        return variable(state.dimensions[static_cast<std::size_t>(index)],
                        moves ? static_cast<int>(3 + place) : -1);
    }

 private:
    /// index: of its partial 1; < 0: a constant.
    [[nodiscard]] MechanismValue variable(double value, int index) const {
        const auto size = static_cast<Eigen::Index>(3 + active.size());
        MechanismValue result{value, MechanismValue::Gradient::Zero(size),
                              MechanismValue::Hessian::Zero(size, size)};
        if (index >= 0) result.gradient[index] = 1.0;
        return result;
    }
};

/// Common to CamCallOver and CamCallAlong: a quantity without an enclosure makes the whole unknown.
template <class Range>
class EnclosedCall {
 public:
    [[nodiscard]] std::optional<Range> known(const Range& found) const {
        return is_known_ ? std::optional<Range>(found) : std::nullopt;
    }

 protected:
    [[nodiscard]] Range noted(const std::optional<Range>& found) const {
        is_known_ = is_known_ && found.has_value();
        return found.value_or(Range(0.0));
    }

 private:
    mutable bool is_known_ = true;
};

struct CamCallOver : EnclosedCall<RangeOver> {
    CamCallOver(const CamMechanism& mechanism, const MechanismStateOver& box) : cam(mechanism), state(box) {}

    const CamMechanism& cam;
    const MechanismStateOver& state;

    [[nodiscard]] RangeOver quantity(MechanismQuantity which, int station) const {
        return noted(cam.quantity_over(which, state, station));
    }
    [[nodiscard]] const RangeOver& displacement() const { return state.s; }
    [[nodiscard]] const RangeOver& velocity() const { return state.velocity; }
    [[nodiscard]] const RangeOver& acceleration() const { return state.acceleration; }
    [[nodiscard]] const RangeOver& dimension(int index) const {
        return state.dimensions[static_cast<std::size_t>(index)];
    }
};

struct CamCallAlong : EnclosedCall<RangeAlong> {
    CamCallAlong(const CamMechanism& mechanism, const MechanismStateAlong& stretch)
        : cam(mechanism), state(stretch) {}

    const CamMechanism& cam;
    const MechanismStateAlong& state;

    [[nodiscard]] RangeAlong quantity(MechanismQuantity which, int station) const {
        return noted(cam.quantity_along(which, state, station));
    }
    [[nodiscard]] const RangeAlong& displacement() const { return state.s; }
    [[nodiscard]] const RangeAlong& velocity() const { return state.velocity; }
    [[nodiscard]] const RangeAlong& acceleration() const { return state.acceleration; }
    [[nodiscard]] RangeAlong dimension(int index) const {
        return {state.dimensions[static_cast<std::size_t>(index)]};
    }
};

}  // namespace camopt
