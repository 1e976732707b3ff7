// SPDX-License-Identifier: MIT
// A cam that cannot be built (an arm that does not reach) is never delivered under a verdict.
#include "profiles/disk/disk_cam.hpp"
#include "studies/delivered/delivered_audit.hpp"
#include "studies/search/planned_solve.hpp"
#include "tests/support/refusal.hpp"
#include "tests/support/scene_kit.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace camopt {
namespace unbuildable_cam_test {

using namespace testing_support;
using enum DimensionIndex;

/// What is wrong with the delivered cam; empty where it can be built.
std::string fault_of(const Solution& solution) {
    double least = 0.0, most = 0.0;
    constexpr int places = 2000;
    for (int k = 0; k <= places; ++k) {
        const double x = solution.motion->end() * k / places;
        const double s = solution.scene.motion.lift * solution.motion->at(x, Side::left).derivative[0];
        least = std::min(least, s);
        most = std::max(most, s);
    }
    return geometry_fault(*disk_cam(solution.cam->cam), least, most);
}

bool stands(const Certificate& certificate) {
    return certificate.verdict == Verdict::optimal || certificate.verdict == Verdict::local ||
           certificate.verdict == Verdict::feasible;
}

TEST(UnbuildableCam, IsNoOptimum) {
    const Solution solution = solve_without_explaining(scene_named("arm_too_long"), {});
    ASSERT_TRUE(stands(solution.certificate)) << solution.certificate.reason;
    ASSERT_TRUE(solution.cam);
    EXPECT_EQ(fault_of(solution), "");
    for (const ConstraintReport& limit : solution.constraints) {
        EXPECT_TRUE(std::isfinite(limit.worst)) << limit.key;
        EXPECT_LE(limit.worst, limit.limit * (1.0 + 1e-6)) << limit.key;
    }
}

TEST(UnbuildableCam, GivesWayToBestWithinReach) {
    const TestScene scene = scene_named("cam_out_of_reach");
    const Solution equal = solve_without_explaining(scene, {});
    EXPECT_EQ(equal.certificate.verdict, Verdict::optimal);
    EXPECT_TRUE(equal.certificate.proof);
    EXPECT_EQ(fault_of(equal), "");
    // Here the reach costs something, and what the proof of all motions says is no bound of these.
    const Solution dearer =
        solve_without_explaining(scene.with("objective.velocity = 0", "objective.acceleration = 1"), {});
    EXPECT_EQ(dearer.certificate.verdict, Verdict::local);
    EXPECT_FALSE(dearer.certificate.lower_bound || dearer.certificate.proof);
    EXPECT_EQ(fault_of(dearer), "");
    EXPECT_FALSE(dearer.scene.motion.reach);
}

TEST(UnbuildableCam, VoidsVerdictOfLastLook) {
    Solution solution = solve_without_explaining(pressure_angle_scene(60.0, 12), {});
    ASSERT_EQ(solution.certificate.verdict, Verdict::optimal);
    ASSERT_TRUE(solution.cam);
    audit_delivered(solution);
    ASSERT_EQ(solution.certificate.verdict, Verdict::optimal);
    DiskCam cam = *disk_cam(solution.cam->cam);
    cam.dimensions[static_cast<std::size_t>(offset)] = 59.9e-3;
    solution.cam->cam = disk_mechanism(cam);
    audit_delivered(solution);
    EXPECT_EQ(solution.certificate.verdict, Verdict::optimal);
    cam.dimensions[static_cast<std::size_t>(offset)] = 60.1e-3;
    solution.cam->cam = disk_mechanism(cam);
    audit_delivered(solution);
    EXPECT_EQ(solution.certificate.verdict, Verdict::failed);
    EXPECT_EQ(solution.certificate.reason, "cam_cannot_be_built");
    EXPECT_FALSE(solution.certificate.lower_bound || solution.certificate.proof);
    ASSERT_FALSE(solution.notes.empty());
    EXPECT_TRUE(says(solution.notes.back(), "the offset of 60.1 mm is not below the prime radius of 60 mm"));
}

}  // namespace unbuildable_cam_test
}  // namespace camopt
