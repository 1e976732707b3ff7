// SPDX-License-Identifier: MIT
// Paper 000: Table 1 from the scenes of its guides of lines and arcs, as well as from the machine of the
// report.
#include "benchmarks/papers/paper_000_parts.hpp"
#include "core/units.hpp"
#include "studies/solve/solve.hpp"
#include "tests/support/scene_kit.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace camopt {
namespace given_guide_test {

using namespace feeding_paper;
using units::degree, units::inch;

constexpr double period = 0.258, turning_time = 0.158;

/// A stroke of the machine by time from its own beginning at rest: its return runs backwards.
struct Stroke {
    Solution solution;
    double first = 0.0;  ///< s: where the scene begins
    bool back = false;

    Stroke(const std::string& scene, double acceleration, bool is_back)
        : solution(solve(testing_support::scene_named(scene))),
          first(std::sqrt(0.5 / acceleration)),
          back(is_back) {}

    [[nodiscard]] std::array<double, columns> row(double time) const {
        const MotionSpec& motion = solution.scene.motion;
        const double since = back ? period - time : time, speed = motion.speed.value();
        const double per_x = motion.unit_angle() / speed, sign = back ? -1.0 : 1.0;
        const MotionPoint at = solution.motion->at((since - first) / per_x);
        const FollowerState feeder{
            solution.scene.cam->find("feeder_start")->middle() + motion.lift * at.derivative[0],
            sign * motion.lift * at.derivative[1] / per_x, motion.lift * at.derivative[2] / (per_x * per_x)};
        const BodyMotion body = body_motion(linkage(), feeder).body;
        std::array<double, columns> values = {
            0.0,      body.angle,      body.velocity,      body.acceleration,
            feeder.s, feeder.velocity, feeder.acceleration};
        for (int i = 0; i < columns; ++i) values[static_cast<std::size_t>(i)] /= column_info(i).unit_value;
        return values;
    }
};

TEST(GivenGuide, TableOneFollowsFromSceneFiles) {
    const Stroke forward("given_guide_forward", 500.0, false), back("given_guide_return", 1248.2, true);
    EXPECT_EQ(forward.solution.certificate.reason, Reason::given_cam);
    int rounded = 0, close = 0;
    for (const PrintedRow& row : printed_rows()) {
        if (!row.moving) continue;
        const double time = instant_of(row.time);
        const auto values = (time < turning_time ? forward : back).row(time), exact = computed_row(row);
        for (int i = theta; i < columns; ++i) {
            const auto column = static_cast<std::size_t>(i);
            EXPECT_NEAR(values[column], exact[column], 1e-5 * std::abs(exact[column]) + 1e-4)
                << row.time << ' ' << column_info(i).symbol;
            const std::string_view words = row.cells[column];
            const double printed = std::stod(std::string(words)), off = std::abs(values[column] - printed);
            rounded += off <= half_digit(words) * (1.0 + 1e-9);
            close += off <= 5.0 * half_digit(words) || off <= 0.003 * std::abs(printed);
        }
    }
    EXPECT_EQ(rounded, agreement().rounded);
    EXPECT_EQ(close, agreement().close);
}

/// What the roller's acceleration and the guide's curvature make of the feeder jumps where arcs begin.
TEST(GivenGuide, AccelerationJumpsWhereArcsJoin) {
    const Solution solution = solve(testing_support::scene_named("given_guide_forward"));
    const auto& breaks = solution.scene.measured->breaks;
    ASSERT_GE(breaks.size(), 3U);
    const double unit = solution.scene.motion.unit_angle();
    double largest = 0.0;
    for (const double angle : breaks) {
        const double x = angle / unit;
        if (!(x > 0.0 && x < 1.0)) continue;
        const MotionPoint left = solution.motion->at(x, Side::left),
                          right = solution.motion->at(x, Side::right);
        EXPECT_NEAR(left.derivative[0], right.derivative[0], 1e-11);
        EXPECT_NEAR(left.derivative[1], right.derivative[1], 1e-7);
        largest = std::max(largest, std::abs(left.derivative[2] - right.derivative[2]));
    }
    EXPECT_GT(largest, 0.1 * solution.peaks.acceleration.value);
}

}  // namespace given_guide_test
}  // namespace camopt
