// SPDX-License-Identifier: MIT
// Set points that a spline of nine segments just fails to contradict: its motions have velocities of
// thousands, and double precision holds some of them only. What is delivered is held, and a remedy that is
// offered works.
#include "tests/support/solved_scene.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace camopt {
namespace nearly_contradicting_test {

using namespace testing_support;

TEST(NearlyContradicting, DeliveredMotionIsRepresentable) {
    // Within the lift so few segments cannot.
    const Solution solution = solve(scene_named("nearly_contradicting").with("motion.within_lift = false"));
    ASSERT_NE(solution.certificate.verdict, Verdict::failed);
    ASSERT_TRUE(solution.curve);
    EXPECT_TRUE(std::isfinite(solution.certificate.objective));
}

TEST(NearlyContradicting, TheSegmentsThatAreOfferedDo) {
    const Solution few = solve(scene_named("nearly_contradicting").with("spline.segments = 6"));
    ASSERT_EQ(few.certificate.verdict, Verdict::infeasible);
    ASSERT_FALSE(few.relaxation.empty());
    const Relaxation& row = few.relaxation.front();
    ASSERT_EQ(row.key, "spline.segments");
    ASSERT_TRUE(row.needed);
    const Solution offered =
        solve(scene_named("nearly_contradicting").set("spline.segments", static_cast<int>(*row.needed)));
    EXPECT_NE(offered.certificate.verdict, Verdict::failed);
    EXPECT_NE(offered.certificate.verdict, Verdict::infeasible);
}

}  // namespace nearly_contradicting_test
}  // namespace camopt
