// SPDX-License-Identifier: MIT
#include "profiles/disk/quantity_over.hpp"

#include "core/errors.hpp"
#include "profiles/disk/disk_sides.hpp"
#include "profiles/disk/quantity_of_follower.hpp"

namespace camopt {
namespace {

using enum DimensionIndex;

RangeOver prime_radius_over(const DiskCam& cam, const StateOver& state) {
    return has_roller(cam.follower) ? state[base_radius] + state[roller_radius] : state[base_radius];
}

/// From the roller's centre to either flank of a groove, or to the surface of an open cam.
RangeOver flank_offset(const DiskCam& cam, const StateOver& state) {
    const double clearance = cam.form.is_grooved() ? cam.form.groove_clearance : 0.0;
    return shifted(state[roller_radius], 0.5 * clearance);
}

formulas::TranslatingRoller<RangeOver> translating_roller_over(const DiskCam& cam, const StateOver& state) {
    const RangeOver start = formulas::translating_roller_start(prime_radius_over(cam, state), state[offset]);
    return {start + state.s, state.velocity, state.acceleration, sense_of(cam.rotation) * state[offset]};
}

formulas::OscillatingRoller<RangeOver> oscillating_roller_over(const DiskCam& cam, const StateOver& state) {
    const RangeOver start = formulas::oscillating_roller_start(prime_radius_over(cam, state),
                                                               state[center_distance], state[arm_length]);
    return {start + state.s, sense_of(cam.rotation) * state.velocity, state.acceleration,
            state[center_distance], state[arm_length]};
}

formulas::OscillatingFlat<RangeOver> oscillating_flat_over(const DiskCam& cam, const StateOver& state) {
    const RangeOver start =
        formulas::oscillating_flat_start(state[base_radius], state[center_distance], state[face_offset]);
    return {start + state.s, sense_of(cam.rotation) * state.velocity, state.acceleration,
            state[center_distance], state[face_offset]};
}

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
    switch (cam.follower) {
        case FollowerType::translating_roller:
        case FollowerType::translating_knife:
            return excess_of(translating_roller_over(cam, state).pitch(), {1.0}, state.acceleration, factor,
                             share);
        case FollowerType::oscillating_roller:
            return excess_of(oscillating_roller_over(cam, state).pitch(), state[arm_length],
                             state.acceleration, factor, share);
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

/// The motion and the dimensions of the second disk, seen in the mirror (disk_sides.hpp), by those of the
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
        const RangeOver angle = RangeOver(cam.form.arm_angle) -
                                formulas::oscillating_roller_start(prime_radius_over(cam, state),
                                                                   state[center_distance], state[arm_length]);
        prime_squared = square(a) + square(l) - 2.0 * (a * l * cos(angle));
    } else {
        at(offset) = given_or_own(cam.form.second_offset, state[offset]);
        const RangeOver rest =
            RangeOver(cam.form.roller_distance) -
            formulas::translating_roller_start(prime_radius_over(cam, state), state[offset]);
        prime_squared = square(rest) + square(at(offset));
    }
    at(base_radius) = sqrt(prime_squared) - at(roller_radius);
    return second;
}

/// Of the outer flank, whose pitch curvature is −κ.
RangeOver outer_flank_over(const DiskCam& cam, const StateOver& state, MechanismQuantity which) {
    if (which == MechanismQuantity::pitch_curvature) return -quantity(cam, state, which);
    if (which != MechanismQuantity::regularity) return quantity(cam, state, which);
    return RangeOver(1.0) + flank_offset(cam, state) * quantity(cam, state, MechanismQuantity::pitch_curvature);
}

}  // namespace

RangeOver quantity(const DiskCam& cam, const StateOver& state, MechanismQuantity which) {
    switch (cam.follower) {
        case FollowerType::translating_roller:
        case FollowerType::translating_knife:
            return formulas::quantity_of_roller<RangeOver>(cam.follower, translating_roller_over(cam, state),
                                                           flank_offset(cam, state), which);
        case FollowerType::translating_flat:
            return formulas::quantity_of_face<RangeOver>(state[base_radius], state[base_radius] + state.s,
                                                         sense_of(cam.rotation) * state.velocity,
                                                         state.acceleration, which);
        case FollowerType::oscillating_roller:
            return formulas::quantity_of_roller<RangeOver>(cam.follower, oscillating_roller_over(cam, state),
                                                           flank_offset(cam, state), which);
        case FollowerType::oscillating_flat:
            return formulas::quantity_of_face_arm<RangeOver>(state[base_radius],
                                                             oscillating_flat_over(cam, state), which);
    }
    throw ModelError("quantity: a follower of no known type");
}

RangeOver quantity(const DiskCam& cam, const StateOver& state, MechanismQuantity which, int side) {
    if (is_second_disk(cam, side)) return quantity(second_disk(cam), second_over(cam, state), which);
    return side == 0 ? quantity(cam, state, which) : outer_flank_over(cam, state, which);
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
