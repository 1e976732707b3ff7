// SPDX-License-Identifier: MIT
// Finished grooves and conjugate disks, by their points alone; and points that were spoiled.
#include "core/units.hpp"
#include "profiles/disk/disk_cam.hpp"
#include "studies/check/check_cam.hpp"
#include "tests/studies/cam_samples.hpp"
#include "tests/support/refusal.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <random>

namespace camopt {
namespace two_sided_check_test {

using testing_support::refusal;
using units::degree;

DiskCam sample(FollowerType follower, CamForm form, std::mt19937& random) {
    const auto between = [&](double low, double high) {
        return low + (high - low) * static_cast<double>(random()) / 4294967295.0;
    };
    DiskCam cam =
        test::sample_cam(follower, random() % 2 == 0 ? Rotation::clockwise : Rotation::counterclockwise);
    const auto base = static_cast<std::size_t>(DimensionIndex::base_radius),
               roller = static_cast<std::size_t>(DimensionIndex::roller_radius);
    cam.dimensions[base] += cam.dimensions[roller];
    cam.dimensions[roller] = between(5e-3, 7e-3);
    cam.dimensions[base] -= cam.dimensions[roller];
    cam.form.type = form;
    if (form == CamForm::grooved) cam.form.groove_clearance = between(0.02e-3, 0.1e-3);
    if (form == CamForm::conjugate) {
        cam.form.second_roller_radius = between(4e-3, 6e-3);
        if (is_oscillating(follower))
            cam.form.arm_angle = between(80.0, 90.0) * degree;
        else
            cam.form.roller_distance = between(130e-3, 140e-3);
    }
    return cam;
}

constexpr FollowerType rollers[] = {FollowerType::translating_roller, FollowerType::oscillating_roller};

TEST(TwoSidedCheck, EitherSideReproducesDesignedMotion) {
    std::mt19937 random(11U);
    const MotionChain motion = test::turn_motion("polynomial_4567");
    for (const FollowerType follower : rollers)
        for (const CamForm form : {CamForm::grooved, CamForm::conjugate})
            for (int i = 0; i < 3; ++i) {
                const DiskCam cam = sample(follower, form, random);
                const MotionScale scale = {0.5 * test::sample_scale(follower).lift, 1.0};
                const ForwardCheckReport report = two_sided_check(disk_mechanism(cam), motion, scale, 1500);
                std::printf("[ two sides] %-19s %-10s relative %.1e, play %.4g to %.4g, %.2f s\n",
                            name_of(follower), name_of(form), report.relative, report.play->least,
                            report.play->largest, report.seconds);
                EXPECT_LT(report.relative, 1e-9);
                ASSERT_TRUE(report.play.has_value());
                if (form == CamForm::conjugate) {
                    EXPECT_LT(std::abs(report.play->least), 1e-9);
                    EXPECT_LT(std::abs(report.play->largest), 1e-9);
                    EXPECT_FALSE(report.play->least_groove_width.has_value());
                    continue;
                }
                // Across the groove it is the clearance; along the follower's way clearance / lever.
                const double clearance = cam.form.groove_clearance;
                const double lever = is_oscillating(follower) ? cam[DimensionIndex::arm_length] : 1.0;
                EXPECT_GT(report.play->least, 0.999 * clearance / lever);
                EXPECT_LT(report.play->largest, 2.0 * clearance / lever);
                EXPECT_NEAR(*report.play->least_groove_width,
                            2.0 * cam[DimensionIndex::roller_radius] + clearance, 1e-9);
            }
}

TEST(TwoSidedCheck, FindsWrongFlankOrGroove) {
    std::mt19937 random(3U);
    const MotionChain motion = test::turn_motion("polynomial_4567");
    const DiskCam cam = sample(FollowerType::translating_roller, CamForm::grooved, random);
    const MotionScale scale = {10e-3, 1.0};
    const double filling = surface_offset(cam, 0);
    const DrivenMechanism mechanism = disk_mechanism(cam);
    const ForwardCheckInput inner = side_check_input(mechanism, motion, scale, {0, 1500, filling});
    ForwardCheckInput outer = side_check_input(mechanism, motion, scale, {1, 1500, filling});
    EXPECT_LT(forward_check(outer).deviation, 1e-10);
    EXPECT_NEAR(least_width(inner, outer), 2.0 * filling, 1e-9);
    constexpr double dent = 0.03e-3;
    for (std::size_t i = 300; i < 360; ++i) outer.points[i] *= 1.0 - dent / outer.points[i].norm();
    EXPECT_GT(forward_check(outer).deviation, 0.5 * dent);
    EXPECT_NEAR(least_width(inner, outer), 2.0 * filling - dent, 0.2 * dent);
}

TEST(TwoSidedCheck, FindsDisksThatJam) {
    std::mt19937 random(8U);
    const MotionChain motion = test::turn_motion("polynomial_4567");
    const DiskCam cam = sample(FollowerType::oscillating_roller, CamForm::conjugate, random);
    const MotionScale scale = {10.0 * degree, 1.0};
    ForwardCheckInput second =
        side_check_input(disk_mechanism(cam), motion, scale, {1, 1500, roller_radius_of(cam, 1)});
    for (Eigen::Vector2d& point : second.points) point *= 1.0 + 0.02e-3 / point.norm();  // too large a disk
    const ForwardCheckResult found = forward_check(second);
    EXPECT_GT(found.deviation * cam[DimensionIndex::arm_length], 0.015e-3);
}

TEST(TwoSidedCheck, IsForTwoSides) {
    const MotionChain motion = test::turn_motion("polynomial_4567");
    const DiskCam cam = test::sample_cam(FollowerType::translating_roller);
    EXPECT_EQ(refusal([&] {
                  static_cast<void>(two_sided_check(disk_mechanism(cam), motion, {10e-3, 1.0}));
              }),
              "a check of both sides needs a groove or a conjugate cam, and this cam has one side");
}

}  // namespace two_sided_check_test
}  // namespace camopt
