// SPDX-License-Identifier: MIT
// The smallest base radius for a given motion, against closed forms of the follower on the cam's axis.
#include "motions/laws/law_catalogue.hpp"
#include "profiles/disk/disk_cam.hpp"
#include "studies/compare/comparison.hpp"
#include "tests/support/middle_cam.hpp"
#include "tests/support/scene_kit.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace camopt {
namespace needed_base_test {

using namespace testing_support;

/// The largest value of f over [0, 1]: samples, then golden section.
template <class Function>
double largest(const Function& f) {
    double best = -1e300, at = 0.0;
    constexpr int samples = 20000;
    for (int i = 0; i <= samples; ++i) {
        const double x = static_cast<double>(i) / samples;
        if (f(x) > best) best = f(x), at = x;
    }
    const double golden = 0.5 * (std::sqrt(5.0) - 1.0);
    double low = std::max(0.0, at - 1.0 / samples), high = std::min(1.0, at + 1.0 / samples);
    for (int i = 0; i < 80; ++i) {
        const double a = high - golden * (high - low), b = low + golden * (high - low);
        (f(a) > f(b) ? high : low) = f(a) > f(b) ? b : a;
    }
    return std::max(best, f(0.5 * (low + high)));
}

/// |φ| <= φm on the cam's axis: s' <= tan φm (base + roller + s).
TEST(NeededBase, IsLeastRadiusForPressureAngle) {
    const Scene scene = pressure_angle_scene(40.0);
    const DrivenMechanism cam = disk_mechanism(middle_cam(disk_of(*scene.cam)));
    for (const char* key : {"modified_sine", "cycloidal", "polynomial_4567"}) {
        const auto law = make_law(key);
        const double lift = scene.motion.lift, slope = std::tan(scene.limits.pressure_angle->value);
        const double expected = largest([&](double x) {
            const MotionPoint point = law->at(x);
            return lift * (point.derivative[1] / scene.motion.rise / slope - point.derivative[0]);
        });
        const NeededBase found = needed_base(scene, cam, *law);
        ASSERT_TRUE(found.radius) << key;
        EXPECT_TRUE(found.broken.empty());
        EXPECT_NEAR(*found.radius / (expected - 10e-3), 1.0, 1e-10) << key;
    }
}

/// A flat face: base + s + s'' >= ρ.
TEST(NeededBase, IsLeastRadiusForFlatFace) {
    const Scene scene = flat_scene(30).with("motion.type = DRD", "limits.cam_radius_min_mm = 2");
    const DrivenMechanism cam = disk_mechanism(middle_cam(disk_of(*scene.cam)));
    const auto law = make_law("polynomial_345");
    const double lift = scene.motion.lift, rise = scene.motion.rise;
    const double expected = 2e-3 + largest([&](double x) {
                                const MotionPoint point = law->at(x);
                                return -lift * (point.derivative[0] + point.derivative[2] / (rise * rise));
                            });
    const NeededBase found = needed_base(scene, cam, *law);
    ASSERT_TRUE(found.radius);
    EXPECT_NEAR(*found.radius / expected, 1.0, 1e-10);
}

TEST(NeededBase, NamesLimitWithoutFeasibleRadius) {
    const Scene scene =
        pressure_angle_scene(40).with("motion.speed_rad_s = 10", "forces = { mass_kg = 1, preload_n = 5 }",
                                      "limits.contact_force_min_n = 10");
    const NeededBase found =
        needed_base(scene, disk_mechanism(middle_cam(disk_of(*scene.cam))), *make_law("modified_sine"));
    EXPECT_FALSE(found.radius);
    EXPECT_EQ(found.broken, "limits.contact_force_min_n");
}

}  // namespace needed_base_test
}  // namespace camopt
