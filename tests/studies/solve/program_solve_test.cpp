// SPDX-License-Identifier: MIT
// Whole turns: several spline segments optimized together, dwells and laws kept, joints as smooth as
// promised.
#include "motions/laws/law_catalogue.hpp"
#include "profiles/disk/disk_cam.hpp"
#include "studies/solve/solve.hpp"
#include "tests/studies/scenes_for_tests.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace camopt {
namespace program_solve_test {

using namespace testing_support;

double jump(const Motion& motion, double left, double right, int order) {
    return std::abs(motion.at(left, Side::left).derivative[order] -
                    motion.at(right, Side::right).derivative[order]);
}

TEST(Program, RiseBetweenDwellsMatchesSingleRise) {
    const Scene rise = paper_objective(MotionType::drd, 3, 12);
    const Scene whole = program({dwell(60), spline(100, 1.0), dwell(40), law(160, "polynomial_345", 0.0)});
    const Solution alone = solve(rise), within = solve(whole);
    ASSERT_EQ(within.certificate.verdict, Verdict::optimal);
    EXPECT_NEAR(within.certificate.objective, alone.certificate.objective, 1e-8);
    EXPECT_NEAR(within.peaks.velocity.value, 12.0 / 7.0, 1e-6);
    ASSERT_EQ(within.segments.size(), 4u);
    EXPECT_NEAR(within.segments[1].peaks->jerk.value, 432.0 / 7.0, 1e-4);
    const Motion& motion = *within.motion;
    EXPECT_NEAR(motion.at(1.0).derivative[0], alone.motion->at(0.4).derivative[0],
                1e-6);  // 60° + 40° of 100°
    EXPECT_NEAR(motion.at(1.8).derivative[0], 1.0, 1e-12);
    EXPECT_NEAR(motion.at(3.6 - 0.8).derivative[0], 0.5, 1e-12);  // the middle of the law
    EXPECT_EQ(within.curve, std::nullopt);
}

TEST(Program, EqualStrokesCostAsMuchAsOne) {
    const Scene scene =
        program({dwell(40), spline(80, 0.5), dwell(30), spline(80, 1.0), dwell(20), spline(110, 0.0)});
    const Solution solution = solve(scene);
    ASSERT_EQ(solution.certificate.verdict, Verdict::optimal);
    EXPECT_NEAR(solution.certificate.objective, 0.940489277, 1e-8);
    for (const SegmentReport& segment : solution.segments) {
        if (segment.kind != SegmentKind::spline) continue;
        EXPECT_LE(segment.peaks->velocity.value, solution.peaks.velocity.value + 1e-12);
        ASSERT_TRUE(segment.curve);
        EXPECT_NEAR(segment.curve->at(segment.curve->end(), Side::left).derivative[0], segment.to, 1e-12);
    }
}

TEST(Program, JointsKeepTheirSmoothness) {
    for (const int degree : {3, 5}) {
        Scene scene = program(
            {spline(90, 1.0), spline(70, 0.3), law(60, "modified_sine", 0.6), dwell(50), spline(90, 0.0)});
        scene.spline.degree = degree;
        scene.spline.segments = 8;
        const Solution solution = solve(scene);
        ASSERT_TRUE(solution.motion) << degree;
        EXPECT_EQ(solution.certificate.verdict, Verdict::optimal);
        const Motion& motion = *solution.motion;
        const std::vector<SegmentReport>& segments = solution.segments;
        for (std::size_t i = 0; i < segments.size(); ++i) {
            const double left = i == 0 ? motion.end() : segments[i].begin;
            for (int order = 0; order < 3; ++order) {
                EXPECT_LT(jump(motion, left, segments[i].begin, order), 1e-8)
                    << degree << ' ' << i << ' ' << order;
            }
            EXPECT_GE(segments[i].continuity, 2);
        }
        if (degree == 5) {  // C4 inside a run
            EXPECT_LT(jump(motion, segments[1].begin, segments[1].begin, 3), 1e-6);
        }
        // The seam at 0° lies inside a run of two splines.
        EXPECT_NEAR(motion.at(0.0).derivative[0], 0.0, 1e-12);
        EXPECT_NEAR(motion.at(segments[0].end, Side::left).derivative[0], 1.0, 1e-10);
        EXPECT_NEAR(motion.at(segments[1].end, Side::left).derivative[0], 0.3, 1e-10);
    }
}

TEST(Program, NothingButSplinesCloses) {
    Scene scene = program({spline(180, 1.0), spline(180, 0.0)});
    scene.spline.degree = 5;
    scene.spline.segments = 8;
    const Solution solution = solve(scene);
    ASSERT_EQ(solution.certificate.verdict, Verdict::optimal) << solution.certificate.reason;
    const Motion& motion = *solution.motion;
    for (int order = 0; order < 4; ++order) EXPECT_LT(jump(motion, 2.0, 0.0, order), 1e-6) << order;
    // Free to move through the turn: better than two rises from rest to rest.
    EXPECT_LT(solution.certificate.objective, 0.94);
}

TEST(Program, AFreeDisplacementIsFound) {
    // The dwell between may lie anywhere: half way costs both strokes the same.
    Scene scene = program({dwell(60), spline(60), dwell(30), spline(60, 1.0), dwell(30), spline(120, 0.0)});
    const Solution solution = solve(scene);
    ASSERT_EQ(solution.certificate.verdict, Verdict::optimal) << solution.certificate.reason;
    const double level = solution.motion->at(scene.motion.length() * 135.0 / 360.0).derivative[0];
    EXPECT_NEAR(level, solution.segments[1].to, 1e-12);
    EXPECT_GT(level, 0.0);
    EXPECT_LT(level, 1.0 + 1e-9);
}

TEST(Program, OpenProgramBeginsAndEndsAtRest) {
    Scene scene = program({spline(90, 1.0), dwell(30), spline(60, 0.5)});
    scene.motion.closed = false;
    const Solution solution = solve(scene);
    ASSERT_EQ(solution.certificate.verdict, Verdict::optimal);
    EXPECT_NEAR(solution.motion->at(solution.motion->end(), Side::left).derivative[0], 0.5, 1e-12);
    EXPECT_NEAR(solution.motion->at(solution.motion->end(), Side::left).derivative[1], 0.0, 1e-9);
    EXPECT_EQ(solution.segments.front().continuity, -1);
}

TEST(Program, CapsInTimeHoldForLawsToo) {
    Scene scene = program({dwell(60), law(60, "cycloidal", 1.0), dwell(60), spline(180, 0.0)});
    scene.motion.speed = 10.0;
    // The cycloid needs 2 · 20 mm / (60°) · 10 rad/s = 382 mm/s.
    const double per_unit = scene.motion.lift * 10.0 / scene.motion.unit_angle();
    const auto cap = [&](double metres_per_second) {
        return PeakLimit{metres_per_second / per_unit, "limits.velocity_mm_s", 1e3 * metres_per_second,
                         "mm/s"};
    };
    scene.limits.velocity = cap(0.383);
    EXPECT_EQ(solve(scene).certificate.verdict, Verdict::optimal);
    scene.limits.velocity = cap(0.381);
    EXPECT_EQ(solve(scene).certificate.verdict, Verdict::infeasible);
}

TEST(Program, PressureAngleCoversWholeRevolution) {
    Scene scene = program({dwell(40), spline(80, 0.5), dwell(30), spline(60, 1.0), spline(150, 0.0)});
    scene.cam = disk_spec({});
    scene.cam->set(DimensionIndex::base_radius, 25e-3);
    scene.cam->set(DimensionIndex::roller_radius, 8e-3);
    scene.cam->set(DimensionIndex::offset, 4e-3);
    const Solution free = solve(scene);
    ASSERT_EQ(free.certificate.verdict, Verdict::optimal);
    const double limit = 0.9 * free.cam->summary.pressure_angle.value;
    scene.limits.pressure_angle = degrees(limit / units::degree, "limits.pressure_angle_deg");
    const Solution kept = solve(scene);
    ASSERT_EQ(kept.certificate.verdict, Verdict::optimal);
    EXPECT_NEAR(kept.cam->summary.pressure_angle.value, limit, 1e-7);
    EXPECT_GE(kept.certificate.objective, free.certificate.objective - 1e-9);  // here the limit costs nothing
    // The same with the base radius free: it pays for itself.
    scene.cam->set(DimensionIndex::base_radius, Dimension(10e-3, 80e-3));
    scene.objective.dimensions[0] = 1e-2;
    const Solution sized = solve(scene);
    EXPECT_EQ(sized.certificate.verdict, Verdict::optimal);
    EXPECT_LE(sized.cam->summary.pressure_angle.value, limit * (1 + 1e-7));
}

/// Quintics of the same continuity hold every cubic. A row of the last spline before the law was one of the
/// law, and "proved" that the jerk limit cannot be kept.
TEST(Program, QuinticsAreNoWorseThanCubics) {
    Scene scene = program(
        {spline(97, 0.75), spline(107, 0.0), law(67, "polynomial_345", 0.5), spline(64, 0.75), spline(25)},
        6);
    scene.objective = {};
    scene.objective.jerk = 1.0;
    const Solution cubic = solve(scene);
    ASSERT_EQ(cubic.certificate.verdict, Verdict::optimal);
    scene.spline.degree = 5;
    scene.spline.continuity = 2;
    const Solution quintic = solve(scene);
    ASSERT_EQ(quintic.certificate.verdict, Verdict::optimal);
    EXPECT_LE(quintic.certificate.objective, cubic.certificate.objective * (1.0 + 1e-7));
}

}  // namespace program_solve_test
}  // namespace camopt
