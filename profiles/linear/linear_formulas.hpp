// SPDX-License-Identifier: MIT
// Private to profiles/linear: the formulas of a plate and the roller on it, generic over the scalar: double
// gives points, automatic differentiation partials, ranges enclosures.
//
// The roller's centre moves along d = (sin ψ, cos ψ), ψ the inclination δ of a pushed follower or the angle
// of an arm, at the speed w (s', l ψ') while the plate slides by c for every radian: in the plate it moves by
// T = (c, 0) + w d. With the components N = w + c sin ψ of T along d and D = |c| cos ψ across it, |T|² = N² +
// D²,
//   tan φ = N/D,   κ = (σ w ψ' N − D b)/|T|³ (ψ' = 0 of a pushed follower),   lever = D/|T|, of an arm l
//   D/|T|
// with b = s'', of an arm l ψ'', and σ the sign of c. κ > 0 where the cam is convex.
#pragma once

#include "profiles/linear/linear_spec.hpp"
#include "scene/cam_mechanism.hpp"

namespace camopt::plate {

template <class T>
using Numbers = std::array<T, plate_number_count>;

/// The kind of follower, and the sign of the travel.
struct Form {
    PlateFollower follower = PlateFollower::translating_roller;
    double sense = 1.0;
};

template <class T>
[[nodiscard]] const T& of(const Numbers<T>& numbers, PlateNumber which) {
    return numbers[static_cast<std::size_t>(which)];
}

/// The arm's angle ψ₀ at displacement 0, from the direction of −x upwards: p + l sin ψ₀ = h + r.
template <class T>
[[nodiscard]] T rest_angle(const Numbers<T>& numbers) {
    using std::asin;
    using enum PlateNumber;
    const T rise = T(of(numbers, base_height) + of(numbers, roller_radius)) - of(numbers, pivot_height);
    return asin(T(rise / of(numbers, arm_length)));
}

template <class T>
struct Roller {
    T along, across;  ///< N, D
    T turning;        ///< σ w ψ'
    T bend;           ///< b
    T lever;          ///< 1, l

    [[nodiscard]] T speed_squared() const { return T(along * along) + T(across * across); }
    [[nodiscard]] T curvature() const {
        using std::sqrt;
        const T squared = speed_squared();
        return T(T(turning * along) - T(across * bend)) / T(squared * T(sqrt(squared)));
    }
    [[nodiscard]] T normal_lever() const {
        using std::sqrt;
        return T(lever * across) / T(sqrt(speed_squared()));
    }
};

/// start: ψ₀ of an arm.
template <class T>
[[nodiscard]] Roller<T> roller(const Form& form, const Numbers<T>& numbers, const T& start, const T& s,
                               const T& velocity, const T& acceleration) {
    using std::cos;
    using std::sin;
    const T travel = (0.5 / std::numbers::pi) * of(numbers, PlateNumber::travel);
    const T arm = is_on_arm(form.follower) ? of(numbers, PlateNumber::arm_length) : T(1.0);
    const T angle = is_on_arm(form.follower) ? T(start + s) : of(numbers, PlateNumber::inclination);
    const T speed = arm * velocity;
    return {T(speed + T(travel * T(sin(angle)))), T(form.sense * T(travel * T(cos(angle)))),
            is_on_arm(form.follower) ? T(form.sense * T(speed * velocity)) : T(0.0), T(arm * acceleration),
            arm};
}

template <class T>
[[nodiscard]] T quantity_of(const Roller<T>& roller, const Form& form, const T& radius,
                            MechanismQuantity which) {
    switch (which) {
        case MechanismQuantity::pressure_numerator:
            return roller.along;
        case MechanismQuantity::pressure_denominator:
            return roller.across;
        case MechanismQuantity::pitch_curvature:
            return roller.curvature();
        case MechanismQuantity::regularity:
            if (form.follower == PlateFollower::translating_knife) return T(1.0);
            return T(1.0) - T(radius * roller.curvature());
        case MechanismQuantity::normal_lever:
            return roller.normal_lever();
        case MechanismQuantity::cam_radius:
        case MechanismQuantity::contact_offset:
        case MechanismQuantity::contact_radius:
            break;
    }
    refuse_quantity(linear_type);
}

/// (factor κ − share) |T|³ over the coefficient of s'', which is D times the lever: linear in s''.
[[nodiscard]] inline RangeOver curvature_excess(const Roller<RangeOver>& still, const RangeOver& acceleration,
                                                const RangeOver& factor, double share) {
    const RangeOver coefficient = still.across * still.lever;
    const RangeOver kept = still.turning * still.along / coefficient;
    return factor * (kept - acceleration) -
           share * (cube_of_root(squared(still.along) + squared(still.across)) / coefficient);
}

}  // namespace camopt::plate
