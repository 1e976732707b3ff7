// SPDX-License-Identifier: MIT
#include "profiles/disk/quantity_over.hpp"

#include "core/errors.hpp"
#include "profiles/disk/disk_cam_formulas.hpp"
#include "profiles/disk/quantity_algebra.hpp"

namespace camopt {
namespace {

using enum DimensionIndex;

RangeOver prime_radius_over(const DiskCam& cam, const StateOver& state) {
    return has_roller(cam.follower) ? state[base_radius] + state[roller_radius] : state[base_radius];
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

template <class Roller>
RangeOver roller_quantity_over(const DiskCam& cam, const StateOver& state, const Roller& roller,
                               Quantity which) {
    switch (which) {
        case Quantity::pressure_numerator:
            return roller.pressure_numerator();
        case Quantity::pressure_denominator:
            return roller.pressure_denominator();
        case Quantity::pitch_curvature:
            return roller.pitch().curvature();
        case Quantity::regularity:
            if (!has_roller(cam.follower)) return {1.0};
            return RangeOver(1.0) - state[roller_radius] * roller.pitch().curvature();
        case Quantity::normal_lever:
            return roller.normal_lever();
        case Quantity::cam_radius:
        case Quantity::contact_offset:
            break;
    }
    refuse_quantity(cam.follower);
}

RangeOver translating_flat_over(const DiskCam& cam, const StateOver& state, Quantity which) {
    const RangeOver height = state[base_radius] + state.s;
    switch (which) {
        case Quantity::pressure_numerator:
            return {0.0};
        case Quantity::pressure_denominator:
            return height;
        case Quantity::cam_radius:
            return height + state.acceleration;
        case Quantity::regularity:
            return (height + state.acceleration) / state[base_radius];
        case Quantity::contact_offset:
            return sense_of(cam.rotation) * state.velocity;
        case Quantity::normal_lever:
            return {1.0};
        case Quantity::pitch_curvature:
            break;
    }
    refuse_quantity(cam.follower);
}

RangeOver oscillating_flat_over(const DiskCam& cam, const StateOver& state, Quantity which) {
    const RangeOver start =
        formulas::oscillating_flat_start(state[base_radius], state[center_distance], state[face_offset]);
    const formulas::OscillatingFlat<RangeOver> flat{start + state.s, sense_of(cam.rotation) * state.velocity,
                                                    state.acceleration, state[center_distance],
                                                    state[face_offset]};
    switch (which) {
        case Quantity::pressure_numerator:
            return flat.pressure_numerator();
        case Quantity::pressure_denominator:
            return flat.pressure_denominator();
        case Quantity::cam_radius:
            return flat.cam_radius();
        case Quantity::regularity:
            return flat.turned_radius() / state[base_radius];
        case Quantity::contact_offset:
        case Quantity::normal_lever:
            return flat.contact_offset();
        case Quantity::pitch_curvature:
            break;
    }
    refuse_quantity(cam.follower);
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

void require_open(const DiskCam& cam, int side) {
    if (side != 0 || cam.form.drives_both_ways())
        throw ModelError("found a side of a groove or of a conjugate cam over a box; allowed: an open cam");
}

}  // namespace

RangeOver quantity(const DiskCam& cam, const StateOver& state, Quantity which) {
    switch (cam.follower) {
        case FollowerType::translating_roller:
        case FollowerType::translating_knife:
            return roller_quantity_over(cam, state, translating_roller_over(cam, state), which);
        case FollowerType::translating_flat:
            return translating_flat_over(cam, state, which);
        case FollowerType::oscillating_roller:
            return roller_quantity_over(cam, state, oscillating_roller_over(cam, state), which);
        case FollowerType::oscillating_flat:
            break;
    }
    return oscillating_flat_over(cam, state, which);
}

RangeOver quantity(const DiskCam& cam, const StateOver& state, Quantity which, int side) {
    require_open(cam, side);
    return quantity(cam, state, which);
}

RangeOver roller_on(const DiskCam& cam, const StateOver& state, int side) {
    require_open(cam, side);
    return state[roller_radius];
}

RangeOver curvature_excess(const DiskCam& cam, const StateOver& state, const RangeOver& factor,
                           double share) {
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
    refuse_quantity(cam.follower);
}

}  // namespace camopt
