// SPDX-License-Identifier: MIT
//
// Private to profiles/: the formulas of the disk cams, generic over the scalar, so that double gives points
// and automatic differentiation gives partials.
//
// They are those of the counterclockwise cam. A clockwise cam is its mirror image: the caller passes
// -offset (translating) or -velocity (oscillating). The formulas depend on `position` instead of s: the
// height of the roller centre or face over the cam centre (translating), the angle psi (oscillating);
// position = start + s.
#pragma once

#include "scene/cam_spec.hpp"

#include <cmath>

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

}  // namespace camopt::formulas
