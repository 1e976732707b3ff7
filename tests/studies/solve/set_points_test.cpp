// SPDX-License-Identifier: MIT
// Set points in units and regions of constant velocity: exact along the whole region, in every design vector,
// proved like any optimum; what contradicts is named.
#include "scene/motion/set_points.hpp"

#include "objectives/scene_model.hpp"
#include "studies/delivered/solution_parts.hpp"
#include "studies/least/adjustment.hpp"
#include "studies/solve/solve.hpp"
#include "tests/studies/scenes_for_tests.hpp"
#include "tests/support/scene_kit.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace camopt {
namespace set_points_test {

using namespace testing_support;

constexpr double degree = 3.14159265358979323846 / 180.0;

/// 10 mm in 120 deg at 300 rpm; from 40 to 70 deg at 180 mm/s: 1.2 of the mean velocity 150 mm/s.
Scene region_scene(int spline_degree, DesignKind design) {
    return scene_named("drd_cubic_12")
        .with("motion.lift_mm = 10", "motion.rise_deg = 120", "motion.speed_rpm = 300",
              "spline.segments = 24", "motion.via = [{ from_deg = 40, to_deg = 70, velocity_mm_s = 180 }]")
        .set("spline.degree", spline_degree)
        .set("spline.design", name_of(design));
}

double farthest_from(const Motion& motion, double velocity, double begin, double end) {
    double worst = 0.0;
    for (int k = 0; k <= 20000; ++k) {
        const double x = std::lerp(begin, end, k / 20000.0);
        const Side side = k == 20000 ? Side::left : Side::right;
        worst = std::max(worst, std::abs(motion.at(x, side).derivative[1] - velocity));
    }
    return worst;
}

class Regions : public ::testing::TestWithParam<std::pair<int, DesignKind>> {};

TEST_P(Regions, HoldTheirVelocityExactlyAndAreProved) {
    const auto [spline_degree, design] = GetParam();
    Scene scene = region_scene(spline_degree, design);
    Scene free = scene;
    free.motion.via.clear();
    const Solution without = solve(free), with = solve(scene);
    ASSERT_EQ(without.certificate.verdict, Verdict::optimal);
    ASSERT_EQ(with.certificate.verdict, Verdict::optimal) << with.certificate.reason;
    EXPECT_GT(farthest_from(*without.motion, 1.2, 1.0 / 3.0, 7.0 / 12.0), 1e-2);
    EXPECT_LT(farthest_from(*with.motion, 1.2, 1.0 / 3.0, 7.0 / 12.0), 1e-10);
    EXPECT_GT(with.certificate.objective, without.certificate.objective);
    EXPECT_LE(with.certificate.gap.value(), 1e-7);
    // Not beyond it: the region is no longer than asked for.
    EXPECT_GT(std::abs(with.motion->at(0.62).derivative[1] - 1.2), 1e-6);
    const std::vector<SetPointReport> reports = set_point_reports(scene.motion, spline_degree, *with.motion);
    ASSERT_EQ(reports.size(), 1u);
    EXPECT_EQ(reports[0].key, "motion.via[0].velocity_mm_s");
    EXPECT_EQ(reports[0].wanted, 180.0);
    EXPECT_NEAR(reports[0].found, 180.0, 1e-8);
    EXPECT_EQ(reports[0].unit, "mm/s");
}

/// Three rows of a cubic, five of a quintic, and none of them superfluous.
TEST_P(Regions, AddExactlyTheirRows) {
    const auto [spline_degree, design] = GetParam();
    const Scene scene = region_scene(spline_degree, design);
    Scene same_space = scene;
    same_space.spline.breakpoints = spline_request(scene, DesignKind::coefficients).space.breakpoints();
    same_space.motion.via.clear();
    const MotionFamily with = scene_family(scene, design), without = scene_family(same_space, design);
    EXPECT_EQ(with.size(), without.size());
    EXPECT_EQ(with.equalities().size(), without.equalities().size() + (spline_degree == 3 ? 3u : 5u));
    EXPECT_TRUE(with.redundant().empty());
    EXPECT_TRUE(with.contradictions().empty());
}

INSTANTIATE_TEST_SUITE_P(
    All, Regions,
    ::testing::Values(std::pair{3, DesignKind::states}, std::pair{3, DesignKind::coefficients},
                      std::pair{3, DesignKind::ordinates}, std::pair{5, DesignKind::states},
                      std::pair{5, DesignKind::coefficients}, std::pair{5, DesignKind::ordinates}));

TEST(Region, EveryDesignVectorFindsTheSameOptimum) {
    for (const int spline_degree : {3, 5}) {
        const double states = solve(region_scene(spline_degree, DesignKind::states)).certificate.objective;
        for (const DesignKind design : {DesignKind::coefficients, DesignKind::ordinates})
            EXPECT_NEAR(solve(region_scene(spline_degree, design)).certificate.objective, states, 1e-7);
    }
}

TEST(Region, EndsAreBreakpointsWithNoneBetween) {
    const Scene scene = region_scene(3, DesignKind::states);
    const double begin = scene.motion.via[0].at, end = *scene.motion.via[0].until;
    const std::vector<double> points = spline_request(scene, DesignKind::states).space.breakpoints();
    int inside = 0, ends = 0;
    for (const double x : points) {
        inside += x > begin && x < end ? 1 : 0;
        ends += x == begin || x == end ? 1 : 0;
    }
    EXPECT_EQ(inside, 0);
    EXPECT_EQ(ends, 2);
    EXPECT_EQ(points.front(), 0.0);
    EXPECT_EQ(points.back(), 1.0);
}

TEST(Region, OfASymmetricMotionIsThereTwice) {
    Scene scene = paper_objective(MotionType::drd, 3, 24);
    scene.motion.symmetric = true;
    scene.motion.via = {{.at = 0.2, .velocity = 1.1, .until = 0.3}};
    const Solution solution = solve(scene);
    ASSERT_EQ(solution.certificate.verdict, Verdict::optimal) << solution.certificate.reason;
    EXPECT_LT(farthest_from(*solution.motion, 1.1, 0.2, 0.3), 1e-10);
    EXPECT_LT(farthest_from(*solution.motion, 1.1, 0.7, 0.8), 1e-10);
}

TEST(Region, RiseAndReturnMayFallAndRest) {
    Scene scene = paper_objective(MotionType::rr, 5, 32);
    scene.motion.via = {{.at = 1.3, .velocity = -1.4, .until = 1.6}};
    const Solution falls = solve(scene);
    ASSERT_EQ(falls.certificate.verdict, Verdict::optimal) << falls.certificate.reason;
    EXPECT_LT(farthest_from(*falls.motion, -1.4, 1.3, 1.6), 1e-10);
    scene.motion.via = {{.at = 0.4, .displacement = 0.5, .velocity = 0.0, .until = 0.5}};
    const Solution rests = solve(scene);
    ASSERT_EQ(rests.certificate.verdict, Verdict::optimal) << rests.certificate.reason;
    EXPECT_NEAR(rests.motion->at(0.45).derivative[0], 0.5, 1e-10);
}

TEST(Region, ProgramRegionsCountFromSegmentStart) {
    // A region that begins where two splines meet, and a point in the other.
    Scene scene = program({dwell(60), spline(100, 0.6), spline(80, 1.0), spline(120, 0.0)}, 16);
    scene.motion.segments[1].via = {{.at = 0.5, .displacement = 0.2}};
    scene.motion.segments[2].via = {{.at = 0.0, .velocity = 0.9, .until = 0.25}};
    const Solution solution = solve(scene);
    ASSERT_EQ(solution.certificate.verdict, Verdict::optimal) << solution.certificate.reason;
    // x is counted in the first spline segment, 100 deg; 0.9 lifts a segment of 80 deg are 1.125 in 100 deg.
    EXPECT_NEAR(solution.motion->at(0.6 + 0.5).derivative[0], 0.2, 1e-10);
    EXPECT_LT(farthest_from(*solution.motion, 1.125, 1.6, 1.8), 1e-9);
    const auto points = placed_points(scene.motion);
    ASSERT_EQ(points.size(), 2u);
    EXPECT_EQ(points[1].member, "motion.segments[2].via[0]");
    EXPECT_NEAR(points[1].end, 1.8, 1e-15);
}

TEST(Region, ContradictedPointIsInfeasibleAndNamed) {
    Scene scene = region_scene(3, DesignKind::states);
    scene.motion.via.push_back({.at = 0.5, .velocity = 1.5});
    const Solution solution = solve(scene);
    EXPECT_EQ(solution.certificate.verdict, Verdict::infeasible);
    EXPECT_EQ(solution.certificate.reason, Reason::conditions_contradict);
    ASSERT_TRUE(solution.certificate.proof);
    EXPECT_GT(recomputed_bound(*solution.certificate.proof), 0.0);
    std::string notes;
    for (const std::string& note : solution.notes) notes += note + "\n";
    EXPECT_NE(notes.find("velocity of set point 1 = 180 mm/s from 40 deg to 70 deg"), std::string::npos)
        << notes;
    EXPECT_NE(notes.find("velocity of set point 2 = 1.5 at x = 0.5"), std::string::npos) << notes;
}

TEST(Region, ThatContradictsTheEndsIsInfeasible) {
    Scene scene = region_scene(3, DesignKind::states);
    scene.motion.via[0].at = 0.0;
    const Solution solution = solve(scene);
    EXPECT_EQ(solution.certificate.verdict, Verdict::infeasible);
    EXPECT_EQ(solution.certificate.reason, Reason::conditions_contradict);
    ASSERT_EQ(solution.notes.size(), 1u);
    EXPECT_EQ(
        solution.notes[0],
        "velocity of set point 1 = 180 mm/s from 0 deg to 70 deg contradicts the conditions at the ends "
        "of the motion, "
        "at its top or where its segments join; more segments were tried without success: change it");
}

/// 40 mm in 10 ms leave nothing for the rest of the lift: no condition contradicts, but no limit can be kept.
TEST(Region, ThatNoLimitAllowsIsProvedInfeasible) {
    Scene scene = region_scene(3, DesignKind::states);
    scene.limits.velocity = normalised_limit("limits.velocity", 1.19);
    const Solution solution = solve(scene);
    EXPECT_EQ(solution.certificate.verdict, Verdict::infeasible);
    EXPECT_EQ(solution.certificate.reason, Reason::limits_contradict);
}

TEST(SetPoints, UnitsSurviveChangesOfRise) {
    const Scene scene = region_scene(3, DesignKind::states);
    MotionSpec longer = scene.motion;
    longer.rise = 160 * degree;
    longer.speed = 2.0 * *scene.motion.speed;
    keep_written(longer, scene.motion);
    const PlacedPoint before = placed_points(scene.motion)[0], after = placed_points(longer)[0];
    const auto physical = [](const MotionSpec& motion, const PlacedPoint& point) {
        return *point.wanted[1] * motion.lift * *motion.speed / motion.rise;
    };
    EXPECT_NEAR(after.begin * longer.rise, before.begin * scene.motion.rise, 1e-15);
    EXPECT_NEAR(after.end * longer.rise, before.end * scene.motion.rise, 1e-15);
    EXPECT_NEAR(physical(longer, after), physical(scene.motion, before), 1e-15);
    MotionSpec normalised = scene.motion;
    normalised.via[0].units = {};
    MotionSpec same = normalised;
    same.rise = 160 * degree;
    keep_written(same, normalised);
    EXPECT_EQ(placed_points(same)[0].begin, before.begin);
    EXPECT_EQ(placed_points(same)[0].wanted[1], before.wanted[1]);
}

TEST(SetPoints, OverlappingBreakpointsAreReplaced) {
    const std::vector<double> points =
        with_regions({0.0, 0.1, 0.2, 0.3, 0.4, 1.0}, {{0.19, 0.26}, {0.25, 0.3}}, 0.02);
    EXPECT_EQ(points, (std::vector<double>{0.0, 0.1, 0.19, 0.3, 0.4, 1.0}));
    EXPECT_EQ(with_regions({0.0, 0.5, 1.0}, {}, 0.1), (std::vector<double>{0.0, 0.5, 1.0}));
    EXPECT_EQ(with_regions({0.0, 0.5, 1.0}, {{0.0, 0.25}, {0.25, 0.75}}, 0.1),
              (std::vector<double>{0.0, 0.25, 0.75, 1.0}));
}

}  // namespace set_points_test
}  // namespace camopt
