// SPDX-License-Identifier: MIT
// Private to profiles/: the formulas of the disk cams, generic over the scalar, so that double gives points
// and automatic differentiation gives partials.
//
// They are those of the counterclockwise cam. A clockwise cam is its mirror image: the caller passes
// -offset (translating) or -velocity (oscillating). The formulas depend on `position` instead of s: the
// height of the roller centre or face over the cam centre (translating), the angle psi (oscillating);
// position = start + s.
#pragma once

#include "core/errors.hpp"
#include "profiles/disk/disk_cam_dimensions.hpp"
#include "scene/cam_mechanism.hpp"

namespace camopt::formulas {

/// The position of the follower on the base circle.
template <class T>
[[nodiscard]] T translating_roller_start(const T& prime_radius, const T& offset) {
    using std::sqrt;
    return sqrt(T(prime_radius * prime_radius - offset * offset));
}

template <class T>
[[nodiscard]] T oscillating_roller_start(const T& prime_radius, const T& center_distance,
                                         const T& arm_length) {
    using std::acos;
    const T squares =
        center_distance * center_distance + arm_length * arm_length - prime_radius * prime_radius;
    const T product = center_distance * arm_length;
    return acos(T(squares / T(product + product)));
}

template <class T>
[[nodiscard]] T oscillating_flat_start(const T& base_radius, const T& center_distance, const T& face_offset) {
    using std::asin;
    return asin(T((base_radius + face_offset) / center_distance));
}

/// Motion of the roller centre in the cam frame: `along` and `across` are the components of its speed whose
/// ratio is the tangent of the pressure angle; `drift` and `push` are the change of both.
template <class T>
struct PitchMotion {
    T across, along, drift, push;

    [[nodiscard]] T speed() const {
        using std::sqrt;
        return sqrt(T(across * across + along * along));
    }
    [[nodiscard]] T curvature() const {
        using std::sqrt;
        const T speed_squared = across * across + along * along;
        const T turning = speed_squared + drift * across - along * push;
        return turning / T(speed_squared * sqrt(speed_squared));
    }
};

/// Of its centre; a knife edge is a roller of radius 0.
template <class T>
struct TranslatingRoller {
    T position, velocity, acceleration, offset;

    [[nodiscard]] T pressure_numerator() const { return velocity - offset; }
    [[nodiscard]] T pressure_denominator() const { return position; }
    [[nodiscard]] PitchMotion<T> pitch() const {
        return {pressure_numerator(), position, velocity, acceleration};
    }
    [[nodiscard]] T normal_lever() const { return position / pitch().speed(); }
};

template <class T>
struct OscillatingRoller {
    T position, velocity, acceleration, center_distance, arm_length;

    /// Speed of the arm's end in the cam frame with the pivot above it.
    [[nodiscard]] T end_speed() const { return arm_length * T(velocity + 1.0); }
    [[nodiscard]] T pressure_numerator() const {
        using std::cos;
        return end_speed() - center_distance * T(cos(position));
    }
    [[nodiscard]] T pressure_denominator() const {
        using std::sin;
        return center_distance * T(sin(position));
    }
    [[nodiscard]] PitchMotion<T> pitch() const {
        return {pressure_numerator(), pressure_denominator(), end_speed() * velocity,
                arm_length * acceleration};
    }
    [[nodiscard]] T normal_lever() const {
        const T along = pressure_denominator();
        return arm_length * along / PitchMotion<T>{pressure_numerator(), along, {}, {}}.speed();
    }
};

template <class T>
struct OscillatingFlat {
    T position, velocity, acceleration, center_distance, face_offset;

    /// Rotation of the face relative to the cam, in units of the cam's.
    [[nodiscard]] T turning() const { return velocity + 1.0; }
    [[nodiscard]] T pressure_numerator() const { return face_offset * turning(); }
    [[nodiscard]] T pressure_denominator() const {
        using std::cos;
        return center_distance * T(cos(position));
    }
    /// From the pivot's foot on the face to the contact point; also the lever of the contact force.
    [[nodiscard]] T contact_offset() const { return pressure_denominator() / turning(); }
    /// cam_radius times `turning`: one division less, and the sign that indicates undercut.
    [[nodiscard]] T turned_radius() const {
        using std::sin;
        const T inverse = T(1.0) / turning();
        const T sine_part = center_distance * T(sin(position)) * T(velocity + turning());
        const T cosine_part = pressure_denominator() * acceleration * inverse;
        return T(sine_part + cosine_part) * inverse - face_offset * turning();
    }
    [[nodiscard]] T cam_radius() const { return turned_radius() / turning(); }
};

// The formula for each quantity of a follower, generic over the number type: double,
// automatic differentiation (disk_cam_expansion.hpp), RangeAlong (over an interval of the cam angle),
// RangeOver (over a box of the motion's state and the dimensions).
//
// Lengths in m, curvatures in 1/m, the regularity without unit; velocities and accelerations by the cam angle
// in the sense of rotation of the cam. Throws ModelError if the follower has no such quantity.

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
        case MechanismQuantity::contact_radius:
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
        case MechanismQuantity::contact_radius:
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
        case MechanismQuantity::contact_radius:
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
