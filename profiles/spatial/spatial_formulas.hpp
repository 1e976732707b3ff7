// SPDX-License-Identifier: MIT
// Private to profiles/spatial/: how the roller's axis moves in the cam frame, in components along
// u (travel), b = u × e and e, generic over the scalar: double gives points, automatic differentiation
// partials. Derived from the positions in spatial_cam.hpp with C_θ = C' − σ z × C,
// C_θθ = C'' − 2σ z × C' + z × (z × C), e_θ = e' − σ z × e.
#pragma once

#include "core/errors.hpp"
#include "profiles/spatial/spatial_dimensions.hpp"
#include "scene/cam_flanks.hpp"
#include "scene/cam_mechanism.hpp"

namespace camopt::spatial_formulas {

/// The variables of a formula, in the order of the partials.
template <class T>
struct Variables {
    T position, velocity, acceleration, roller_radius, arm_length, center_distance, lateral_offset;
};

[[nodiscard]] inline Variables<double> variables_of(const SpatialDimensions& cam,
                                                    const FollowerState& state) {
    using enum SpatialDimension;
    return {cam.start + state.s, state.velocity,       state.acceleration, cam[roller_radius],
            cam[arm_length],     cam[center_distance], cam[lateral_offset]};
}

/// V = ∂C/∂θ, the parts of A = C_θθ and of e_θ across the axis.
template <class T>
struct AxisMotion {
    T across_travel, along_b, along_axis;  ///< V·u, V·b, V·e
    T turn_u, turn_b;                      ///< A·u, A·b
    T lever;                               ///< ∂(A·u)/∂q''
    T tilt_u, tilt_b;                      ///< e_θ·u, e_θ·b
};

template <class T, class Height>
[[nodiscard]] AxisMotion<T> barrel_motion(const Variables<T>& v, double sense, const Height& height) {
    using std::cos, std::sin;
    const T sine = sin(v.position), cosine = cos(v.position);
    const T rho = v.center_distance - height;
    const T lateral = v.arm_length * cosine - v.lateral_offset;
    AxisMotion<T> m{};
    m.across_travel = v.arm_length * v.velocity - sense * rho * sine;
    m.along_b = -sense * rho * cosine;
    m.along_axis = sense * lateral;
    m.turn_u = v.arm_length * v.acceleration + lateral * sine;
    m.turn_b = v.arm_length * squared(v.velocity) + lateral * cosine;
    m.lever = v.arm_length;
    m.tilt_u = sense * sine;
    m.tilt_b = sense * cosine;
    return m;
}

template <class T, class Height>
[[nodiscard]] AxisMotion<T> rotating_motion(const Variables<T>& v, double sense, const Height& height) {
    using std::cos, std::sin;
    const T sine = sin(v.position), cosine = cos(v.position);
    const T rho = v.arm_length + height;
    const T radial = v.center_distance - rho * cosine;
    AxisMotion<T> m{};
    m.across_travel = rho * v.velocity - sense * v.lateral_offset * sine;
    m.along_b = sense * radial;
    m.along_axis = sense * v.lateral_offset * cosine;
    m.turn_u = rho * v.acceleration - radial * sine;
    m.turn_b = 2.0 * sense * rho * v.velocity * sine - v.lateral_offset;
    m.lever = rho;
    m.tilt_u = v.velocity;
    m.tilt_b = -sense * cosine;
    return m;
}

template <class T, class Height>
[[nodiscard]] AxisMotion<T> translating_motion(const Variables<T>& v, double sense, const Height& height) {
    AxisMotion<T> m{};
    m.across_travel = v.velocity;
    m.along_b = sense * T(v.center_distance - height);
    m.along_axis = sense * v.lateral_offset;
    m.turn_u = v.acceleration;
    m.turn_b = -v.lateral_offset;
    // A zero with the derivatives of a zero.
    m.tilt_u = 0.0 * v.velocity;
    m.tilt_b = m.tilt_u - sense;
    m.lever = m.tilt_u + 1.0;
    return m;
}

template <class T, class Height>
[[nodiscard]] AxisMotion<T> axis_motion(const SpatialDimensions& cam, const Variables<T>& variables,
                                        const Height& height) {
    const double sense = sense_of(cam.rotation);
    switch (cam.follower) {
        case SpatialFollower::barrel:
            return barrel_motion(variables, sense, height);
        case SpatialFollower::cylindrical_rotating:
            return rotating_motion(variables, sense, height);
        case SpatialFollower::cylindrical_translating:
            return translating_motion(variables, sense, height);
    }
    throw ModelError("a follower of no known type");
}

/// Which sign makes V·b positive in a cam without fault.
[[nodiscard]] inline double sign_of_b(const SpatialDimensions& cam) {
    const double sense = sense_of(cam.rotation);
    return cam.follower == SpatialFollower::barrel ? -sense : sense;
}

/// g = 1 − σ_f r bend − (r twist)², with bend = σ_f (L − 2FM)/W² and twist = σ_f M/W.
/// n_u = −σ_f V_b/W and n_b = σ_f V_u/W put in; the products are written over W, so that one root is taken.
template <class T>
struct UndercutTerms {
    T bend, twist;
};

template <class T>
[[nodiscard]] UndercutTerms<T> undercut_terms(const AxisMotion<T>& m) {
    using std::sqrt;
    const T speed_squared = squared(m.across_travel) + squared(m.along_b);
    const T inverse = T(1.0) / speed_squared;
    const T turn = m.turn_b * m.across_travel - m.turn_u * m.along_b;
    const T tilt = m.tilt_b * m.across_travel - m.tilt_u * m.along_b;
    return {T(turn - 2.0 * m.along_axis * tilt) * inverse / T(sqrt(speed_squared)), tilt * inverse};
}

template <class T>
[[nodiscard]] T undercut(const AxisMotion<T>& m, const T& roller_radius, int flank) {
    const UndercutTerms<T> terms = undercut_terms(m);
    const T twisted = roller_radius * terms.twist;
    const double side = flank > 0 ? 1.0 : -1.0;
    return T(1.0 - side * roller_radius * terms.bend) - twisted * twisted;
}

/// Force or moment of the follower over the force along the normal.
template <class T>
[[nodiscard]] T normal_lever(const SpatialDimensions& cam, const AxisMotion<T>& m) {
    using std::sqrt;
    return sign_of_b(cam) * T(m.lever * m.along_b) /
           T(sqrt(T(squared(m.across_travel) + squared(m.along_b))));
}

/// See spatial_cam.hpp.
template <class T>
[[nodiscard]] T contact_radius(const SpatialDimensions& cam, const AxisMotion<T>& m, const T& roller_radius,
                               int flank) {
    using std::sqrt;
    const double wider = 0.5 * cam.form.groove_clearance;
    const T groove_radius = roller_radius + T(wider), g = undercut(m, groove_radius, flank);
    const T inclined = T(1.0) + squared(T(groove_radius * undercut_terms(m).twist));
    return T(roller_radius * groove_radius) * T(g * sqrt(inclined)) /
           T(T(roller_radius * inclined) + wider * g);
}

template <class T, class Height>
[[nodiscard]] T quantity_of(const SpatialDimensions& cam, const Variables<T>& variables, const Height& height,
                            int flank, SpatialQuantity which) {
    const AxisMotion<T> motion = axis_motion(cam, variables, height);
    switch (which) {
        case SpatialQuantity::pressure_numerator:
            return motion.across_travel;
        case SpatialQuantity::pressure_denominator:
            return sign_of_b(cam) * motion.along_b;
        case SpatialQuantity::undercut:
            return undercut(motion, T(variables.roller_radius + T(0.5 * cam.form.groove_clearance)), flank);
        case SpatialQuantity::normal_lever:
            return normal_lever(cam, motion);
        case SpatialQuantity::contact_radius:
            return contact_radius(cam, motion, variables.roller_radius, flank);
    }
    throw ModelError("spatial cam: no known quantity");
}

// The limits of barrel and cylindrical cams over a box of motions and dimensions, by these formulas.

/// A location on the roller: its part of the roller's length, and the flank.
struct PlaceOnRoller {
    double share = 0.0;
    int flank = 1;
};

struct PressureLimit {
    double angle = 0.0;
    int sign = 1;
    bool continued = false;  ///< of barrel cams: by tangents, as the limit itself is where it is convex
};

/// `cam`: its follower and its sense alone. The excess of the pressure angle; of a barrel cam, with u = φ ±
/// ψ, written as ±r ψ' cos φ − ρ sin u.
[[nodiscard]] RangeOver pressure_over(const SpatialDimensions& cam, const MechanismStateOver& state,
                                      const PlaceOnRoller& place, const PressureLimit& limit);

/// margin − g times W³/(r · lever · |V_b|), with the lever of s'' in A·u: linear in s''.
[[nodiscard]] RangeOver undercut_over(const SpatialDimensions& cam, const MechanismStateOver& state,
                                      const PlaceOnRoller& place, double margin);

[[nodiscard]] RangeOver quantity_over(const SpatialDimensions& cam, const MechanismStateOver& state,
                                      const PlaceOnRoller& place, SpatialQuantity which);

/// Of a cam with its numbers, along a stretch of a motion.
[[nodiscard]] RangeAlong quantity_along(const SpatialDimensions& cam, const MechanismStateAlong& state,
                                        const RollerStation& station, SpatialQuantity which);

}  // namespace camopt::spatial_formulas
