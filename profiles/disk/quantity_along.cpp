// SPDX-License-Identifier: MIT
#include "profiles/disk/quantity_along.hpp"

#include "profiles/disk/disk_cam_formulas.hpp"
#include "profiles/disk/disk_sides.hpp"

namespace camopt {
namespace {

using enum DimensionIndex;

/// Of followers with a pitch curve.
template <class Roller>
RangeAlong roller_quantity(const DiskCam& cam, const Roller& roller, Quantity which) {
    switch (which) {
        case Quantity::pressure_numerator:
            return roller.pressure_numerator();
        case Quantity::pressure_denominator:
            return roller.pressure_denominator();
        case Quantity::pitch_curvature:
            return roller.pitch().curvature();
        case Quantity::regularity:
            if (!has_roller(cam.follower)) return {1.0};
            return RangeAlong(1.0) - surface_offset(cam, 0) * roller.pitch().curvature();
        case Quantity::normal_lever:
            return roller.normal_lever();
        case Quantity::cam_radius:
        case Quantity::contact_offset:
            break;
    }
    refuse_quantity(cam.follower);
}

RangeAlong translating_flat_quantity(const DiskCam& cam, const StateAlong& state, Quantity which) {
    const RangeAlong height = RangeAlong(cam[base_radius]) + state.s;
    switch (which) {
        case Quantity::pressure_numerator:
            return {0.0};
        case Quantity::pressure_denominator:
            return height;
        case Quantity::cam_radius:
            return height + state.acceleration;
        case Quantity::regularity:
            return (height + state.acceleration) / RangeAlong(cam[base_radius]);
        case Quantity::contact_offset:
            return sense_of(cam.rotation) * state.velocity;
        case Quantity::normal_lever:
            return {1.0};
        case Quantity::pitch_curvature:
            break;
    }
    refuse_quantity(cam.follower);
}

RangeAlong oscillating_flat_quantity(const DiskCam& cam, const StateAlong& state, Quantity which) {
    const formulas::OscillatingFlat<RangeAlong> flat{
        RangeAlong(rest_position(cam)) + state.s, sense_of(cam.rotation) * state.velocity, state.acceleration,
        RangeAlong(cam[center_distance]), RangeAlong(cam[face_offset])};
    switch (which) {
        case Quantity::pressure_numerator:
            return flat.pressure_numerator();
        case Quantity::pressure_denominator:
            return flat.pressure_denominator();
        case Quantity::cam_radius:
            return flat.cam_radius();
        case Quantity::regularity:
            return flat.turned_radius() / RangeAlong(cam[base_radius]);
        case Quantity::contact_offset:
        case Quantity::normal_lever:
            return flat.contact_offset();
        case Quantity::pitch_curvature:
            break;
    }
    refuse_quantity(cam.follower);
}

}  // namespace

RangeAlong quantity(const DiskCam& cam, const StateAlong& state, Quantity which) {
    const double sense = sense_of(cam.rotation);
    switch (cam.follower) {
        case FollowerType::translating_roller:
        case FollowerType::translating_knife:
            return roller_quantity(cam,
                                   formulas::TranslatingRoller<RangeAlong>{
                                       RangeAlong(rest_position(cam)) + state.s, state.velocity,
                                       state.acceleration, RangeAlong(sense * cam[offset])},
                                   which);
        case FollowerType::translating_flat:
            return translating_flat_quantity(cam, state, which);
        case FollowerType::oscillating_roller:
            return roller_quantity(
                cam,
                formulas::OscillatingRoller<RangeAlong>{
                    RangeAlong(rest_position(cam)) + state.s, sense * state.velocity, state.acceleration,
                    RangeAlong(cam[center_distance]), RangeAlong(cam[arm_length])},
                which);
        case FollowerType::oscillating_flat:
            break;
    }
    return oscillating_flat_quantity(cam, state, which);
}

}  // namespace camopt
