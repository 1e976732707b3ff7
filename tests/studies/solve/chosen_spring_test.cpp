// SPDX-License-Identifier: MIT
// Preload and spring rate as ranges, and the cap on the contact force: against solves with fixed numbers.
#include "report/json/result_json.hpp"
#include "report/solve/solution_document.hpp"
#include "studies/compare/comparison.hpp"
#include "studies/solve/solve.hpp"
#include "tests/support/scene_kit.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace camopt {
namespace chosen_spring_test {

using namespace testing_support;
using testing::HasSubstr;

/// A roller under a mass that would leave the cam: the spring has to hold it, and not to press too much.
TestScene sprung() {
    return pressure_angle_scene(60, 12).with(
        "limits = { contact_force_min_n = 10, contact_force_max_n = 480 }", "motion.speed_rad_s = 40",
        "forces = { mass_kg = 1, spring_rate_n_m = 4000, preload_n = 200 }");
}

TEST(ChosenSpring, PreloadIsProvedTogetherWithMotion) {
    const Solution chosen = solve(sprung().with("forces.preload_n = { min = 0, max = 1000 }"));
    ASSERT_EQ(chosen.certificate.verdict, Verdict::optimal) << chosen.certificate.reason;
    const double preload = chosen.scene.forces->preload;
    EXPECT_GT(preload, 0.0);
    EXPECT_LT(preload, 1000.0);
    const Solution same = solve(sprung().set("forces.preload_n", preload));
    EXPECT_NEAR(same.certificate.objective, chosen.certificate.objective, 1e-6);
    for (double other = 0.0; other <= 1000.0; other += 50.0) {
        const Solution fixed = solve(sprung().set("forces.preload_n", other));
        if (fixed.certificate.verdict == Verdict::infeasible) continue;
        EXPECT_GE(fixed.certificate.objective, *chosen.certificate.lower_bound - 1e-9) << other;
    }
}

TEST(ChosenSpring, TooNarrowRangeIsProvedInfeasible) {
    const Solution none =
        solve(sprung().with("forces.preload_n = { min = 0, max = 5 }", "solver.explain_seconds = 1"));
    EXPECT_EQ(none.certificate.verdict, Verdict::infeasible);
    const auto row = std::ranges::find(none.relaxation, "forces.preload_n.max", &Relaxation::key);
    ASSERT_NE(row, none.relaxation.end());
    EXPECT_TRUE(row->needed);
}

TEST(ChosenSpring, RateIsBoundedOverBoxes) {
    const Solution chosen = solve(sprung().with("forces.spring_rate_n_m = { min = 0, max = 20000 }",
                                                "forces.preload_n = 60", "solver.starts = 2"));
    ASSERT_TRUE(chosen.motion) << chosen.certificate.reason;
    const double rate = chosen.scene.forces->spring_rate;
    EXPECT_GE(rate, 0.0);
    EXPECT_LE(rate, 20000.0);
    const Solution same = solve(sprung().with("forces.preload_n = 60").set("forces.spring_rate_n_m", rate));
    EXPECT_NEAR(same.certificate.objective, chosen.certificate.objective, 1e-5);
    ASSERT_TRUE(chosen.certificate.lower_bound);
    for (const double other : {1000.0, 4000.0, 8000.0, 16000.0}) {
        const Solution fixed =
            solve(sprung().with("forces.preload_n = 60").set("forces.spring_rate_n_m", other));
        if (!fixed.motion) continue;
        EXPECT_GE(fixed.certificate.objective, *chosen.certificate.lower_bound - 1e-9) << other;
    }
}

TEST(ChosenSpring, IsReportedInItsUnits) {
    const Solution metric = solve(sprung().with("forces.preload_n = { min = 0, max = 1000 }"));
    EXPECT_THAT(result_json(metric), HasSubstr("\"preload_n\""));
    EXPECT_THAT(result_json(metric), HasSubstr("\"forces.preload\""));
    EXPECT_THAT(report_markdown(metric), HasSubstr("chosen by the optimizer"));
    const Solution inches =
        solve(sprung().with("motion.lift_in = 0.8", "forces.preload_lbf = { min = 0, max = 200 }"));
    EXPECT_THAT(report_markdown(inches), HasSubstr("lbf"));
    EXPECT_NEAR(inches.scene.forces->preload_range->at(1), 200 * 4.4482216152605, 1e-9);
}

TEST(ChosenSpring, LawsAreComparedWithIt) {
    const Comparison comparison = compare(sprung().with("forces.preload_n = { min = 0, max = 1000 }"));
    ASSERT_TRUE(comparison.optimum.motion);
    const Comparison fixed =
        compare(sprung().set("forces.preload_n", comparison.optimum.scene.forces->preload));
    ASSERT_EQ(comparison.rows.size(), fixed.rows.size());
    for (std::size_t i = 1; i < fixed.rows.size(); ++i)
        EXPECT_EQ(comparison.rows[i].feasible, fixed.rows[i].feasible) << i;
}

}  // namespace chosen_spring_test
}  // namespace camopt
