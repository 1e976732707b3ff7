// SPDX-License-Identifier: MIT
// Random roller cams whose undercut limit is not convex: what is delivered satisfies every limit, nearly all
// of it is proved, and more starts find nothing below what is proved.
#include "profiles/disk/disk_cam.hpp"
#include "solvers/certificate/box_proof.hpp"
#include "studies/search/planned_solve.hpp"
#include "studies/solve/solve.hpp"
#include "tests/studies/scenes_for_tests.hpp"
#include "tests/support/long_run.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <random>

namespace camopt {
namespace cam_random_test {

using namespace testing_support;
using enum DimensionIndex;

/// At least nine of ten scenes end with a proof, one way or the other.
constexpr double part_proved = 0.9;
constexpr int many_starts = 40;
constexpr unsigned one_thorough_of = 4;
constexpr int dense_points = 20000;

double uniform(std::mt19937& random, double low, double high) {
    return low + (high - low) * static_cast<double>(random()) / 4294967295.0;
}

/// A pressure angle and a least convex radius that both mean something for this lift and rise.
Scene random_scene(unsigned seed) {
    std::mt19937 random(seed);
    Scene scene;
    scene.motion.type = random() % 2 == 0 ? MotionType::drd : MotionType::rr;
    scene.motion.lift = uniform(random, 8e-3, 30e-3);
    scene.motion.rise = uniform(random, 50.0, 110.0) * units::degree;
    scene.spline.segments = scene.motion.type == MotionType::drd ? 12 : 16;
    scene.objective.velocity = uniform(random, 0.1, 1.0);
    scene.objective.acceleration = uniform(random, 0.1, 1.0);
    scene.objective.jerk = uniform(random, 0.05, 0.5);
    scene.cam = disk_spec({});
    const double prime = scene.motion.lift * uniform(random, 1.8, 3.5);
    const double roller = prime * uniform(random, 0.15, 0.3);
    scene.cam->set(base_radius, prime - roller);
    scene.cam->set(roller_radius, roller);
    scene.cam->set(offset, prime * uniform(random, -0.15, 0.25));
    scene.cam->rotation = random() % 2 == 0 ? Rotation::counterclockwise : Rotation::clockwise;
    scene.limits.pressure_angle = degrees(uniform(random, 28.0, 45.0), "limits.pressure_angle_deg");
    const Solution free = solve(scene);
    if (!free.motion) return scene;
    // A radius that the cam without this limit does not keep.
    const double radius = std::max(free.cam->summary.convex_radius->value, 0.02 * prime);
    scene.limits.cam_radius_min =
        millimetres(1e3 * radius * uniform(random, 1.02, 1.35), "limits.cam_radius_min_mm");
    return scene;
}

/// The largest relative violation of the limits, from the motion alone: formulas of a translating roller,
/// written out by its pitch curve.
double worst_violation(const Scene& scene, const Motion& motion) {
    const DiskSpec cam = disk_of(*scene.cam);
    const double roller = cam[roller_radius].low;
    const double prime = cam[base_radius].low + roller;
    const double e = (scene.cam->rotation == Rotation::counterclockwise ? 1.0 : -1.0) * cam[offset].low;
    const double s0 = std::sqrt(prime * prime - e * e);
    const double unit = scene.motion.unit_angle();
    double worst = -1.0;
    for (int k = 0; k <= dense_points; ++k) {
        const MotionPoint point =
            motion.at(motion.begin() + (motion.end() - motion.begin()) * k / dense_points);
        const double y = s0 + scene.motion.lift * point.derivative[0];
        const double v = scene.motion.lift / unit * point.derivative[1] - e;
        const double a = scene.motion.lift / (unit * unit) * point.derivative[2];
        const double angle = std::abs(std::atan(v / y));
        worst = std::max(worst, angle / scene.limits.pressure_angle->value - 1.0);
        const double w = std::hypot(y, v);
        const double curvature = (y * y + v * (2.0 * (v + e) - e) - y * a) / (w * w * w);
        if (curvature <= 0.0 || !scene.limits.cam_radius_min) continue;
        const double radius = 1.0 / curvature - roller;
        worst = std::max(worst, 1.0 - radius / scene.limits.cam_radius_min->value);
    }
    return worst;
}

TEST(RandomRollerCams, BoundsSurviveManyStarts) {
    const int random_scenes = scenes_to_try(12, 50);
    int proved = 0, infeasible = 0, over_boxes = 0;
    for (unsigned seed = 1; seed <= static_cast<unsigned>(random_scenes); ++seed) {
        Scene scene = random_scene(seed);
        const Solution solution = solve_without_explaining(scene, {});
        const Certificate& certificate = solution.certificate;
        infeasible += certificate.verdict == Verdict::infeasible ? 1 : 0;
        proved += certificate.verdict == Verdict::optimal ? 1 : 0;
        over_boxes += certificate.proof_kind == ProofKind::boxes ? 1 : 0;
        if (certificate.box_proof) {
            const double again = recomputed_bound(*certificate.box_proof);
            if (solution.motion) {
                EXPECT_GE(again, *certificate.lower_bound - 1e-12) << "seed " << seed;
            } else {
                EXPECT_EQ(again, infinity) << "seed " << seed;
            }
        }
        if (!solution.motion) continue;
        EXPECT_LE(worst_violation(scene, *solution.motion), 1e-6) << "seed " << seed;
        if (seed % one_thorough_of != 0) continue;
        scene.solver.starts = many_starts;
        scene.solver.gap = 1e-7;
        const Solution thorough = solve_without_explaining(scene, {});
        ASSERT_TRUE(thorough.motion) << "seed " << seed;
        EXPECT_GE(thorough.certificate.objective, *certificate.lower_bound - 1e-9) << "seed " << seed;
        EXPECT_LE(certificate.objective - thorough.certificate.objective, 1e-4) << "seed " << seed;
    }
    std::printf("%d scenes: %d optimal, %d infeasible, %d of these over boxes\n", random_scenes, proved,
                infeasible, over_boxes);
    EXPECT_GE(proved + infeasible, part_proved * random_scenes);
    EXPECT_GE(over_boxes, random_scenes / 4);
}

}  // namespace cam_random_test
}  // namespace camopt
