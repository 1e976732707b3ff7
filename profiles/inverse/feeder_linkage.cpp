// SPDX-License-Identifier: MIT
#include "profiles/inverse/feeder_linkage.hpp"

#include "core/errors.hpp"

#include <fmt/format.h>

namespace camopt {

void FeederLinkage::validate() const {
    if (!(pin_distance > 0.0 && std::isfinite(pin_distance)))
        throw InputError(
            fmt::format("the pin's distance from the pivot is {} m; it must be > 0", pin_distance));
    if (!(std::abs(feeder_offset) > 0.0 && std::isfinite(feeder_offset)))
        throw InputError(fmt::format("the feeder's offset is {} m; it must not be 0", feeder_offset));
    if (!std::isfinite(pin_angle) || !rocker_pivot.allFinite())
        throw InputError("the pin's angle and the rocker's pivot must be finite numbers");
}

Eigen::Vector2d pin_at(const FeederLinkage& linkage, double body_angle) {
    const double angle = body_angle + linkage.pin_angle;
    return linkage.pin_distance * Eigen::Vector2d(std::cos(angle), std::sin(angle));
}

}  // namespace camopt
