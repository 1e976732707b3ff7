// SPDX-License-Identifier: MIT
#include "cam_samples.hpp"

#include "core/units.hpp"
#include "motions/laws/law_catalogue.hpp"

#include <cmath>
#include <memory>

namespace camopt::test {

MotionChain turn_motion(const std::string& law) {
    using units::degree;
    const std::shared_ptr<const Motion> shape = make_law(law);
    return MotionChain({{0.0, 60 * degree, nullptr, 0.0, 1.0, 0.0, 1.0},
                        {60 * degree, 160 * degree, shape, 60 * degree, 100 * degree, 0.0, 1.0},
                        {160 * degree, 200 * degree, nullptr, 0.0, 1.0, 1.0, 1.0},
                        {200 * degree, 360 * degree, shape, 200 * degree, 160 * degree, 1.0, -1.0}});
}

DiskCam sample_cam(FollowerType follower, Rotation rotation) {
    using enum DimensionIndex;
    using units::degree, units::millimetre;
    DiskCam cam{follower, rotation, {}};
    const auto set = [&](DimensionIndex index, double value) {
        cam.dimensions[static_cast<std::size_t>(index)] = value * millimetre;
    };
    if (has_roller(follower)) set(roller_radius, 10);
    if (follower == FollowerType::translating_roller || follower == FollowerType::translating_knife) {
        set(base_radius, has_roller(follower) ? 35 : 45);
        set(offset, 8);
    }
    if (follower == FollowerType::translating_flat) set(base_radius, 60);
    if (follower == FollowerType::oscillating_roller) {
        set(center_distance, 100);
        set(arm_length, 80);
        set(base_radius, std::sqrt(100. * 100 + 80 * 80 - 2 * 100 * 80 * std::cos(32 * degree)) - 10);
    }
    if (follower == FollowerType::oscillating_flat) {
        set(center_distance, 100);
        set(face_offset, 4);
        set(base_radius, 100 * std::sin(22 * degree) - 4);
    }
    return cam;
}

MotionScale sample_scale(FollowerType follower) {
    using units::degree, units::millimetre;
    switch (follower) {
        case FollowerType::translating_flat:
            return {14 * millimetre, 1.0};
        case FollowerType::oscillating_roller:
            return {22 * degree, 1.0};
        case FollowerType::oscillating_flat:
            return {6 * degree, 1.0};
        default:
            return {25 * millimetre, 1.0};
    }
}

}  // namespace camopt::test
