// SPDX-License-Identifier: MIT
// Motions that do not start or end at rest: given states, motions that go on in the next revolution, laws at
// both ends, turning points at joints, repeated parts.
#include "core/units.hpp"
#include "tests/support/refusal.hpp"
#include "tests/support/solved_scene.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

namespace camopt {
namespace ends_in_motion_test {

using namespace testing_support;

void expect_refusal(const auto& action, const std::string& words) {
    const std::string message = refusal(action);
    EXPECT_NE(message.find(words), std::string::npos) << message;
}

/// By quintics, of another motion than that of its file.
TestScene scene_with(const char* motion) {
    return scene_named("rotary_knife_turn").with(motion);
}

void expect_state(const Motion& motion, double x, Side side, std::array<double, 3> state) {
    for (std::size_t order = 0; order < 3; ++order)
        EXPECT_NEAR(motion.at(x, side).derivative[order], state[order],
                    1e-9 * std::max(1.0, std::abs(state[order])))
            << order;
}

/// A jump of a derivative from the end of the turn to its start.
double jump(const Motion& motion, std::size_t order) {
    return motion.at(motion.end(), Side::left).derivative[order] -
           motion.at(motion.begin(), Side::right).derivative[order];
}

TEST(EndsInMotion, DrdHasTheGivenStates) {
    const Solution solution = optimum_of(
        scene_with("motion = { type = 'DRD', lift_mm = 10, rise_deg = 90, speed_rpm = 60,"
                   "start = { velocity_mm_s = 20 }, end = { velocity = 0.5, acceleration = -1 } }"));
    const double rate = 360.0 / 90.0;  // x in a second
    expect_state(*solution.motion, 0.0, Side::right, {0.0, 20.0 / (10.0 * rate), 0.0});
    expect_state(*solution.motion, 1.0, Side::left, {1.0, 0.5, -1.0});
    EXPECT_FALSE(solution.any_curve_limit) << "its bound is that of motions from rest to rest";
}

TEST(EndsInMotion, RrMayStartDownwards) {
    const Solution solution = optimum_of(
        scene_with("motion = { type = 'RR', start = { velocity = -0.5 }, end = { velocity = -0.5 } }"));
    expect_state(*solution.motion, 0.0, Side::right, {0.0, -0.5, 0.0});
    expect_state(*solution.motion, 2.0, Side::left, {0.0, -0.5, 0.0});
    EXPECT_NEAR(solution.motion->at(1.0).derivative[0], 1.0, 1e-9);
}

/// Splines all around: the turn ends as it starts, one lift further.
TEST(Relative, RingGoesOnSmoothly) {
    const Solution solution = optimum_of(scene_named("rotary_knife_turn"));
    EXPECT_NEAR(jump(*solution.motion, 0), 1.0, 1e-9);
    for (std::size_t order = 1; order < 4; ++order)
        EXPECT_NEAR(jump(*solution.motion, order), 0.0, 1e-6) << order;
    EXPECT_GT(solution.motion->at(0.0).derivative[1], 0.1) << "it does not stop between two turns";
    EXPECT_EQ(solution.segments.front().continuity, 3);
}

/// A dwell inside: the first and the last spline are two runs that join across the end of the turn.
TEST(Relative, RunsJoinAcrossTheEnd) {
    const Solution solution =
        optimum_of(scene_with("motion.segments = [{ kind = 'spline', angle_deg = 150, to = 0.5 }, { kind = "
                              "'dwell', angle_deg = 60 },"
                              "{ kind = 'spline', angle_deg = 150, to = 1 }]"));
    EXPECT_NEAR(jump(*solution.motion, 0), 1.0, 1e-9);
    for (std::size_t order = 1; order < 4; ++order)
        EXPECT_NEAR(jump(*solution.motion, order), 0.0, 1e-6) << order;
    EXPECT_GT(solution.motion->at(0.0).derivative[1], 0.1);
}

/// Line, polynomial, line: a rotary knife that cuts at constant velocity.
TEST(Relative, LawsStandAtBothEnds) {
    const TestScene scene = scene_with(
        "motion.segments = [{ kind = 'law', law = 'constant_velocity', angle_deg = 30, to_deg = 40 },"
        "{ kind = 'spline', angle_deg = 300, to_deg = 320 },"
        "{ kind = 'law', law = 'constant_velocity', angle_deg = 30, to_deg = 360 }]");
    const Solution solution = optimum_of(scene);
    EXPECT_NEAR(jump(*solution.motion, 0), 1.0, 1e-9);
    EXPECT_NEAR(jump(*solution.motion, 1), 0.0, 1e-9);
    expect_refusal([&] { static_cast<void>(solve(scene.with("motion.segments[2].to_deg = 350"))); },
                   "with another velocity");
}

TEST(EndsInMotion, RegionsReachTheOpenEnds) {
    const Solution solution = optimum_of(scene_named("rotary_knife_set_points"));
    expect_state(*solution.motion, 0.0, Side::right, {0.0, 0.5, 0.0});
    expect_state(*solution.motion, 1.0, Side::left, {1.0, 0.5, 0.0});
}

TEST(TurningPoint, IsHeldAtAJoint) {
    const TestScene scene = scene_with(
        "motion = { type = 'program', lift_mm = 10, closed = false, within_lift = false, segments = ["
        "{ kind = 'spline', angle_deg = 90, to = 1, end = { velocity = 0 } },"
        "{ kind = 'spline', angle_deg = 60, to = -1 }] }");
    const Solution turning = optimum_of(scene);
    EXPECT_NEAR(turning.motion->at(1.0).derivative[1], 0.0, 1e-9);
    EXPECT_GT(std::abs(turning.motion->at(1.0).derivative[2]), 1.0) << "it does not rest there";
    Scene free = scene;
    free.motion.segments[0].end.reset();
    EXPECT_GT(std::abs(optimum_of(free).motion->at(1.0).derivative[1]), 1e-3);
}

/// The same motion in every part, at the price of one part.
TEST(Repeat, IsOnePartManyTimes) {
    const std::string head = "motion = { type = 'program', lift_mm = 10, segments = [",
                      dwell = "{ kind = 'dwell', angle_deg = 10 }, ",
                      up = "{ kind = 'spline', angle_deg = 40, to = 1 }, " + dwell;
    // Written out, the second and the last spline need their displacement.
    std::string four;
    for (int i = 0; i < 4; ++i)
        four += up + "{ kind = 'spline', angle_deg = 40" + (i < 3 ? ", to = 0 }, " : " }");
    const Solution repeated =
        optimum_of(scene_with((head + up + "{ kind = 'spline', angle_deg = 40 }], repeat = 4 }").c_str()));
    const Solution whole = optimum_of(scene_with((head + four + "] }").c_str()));
    EXPECT_NEAR(repeated.certificate.objective, whole.certificate.objective, 1e-7);
    ASSERT_EQ(repeated.segments.size(), 12U);
    const Motion& motion = *repeated.motion;
    EXPECT_NEAR(motion.end(), 9.0, 1e-12);
    for (int k = 0; k < 200; ++k) {
        const double x = 2.25 * (k + 0.5) / 200;
        for (int copy = 1; copy < 4; ++copy)
            for (std::size_t order = 0; order < 4; ++order)
                EXPECT_NEAR(motion.at(x + 2.25 * copy).derivative[order], motion.at(x).derivative[order],
                            1e-6);
    }
    EXPECT_LT(repeated.design.values.size(), whole.design.values.size() / 3);
}

TEST(Repeat, AnglesFillOnePart) {
    expect_refusal(
        [] {
            (void)scene_with(
                "motion = { type = 'program', repeat = 10, segments = ["
                "{ kind = 'spline', angle_deg = 20, to = 1 }, { kind = 'spline', angle_deg = 20 }] }")
                .read();
        },
        "those of one of the 10 copies add up to 36 deg");
}

TEST(Dwell, OfZeroIsRefusedWithAdvice) {
    expect_refusal(
        [] {
            Scene scene = scene_with(
                "motion = { type = 'program', segments = ["
                "{ kind = 'spline', angle_deg = 180, to = 1 }, { kind = 'spline', angle_deg = 180 }] }");
            scene.motion.segments.insert(scene.motion.segments.begin() + 1, ProgramSegment{});
            validate(scene);
        },
        "end = { velocity = 0 }");
}

}  // namespace ends_in_motion_test
}  // namespace camopt
