// SPDX-License-Identifier: MIT
// What a scene file says of motions, in plain structs of C++: prescribed programs, ends in motion, corridors,
// limits of one side, the area, repeated parts, a load over the cam angle.
#include "core/units.hpp"
#include "profiles/disk/disk_cam.hpp"
#include "scene/written_limits.hpp"
#include "studies/solve/solve.hpp"
#include "tests/studies/scenes_for_tests.hpp"
#include "tests/support/solved_scene.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace camopt {
namespace embedder_motions_test {

using namespace testing_support;

Scene rise() {
    Scene scene = paper_objective(MotionType::drd, 3, 12);
    scene.motion.lift = 10.0 * units::millimetre;
    scene.motion.rise = 120.0 * units::degree;
    scene.motion.speed = 600.0 * units::revolution_per_minute;
    return scene;
}

Scene prescribed(std::vector<ProgramSegment> segments) {
    Scene scene;
    scene.motion.type = MotionType::program;
    scene.motion.lift = 10.0 * units::millimetre;
    scene.motion.speed = 300.0 * units::revolution_per_minute;
    scene.motion.segments = std::move(segments);
    return scene;
}

/// The least y^(order) on a dense grid.
double least(const Motion& motion, std::size_t order, double from, double until) {
    constexpr int places = 5000;
    double found = infinity;
    for (int k = 0; k <= places; ++k)
        found = std::min(found, motion.at(from + (until - from) * k / places).derivative[order]);
    return found;
}

TEST(MotionsFromCpp, SidedLimitInTimeHolds) {
    Scene scene = rise();
    const double per_normalised =
        scene.motion.lift * std::pow(*scene.motion.speed / scene.motion.rise, 2);  // m/s²
    constexpr double limit = -42.0;
    const Solution free = optimum_of(scene);
    EXPECT_LT(least(*free.motion, 2, 0.0, 1.0) * per_normalised, limit - 1.0) << "it costs nothing";
    scene.limits.acceleration_min = metres_per_second_squared(limit);
    const Solution solution = optimum_of(scene);
    EXPECT_GE(least(*solution.motion, 2, 0.0, 1.0) * per_normalised, limit * (1.0 + 1e-8));
    ASSERT_EQ(solution.constraints.size(), free.constraints.size() + 1);
    EXPECT_EQ(solution.constraints.front().key, "limits.acceleration_m_s2.min");
    EXPECT_NEAR(solution.constraints.front().worst, limit, 1e-6);
}

TEST(MotionsFromCpp, CorridorHoldsOnItsStretch) {
    Scene scene = rise();
    const double from = 40.0 / 120.0, to = 60.0 / 120.0;
    EXPECT_GT(optimum_of(scene).motion->at(to).derivative[0], 0.49);
    Corridor corridor;
    corridor.from = 40.0 * units::degree;
    corridor.to = 60.0 * units::degree;
    corridor.bounds[0].most = 0.4;   // y, in lifts
    corridor.bounds[1].least = 0.9;  // y'
    scene.motion.corridors = {corridor};
    const Solution solution = optimum_of(scene);
    EXPECT_NEAR(solution.motion->at(to).derivative[0], 0.4, 1e-8);
    EXPECT_GE(least(*solution.motion, 1, from, to), 0.9 - 1e-8);
}

TEST(MotionsFromCpp, EndsHaveGivenStates) {
    Scene scene = rise();
    scene.spline.degree = 5;
    scene.motion.start = SetPoint{.velocity = 0.5};
    scene.motion.end = SetPoint{.at = 1.0, .velocity = 0.25, .acceleration = -1.0};
    const Solution solution = optimum_of(scene);
    EXPECT_NEAR(solution.motion->at(0.0).derivative[1], 0.5, 1e-9);
    EXPECT_NEAR(solution.motion->at(0.0).derivative[2], 0.0, 1e-9);
    EXPECT_NEAR(solution.motion->at(1.0, Side::left).derivative[1], 0.25, 1e-9);
    EXPECT_NEAR(solution.motion->at(1.0, Side::left).derivative[2], -1.0, 1e-8);
}

TEST(MotionsFromCpp, AreaIsWeighed) {
    Scene scene = rise();
    scene.motion.type = MotionType::rr;
    const auto area = [](const Motion& motion) {
        double sum = 0.0;
        constexpr int places = 2000;
        for (int k = 0; k < places; ++k) sum += motion.at(2.0 * (k + 0.5) / places).derivative[0];
        return sum / places;
    };
    const double without = area(*optimum_of(scene).motion);
    scene.objective.area = 3.0;
    scene.objective.reference.area = 0.5;
    EXPECT_GT(area(*optimum_of(scene).motion), without + 0.01);
}

TEST(MotionsFromCpp, PrescribedProgramNeedsNoObjective) {
    const Solution solution = optimum_of(
        prescribed({law(120, "cycloidal", 1.0), dwell(60), law(90, "polynomial_345", 0.0), dwell(90)}));
    EXPECT_NEAR(solution.motion->at(0.5).derivative[0], 0.5, 1e-12);
    EXPECT_EQ(solution.segments.size(), 4U);
}

TEST(MotionsFromCpp, RepeatedPartsAreEqual) {
    Scene scene = prescribed(
        {spline(60, 1.0), dwell(60), spline(60, 0.0), spline(60, 1.0), dwell(60), spline(60, 0.0)});
    scene.motion.repeat = 2;
    scene.objective.acceleration = 1.0;
    scene.objective.jerk = 0.2;
    const Solution solution = optimum_of(scene);
    for (const double x : {0.3, 0.7, 2.4})
        EXPECT_NEAR(solution.motion->at(x).derivative[2], solution.motion->at(x + 3.0).derivative[2], 1e-9);
}

TEST(MotionsFromCpp, LoadOverAngleEntersForce) {
    Scene scene = prescribed({law(120, "cycloidal", 1.0), dwell(60), law(120, "cycloidal", 0.0), dwell(60)});
    scene.cam = disk_spec({});
    scene.cam->set(DimensionIndex::base_radius, 40.0 * units::millimetre);
    scene.cam->set(DimensionIndex::roller_radius, 10.0 * units::millimetre);
    ForceSpec forces;
    forces.preload = 100.0;
    scene.forces = forces;
    const auto largest = [](const Solution& solution) {
        return solution.cam.value().summary.forces.value().largest_force;
    };
    EXPECT_NEAR(largest(optimum_of(scene)).value, 100.0, 1e-6);
    scene.forces->load = {
        {60.0 * units::degree, 0.0}, {90.0 * units::degree, 250.0}, {120.0 * units::degree, 0.0}};
    const CamExtreme loaded = largest(optimum_of(scene));
    EXPECT_NEAR(loaded.value, 350.0, 1e-6);
    EXPECT_NEAR(loaded.at, 90.0 / 120.0, 1e-6);
}

}  // namespace embedder_motions_test
}  // namespace camopt
