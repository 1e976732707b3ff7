// SPDX-License-Identifier: MIT
// Motions that do not start or end at rest: given states, motions that go on in the next revolution, laws at
// both ends, turning points at joints, repeated parts.
#include "core/units.hpp"
#include "input/loading/load_scene.hpp"
#include "input/scene_reader.hpp"
#include "studies/solve/solve.hpp"
#include "tests/support/refusal.hpp"
#include "tests/support/source_folder.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

namespace camopt {
namespace ends_in_motion_test {

void expect_refusal(const auto& action, const std::string& words) {
    const std::string message = testing_support::refusal(action);
    EXPECT_NE(message.find(words), std::string::npos) << message;
}

Scene scene_of(const std::string& toml) {
    return input::read_scene(toml, "s.toml", known_names(), {});
}

const std::string objective =
    "[objective]\nacceleration = 1\njerk = 0.2\n[spline]\ndegree = 5\nsegments = 12\n";

Solution optimum_of(const Scene& scene) {
    Solution solution = solve(scene);
    EXPECT_EQ(solution.certificate.verdict, Verdict::optimal) << solution.certificate.reason;
    if (!solution.motion) throw InputError("no motion");
    return solution;
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
    const Solution solution =
        optimum_of(scene_of("[motion]\ntype = \"DRD\"\nlift_mm = 10\nrise_deg = 90\nspeed_rpm = 60\n"
                            "start = { velocity_mm_s = 20 }\nend = { velocity = 0.5, acceleration = -1 }\n" +
                            objective));
    const double rate = 360.0 / 90.0;  // x in a second
    expect_state(*solution.motion, 0.0, Side::right, {0.0, 20.0 / (10.0 * rate), 0.0});
    expect_state(*solution.motion, 1.0, Side::left, {1.0, 0.5, -1.0});
    EXPECT_FALSE(solution.any_curve_limit) << "its bound is that of motions from rest to rest";
}

TEST(EndsInMotion, RrMayStartDownwards) {
    const Solution solution = optimum_of(scene_of(
        "[motion]\ntype = \"RR\"\nstart = { velocity = -0.5 }\nend = { velocity = -0.5 }\n" + objective));
    expect_state(*solution.motion, 0.0, Side::right, {0.0, -0.5, 0.0});
    expect_state(*solution.motion, 2.0, Side::left, {0.0, -0.5, 0.0});
    EXPECT_NEAR(solution.motion->at(1.0).derivative[0], 1.0, 1e-9);
}

const std::string knife =
    "[motion]\ntype = \"program\"\nlift_deg = 360\nspeed_rpm = 250\nclosed = \"relative\"\n";

/// Splines all around: the turn ends as it starts, one lift further.
TEST(Relative, RingGoesOnSmoothly) {
    const Solution solution =
        optimum_of(scene_of(knife +
                            "[[motion.segments]]\nkind = \"spline\"\nangle_deg = 200\nto = 0.8\n"
                            "via = [{ at = 0.5, velocity_deg_deg = 0.5 }]\n"
                            "[[motion.segments]]\nkind = \"spline\"\nangle_deg = 160\nto = 1\n" +
                            objective));
    EXPECT_NEAR(jump(*solution.motion, 0), 1.0, 1e-9);
    for (std::size_t order = 1; order < 4; ++order)
        EXPECT_NEAR(jump(*solution.motion, order), 0.0, 1e-6) << order;
    EXPECT_GT(solution.motion->at(0.0).derivative[1], 0.1) << "it does not stop between two turns";
    EXPECT_EQ(solution.segments.front().continuity, 3);
}

/// A dwell inside: the first and the last spline are two runs that join across the end of the turn.
TEST(Relative, RunsJoinAcrossTheEnd) {
    const Solution solution =
        optimum_of(scene_of(knife +
                            "[[motion.segments]]\nkind = \"spline\"\nangle_deg = 150\nto = 0.5\n"
                            "[[motion.segments]]\nkind = \"dwell\"\nangle_deg = 60\n"
                            "[[motion.segments]]\nkind = \"spline\"\nangle_deg = 150\nto = 1\n" +
                            objective));
    EXPECT_NEAR(jump(*solution.motion, 0), 1.0, 1e-9);
    for (std::size_t order = 1; order < 4; ++order)
        EXPECT_NEAR(jump(*solution.motion, order), 0.0, 1e-6) << order;
    EXPECT_GT(solution.motion->at(0.0).derivative[1], 0.1);
}

/// Line, polynomial, line: a rotary knife that cuts at constant velocity.
TEST(Relative, LawsStandAtBothEnds) {
    const std::string lines =
        "[[motion.segments]]\nkind = \"law\"\nlaw = \"constant_velocity\"\nangle_deg = 30\nto_deg = 40\n"
        "[[motion.segments]]\nkind = \"spline\"\nangle_deg = 300\nto_deg = 320\n"
        "[[motion.segments]]\nkind = \"law\"\nlaw = \"constant_velocity\"\nangle_deg = 30\nto_deg = ";
    const Solution solution = optimum_of(scene_of(knife + lines + "360\n" + objective));
    EXPECT_NEAR(jump(*solution.motion, 0), 1.0, 1e-9);
    EXPECT_NEAR(jump(*solution.motion, 1), 0.0, 1e-9);
    expect_refusal([&] { static_cast<void>(solve(scene_of(knife + lines + "350\n" + objective))); },
                   "with another velocity");
}

TEST(EndsInMotion, RegionsReachTheOpenEnds) {
    const Scene scene = input::read_scene_file(
        source_folder() + "/tests/support/cases/rotary_knife_set_points.toml", known_names());
    const Solution solution = optimum_of(scene);
    expect_state(*solution.motion, 0.0, Side::right, {0.0, 0.5, 0.0});
    expect_state(*solution.motion, 1.0, Side::left, {1.0, 0.5, 0.0});
}

TEST(TurningPoint, IsHeldAtAJoint) {
    const std::string text =
        "[motion]\ntype = \"program\"\nlift_mm = 10\nclosed = false\nwithin_lift = false\n"
        "[[motion.segments]]\nkind = \"spline\"\nangle_deg = 90\nto = 1\nend = { velocity = 0 }\n"
        "[[motion.segments]]\nkind = \"spline\"\nangle_deg = 60\nto = -1\n" +
        objective;
    const Solution turning = optimum_of(scene_of(text));
    EXPECT_NEAR(turning.motion->at(1.0).derivative[1], 0.0, 1e-9);
    EXPECT_GT(std::abs(turning.motion->at(1.0).derivative[2]), 1.0) << "it does not rest there";
    Scene free = scene_of(text);
    free.motion.segments[0].end.reset();
    EXPECT_GT(std::abs(optimum_of(free).motion->at(1.0).derivative[1]), 1e-3);
}

/// The same motion in every part, at the price of one part.
TEST(Repeat, IsOnePartManyTimes) {
    const std::string part =
        "[[motion.segments]]\nkind = \"spline\"\nangle_deg = 40\nto = 1\n"
        "[[motion.segments]]\nkind = \"dwell\"\nangle_deg = 10\n"
        "[[motion.segments]]\nkind = \"spline\"\nangle_deg = 40\n";
    const std::string head = "[motion]\ntype = \"program\"\nlift_mm = 10\n";
    std::string four;
    for (int i = 0; i < 4; ++i) four += part;
    // Written out, the second and the last spline need their displacement.
    std::size_t at = 0;
    const std::string open = "angle_deg = 40\n[[";
    while ((at = four.find(open, at)) != std::string::npos) four.insert(at + 15, "to = 0\n");
    const Solution repeated = optimum_of(scene_of(head + "repeat = 4\n" + part + objective));
    const Solution whole = optimum_of(scene_of(head + four + objective));
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
            static_cast<void>(
                scene_of("[motion]\ntype = \"program\"\nrepeat = 10\n[[motion.segments]]\nkind = "
                         "\"spline\"\nangle_deg = "
                         "20\nto = 1\n[[motion.segments]]\nkind = \"spline\"\nangle_deg = 20\n" +
                         objective));
        },
        "those of one of the 10 copies add up to 36 deg");
}

TEST(Dwell, OfZeroIsRefusedWithAdvice) {
    expect_refusal(
        [] {
            Scene scene = scene_of(
                "[motion]\ntype = \"program\"\n[[motion.segments]]\nkind = \"spline\"\nangle_deg = 180\nto "
                "= 1\n[[motion.segments]]\nkind = \"spline\"\nangle_deg = 180\n" +
                objective);
            scene.motion.segments.insert(scene.motion.segments.begin() + 1, ProgramSegment{});
            validate(scene);
        },
        "end = { velocity = 0 }");
}

}  // namespace ends_in_motion_test
}  // namespace camopt
