// SPDX-License-Identifier: MIT
// Private to profiles/inverse/: inverse kinematics from the feeder's motion to the body and the guide, over
// any scalar, so that automatic differentiation gives the partials. Only +, -, ·, /, sqrt: e is the unit
// vector from the rocker's pivot to the pin, P · e = L1 cos(th - phi), P x e = L1 sin(phi - th). ' is by the
// independent variable of the roller's and the feeder's motion: time, or the cam angle.
#pragma once

#include "core/numbers/enclosures.hpp"
#include "core/partials.hpp"
#include "profiles/inverse/feeder_linkage.hpp"

namespace camopt::inverse {

/// Which of the two pins on a line through the rocker's pivot, and to which side of the pivot it lies.
struct Branch {
    double side = 1.0;         ///< +1: the pin lies on the feeder's side of the pivot
    double nearer = 1.0;       ///< +1: the nearer of the two to the rocker's pivot
    double offset_sign = 1.0;  ///< of the feeder's offset
};
[[nodiscard]] inline Branch branch_of(const FeederLinkage& linkage) {
    const Eigen::Vector2d pin = pin_at(linkage, 0.0), arm = pin - linkage.rocker_pivot;
    // Of two points of the pin's circle on a ray, at the nearer one the ray enters the circle: P · e < 0
    // there.
    return {arm.x() * linkage.feeder_offset < 0.0 ? -1.0 : 1.0, pin.dot(arm) < 0.0 ? 1.0 : -1.0,
            linkage.feeder_offset < 0.0 ? -1.0 : 1.0};
}

/// The linkage data for the inverse kinematics; the pin's angle only shifts the body's.
template <class T>
struct LinkageNumbers {
    T pin_distance, pivot_x, pivot_y, offset;
};

template <class T>
[[nodiscard]] LinkageNumbers<T> numbers_of(const FeederLinkage& linkage) {
    return {T(linkage.pin_distance), T(linkage.rocker_pivot.x()), T(linkage.rocker_pivot.y()),
            T(linkage.feeder_offset)};
}

template <class T>
struct Feeder {
    T position, velocity, acceleration;
};

template <class T>
struct Backwards {
    T pin_x, pin_y;
    T reach;                   ///< L2
    T along;                   ///< P · e
    T velocity, acceleration;  ///< theta', theta''
    T discriminant;            ///< < 0: the rocker misses the pin
};

/// Over a box no branch is decided: the root of a possibly negative interval is unbounded.
template <class T>
[[nodiscard]] bool misses(const T& discriminant) {
    return !(discriminant > 0.0);
}
[[nodiscard]] inline bool misses(const RangeOver&) {
    return false;
}
[[nodiscard]] inline bool misses(const RangeAlong&) {
    return false;
}

template <class T>
[[nodiscard]] Backwards<T> backwards(const LinkageNumbers<T>& linkage, const Branch& branch,
                                     const Feeder<T>& feeder) {
    using std::sqrt;
    const T tangent = T(feeder.position - linkage.pivot_y) / linkage.offset;
    const T cosine_squared = T(1.0) / T(T(1.0) + squared(tangent));  // cos² phi
    const T turning = T(feeder.velocity * cosine_squared) / linkage.offset;
    const T turning_rate =
        T(T(feeder.acceleration * cosine_squared) / linkage.offset) - T(2.0 * T(turning * turning) * tangent);
    const T ex = T(branch.side * branch.offset_sign) * T(sqrt(cosine_squared)), ey = ex * tangent;
    Backwards<T> result{};
    const T projection = T(linkage.pivot_x * ex) + T(linkage.pivot_y * ey);
    const T pivot_squared = T(linkage.pivot_x * linkage.pivot_x) + T(linkage.pivot_y * linkage.pivot_y);
    result.discriminant =
        T(projection * projection) + T(T(linkage.pin_distance * linkage.pin_distance) - pivot_squared);
    if (misses(result.discriminant)) return result;
    result.reach = T(-projection) - T(branch.nearer * T(sqrt(result.discriminant)));
    result.pin_x = linkage.pivot_x + T(result.reach * ex);
    result.pin_y = linkage.pivot_y + T(result.reach * ey);
    result.along = T(result.pin_x * ex) + T(result.pin_y * ey);
    const T across = T(result.pin_x * ey) - T(result.pin_y * ex);
    result.velocity = T(turning * result.reach) / result.along;
    const T reach_rate = result.velocity * across;
    const T wanted = T(turning_rate * result.reach) + T(2.0 * T(reach_rate * turning));
    result.acceleration = T(wanted - T(T(result.velocity * result.velocity) * across)) / result.along;
    return result;
}

/// L, L', L''.
template <class T>
struct Roller {
    T distance, velocity, acceleration;
};

/// The guide's slope, its tangent L ψ', and what its curvature is over (1 + L² ψ'²)^(3/2).
template <class T>
struct GuideBend {
    T tangent, top;
};
template <class T>
[[nodiscard]] GuideBend<T> guide_bend(const Roller<T>& roller, const Backwards<T>& body) {
    const T slope = T(-body.velocity) / roller.velocity;
    const T bend =
        -T(body.acceleration + T(slope * roller.acceleration)) / T(roller.velocity * roller.velocity);
    const T tangent = roller.distance * slope;
    return {tangent, T(T(roller.distance * bend) + T(slope * T(squared(tangent) + T(2.0))))};
}

/// Curvature of the guide: (L psi'' + psi' (2 + L² psi'²)) / (1 + L² psi'²)^(3/2), here ' by L.
template <class T>
[[nodiscard]] T guide_curvature(const Roller<T>& roller, const Backwards<T>& body) {
    using std::sqrt;
    const GuideBend<T> guide = guide_bend(roller, body);
    const T secant = squared(guide.tangent) + T(1.0);
    return guide.top / T(secant * T(sqrt(secant)));
}

}  // namespace camopt::inverse
