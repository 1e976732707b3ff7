// SPDX-License-Identifier: MIT
#include "profiles/disk/quantity_along.hpp"

#include "profiles/disk/disk_sides.hpp"
#include "profiles/disk/quantity_of_follower.hpp"

namespace camopt {
using enum DimensionIndex;

RangeAlong quantity(const DiskCam& cam, const StateAlong& state, MechanismQuantity which) {
    const double sense = sense_of(cam.rotation);
    switch (cam.follower) {
        case FollowerType::translating_roller:
        case FollowerType::translating_knife:
            return formulas::quantity_of_roller<RangeAlong>(
                cam.follower,
                formulas::TranslatingRoller<RangeAlong>{RangeAlong(rest_position(cam)) + state.s,
                                                        state.velocity, state.acceleration,
                                                        RangeAlong(sense * cam[offset])},
                surface_offset(cam, 0), which);
        case FollowerType::translating_flat:
            return formulas::quantity_of_face<RangeAlong>(cam[base_radius],
                                                          RangeAlong(cam[base_radius]) + state.s,
                                                          sense * state.velocity, state.acceleration, which);
        case FollowerType::oscillating_roller:
            return formulas::quantity_of_roller<RangeAlong>(
                cam.follower,
                formulas::OscillatingRoller<RangeAlong>{
                    RangeAlong(rest_position(cam)) + state.s, sense * state.velocity, state.acceleration,
                    RangeAlong(cam[center_distance]), RangeAlong(cam[arm_length])},
                surface_offset(cam, 0), which);
        case FollowerType::oscillating_flat:
            break;
    }
    return formulas::quantity_of_face_arm<RangeAlong>(
        cam[base_radius],
        {RangeAlong(rest_position(cam)) + state.s, sense * state.velocity, state.acceleration,
         RangeAlong(cam[center_distance]), RangeAlong(cam[face_offset])},
        which);
}

}  // namespace camopt
