// SPDX-License-Identifier: MIT
#include "profiles/spatial/spatial_spec.hpp"
#include "tests/input/scene_key_cases.hpp"

#include <numbers>

namespace camopt::input {
namespace spatial_key_cases {

using enum SpatialFollower;

constexpr double pi = std::numbers::pi;

/// A spatial cam's scene, without one of its quantities.
std::string spatial(SpatialFollower follower, const std::string& except = "") {
    std::string toml = swings(follower) ? "motion.lift_deg = 20\n" : "motion.lift_mm = 20\n";
    const auto add = [&](const std::string& quantity, const std::string& value) {
        if (quantity != except) toml += "cam." + quantity + value + "\n";
    };
    add("type", follower == barrel ? " = \"barrel\"" : " = \"cylindrical\"");
    if (follower != barrel)
        add("follower", follower == cylindrical_rotating ? " = \"rotating\"" : " = \"translating\"");
    add("roller_radius", "_mm = 10");
    add("roller_length", "_mm = 20");
    if (follower != cylindrical_translating) {
        add("arm_length", "_mm = 70");
        add("center_distance", "_mm = 150");
    } else {
        add("cylinder_radius", "_mm = 60");
    }
    return toml;
}

std::function<double(const Scene&)> low(SpatialNumber which) {
    return [which](const Scene& s) {
        return s.cam.value().dimensions.at(static_cast<std::size_t>(which)).value.low;
    };
}
std::function<double(const Scene&)> high(SpatialNumber which) {
    return [which](const Scene& s) {
        return s.cam.value().dimensions.at(static_cast<std::size_t>(which)).value.high;
    };
}
std::function<double(const Scene&)> kind(SpatialFollower follower) {
    return [follower](const Scene& s) { return s.cam && spatial_follower(*s.cam) == follower ? 1.0 : 0.0; };
}

}  // namespace spatial_key_cases

std::vector<KeyCase> spatial_cases() {
    using namespace spatial_key_cases;
    using enum SpatialNumber;
    return {
        {"cam.type", "\"barrel\"", 1, kind(barrel), spatial(barrel, "type")},
        {"cam.type", "\"cylindrical\"", 1, kind(cylindrical_rotating), spatial(cylindrical_rotating, "type")},
        {"cam.follower", "\"rotating\"", 1, kind(cylindrical_rotating),
         spatial(cylindrical_rotating, "follower")},
        {"cam.follower", "\"translating\"", 1, kind(cylindrical_translating),
         spatial(cylindrical_translating, "follower")},
        {"cam.rotation", "\"clockwise\"", 1,
         [](const Scene& s) { return s.cam.value().rotation == Rotation::clockwise ? 1.0 : 0.0; },
         spatial(barrel)},
        {"cam.roller_radius_mm", "{ min = 5, max = 8 }", 0.008, high(roller_radius),
         spatial(barrel, "roller_radius")},
        {"cam.roller_length_mm", "25", 0.025, low(roller_length), spatial(barrel, "roller_length")},
        {"cam.roller_length_in", "1", 0.0254, low(roller_length),
         spatial(cylindrical_translating, "roller_length")},
        {"cam.roller_length_m", "{ min = 0.01, max = 0.02 }", 0.02, high(roller_length),
         spatial(cylindrical_rotating, "roller_length")},
        {"cam.arm_length_mm", "80", 0.08, low(arm_length), spatial(barrel, "arm_length")},
        {"cam.center_distance_mm", "{ min = 120, max = 250 }", 0.25, high(center_distance),
         spatial(barrel, "center_distance")},
        {"cam.cylinder_radius_mm", "65", 0.065, low(center_distance),
         spatial(cylindrical_translating, "cylinder_radius")},
        {"cam.cylinder_radius_in", "2", 0.0508, low(center_distance),
         spatial(cylindrical_translating, "cylinder_radius")},
        {"cam.cylinder_radius_m", "{ min = 0.05, max = 0.07 }", 0.05, low(center_distance),
         spatial(cylindrical_translating, "cylinder_radius")},
        {"cam.lateral_offset_mm", "72", 0.072, low(lateral_offset), spatial(barrel, "lateral_offset")},
        {"cam.axial_offset_mm", "3", 0.0, low(lateral_offset), spatial(barrel)},  // none is 0
        {"cam.lateral_offset_in", "-0.5", -0.0127, low(lateral_offset), spatial(cylindrical_rotating)},
        {"cam.lateral_offset_m", "{ min = -0.01, max = 0.01 }", -0.01, low(lateral_offset),
         spatial(cylindrical_translating)},
        {"cam.axial_offset_mm", "-5", -0.005, low(axial_offset), spatial(barrel)},
        {"cam.axial_offset_in", "1", 0.0254, low(axial_offset), spatial(cylindrical_rotating)},
        {"cam.axial_offset_m", "0.01", 0.01, low(axial_offset), spatial(cylindrical_translating)},
        {"cam.start_angle_deg", "-9", -pi / 20, low(start), spatial(barrel)},
        {"cam.start_angle_rad", "0.1", 0.1, low(start), spatial(cylindrical_rotating)},
        // Without it the swing is even about the line through both axes.
        {"motion.lift_deg", "30", -pi / 12, low(start),
         spatial(barrel).substr(std::string("motion.lift_deg = 20\n").size())},
    };
}

}  // namespace camopt::input
