// SPDX-License-Identifier: MIT
// When a limit is active: measured by the quantity it holds, never by the limit, which may be 0.
#include "core/units.hpp"
#include "report/solve/solution_document.hpp"
#include "studies/delivered/scene_limits.hpp"
#include "tests/support/refusal.hpp"
#include "tests/support/solved_scene.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

namespace camopt {
namespace limit_activity_test {

using testing_support::says;

/// A solution with one limit of a cam, and whether it is active.
bool is_active(const WrittenLimit& limit, std::optional<WrittenLimit> LimitSpec::*member, const char* name,
               double worst) {
    Solution solution;
    solution.scene.limits.*member = limit;
    solution.cam.emplace();
    solution.cam->summary.base_radius = 30e-3;
    solution.cam->summary.forces = ForceSummary{};
    solution.cam->summary.forces->largest_force = {500.0, 0.3};
    solution.constraints = {{name, limit.key, limit.given(), worst, limit.unit, 0.2}};
    judge_activity(solution);
    return solution.constraints.front().active;
}

TEST(LimitActivity, ZeroForceLimitScalesWithForce) {
    const WrittenLimit zero{0.0, "limits.contact_force_min_n", 1.0, "N"};
    const auto active = [&](double least) {
        return is_active(zero, &LimitSpec::contact_force_min, "contact_force_min", least);
    };
    EXPECT_TRUE(active(2e-9));
    EXPECT_TRUE(active(-2e-9));
    EXPECT_FALSE(active(1e-2));
}

TEST(LimitActivity, ZeroRadiusLimitUsesBaseCircle) {
    const WrittenLimit zero{0.0, "limits.cam_radius_min_mm", 1e-3, "mm"};
    const auto active = [&](double least) {
        return is_active(zero, &LimitSpec::cam_radius_min, "cam_radius_min", least);
    };
    EXPECT_TRUE(active(1e-9));
    EXPECT_TRUE(active(-1e-9));
    EXPECT_FALSE(active(1e-3));
}

TEST(LimitActivity, UndefinedRadiusIsNotActive) {
    const WrittenLimit thirty{30e-3, "limits.concave_radius_min_mm", 1e-3, "mm"};
    EXPECT_FALSE(is_active(thirty, &LimitSpec::concave_radius_min, "concave_radius_min", infinity));
    EXPECT_TRUE(is_active(thirty, &LimitSpec::concave_radius_min, "concave_radius_min", 30.0 + 1e-6));
}

TEST(LimitActivity, SmallDistantLimitIsNotActive) {
    const WrittenLimit small{1e-5 * units::degree, "limits.pressure_angle_deg", units::degree, "deg"};
    EXPECT_FALSE(is_active(small, &LimitSpec::pressure_angle, "pressure_angle", 0.0));
    EXPECT_TRUE(is_active(small, &LimitSpec::pressure_angle, "pressure_angle", 1e-5));
}

const ConstraintReport& limit_of(const Solution& solution, const std::string& key) {
    return *std::ranges::find(solution.constraints, key, &ConstraintReport::key);
}

std::string text_of(const Solution& solution) {
    return summary_text(solution);
}

// The roller is larger than the nose of the best motion's cam: the limit of 0 holds it at a cusp.
TEST(LimitActivity, ActiveUndercutLimitIsCusp) {
    const Solution solution = solve(testing_support::scene_named("roller_at_cusp"));
    ASSERT_TRUE(solution.cam);
    EXPECT_TRUE(limit_of(solution, "limits.cam_radius_min_mm").active);
    EXPECT_TRUE(solution.cam->summary.cusp()) << solution.cam->summary.regularity.value;
    EXPECT_FALSE(solution.cam->summary.undercut());
    EXPECT_FALSE(solution.cam->summary.no_contact);
    const std::string text = text_of(solution);
    EXPECT_TRUE(says(text, "A CUSP at "));
    EXPECT_FALSE(says(text, "UNDERCUT"));
    EXPECT_TRUE(says(text, "Active limits: the cam radius at "));
}

TEST(LimitActivity, ConvexCamHasNoConcaveRadius) {
    const Solution solution = solve(testing_support::scene_named("nowhere_concave"));
    ASSERT_TRUE(solution.cam);
    ASSERT_FALSE(solution.cam->summary.concave_radius);
    EXPECT_FALSE(limit_of(solution, "limits.concave_radius_min_mm").active);
    const std::string text = text_of(solution);
    EXPECT_TRUE(says(text, "nowhere concave"));
    EXPECT_TRUE(says(text, "No limit is active"));
    EXPECT_FALSE(says(text, "∞"));
}

}  // namespace limit_activity_test
}  // namespace camopt
