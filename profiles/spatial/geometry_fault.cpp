// SPDX-License-Identifier: MIT
// Whether a spatial cam can be built: at rest, and over the whole range of its motion.
#include "profiles/spatial/spatial_cam.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace camopt {
namespace {

using enum SpatialDimension;

std::string length_text(double value) {
    return fmt::format("{:.6g} mm", value / 1e-3);
}

std::string dimension_fault(const SpatialCam& cam) {
    for (int i = 0; i < spatial_dimension_count; ++i) {
        const auto index = static_cast<SpatialDimension>(i);
        if (!std::isfinite(cam[index])) return fmt::format("the {} is not a number", name_of(index));
        const bool unused = index == arm_length && cam.follower == SpatialFollower::cylindrical_translating;
        if (index != lateral_offset && !unused && !(cam[index] > 0.0))
            return fmt::format("the {} of {} is not positive", name_of(index), length_text(cam[index]));
    }
    if (!std::isfinite(cam.axial_offset) || !std::isfinite(cam.start))
        return "the axial_offset or the start is not a number";
    if (cam.roller_length > 0.0) return {};
    return fmt::format("the roller_length of {} is not positive", length_text(cam.roller_length));
}

std::string swing_fault(double low, double high) {
    const double right_angle = 0.5 * std::numbers::pi;
    if (low > -right_angle && high < right_angle) return {};
    const double degree = std::numbers::pi / 180.0;
    return fmt::format("the follower swings from {:.6g} to {:.6g} deg, beyond a right angle", low / degree,
                       high / degree);
}

/// The far end of the roller's axis keeps its distance from the cam's axis: `radial` > 0.
std::string far_end_fault(double radial) {
    if (radial > 0.0) return {};
    return fmt::format("the far end of the roller is {} from the cam's axis", length_text(radial));
}

}  // namespace

std::string geometry_fault(const SpatialCam& cam, double least, double most) {
    if (std::string fault = dimension_fault(cam); !fault.empty()) return fault;
    if (cam.follower == SpatialFollower::cylindrical_translating || cam.follower == SpatialFollower::barrel) {
        if (cam.follower == SpatialFollower::barrel)
            if (std::string fault = swing_fault(cam.start + least, cam.start + most); !fault.empty())
                return fault;
        return far_end_fault(cam[center_distance] - cam.roller_length);
    }
    const double low = cam.start + least, high = cam.start + most;
    if (std::string fault = swing_fault(low, high); !fault.empty()) return fault;
    const double straightest = low <= 0.0 && high >= 0.0 ? 0.0 : std::min(std::abs(low), std::abs(high));
    return far_end_fault(cam[center_distance] -
                         (cam[arm_length] + cam.roller_length) * std::cos(straightest));
}

}  // namespace camopt
