// SPDX-License-Identifier: MIT
// Set points that a spline of nine segments just fails to contradict: its motions have velocities of
// thousands, and double precision holds some of them only. What is delivered is held, and a remedy that is
// offered works.
#include "input/loading/load_scene.hpp"
#include "studies/solve/solve.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace camopt {
namespace nearly_contradicting_test {

Scene scene_with(int segments) {
    return scene_of_toml(
        "motion.type = \"RR\"\n"
        "motion.lift_m = 0.028806127460543559\n"
        "motion.rise_deg = 69.502291397313698\n"
        "motion.return_deg = 77.419011036479958\n"
        "motion.via = [{ at = 0.5, velocity = 1.2244721886658188 }, "
        "{ at = 0.24819131387678853, displacement = 0.10161723432929007, "
        "velocity = 1.0445015508375064 }]\n"
        "spline.degree = 3\n"
        "spline.design = \"states\"\n"
        "objective.velocity = 0.66043282811445003\n"
        "objective.acceleration = 0.11899469086508263\n"
        "objective.jerk = 0.61634726429655418\n"
        "solver.max_seconds = 4\n"
        "spline.segments = " +
        std::to_string(segments) + "\n");
}

TEST(NearlyContradicting, DeliveredMotionIsRepresentable) {
    Scene scene = scene_with(9);
    scene.motion.within_lift = false;  // so few segments cannot
    const Solution solution = solve(scene);
    ASSERT_NE(solution.certificate.verdict, Verdict::failed);
    ASSERT_TRUE(solution.curve);
    EXPECT_TRUE(std::isfinite(solution.certificate.objective));
}

TEST(NearlyContradicting, TheSegmentsThatAreOfferedDo) {
    const Solution few = solve(scene_with(6));
    ASSERT_EQ(few.certificate.verdict, Verdict::infeasible);
    ASSERT_FALSE(few.relaxation.empty());
    const Relaxation& row = few.relaxation.front();
    ASSERT_EQ(row.key, "spline.segments");
    ASSERT_TRUE(row.needed);
    const Solution offered = solve(scene_with(static_cast<int>(*row.needed)));
    EXPECT_NE(offered.certificate.verdict, Verdict::failed);
    EXPECT_NE(offered.certificate.verdict, Verdict::infeasible);
}

}  // namespace nearly_contradicting_test
}  // namespace camopt
