// SPDX-License-Identifier: MIT
// A cam that cannot be built (an arm that does not reach) is never delivered under a verdict.
#include "profiles/disk/disk_cam.hpp"
#include "studies/delivered/delivered_audit.hpp"
#include "studies/search/planned_solve.hpp"
#include "tests/studies/cam_scenes.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace camopt {
namespace unbuildable_cam_test {

using testing_support::pressure_angle_scene;
using enum DimensionIndex;

/// The least cost of base circle and centre distance is an arm longer than both together.
Scene arm_too_long() {
    Scene scene;
    scene.motion.lift_is_angle = true;
    scene.motion.lift = 0.26938895457040668;
    scene.motion.rise = 139.3020527593446 * units::degree;
    scene.spline.degree = 5;
    scene.spline.segments = 6;
    scene.objective.velocity = 0.21202963797666124;
    scene.objective.acceleration = 0.38359018138971257;
    scene.objective.dimensions[static_cast<std::size_t>(base_radius)] = 0.024490334214622812;
    scene.objective.dimensions[static_cast<std::size_t>(center_distance)] = 0.28051354531770495;
    DiskSpec cam;
    cam.follower = FollowerType::oscillating_roller;
    cam[center_distance] = Dimension(0.051345198818442156, 0.10696161028767007);
    cam[base_radius] = Dimension(24.71066742037014e-3, 30.466071074961253e-3);
    cam[roller_radius] = Dimension(3.5521661892715626e-3, 7.3066012090840848e-3);
    cam[arm_length] = 0.08163069663055654;
    scene.cam = disk_spec(cam);
    scene.limits.pressure_angle =
        testing_support::degrees(0.60172141662463197 / units::degree, "limits.pressure_angle_deg");
    scene.solver.starts = 2;
    scene.solver.max_seconds = 20.0;
    return scene;
}

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
    const Solution solution = solve_without_explaining(arm_too_long(), {});
    ASSERT_TRUE(stands(solution.certificate)) << solution.certificate.reason;
    ASSERT_TRUE(solution.cam);
    EXPECT_EQ(fault_of(solution), "");
    for (const ConstraintReport& limit : solution.constraints) {
        EXPECT_TRUE(std::isfinite(limit.worst)) << limit.key;
        EXPECT_LE(limit.worst, limit.limit * (1.0 + 1e-6)) << limit.key;
    }
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
    EXPECT_NE(solution.notes.back().find("the offset of 60.1 mm is not below the prime radius of 60 mm"),
              std::string::npos)
        << solution.notes.back();
}

}  // namespace unbuildable_cam_test
}  // namespace camopt
