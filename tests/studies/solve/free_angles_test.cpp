// SPDX-License-Identifier: MIT
// Angles of a program that are searched: proved by boxes where the least objective only falls with an angle.
#include "motions/laws/law_catalogue.hpp"
#include "scene/motion/set_points.hpp"
#include "studies/solve/solve.hpp"
#include "tests/studies/scenes_for_tests.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace camopt {
namespace free_angles_test {

using namespace testing_support;

constexpr double degree = 3.14159265358979323846 / 180.0;

ProgramSegment stroke(double to, double least, double most, double start) {
    ProgramSegment segment = spline(start, to);
    segment.angle_range = AngleRange{least * degree, most * degree};
    return segment;
}

constexpr double acceleration_limit = 18.0;  // m/s²

PeakLimit limit_of(double acceleration) {
    return PeakLimit(0.0, {}, acceleration, "m/s^2");
}

/// 20 mm up, 20 mm more, 40 mm down; the last two share 200 deg.
Scene strokes_scene() {
    // The last two would meet at speed without a rest between them.
    Scene scene = program({dwell(30), spline(90, 0.5), dwell(30), stroke(1.0, 60, 150, 100), dwell(10),
                           stroke(0.0, 40, 140, 100)},
                          16);
    scene.motion.lift = 40e-3;
    scene.motion.speed = 20.0;
    scene.limits.acceleration = limit_of(acceleration_limit);
    return scene;
}

/// Least objective for a given angle of the stroke to the top, and nothing searched.
double objective_at(const Scene& scene, double top) {
    std::vector<double> angles;
    for (const ProgramSegment& segment : scene.motion.segments) angles.push_back(segment.angle);
    angles[3] = top * degree;
    angles[5] = (200 - top) * degree;
    Scene given = with_segment_angles(scene, angles);
    for (ProgramSegment& segment : given.motion.segments) segment.angle_range.reset();
    given.limits.acceleration = limit_of(acceleration_limit);
    const Solution solution = solve(given);
    return solution.motion ? solution.certificate.objective : HUGE_VAL;
}

TEST(FreeAngles, OneBoundSettlesAngleIndependentCosts) {
    Scene scene = strokes_scene();
    scene.limits.acceleration.reset();
    const Solution solution = solve(scene);
    EXPECT_EQ(solution.certificate.verdict, Verdict::optimal) << solution.certificate.reason;
    EXPECT_EQ(solution.certificate.proof_kind, ProofKind::duality);
    EXPECT_NEAR(solution.certificate.objective, 0.947449535, 1e-7);  // n = 16, as a rise alone
}

TEST(FreeAngles, OptimalShareIsProved) {
    const Scene scene = strokes_scene();
    const Solution solution = solve(scene);
    ASSERT_EQ(solution.certificate.verdict, Verdict::optimal) << solution.certificate.reason;
    double total = 0.0;
    for (const ProgramSegment& segment : solution.scene.motion.segments) total += segment.angle;
    EXPECT_NEAR(total, 360 * degree, 1e-12);
    const double first = solution.scene.motion.segments[3].angle / degree;
    EXPECT_GE(first, 60.0);
    EXPECT_LE(first, 150.0);
    double least = HUGE_VAL;
    for (double angle = 62; angle < 150; angle += 8) least = std::min(least, objective_at(scene, angle));
    EXPECT_LE(solution.certificate.objective, least + 1e-7);
    EXPECT_NEAR(objective_at(scene, first), solution.certificate.objective, 1e-6);
    EXPECT_GT(objective_at(scene, 88), solution.certificate.objective + 1e-3);  // the limit bites there
    for (const CaseProof& part : solution.certificate.cases) {
        ASSERT_TRUE(part.proof);
        EXPECT_GE(recomputed_bound(*part.proof) + 1e-9, part.infeasible ? 0.0 : part.bound);
    }
    EXPECT_EQ(solution.design.names.front(), "motion.segments[3].angle_rad");
}

TEST(FreeAngles, InfeasibleSharesAreProved) {
    Scene scene = strokes_scene();
    scene.limits.acceleration = limit_of(12.0);
    const Solution solution = solve(scene);
    EXPECT_EQ(solution.certificate.verdict, Verdict::infeasible) << solution.certificate.reason;
    EXPECT_FALSE(solution.motion);
}

/// Two splines that meet at speed know each other's angle: no bound over boxes, an honest local optimum.
TEST(FreeAngles, OfJointsAtSpeedAreLocal) {
    Scene scene =
        program({dwell(120), stroke(0.3, 40, 120, 60), stroke(1.0, 40, 120, 60), spline(120, 0.0)}, 8);
    scene.motion.within_lift = false;  // the top is a joint at speed too
    const Solution solution = solve(scene);
    ASSERT_TRUE(solution.motion) << solution.certificate.reason;
    EXPECT_TRUE(solution.certificate.verdict == Verdict::local ||
                solution.certificate.verdict == Verdict::feasible);
    EXPECT_FALSE(solution.certificate.lower_bound);
    Scene given = scene;
    for (ProgramSegment& segment : given.motion.segments) segment.angle_range.reset();
    EXPECT_LT(solution.certificate.objective, solve(given).certificate.objective - 1e-4);
}

TEST(FreeAngles, InconsistentRangesAreRefused) {
    Scene scene = strokes_scene();
    scene.limits = {};
    scene.motion.segments[3].angle_range.reset();
    const auto fault = find_fault(scene);
    ASSERT_TRUE(fault);
    EXPECT_EQ(fault->member, "motion.segments[5].angle");
    EXPECT_EQ(fault->found, "the only range of the program");
    scene = strokes_scene();
    scene.limits = {};
    scene.motion.closed = false;
    ASSERT_TRUE(find_fault(scene));
    EXPECT_EQ(find_fault(scene)->found, "a range in a program that is not closed");
}

TEST(FreeAngles, PointsInUnitsKeepTheirAngle) {
    Scene scene = strokes_scene();
    SetPoint point{.at = 0.5, .velocity = 1.0};
    point.units = {.place = "deg", .velocity = "mm/s"};
    scene.motion.segments[3].via = {point};
    const Scene longer = with_segment_angles(
        scene, {30 * degree, 90 * degree, 30 * degree, 125 * degree, 10 * degree, 75 * degree});
    const SetPoint& moved = longer.motion.segments[3].via[0];
    EXPECT_NEAR(moved.at * 125, 50.0, 1e-12);
    EXPECT_NEAR(*moved.velocity / 125, 1.0 / 100, 1e-15);
}

/// Corridors stand while segments move past them: the box of the largest angles proves nothing.
TEST(FreeAngles, CorridorIsNoReasonForInfeasibility) {
    Scene scene = strokes_scene();
    Corridor corridor;
    corridor.from = 190 * degree;
    corridor.to = 195 * degree;
    corridor.bounds[0].least = 0.55;  // on the way to the top, which begins later if all angles grow
    scene.motion.corridors = {corridor};
    scene.motion.segments[1].angle_range = AngleRange{60 * degree, 150 * degree};
    scene.solver.max_seconds = 20.0;
    const Solution solution = solve(scene);
    EXPECT_TRUE(solution.motion) << solution.certificate.reason;
    EXPECT_EQ(solution.certificate.proof_kind, ProofKind::none);
}

/// More area may be lost where a dwell at 0 grows: the bound of the largest angles was above the optimum.
TEST(FreeAngles, AreaHasNoBoundOverAngles) {
    Scene scene = program({dwell(90), spline(90, 1.0), dwell(90), spline(90, 0.0)});
    for (const std::size_t rest : {std::size_t{0}, std::size_t{2}})
        scene.motion.segments[rest].angle_range = AngleRange{30 * degree, 150 * degree};
    scene.objective = {};
    scene.objective.acceleration = 0.1;
    scene.objective.area = 1.0;
    scene.objective.reference.area = 0.5;
    const Solution solution = solve(scene);
    ASSERT_TRUE(solution.motion) << solution.certificate.reason;
    EXPECT_FALSE(solution.certificate.lower_bound);
    EXPECT_NEAR(30 * degree, solution.scene.motion.segments[0].angle, 1e-6);
    EXPECT_LT(solution.certificate.objective, 0.71);
}

}  // namespace free_angles_test
}  // namespace camopt
