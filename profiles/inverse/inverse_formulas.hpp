// SPDX-License-Identifier: MIT
// Private to profiles/inverse/: from the feeder's motion back to the body, over any scalar, so that automatic
// differentiation gives the partials. Only +, -, ·, /, sqrt: e is the unit vector from the rocker's pivot to
// the pin, P · e = L1 cos(th - phi), P x e = L1 sin(phi - th).
#pragma once

#include "profiles/inverse/feeder_linkage.hpp"

#include <cmath>

namespace camopt::inverse {

/// Which of the two pins on a line through the rocker's pivot, and to which side of the pivot it lies.
struct Branch {
    double side = 1.0;    ///< +1: the pin lies on the feeder's side of the pivot
    double nearer = 1.0;  ///< +1: the nearer of the two to the rocker's pivot
};
[[nodiscard]] Branch branch_of(const FeederLinkage& linkage);

template <class T>
struct Backwards {
    T pin_x, pin_y;
    T reach;                   ///< L2
    T along;                   ///< P · e
    T velocity, acceleration;  ///< theta', theta''
    T discriminant;            ///< < 0: the rocker misses the pin
};

template <class T>
[[nodiscard]] Backwards<T> backwards(const FeederLinkage& linkage, const Branch& branch, const T& position,
                                     const T& speed, const T& acceleration) {
    using std::sqrt;
    const double offset = linkage.feeder_offset;
    const double cx = linkage.rocker_pivot.x(), cy = linkage.rocker_pivot.y();
    const T tangent = (position - cy) / offset;
    const T squared = T(1.0) / T(T(1.0) + tangent * tangent);  // cos² phi
    const T turning = speed * squared / offset;
    const T turning_rate = T(acceleration * squared / offset) - T(2.0 * turning * turning * tangent);
    const T ex = branch.side * T(sqrt(squared)) * (offset > 0.0 ? 1.0 : -1.0), ey = ex * tangent;
    Backwards<T> result;
    const T projection = T(cx * ex) + T(cy * ey);
    result.discriminant = T(projection * projection) +
                          (linkage.pin_distance * linkage.pin_distance - linkage.rocker_pivot.squaredNorm());
    if (!(result.discriminant > 0.0)) return result;
    result.reach = T(-projection) - T(branch.nearer * T(sqrt(result.discriminant)));
    result.pin_x = T(cx + result.reach * ex);
    result.pin_y = T(cy + result.reach * ey);
    result.along = T(result.pin_x * ex) + T(result.pin_y * ey);
    const T across = T(result.pin_x * ey) - T(result.pin_y * ex);
    result.velocity = turning * result.reach / result.along;
    const T reach_rate = result.velocity * across;
    const T wanted = T(turning_rate * result.reach) + T(2.0 * reach_rate * turning);
    result.acceleration = T(wanted - T(result.velocity * result.velocity * across)) / result.along;
    return result;
}

}  // namespace camopt::inverse
