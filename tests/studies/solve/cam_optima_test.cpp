// SPDX-License-Identifier: MIT
// The cam in the loop: proved optima and smallest cams of docs/theory/pressure_angle.md, flat faces, what is
// left out.
#include "profiles/disk/disk_cam.hpp"
#include "studies/solve/solve.hpp"
#include "tests/studies/scenes_for_tests.hpp"
#include "tests/support/scene_kit.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace camopt {
namespace cam_optima_test {

using enum DimensionIndex;

using namespace testing_support;

double prime_radius_mm(const Solution& solution) {
    const DiskCam cam = *disk_cam(solution.cam->cam);
    return 1e3 * (cam[base_radius] + cam[roller_radius]);
}

struct Optimum {
    double prime_radius, free, antisymmetric;  // 0: not in the table
};

TEST(PressureAngle, TabulatedOptimaAreProved) {
    for (const Optimum& row : {Optimum{50, 0.940489277, 0},
                               {40, 1.01911894, 1.09082869},
                               {35, 1.21170602, 1.52206845},
                               {30, 1.84837418, 0},
                               {28, 2.87039549, 0}}) {
        for (const bool symmetric : {false, true}) {
            const double expected = symmetric ? row.antisymmetric : row.free;
            if (expected == 0) continue;
            const Solution solution =
                solve(pressure_angle_scene(row.prime_radius).set("motion.symmetric", symmetric));
            ASSERT_EQ(solution.certificate.verdict, Verdict::optimal) << row.prime_radius;
            EXPECT_NEAR(solution.certificate.objective, expected, 1e-8 * expected + 5e-9) << row.prime_radius;
            EXPECT_LE(*solution.certificate.gap, 1e-7);
            EXPECT_TRUE(solution.solver.convex);
            EXPECT_LE(solution.cam->summary.pressure_angle.value, 30.0 * units::degree * (1 + 1e-8));
        }
    }
}

TEST(PressureAngle, QuinticSplinesAreProvedToo) {
    for (const auto& [segments, expected] : {std::pair{12, 1.057339917}, {24, 1.028360085}}) {
        const Solution solution = solve(pressure_angle_scene(40, segments).with("spline.degree = 5"));
        EXPECT_EQ(solution.certificate.verdict, Verdict::optimal) << segments;
        EXPECT_NEAR(solution.certificate.objective, expected, 1e-7) << segments;
        // A limit far away changes nothing.
        Scene scene = pressure_angle_scene(1000, segments).with("spline.degree = 5");
        const double far = solve(scene).certificate.objective;
        scene.cam.reset();
        scene.limits = {};
        EXPECT_NEAR(far, solve(scene).certificate.objective, 1e-8) << segments;
    }
}

TEST(PressureAngle, AntisymmetryCanMakeItInfeasible) {
    const Solution solution = solve(pressure_angle_scene(30).with("motion.symmetric = true"));
    EXPECT_EQ(solution.certificate.verdict, Verdict::infeasible);
    ASSERT_TRUE(solution.certificate.proof);
    EXPECT_GT(solution.certificate.proof->bound, 0.0);
}

TEST(PressureAngle, EveryBackendFindsTheSame) {
    for (const char* backend : {"structured", "ipopt", "nlopt.slsqp"}) {
        Scene scene = pressure_angle_scene(40, 12);
        if (!is_available(backend)) continue;
        scene.solver.name = backend;
        const Solution own = solve(scene);
        scene.solver.name = "structured";
        EXPECT_NEAR(own.certificate.objective, solve(scene).certificate.objective, 1e-6) << backend;
        // SLSQP ends a little above the optimum: its own last digits decide between optimal and local.
        EXPECT_LE(*own.certificate.gap, 1e-6) << backend;
    }
}

constexpr double any_motion_mm = 24.0813;  // h / (exp(β tan φ) − 1)

TestScene smallest_cam_scene(int segments, double weight) {
    return scene_named("cam_smallest")
        .with("cam.base_radius_mm = { min = 1, max = 60 }")
        .set("spline.segments", segments)
        .set("objective.base_radius", weight);
}

TEST(SmallestCam, LargerWeightShrinksCam) {
    double last = 1e9;
    for (const double weight : {0.3, 3.0, 30.0, 300.0, 3000.0}) {
        const Solution solution = solve(smallest_cam_scene(24, weight));
        ASSERT_EQ(solution.certificate.verdict, Verdict::optimal) << weight;
        const double found = prime_radius_mm(solution);
        EXPECT_LT(found, last);
        EXPECT_GT(found, 27.00587);
        ASSERT_TRUE(solution.cam->smallest);
        EXPECT_NEAR(1e3 * solution.cam->smallest->prime_radius, any_motion_mm, 5e-5);
        last = found;
    }
    EXPECT_NEAR(last, 27.00587, 0.02);
}

TEST(SmallestCam, AloneReachesTheSplineMinimum) {
    for (const auto& [segments, least] :
         {std::pair{24, 27.00587}, {48, 25.4783}, {96, 24.7645}, {192, 24.4192}}) {
        const Solution solution =
            solve(smallest_cam_scene(segments, 1.0).with("objective = { base_radius = 1 }"));
        ASSERT_TRUE(solution.motion);
        EXPECT_LE(*solution.certificate.gap, 1e-6);
        EXPECT_NEAR(prime_radius_mm(solution), least, 5e-5 * least / 24.0) << segments;
        EXPECT_GT(prime_radius_mm(solution), any_motion_mm);
    }
}

TEST(SmallestCam, BelowLowerBoundIsProvedInfeasible) {
    const Solution solution = solve(pressure_angle_scene(24.0));
    ASSERT_EQ(solution.certificate.verdict, Verdict::infeasible);
    EXPECT_FALSE(solution.conflict.empty());
    EXPECT_EQ(solution.conflict.front().key, "limits.pressure_angle_deg");
    bool base = false;
    for (const Relaxation& relaxation : solution.relaxation) {
        if (relaxation.key != "cam.base_radius_mm") continue;
        base = true;
        ASSERT_TRUE(relaxation.needed);
        EXPECT_NEAR(*relaxation.needed + 10.0, 27.00587, 1e-5);
    }
    EXPECT_TRUE(base);
}

/// Each line of the explanation, carried out with a little to spare, makes the scene feasible; with a little
/// less it stays infeasible.
TEST(Explanation, EachChangeIsEnoughAndNeeded) {
    const Scene scene = pressure_angle_scene(25.0, 12).with("solver.explain_changes = 100");
    const Solution solution = solve(scene);
    ASSERT_EQ(solution.certificate.verdict, Verdict::infeasible);
    int checked = 0;
    for (const Relaxation& relaxation : solution.relaxation) {
        ASSERT_TRUE(relaxation.needed) << relaxation.key;
        for (const double spare : {1e-6, -1e-6}) {
            Scene changed = scene;
            const double value =
                *relaxation.needed +
                spare * std::abs(*relaxation.needed) * (*relaxation.needed > relaxation.given ? 1.0 : -1.0);
            if (relaxation.key == "limits.pressure_angle_deg") {
                changed.limits.pressure_angle->value = value * units::degree;
            } else if (relaxation.key == "motion.rise_deg") {
                changed.motion.rise = value * units::degree;
            } else if (relaxation.key == "cam.base_radius_mm") {
                changed.cam->set(base_radius, value * 1e-3);
            } else {
                continue;
            }
            ++checked;
            EXPECT_EQ(solve(changed).motion != nullptr, spare > 0.0) << relaxation.key << ' ' << value;
        }
    }
    EXPECT_EQ(checked, 6);
}

TEST(FlatFace, LinearUndercutProvesOptimum) {
    const Solution limited = solve(flat_scene(30).with("limits.cam_radius_min_mm = 8"));
    ASSERT_EQ(limited.certificate.verdict, Verdict::optimal);
    EXPECT_GE(limited.cam->summary.convex_radius->value, 8e-3 * (1 - 1e-8));
    const Solution free = solve(flat_scene(30));
    EXPECT_LT(free.cam->summary.convex_radius->value, 8e-3);
    EXPECT_LT(free.certificate.objective, limited.certificate.objective);
    // With the base radius free the peaks cost what they cost without the limit, or the cam grows.
    const Solution large = solve(flat_scene(30).with("limits.cam_radius_min_mm = 8",
                                                     "cam.base_radius_mm = { min = 1, max = 200 }",
                                                     "objective.base_radius = 1e-3"));
    ASSERT_EQ(large.certificate.verdict, Verdict::optimal);
    EXPECT_LT(large.certificate.objective - 1e-3 * (*disk_cam(large.cam->cam))[base_radius] / 14e-3,
              limited.certificate.objective);
}

TEST(FlatFace, TheFaceWidthLimitsTheVelocity) {
    const TestScene scene = flat_scene(60).with("limits.cam_radius_min_mm = 0");
    const Solution free = solve(scene);
    const double width = 0.9 * free.cam->summary.contact_offset->value;
    const Solution narrow = solve(scene.set("cam.face_half_width_m", width));
    ASSERT_EQ(narrow.certificate.verdict, Verdict::optimal);
    EXPECT_NEAR(narrow.cam->summary.contact_offset->value, width, 1e-7 * width);
    EXPECT_GT(narrow.certificate.objective, free.certificate.objective);
}

TEST(NoCam, NoProfileIsEverTouched) {
    Scene scene = pressure_angle_scene(40);
    scene.cam.reset();
    scene.limits = {};
    const Solution solution = solve(scene);
    EXPECT_EQ(solution.evaluations.profile_points, 0);
    EXPECT_FALSE(solution.cam);
}

TEST(ClockwiseCams, OffsetActsInOppositeDirection) {
    const auto objective = [](const char* offset, const char* rotation) {
        return solve(pressure_angle_scene(40).with(offset, rotation)).certificate.objective;
    };
    const double counterclockwise = objective("cam.offset_mm = 8", "cam.rotation = counterclockwise");
    const double clockwise = objective("cam.offset_mm = 8", "cam.rotation = clockwise");
    const double mirrored = objective("cam.offset_mm = -8", "cam.rotation = clockwise");
    EXPECT_NEAR(counterclockwise, mirrored, 1e-9);
    EXPECT_GT(clockwise, counterclockwise + 1e-3);
}

}  // namespace cam_optima_test
}  // namespace camopt
