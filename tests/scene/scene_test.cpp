// SPDX-License-Identifier: MIT
// Scenes written in C++: what validate() refuses, and with which words.
#include "scene/scene.hpp"

#include "profiles/disk/disk_cam.hpp"
#include "tests/support/refusal.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <limits>
#include <numbers>

namespace camopt {
namespace scene_test {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double pi = std::numbers::pi;

Scene good_scene() {
    Scene scene;
    scene.objective.jerk = 1.0;
    return scene;
}

std::string message_of(const std::function<void(Scene&)>& change) {
    Scene scene = good_scene();
    return testing_support::refusal(
        [&] {
            change(scene);
            validate(scene);
        },
        "accepted");
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
         "motion.return_angle: found 8 rad for rise and return together; allowed: at most one revolution, "
         "6.283185307179586 rad"},
        {[](Scene& s) {
             s.motion.type = MotionType::rr;
             s.motion.return_angle = 1;
             s.motion.symmetric = true;
         },
         "motion.symmetric: found true with a return different from the rise; allowed: false, or equal "
         "angles for "
         "rise and "
         "return"},
        {[](Scene& s) { s.motion.via = {{.at = 2, .displacement = 1}}; },
         "motion.via[0].at: found 2; allowed: a number from 0 to 1"},
        {[](Scene& s) { s.motion.via = {{.at = 0.5}}; },
         "motion.via[0]: found no value; allowed: at least one of displacement, velocity, acceleration"},
        {[](Scene& s) { s.motion.via = {{.at = 0.5, .velocity = nan}}; },
         "motion.via[0].velocity: found nan; allowed: a finite number"},
        {[](Scene& s) { s.spline.degree = 4; }, "spline.degree: found 4; allowed: 3, 5 or 7"},
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
        {[](Scene& s) { s.spline.rest = 3; },
         "spline.end_jerk: found \"zero\" with degree 3; allowed: \"free\", or degree 5 or 7"},
        {[](Scene& s) { s.spline.rest = 4; },
         "spline.rest: found 4 with degree 3; allowed: 2, or degree 5 or 7"},
        {[](Scene& s) {
             s.spline.degree = 5;
             s.spline.rest = 5;
         },
         "spline.rest: found 5 with degree 5; allowed: an integer from 2 to 4"},
        {[](Scene& s) { s.spline.rest = 1; },
         "spline.rest: found 1 with degree 3; allowed: 2, or degree 5 or 7"},
        {[](Scene& s) {
             s.spline.degree = 7;
             s.spline.continuity = 2;
         },
         "spline.continuity: found 2; allowed: an integer from 3 to 6 with degree 7"},
        {[](Scene& s) { s.objective.jerk = 0; },
         "objective: found no weight > 0; allowed: at least one of velocity, acceleration, jerk, "
         "torque, rms_acceleration, rms_jerk, area > 0, or of a dimension of the cam that is a range"},
        {[](Scene& s) { s.objective.velocity = -1; }, "objective.velocity: found -1; allowed: a number >= 0"},
        {[](Scene& s) { s.objective.reference.numeric = true; },
         "objective.reference.jerk: found no number; allowed: a number > 0, because objective.jerk = 1"},
        {[](Scene& s) { s.limits.velocity = PeakLimit(0); },
         "limits.velocity: found 0; allowed: a number > 0"},
        {[](Scene& s) { s.limits.jerk = PeakLimit(1, {}, 1, "mm/s^3"); },
         "limits.jerk: found the unit \"mm/s^3\" without a speed; allowed: together with motion.speed, or by "
         "the "
         "cam angle: jerk, jerk_mm_rad3, jerk_in_rad3, jerk_m_rad3, jerk_mm_deg3 or jerk_in_deg3"},
        {[](Scene& s) { s.solver.tolerance = 1; },
         "solver.tolerance: found 1; allowed: a number from 1e-12 to 0.01"},
        {[](Scene& s) { s.solver.max_seconds = 0; }, "solver.max_seconds: found 0; allowed: a number > 0"},
        {[](Scene& s) { s.solver.starts = 0; },
         "solver.starts: found 0; allowed: an integer from 1 to 100000"},
    };
    for (const SceneCase& c : cases) EXPECT_EQ(message_of(c.change), c.message);
}

Scene program_scene() {
    Scene scene = good_scene();
    scene.motion.type = MotionType::program;
    scene.motion.segments = {{.kind = SegmentKind::dwell, .angle = pi / 2, .to = {}},
                             {.kind = SegmentKind::spline, .angle = pi / 2, .to = 1.0},
                             {.kind = SegmentKind::law, .angle = pi / 2, .law = "cycloidal", .to = 0.5},
                             {.kind = SegmentKind::spline, .angle = pi / 4, .to = {}},
                             {.kind = SegmentKind::dwell, .angle = pi / 4, .to = {}}};
    return scene;
}

Scene cam_scene(FollowerType follower = FollowerType::translating_roller) {
    Scene scene = good_scene();
    scene.motion.lift_is_angle = is_oscillating(follower);
    DiskSpec cam;
    cam.follower = follower;
    for (const DimensionIndex index : {DimensionIndex::base_radius, DimensionIndex::roller_radius,
                                       DimensionIndex::center_distance, DimensionIndex::arm_length})
        if (has_dimension(follower, index)) cam[index] = 0.05;
    if (has_dimension(follower, DimensionIndex::arm_length)) cam[DimensionIndex::arm_length] = 0.07;
    scene.cam = disk_spec(cam);
    return scene;
}

std::string message_of(Scene scene, const std::function<void(Scene&)>& change) {
    return message_of([&](Scene& target) {
        target = std::move(scene);
        change(target);
    });
}

TEST(Scene, WrongProgramsAreNamed) {
    const std::vector<SceneCase> cases = {
        {[](Scene& s) { s.motion.symmetric = true; },
         "motion.symmetric: found true in a motion of type \"program\"; allowed: false, or type \"DRD\" or "
         "\"RR\""},
        {[](Scene& s) { s.motion.via = {{.at = 0.5, .velocity = 1}}; },
         "motion.via: found exact points in a motion of type \"program\"; allowed: only in type \"DRD\" or "
         "\"RR\"; a program has them in its segments"},
        {[](Scene& s) { s.motion.type = MotionType::drd; },
         "motion.segments: found segments in a motion of type \"DRD\"; allowed: only in type \"program\""},
        {[](Scene& s) {
             s.motion = MotionSpec{};
             s.motion.closed = false;
         },
         "motion.closed: found false in a motion of type \"DRD\"; allowed: only in type \"program\""},
        {[](Scene& s) { s.motion.segments[1].angle = nan; },
         "motion.segments[1].angle: found nan; allowed: a number > 0 and <= 6.283185307179586"},
        {[](Scene& s) { s.motion.segments[1].to = nan; },
         "motion.segments[1].to: found nan; allowed: a finite number"},
        {[](Scene& s) { s.motion.segments[2].law = ""; },
         "motion.segments[2].law: found no law in a segment of kind \"law\"; allowed: a law of the "
         "catalogue"},
        {[](Scene& s) { s.motion.segments[3].to = 0.25; },
         "motion.segments[3].to: found a closed program that ends at 0.25 lifts; allowed: 0, where it began, "
         "or no "
         "`to`, or motion.closed = false"},
        {[](Scene& s) { s.motion.segments.pop_back(); },
         "motion.segments: found angles that add up to 315 deg; allowed: 360 deg, or motion.closed = false "
         "for part of a revolution"},
        {[](Scene& s) {
             s.spline.breakpoints = {0, 4};
         },
         "spline.breakpoints[1]: found 4; allowed: 1, the end of a segment"},
    };
    for (const SceneCase& c : cases) EXPECT_EQ(message_of(program_scene(), c.change), c.message);
}

TEST(Scene, WrongCamsAreNamed) {
    const std::vector<SceneCase> cases = {
        {[](Scene& s) { s.motion.lift_is_angle = true; },
         "cam.follower: found \"translating_roller\" where the lift is an angle; allowed: an oscillating "
         "follower, or "
         "a lift in mm, in or m"},
        {[](Scene& s) { s.cam->set(DimensionIndex::base_radius, nan); },
         "cam.base_radius: found nan; allowed: a number > 0"},
        {[](Scene& s) {
             s.cam->set(DimensionIndex::base_radius, {0.06, 0.02});
         },
         "cam.base_radius: found a range from 0.06 to 0.02; allowed: a range that ascends"},
        {[](Scene& s) { s.cam->face_half_width = 0.1; },
         "cam.face_half_width: found a dimension that the follower \"translating_roller\" does not have; "
         "allowed: "
         "only with \"translating_flat\""},
        {[](Scene& s) { s.cam->set(DimensionIndex::offset, -0.2); },
         "cam.offset: found an offset of -200 mm; allowed: less than 100 mm to either side, the largest base "
         "radius + "
         "roller radius"},
        {[](Scene& s) {
             s.forces = ForceSpec{};
             s.motion.speed = 10;
             s.forces->cam_poisson = 0.5;
         },
         "forces.cam_poisson: found 0.5; allowed: a number >= 0 and < 0.5"},
        {[](Scene& s) { s.forces = ForceSpec{}; },
         "forces: found forces without a speed; allowed: only where motion.speed is given"},
        {[](Scene& s) { s.limits.pressure_angle = WrittenLimit(2); },
         "limits.pressure_angle: found 2; allowed: a number > 0 and < 1.5707963267948966"},
        {[](Scene& s) { s.limits.torque_max = WrittenLimit(2); },
         "limits.torque_max: found a limit of a force without forces; allowed: only together with a [forces] "
         "table"},
        {[](Scene& s) { s.objective.dimensions[0] = -1; },
         "objective.base_radius: found -1; allowed: a number >= 0"},
        {[](Scene& s) { s.objective.dimensions[4] = 1; },
         "objective.arm_length: found 1 for a dimension that the follower \"translating_roller\" does not "
         "have; "
         "allowed: 0"},
    };
    for (const SceneCase& c : cases) EXPECT_EQ(message_of(cam_scene(), c.change), c.message);
}

TEST(Scene, UnknownCamDimensionIsRefused) {
    EXPECT_EQ(message_of([](Scene&) { cam_scene().cam->set(DimensionIndex::arm_length, 0.1); }),
              "cam.arm_length: found a dimension that this cam of type \"disk\" does not have; allowed: "
              "base_radius, roller_radius, offset");
    EXPECT_EQ(message_of([](Scene&) {
                  DiskSpec cam;
                  cam[DimensionIndex::arm_length] = 0.1;
                  (void)disk_spec(cam);
              }),
              "cam.arm_length: found a dimension that the follower \"translating_roller\" does not have; "
              "allowed: only with \"oscillating_roller\"");
}

TEST(Scene, ValidProgramsAndCamsAreAllowed) {
    const auto nothing = [](Scene&) {};
    EXPECT_EQ(message_of(program_scene(), nothing), "accepted");
    EXPECT_EQ(message_of(program_scene(), [](Scene& s) { s.motion.segments[3].to = 0.0; }), "accepted");
    EXPECT_EQ(message_of(program_scene(), [](Scene& s) { s.spline.breakpoints = {0, 0.3, 1}; }), "accepted");
    EXPECT_EQ(message_of(program_scene(), [](Scene& s) { s.motion.segments[0].angle *= 1 + 1e-9; }),
              "accepted");
    EXPECT_EQ(message_of(program_scene(),
                         [](Scene& s) {
                             s.motion.closed = false;
                             s.motion.segments.resize(3);
                         }),
              "accepted");
    for (const FollowerType follower : {FollowerType::translating_roller, FollowerType::translating_knife,
                                        FollowerType::translating_flat, FollowerType::oscillating_roller})
        EXPECT_EQ(message_of(cam_scene(follower), nothing), "accepted") << name_of(follower);
    EXPECT_EQ(message_of(cam_scene(FollowerType::oscillating_flat),
                         [](Scene& s) {
                             s.cam->set(DimensionIndex::base_radius, {0.04, 0.06});
                         }),
              "accepted");
    EXPECT_EQ(message_of(cam_scene(),
                         [](Scene& s) {
                             s.objective.jerk = 0;
                             s.objective.dimensions[0] = 1;
                             s.cam->set(DimensionIndex::base_radius, {0.02, 0.06});
                         }),
              "accepted");
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
                  s.spline.rest = 3;
                  s.spline.design = DesignKind::states;
              }),
              "accepted");
    for (const int least : {3, 6})
        EXPECT_EQ(message_of([&](Scene& s) {
                      s.spline.degree = 7;
                      s.spline.continuity = least;
                      s.spline.rest = 6;
                  }),
                  "accepted");
}

}  // namespace scene_test
}  // namespace camopt
