// SPDX-License-Identifier: MIT
// Scenes written in C++: what validate() refuses, and with which words.
#include "core/scene.hpp"

#include "core/errors.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <limits>
#include <numbers>

namespace camopt {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double pi = std::numbers::pi;

Scene good_scene() {
    Scene scene;
    scene.objective.jerk = 1.0;
    return scene;
}

std::string message_of(const std::function<void(Scene&)>& change) {
    Scene scene = good_scene();
    change(scene);
    try {
        validate(scene);
    } catch (const InputError& error) {
        return error.what();
    }
    return "accepted";
}

struct SceneCase {
    std::function<void(Scene&)> change;
    std::string message;
};

TEST(Scene, WrongMembersAreNamed) {
    const std::vector<SceneCase> cases = {
        {[](Scene& s) { s.motion.lift = 0; }, "motion.lift: found 0; allowed: a number > 0"},
        {[](Scene& s) { s.motion.lift = nan; }, "motion.lift: found nan; allowed: a number > 0"},
        {[](Scene& s) { s.motion.rise = 7; },
         "motion.rise: found 7; allowed: a number > 0 and <= 6.283185307179586"},
        {[](Scene& s) { s.motion.speed = 0; }, "motion.speed: found 0; allowed: a number > 0"},
        {[](Scene& s) { s.motion.return_angle = 1; },
         "motion.return_angle: found a return in a motion of type \"DRD\"; allowed: only in type \"RR\""},
        {[](Scene& s) {
             s.motion.type = MotionType::rr;
             s.motion.rise = 4;
         },
         "motion.return_angle: found 8 rad for rise and return together; allowed: at most a whole turn, "
         "6.283185307179586 rad"},
        {[](Scene& s) {
             s.motion.type = MotionType::rr;
             s.motion.return_angle = 1;
             s.motion.symmetric = true;
         },
         "motion.symmetric: found true with a return unlike the rise; allowed: false, or equal angles for "
         "rise and "
         "return"},
        {[](Scene& s) { s.motion.via = {{.at = 2, .displacement = 1}}; },
         "motion.via[0].at: found 2; allowed: a number from 0 to 1"},
        {[](Scene& s) { s.motion.via = {{.at = 0.5}}; },
         "motion.via[0]: found no value; allowed: at least one of displacement, velocity, acceleration"},
        {[](Scene& s) { s.motion.via = {{.at = 0.5, .velocity = nan}}; },
         "motion.via[0].velocity: found nan; allowed: a finite number"},
        {[](Scene& s) { s.spline.degree = 4; }, "spline.degree: found 4; allowed: 3 or 5"},
        {[](Scene& s) { s.spline.segments = 0; },
         "spline.segments: found 0; allowed: an integer from 1 to 65536"},
        {[](Scene& s) { s.spline.continuity = 3; }, "spline.continuity: found 3; allowed: 2 with degree 3"},
        {[](Scene& s) {
             s.spline.breakpoints = {0, nan, 1};
         },
         "spline.breakpoints[1]: found nan after 0; allowed: ascending breakpoints"},
        {[](Scene& s) {
             s.spline.breakpoints = {0, 0.5, 1.1};
         },
         "spline.breakpoints[2]: found 1.1; allowed: 1, the end of the motion"},
        {[](Scene& s) { s.spline.end_jerk = EndJerk::zero; },
         "spline.end_jerk: found \"zero\" with degree 3; allowed: \"free\", or degree 5"},
        {[](Scene& s) { s.objective.jerk = 0; },
         "objective: found no weight > 0; allowed: at least one of velocity, acceleration, jerk, "
         "rms_acceleration, rms_jerk > 0, or of a dimension of the cam that is a range"},
        {[](Scene& s) { s.objective.velocity = -1; }, "objective.velocity: found -1; allowed: a number >= 0"},
        {[](Scene& s) { s.objective.reference.numeric = true; },
         "objective.reference.jerk: found no number; allowed: a number > 0, because objective.jerk = 1"},
        {[](Scene& s) { s.limits.velocity = PeakLimit{.normalised = 0}; },
         "limits.velocity: found 0; allowed: a number > 0"},
        {[](Scene& s) { s.limits.jerk = PeakLimit{.normalised = 1, .given = 1, .unit = "mm/s^3"}; },
         "limits.jerk: found a limit in mm/s^3 without a speed; allowed: a limit in time only where "
         "motion.speed is "
         "given"},
        {[](Scene& s) { s.solver.tolerance = 1; },
         "solver.tolerance: found 1; allowed: a number from 1e-12 to 0.01"},
        {[](Scene& s) { s.solver.max_seconds = 0; }, "solver.max_seconds: found 0; allowed: a number > 0"},
        {[](Scene& s) { s.solver.starts = 0; }, "solver.starts: found 0; allowed: an integer >= 1"},
    };
    for (const SceneCase& c : cases) EXPECT_EQ(message_of(c.change), c.message);
}

TEST(Scene, TheEdgesOfTheRangesAreAllowed) {
    EXPECT_EQ(message_of([](Scene&) {}), "accepted");
    EXPECT_EQ(message_of([](Scene& s) { s.motion.rise = 2 * pi; }), "accepted");
    EXPECT_EQ(message_of([](Scene& s) { s.motion.type = MotionType::rr; }), "accepted");
    EXPECT_EQ(message_of([](Scene& s) { s.spline.breakpoints = {0, 0.3, 0.7, 1 + 5e-13}; }), "accepted");
    EXPECT_EQ(message_of([](Scene& s) {
                  s.motion.symmetric = true;
                  s.spline.breakpoints = {0, 0.3, 0.7, 1};
              }),
              "accepted");
    EXPECT_EQ(message_of([](Scene& s) {
                  s.spline.degree = 5;
                  s.spline.continuity = 3;
                  s.spline.end_jerk = EndJerk::zero;
                  s.spline.design = DesignKind::states;
              }),
              "accepted");
}

}  // namespace
}  // namespace camopt
