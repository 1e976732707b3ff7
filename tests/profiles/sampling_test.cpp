// SPDX-License-Identifier: MIT
// Whole cams as points: the chords keep their tolerance, the breakpoints are there.
#include "profiles/sampling.hpp"

#include "core/errors.hpp"
#include "profiles/disk/disk_cam.hpp"
#include "test_turn.hpp"
#include "tests/support/refusal.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace camopt {
namespace sampling_test {

using testing_support::refusal;

using Eigen::Vector2d;
using namespace test;

double distance_to_chord(const Vector2d& point, const Vector2d& from, const Vector2d& to) {
    const Vector2d chord = to - from;
    return std::abs(chord.x() * (point - from).y() - chord.y() * (point - from).x()) / chord.norm();
}

/// The farthest that the cam goes from the polyline, by 50 points a chord.
double worst_distance(const TestCam& cam, const std::vector<MechanismPoint>& points) {
    const TestTurn turn;
    double worst = 0.0;
    for (std::size_t i = 1; i < points.size(); ++i)
        for (int part = 1; part < 50; ++part) {
            const double theta = points[i - 1].theta + (points[i].theta - points[i - 1].theta) * part / 50;
            worst = std::max(worst,
                             distance_to_chord(cam.at(theta, turn).contact, points[i - 1].contact.head<2>(),
                                               points[i].contact.head<2>()));
        }
    return worst;
}

void expect_breakpoints(const std::vector<MechanismPoint>& points) {
    for (const double breakpoint : TestTurn().breakpoints())
        EXPECT_EQ(std::ranges::count(points, breakpoint, &MechanismPoint::theta), 1) << breakpoint / degree;
    EXPECT_TRUE(std::ranges::is_sorted(points, std::ranges::less_equal(), &MechanismPoint::theta));
    EXPECT_TRUE(std::ranges::adjacent_find(points, std::ranges::equal_to(), &MechanismPoint::theta) ==
                points.end());
}

class SampledCam : public ::testing::TestWithParam<TestCam> {
 protected:
    [[nodiscard]] static std::vector<MechanismPoint> sampled(const ProfileSampling& sampling) {
        return sampled_profile(disk_mechanism(GetParam().cam), TestTurn(), {GetParam().lift, 1.0}, sampling);
    }
};

TEST_P(SampledCam, KeepsTheChordToleranceWithoutWaste) {
    for (const double tolerance : {1e-4, 1e-6, 1e-8}) {
        const std::vector<MechanismPoint> points = sampled({.chord_tolerance = tolerance});
        const double worst = worst_distance(GetParam(), points);
        EXPECT_LE(worst, tolerance);
        expect_breakpoints(points);
        // An arc of radius R needs a chord for every 2 sqrt(2 tolerance / R); halving costs at most twice
        // that.
        const double needed = full_turn / (2.0 * std::sqrt(2.0 * tolerance / 0.1));
        EXPECT_LT(static_cast<double>(points.size()), 45.0 + 2.5 * needed) << tolerance;
    }
}

TEST_P(SampledCam, HasThePointsOfTheCam) {
    const TestTurn turn;
    for (const MechanismPoint& point : sampled({.chord_tolerance = 1e-5})) {
        const ProfilePoint expected = GetParam().at(point.theta, turn);
        EXPECT_EQ(point.contact.head<2>(), expected.contact);
        EXPECT_EQ(point.regularity, expected.regularity);
    }
}

TEST_P(SampledCam, PlacesACountEvenly) {
    for (const int count : {2, 3, 7, 37, 361, 1000}) {
        const std::vector<MechanismPoint> points = sampled({.count = count});
        EXPECT_GE(points.size(), static_cast<std::size_t>(count));
        EXPECT_LE(points.size(), static_cast<std::size_t>(count) + 3);
        expect_breakpoints(points);
        for (std::size_t i = 1; i < points.size(); ++i)
            EXPECT_LE(points[i].theta - points[i - 1].theta, full_turn / (count - 1) * (1.0 + 1e-12));
    }
    EXPECT_EQ(sampled({.count = 361}).size(), 361U);
}

INSTANTIATE_TEST_SUITE_P(All, SampledCam, ::testing::ValuesIn(regular_cams()),
                         [](const auto& item) { return item.param.name; });

/// A cusp has no tangent, but the points still come to an end and keep the tolerance.
TEST(Sampling, EndsOnUndercutCams) {
    for (const TestCam& cam : {translating_roller(35, 30), translating_flat(15), oscillating_roller(50)}) {
        const std::vector<MechanismPoint> points =
            sampled_profile(disk_mechanism(cam.cam), TestTurn(), {cam.lift, 1.0}, {.chord_tolerance = 1e-6});
        EXPECT_TRUE(std::ranges::any_of(points, [](const auto& point) { return point.regularity < 0.0; }));
        EXPECT_LT(points.size(), 5000U);
        expect_breakpoints(points);
    }
}

TEST(Sampling, ToleranceSuitsSmallAndLargeLifts) {
    for (const double factor : {1e-6 / 0.025, 1.0 / 0.025}) {
        TestCam cam = translating_roller(45 * factor, 10 * factor, 8 * factor, 25 * factor);
        const double tolerance = 1e-6 * factor;
        const std::vector<MechanismPoint> points = sampled_profile(
            disk_mechanism(cam.cam), TestTurn(), {cam.lift, 1.0}, {.chord_tolerance = tolerance});
        EXPECT_LE(worst_distance(cam, points), tolerance);
        EXPECT_GT(points.size(), 200U);
    }
}

TEST(Sampling, ScalesTheMotion) {
    const MotionPoint point{0.5, {0.5, 2.0, 3.0, -60.0}};
    const FollowerState state = state_of(point, {0.02, 0.5});
    EXPECT_DOUBLE_EQ(state.s, 0.01);
    EXPECT_DOUBLE_EQ(state.velocity, 0.08);
    EXPECT_DOUBLE_EQ(state.acceleration, 0.24);
}

TEST(Sampling, UsesTheUnitAngle) {
    const auto law = make_law("cycloidal");
    const TestCam cam = translating_roller(45, 10);
    const auto points = sampled_profile(disk_mechanism(cam.cam), *law, {cam.lift, 1.5}, {.count = 11});
    ASSERT_EQ(points.size(), 11U);
    EXPECT_DOUBLE_EQ(points.back().theta, 1.5);
    // At the cam angle θ the frame that stands still is the cam frame, turned by θ.
    const auto height = [](const MechanismPoint& at) {
        return std::sin(at.theta) * at.pitch.x() + std::cos(at.theta) * at.pitch.y();
    };
    EXPECT_NEAR(height(points[5]) - height(points[0]), 0.5 * cam.lift, 1e-15);
}

TEST(Sampling, RefusesWhatMakesNoPoints) {
    const TestCam cam = translating_flat(60);
    const auto sample = [&](const ProfileSampling& sampling) {
        return sampled_profile(disk_mechanism(cam.cam), TestTurn(), {cam.lift, 1.0}, sampling);
    };
    EXPECT_EQ(refusal([&] { (void)sample({.count = 1}); }), "count: found 1; allowed: at least 2");
    EXPECT_EQ(refusal([&] { (void)sample({.chord_tolerance = 0.0}); }),
              "chord_tolerance: found 0; allowed: above 0");
    EXPECT_EQ(refusal([&] { (void)sample({.chord_tolerance = std::nan("")}); }),
              "chord_tolerance: found nan; allowed: above 0");
}

}  // namespace sampling_test
}  // namespace camopt
