// SPDX-License-Identifier: MIT
// The formula of disk_cam_formulas.hpp for each quantity of a follower, generic over the number type: double,
// automatic differentiation (disk_cam_expansion.hpp), RangeAlong (over an interval of the cam angle),
// RangeOver (over a box of the motion's state and the dimensions).
//
// Lengths in m, curvatures in 1/m, the regularity without unit; velocities and accelerations by the cam angle
// in the sense of rotation of the cam. Throws ModelError if the follower has no such quantity.
#pragma once

#include "core/errors.hpp"
#include "profiles/disk/disk_cam.hpp"
#include "profiles/disk/disk_cam_formulas.hpp"

namespace camopt::formulas {

/// 1 − R κ; R: from the pitch curve to the surface, whose pitch curvature is κ.
template <class Number>
[[nodiscard]] Number regularity_of(const Number& offset, const Number& curvature) {
    const Number bent = offset * curvature;
    return Number(-1.0 * bent) + 1.0;
}

/// Of followers with a pitch curve, translating or oscillating. `flank_offset`: from the pitch curve to the
/// surface.
template <class Number, class Roller>
[[nodiscard]] Number quantity_of_roller(FollowerType follower, const Roller& roller,
                                        const Number& flank_offset, MechanismQuantity which) {
    switch (which) {
        case MechanismQuantity::pressure_numerator:
            return roller.pressure_numerator();
        case MechanismQuantity::pressure_denominator:
            return roller.pressure_denominator();
        case MechanismQuantity::pitch_curvature:
            return roller.pitch().curvature();
        case MechanismQuantity::regularity:
            if (!has_roller(follower)) return Number(1.0);
            return regularity_of<Number>(flank_offset, roller.pitch().curvature());
        case MechanismQuantity::normal_lever:
            return roller.normal_lever();
        case MechanismQuantity::cam_radius:
        case MechanismQuantity::contact_offset:
            break;
    }
    refuse_quantity(name_of(follower));
}

/// Of a flat face that slides: the height of the face, base radius + s, and the derivatives of s.
template <class Number>
[[nodiscard]] Number quantity_of_face(const Number& base_radius, const Number& height, const Number& velocity,
                                      const Number& acceleration, MechanismQuantity which) {
    switch (which) {
        case MechanismQuantity::pressure_numerator:
            return Number(0.0);
        case MechanismQuantity::pressure_denominator:
            return height;
        case MechanismQuantity::cam_radius:
            return height + acceleration;
        case MechanismQuantity::regularity:
            return Number(height + acceleration) / base_radius;
        case MechanismQuantity::contact_offset:
            return velocity;
        case MechanismQuantity::normal_lever:
            return Number(1.0);
        case MechanismQuantity::pitch_curvature:
            break;
    }
    refuse_quantity(name_of(FollowerType::translating_flat));
}

/// Of a flat face on an arm.
template <class Number>
[[nodiscard]] Number quantity_of_face_arm(const Number& base_radius, const OscillatingFlat<Number>& face,
                                          MechanismQuantity which) {
    switch (which) {
        case MechanismQuantity::pressure_numerator:
            return face.pressure_numerator();
        case MechanismQuantity::pressure_denominator:
            return face.pressure_denominator();
        case MechanismQuantity::cam_radius:
            return face.cam_radius();
        case MechanismQuantity::regularity:
            return face.turned_radius() / base_radius;
        case MechanismQuantity::contact_offset:
        case MechanismQuantity::normal_lever:
            return face.contact_offset();
        case MechanismQuantity::pitch_curvature:
            break;
    }
    refuse_quantity(name_of(FollowerType::oscillating_flat));
}

/// Of the side of an open cam of the same dimensions. `Source` has the members s, velocity and acceleration,
/// rest() (the origin of s), flank_offset() and number(dimension).
template <class Number, class Source>
[[nodiscard]] Number quantity_of_first_side(const DiskCam& cam, const Source& source,
                                            MechanismQuantity which) {
    using enum DimensionIndex;
    const double sense = sense_of(cam.rotation);
    switch (cam.follower) {
        case FollowerType::translating_roller:
        case FollowerType::translating_knife:
            return quantity_of_roller<Number>(
                cam.follower,
                TranslatingRoller<Number>{source.rest() + source.s, source.velocity, source.acceleration,
                                          sense * source.number(offset)},
                source.flank_offset(), which);
        case FollowerType::translating_flat:
            return quantity_of_face<Number>(source.number(base_radius), source.number(base_radius) + source.s,
                                            sense * source.velocity, source.acceleration, which);
        case FollowerType::oscillating_roller:
            return quantity_of_roller<Number>(
                cam.follower,
                OscillatingRoller<Number>{source.rest() + source.s, sense * source.velocity,
                                          source.acceleration, source.number(center_distance),
                                          source.number(arm_length)},
                source.flank_offset(), which);
        case FollowerType::oscillating_flat:
            return quantity_of_face_arm<Number>(
                source.number(base_radius),
                {source.rest() + source.s, sense * source.velocity, source.acceleration,
                 source.number(center_distance), source.number(face_offset)},
                which);
    }
    throw ModelError("quantity: a follower of no known type");
}

/// Of the outer flank of a groove, whose pitch curvature is −κ; `offset`: from the pitch curve to it;
/// `first`: the quantities of the inner flank.
template <class Offset, class First>
[[nodiscard]] auto quantity_of_outer_flank(const Offset& offset, const First& first,
                                           MechanismQuantity which) {
    if (which == MechanismQuantity::pitch_curvature) return -1.0 * first(which);
    if (which != MechanismQuantity::regularity) return first(which);
    return regularity_of(offset, -1.0 * first(MechanismQuantity::pitch_curvature));
}

}  // namespace camopt::formulas
