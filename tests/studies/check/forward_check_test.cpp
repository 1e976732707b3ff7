// SPDX-License-Identifier: MIT
#include "studies/check/forward_check.hpp"

#include "core/errors.hpp"
#include "core/units.hpp"
#include "profiles/disk/disk_cam.hpp"
#include "studies/check/forward_check_input.hpp"
#include "studies/check/point_curve.hpp"
#include "tests/studies/cam_samples.hpp"
#include "tests/support/refusal.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <string>
#include <utility>

namespace camopt {
namespace forward_check_test {

using testing_support::refusal;

using Eigen::Vector2d;
using std::numbers::pi;

TEST(PointCurve, IsOfTheSixthOrder) {
    double before = 0.0;
    for (const int count : {40, 80, 160}) {
        std::vector<Vector2d> points;
        for (int i = 0; i < count; ++i)
            points.emplace_back(3.0 * std::cos(2 * pi * i / count), std::sin(2 * pi * i / count));
        const PointCurve curve(points, {}, true);
        double worst = 0.0;
        for (int i = 0; i < 5000; ++i) {
            const Vector2d point = curve.at(curve.length() * i / 5000);
            worst = std::max(worst, std::abs(std::hypot(point.x() / 3.0, point.y()) - 1.0));
        }
        std::printf("[ curve    ] ellipse, %d points: %.2e\n", count, worst);
        EXPECT_TRUE(before == 0.0 || before / worst > 25.0);
        before = worst;
    }
    EXPECT_LT(before, 1e-6);
}

TEST(PointCurve, KeepsCornersAndDropsDuplicates) {
    const std::vector<Vector2d> points = {{0, 0}, {1, 0}, {2, 0}, {2, 0}, {2, 1}, {2, 2}};
    const PointCurve curve(points, std::vector<int>{3}, false);
    EXPECT_DOUBLE_EQ(curve.length(), 4.0);
    EXPECT_NEAR((curve.at(1.7) - Vector2d(1.7, 0)).norm(), 0.0, 1e-15);
    EXPECT_NEAR((curve.at(2.7) - Vector2d(2, 0.7)).norm(), 0.0, 1e-15);
    EXPECT_EQ(refusal([&] { PointCurve(points, std::vector<int>{6}, false); }),
              "break 6 of a curve of 6 points");
    EXPECT_EQ(refusal([&] {
                  PointCurve(std::vector<Vector2d>{{0, 0}, {0, 0}, {1, 0}}, {}, false);
              }),
              "a curve needs at least three different points");
}

TEST(ForwardCheck, EveryFollowerMovesAsDesigned) {
    for (const std::string law : {"polynomial_4567", "modified_sine"})
        for (const FollowerType follower : test::all_followers)
            for (const Rotation rotation : {Rotation::counterclockwise, Rotation::clockwise}) {
                const MotionChain motion = test::turn_motion(law);
                const DiskCam cam = test::sample_cam(follower, rotation);
                std::printf("[ forward  ] %-19s %-16s %-16s", name_of(follower), name_of(rotation),
                            law.c_str());
                for (const int count : {250, 500, 1000, 2000}) {
                    const ForwardCheckResult result = forward_check(forward_check_input(
                        disk_mechanism(cam), motion, test::sample_scale(follower), count));
                    std::printf("  %d: %.1e (%.2f s)", result.points, result.relative, result.seconds);
                    EXPECT_LT(result.relative, count == 2000 ? 1e-12 : 1e-6);
                    EXPECT_EQ(result.beyond, 0);
                    EXPECT_EQ(result.angles, 4001);
                }
                std::printf("\n");
            }
}

TEST(ForwardCheck, AccelerationJumpsAndShortStretchesPass) {
    for (const std::string law : {"parabolic", "mcv_50", "double_harmonic"})
        for (const FollowerType follower : test::all_followers) {
            const MotionChain motion = test::turn_motion(law);
            const auto input = forward_check_input(disk_mechanism(test::sample_cam(follower)), motion,
                                                   test::sample_scale(follower), 2000);
            EXPECT_LT(forward_check(input).relative, 1e-11) << law << " " << name_of(follower);
        }
}

TEST(ForwardCheck, AWrongCamIsFound) {
    for (const FollowerType follower : test::all_followers) {
        const MotionChain motion = test::turn_motion("modified_sine");
        ForwardCheckInput input = forward_check_input(disk_mechanism(test::sample_cam(follower)), motion,
                                                      test::sample_scale(follower), 500);
        for (Vector2d& point : input.points) point *= 1.001;
        const ForwardCheckResult result = forward_check(input);
        EXPECT_GT(result.relative, 5e-4) << name_of(follower);
        EXPECT_LT(result.relative, 5e-3) << name_of(follower);
    }
}

TEST(ForwardCheck, DisplacedPointAndWrongRotationFail) {
    for (const FollowerType follower : test::all_followers) {
        const MotionChain motion = test::turn_motion("modified_sine");
        ForwardCheckInput input = forward_check_input(disk_mechanism(test::sample_cam(follower)), motion,
                                                      test::sample_scale(follower), 500);
        ForwardCheckInput bump = input;
        bump.points[137] *= 1.0001;
        EXPECT_GT(forward_check(bump).relative, 5e-5) << name_of(follower);
        input.rotation = Rotation::clockwise;
        EXPECT_GT(forward_check(input).relative, 0.05) << name_of(follower);
    }
}

TEST(ForwardCheck, UndercutCamsAreFound) {
    const MotionChain motion = test::turn_motion("polynomial_4567");
    DiskCam roller = test::sample_cam(FollowerType::translating_roller);
    roller.dimensions[static_cast<std::size_t>(DimensionIndex::roller_radius)] =
        39e-3;  // critical: 34.5 at 45
    roller.dimensions[static_cast<std::size_t>(DimensionIndex::base_radius)] = 6e-3;
    const DiskCam flat = test::sample_cam(FollowerType::oscillating_flat, Rotation::clockwise);
    for (const auto& [cam, lift] : {std::pair(roller, 25e-3), std::pair(flat, 10 * units::degree)}) {
        const auto result =
            forward_check(forward_check_input(disk_mechanism(cam), motion, {lift, 1.0}, 1000));
        EXPECT_GT(result.relative, 1e-3);
        std::printf("[ forward  ] undercut %s: %.2e at %.1f deg\n", name_of(cam.follower), result.relative,
                    result.theta / units::degree);
    }
}

TEST(ForwardCheck, SectorIsCheckedBetweenEnds) {
    for (const FollowerType follower : test::all_followers) {
        const auto scale = test::sample_scale(follower);
        const DiskCam cam = test::sample_cam(follower);
        const MotionChain turn = test::turn_motion("modified_sine");
        const MotionChain rise({turn.parts()[1]});
        ForwardCheckInput input = forward_check_input(disk_mechanism(cam), rise, scale, 600);
        EXPECT_FALSE(input.closed);
        const ForwardCheckResult result = forward_check(input);
        EXPECT_LT(result.relative, 1e-7) << name_of(follower);
        EXPECT_LT(result.beyond, 5) << name_of(follower);
        EXPECT_EQ(result.angles + result.beyond, input.angles);
    }
}

TEST(ForwardCheck, SaysWhatIsWrong) {
    ForwardCheckInput input;
    input.points = {{1, 0}, {0, 1}, {-1, 0}};
    EXPECT_EQ(refusal([&] { (void)forward_check(input); }), "a forward check needs the designed motion");
    input.designed = [](double) { return 0.0; };
    input.angles = 0;
    EXPECT_EQ(refusal([&] { (void)forward_check(input); }), "a forward check of 0 angles: at least 1");
    input.angles = 1;
    input.points[1].x() = NAN;
    EXPECT_EQ(refusal([&] { (void)forward_check(input); }),
              "a forward check takes finite points only, and one is not");
}

}  // namespace forward_check_test
}  // namespace camopt
