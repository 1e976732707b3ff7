// SPDX-License-Identifier: MIT
#include "profiles/disk/disk_cam.hpp"
#include "profiles/disk/disk_cam_formulas.hpp"

namespace camopt {

namespace {

struct SourceAlong : StateAlong {
    const DiskCam& cam;

    [[nodiscard]] RangeAlong rest() const { return {rest_position(cam)}; }
    [[nodiscard]] RangeAlong flank_offset() const { return {surface_offset(cam, 0)}; }
    [[nodiscard]] RangeAlong number(DimensionIndex which) const { return {cam[which]}; }
};

using enum DimensionIndex;

RangeOver prime_radius_over(const DiskCam& cam, const StateOver& state) {
    return has_roller(cam.follower) ? state[base_radius] + state[roller_radius] : state[base_radius];
}

/// From the roller's centre to either flank of a groove, or to the surface of an open cam.
RangeOver flank_offset(const DiskCam& cam, const StateOver& state) {
    const double clearance = cam.form.is_grooved() ? cam.form.groove_clearance : 0.0;
    return state[roller_radius] + RangeOver(0.5 * clearance);
}

/// The origin of s.
RangeOver rest_over(const DiskCam& cam, const StateOver& state) {
    const RangeOver& distance = state[center_distance];
    switch (cam.follower) {
        case FollowerType::translating_roller:
        case FollowerType::translating_knife:
            return formulas::translating_roller_start(prime_radius_over(cam, state), state[offset]);
        case FollowerType::oscillating_roller:
            return formulas::oscillating_roller_start(prime_radius_over(cam, state), distance,
                                                      state[arm_length]);
        case FollowerType::translating_flat:
            return state[base_radius];
        case FollowerType::oscillating_flat:
            return formulas::oscillating_flat_start(state[base_radius], distance, state[face_offset]);
    }
    throw ModelError("quantity: a follower of no known type");
}

struct SourceOver {
    const DiskCam& cam;
    const StateOver& state;
    const RangeOver &s = state.s, &velocity = state.velocity, &acceleration = state.acceleration;

    [[nodiscard]] RangeOver rest() const { return rest_over(cam, state); }
    [[nodiscard]] RangeOver flank_offset() const { return camopt::flank_offset(cam, state); }
    [[nodiscard]] const RangeOver& number(DimensionIndex which) const { return state[which]; }
};

/// κ v³ = v² + drift across − along push with push = lever s'': the excess of factor κ over `share`, times
/// v³ / (along lever).
RangeOver excess_of(const formulas::PitchMotion<RangeOver>& pitch, const RangeOver& lever,
                    const RangeOver& acceleration, const RangeOver& factor, double share) {
    const RangeOver speed_squared = square(pitch.across) + square(pitch.along);
    const RangeOver coefficient = pitch.along * lever;
    const RangeOver still = (speed_squared + pitch.drift * pitch.across) / coefficient;
    return factor * (still - acceleration) - share * (cube_of_root(speed_squared) / coefficient);
}

RangeOver open_excess(const DiskCam& cam, const StateOver& state, const RangeOver& factor, double share) {
    const double sense = sense_of(cam.rotation);
    const RangeOver position = rest_over(cam, state) + state.s;
    switch (cam.follower) {
        case FollowerType::translating_roller:
        case FollowerType::translating_knife: {
            const formulas::TranslatingRoller<RangeOver> roller{position, state.velocity, state.acceleration,
                                                                sense * state[offset]};
            return excess_of(roller.pitch(), {1.0}, state.acceleration, factor, share);
        }
        case FollowerType::oscillating_roller: {
            const formulas::OscillatingRoller<RangeOver> roller{position, sense * state.velocity,
                                                                state.acceleration, state[center_distance],
                                                                state[arm_length]};
            return excess_of(roller.pitch(), state[arm_length], state.acceleration, factor, share);
        }
        case FollowerType::translating_flat:
        case FollowerType::oscillating_flat:
            break;
    }
    refuse_quantity(name_of(cam.follower));
}

bool is_second_disk(const DiskCam& cam, int side) {
    return side == 1 && cam.form.is_conjugate();
}

RangeOver given_or_own(const std::optional<double>& given, const RangeOver& own) {
    return given ? RangeOver(*given) : own;
}

/// The motion and the dimensions of the second disk, in the mirror image (disk_cam.hpp), by those of the
/// cam.
StateOver second_over(const DiskCam& cam, const StateOver& state) {
    StateOver second{-state.s, -state.velocity, -state.acceleration, {}};
    const auto at = [&second](DimensionIndex which) -> RangeOver& {
        return second.dimensions[static_cast<std::size_t>(which)];
    };
    at(roller_radius) = given_or_own(cam.form.second_roller_radius, state[roller_radius]);
    RangeOver prime_squared;
    if (is_oscillating(cam.follower)) {
        const RangeOver& a = at(center_distance) = state[center_distance];
        const RangeOver& l = at(arm_length) = given_or_own(cam.form.second_arm_length, state[arm_length]);
        prime_squared = square(a) + square(l) -
                        2.0 * (a * l * cos(RangeOver(cam.form.arm_angle) - rest_over(cam, state)));
    } else {
        at(offset) = given_or_own(cam.form.second_offset, state[offset]);
        const RangeOver rest = RangeOver(cam.form.roller_distance) - rest_over(cam, state);
        prime_squared = square(rest) + square(at(offset));
    }
    at(base_radius) = sqrt(prime_squared) - at(roller_radius);
    return second;
}

}  // namespace

RangeAlong quantity(const DiskCam& cam, const StateAlong& state, MechanismQuantity which) {
    return formulas::quantity_of_first_side<RangeAlong>(cam, SourceAlong{state, cam}, which);
}

RangeOver quantity(const DiskCam& cam, const StateOver& state, MechanismQuantity which) {
    return formulas::quantity_of_first_side<RangeOver>(cam, SourceOver{cam, state}, which);
}

RangeOver quantity(const DiskCam& cam, const StateOver& state, MechanismQuantity which, int side) {
    if (is_second_disk(cam, side)) return quantity(second_disk(cam), second_over(cam, state), which);
    const auto first = [&](MechanismQuantity of) { return quantity(cam, state, of); };
    return side == 0 ? first(which)
                     : formulas::quantity_of_outer_flank(flank_offset(cam, state), first, which);
}

RangeOver roller_on(const DiskCam& cam, const StateOver& state, int side) {
    if (is_second_disk(cam, side)) return given_or_own(cam.form.second_roller_radius, state[roller_radius]);
    return state[roller_radius];
}

RangeOver curvature_excess(const DiskCam& cam, const StateOver& state, const RangeOver& factor, double share,
                           int side) {
    if (is_second_disk(cam, side))
        return open_excess(second_disk(cam), second_over(cam, state), factor, share);
    return open_excess(cam, state, side == 0 ? factor : -factor, share);
}

}  // namespace camopt
