// SPDX-License-Identifier: MIT
// Forward simulation of a guide by its points: polylines converge as chords do, a slot's wall leads the
// roller far below 1e-6 rad, a wrong wall is found out.
#include "benchmarks/papers/guide.hpp"
#include "benchmarks/papers/polyline_check.hpp"
#include "core/errors.hpp"
#include "profiles/inverse/reference_machine.hpp"
#include "tests/support/refusal.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace camopt {

namespace inverse_forward_test {

using testing_support::refusal;

using test::inch;

GuideCheckInput input_for(const Guide& guide) {
    GuideCheckInput input;
    input.designed = [&guide](double distance) { return guide.at(distance).angle; };
    input.begin = 2.0 * inch;
    input.end = 13.9 * inch;
    input.places = 2000;
    return input;
}

/// Points of the middle line where the roller is at even steps of time.
std::vector<Eigen::Vector2d> points_in_time(const Guide& guide, int steps) {
    std::vector<Eigen::Vector2d> points;
    const RollerStroke stroke = test::forward_stroke();
    for (int i = 0; i <= steps; ++i)
        points.push_back(guide.at(state_of(stroke, stroke.end * i / steps).distance).position);
    return points;
}

TEST(InverseForward, PolylineConvergesAsChordsDo) {
    const Guide guide = make_g1_guide(test::forward_dimensions());
    GuideCheckInput input = input_for(guide);
    struct Row {
        int points;
        double degrees;
    };
    for (const Row& row : {Row{100, 3.6e-3}, Row{400, 2.2e-4}, Row{1600, 1.4e-5}}) {
        input.points = points_in_time(guide, row.points);
        const double found = polyline_check(input).deviation / units::degree;
        EXPECT_NEAR(found, row.degrees, 0.05 * row.degrees) << row.points;
    }
}

TEST(InverseForward, SlotWallLeadsTheRoller) {
    const Guide guide = make_g1_guide(test::forward_dimensions());
    const double radius = 0.5 * inch;  // chosen
    for (const double side : {1.0, -1.0}) {
        GuideCheckInput input = input_for(guide);
        input.roller_radius = radius;
        const GuidePoints wall = guide_points(guide, 400, side * radius);
        input.points = wall.points;
        input.breaks = wall.breaks;
        const GuideCheckResult result = slot_check(input);
        EXPECT_LT(result.deviation, 1e-6);
        EXPECT_LT(result.deviation, 1e-8) << "the reference is 5e-9 rad";
        // A roller a micrometre too thick turns the body by a measurable amount.
        input.roller_radius = radius + 1e-6;
        EXPECT_GT(slot_check(input).deviation, 3e-6);
    }
}

TEST(InverseForward, RefusesWhatCannotBeChecked) {
    const Guide guide = make_g1_guide(test::forward_dimensions());
    GuideCheckInput input = input_for(guide);
    EXPECT_EQ(refusal([&] { (void)slot_check(input); }),
              "0 points of the guide were given; it needs at least 3");
    input.points = guide_points(guide, 100).points;
    EXPECT_EQ(refusal([&] { (void)slot_check(input); }),
              "the roller's radius is 0 m; it must be > 0");  // no roller
    input.end = 20.0 * inch;
    input.designed = [](double) { return 0.0; };
    EXPECT_EQ(polyline_check(input).deviation, std::numeric_limits<double>::infinity());
}

}  // namespace inverse_forward_test

}  // namespace camopt
