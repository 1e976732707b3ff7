// SPDX-License-Identifier: MIT
// The quick rows of the stability table, group by group, and the judge of the table itself: it must see what
// is wrong.
#include "tests/soak/relations/relation.hpp"
#include "tests/soak/stability/condition_number.hpp"
#include "tests/soak/stability/stability_cases.hpp"
#include "tests/soak/stability/stability_scenes.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace camopt::stability {
namespace table_test {

using soak::Solved;

struct Group {
    const char* name;
    std::vector<StabilityCase> (*cases)();
};

class StabilityGroup : public testing::TestWithParam<Group> {};

TEST_P(StabilityGroup, HasNoWrongVerdict) {
    int run = 0;
    int absent = 0;
    for (const StabilityCase& one : GetParam().cases()) {
        if (!one.quick) continue;
        const StabilityRow row = one.run();
        ++(row.judgement == Judgement::absent ? absent : run);
        EXPECT_NE(row.judgement, Judgement::wrong)
            << row.group << ": " << row.name << ", " << row.backend << ": " << row.why;
        if (row.backend == "structured" && !row.expected.may_give_up) {
            EXPECT_EQ(row.judgement, Judgement::ok) << row.name << ": " << row.why;
        }
    }
    EXPECT_GT(run, 0);
    RecordProperty("rows_of_absent_backends", absent);
}

INSTANTIATE_TEST_SUITE_P(Table, StabilityGroup,
                         testing::Values(Group{"design_vectors", design_vector_cases},
                                         Group{"scaling", scaling_cases}, Group{"weights", weight_cases},
                                         Group{"breakpoints", breakpoint_cases},
                                         Group{"exact_points", exact_point_cases},
                                         Group{"limits", limit_cases}, Group{"degenerate", degenerate_cases},
                                         Group{"claims", claim_cases}, Group{"stiff_trains", train_cases}),
                         [](const auto& group) { return std::string(group.param.name); });

Solved solved_twelve() {
    return soak::solved_from(study_scene(MotionType::drd, 3, 12), soak::Scope::memory);
}

/// With one number of its motion changed.
Solved with_bent_piece(Solved solved, std::size_t power, double by) {
    solved.outcome.spline->pieces.at(4).at(power) += by;
    read_motion(solved);
    return solved;
}

TEST(MotionInMemory, HasWhatTheLibraryReports) {
    const Solved solved = solved_twelve();
    ASSERT_TRUE(solved.motion && solved.motion->exact);
    EXPECT_NEAR(static_cast<double>(solved.figures.peak[1]), 12.0 / 7, 1e-8);
    EXPECT_NEAR(static_cast<double>(solved.figures.peak[2]), 36.0 / 7, 1e-8);
    EXPECT_NEAR(static_cast<double>(solved.figures.peak[3]), 432.0 / 7, 1e-7);
    EXPECT_NEAR(static_cast<double>(objective_of(solved.numbers, solved.figures, {})),
                *solved.outcome.objective, 1e-13);
    EXPECT_LE(missed_conditions(solved).amount, 1e-12L);
    EXPECT_LE(largest_jump(solved, 0, 2).amount, 1e-12L);
}

TEST(MotionInMemory, EveryJumpIsSeen) {
    const Solved solved = solved_twelve();
    for (const std::size_t power : {0, 1, 2})
        EXPECT_GT(largest_jump(with_bent_piece(solved, power, 1e-6), 0, 2).amount, 1e-8L) << power;
    // y''' of a cubic may jump, that of a C4 quintic may not.
    EXPECT_EQ(largest_jump(solved, 3, 3).amount, 0.0L);
    const Solved quintic = soak::solved_from(study_scene(MotionType::drd, 5, 12), soak::Scope::memory);
    EXPECT_LE(largest_jump(quintic, 3, 3).amount, 1e-9L);
    EXPECT_GT(largest_jump(with_bent_piece(quintic, 3, 1e-4), 3, 3).amount, 1e-6L);
    EXPECT_FALSE(check_joints(with_bent_piece(quintic, 3, 1e-2)).value_or("").empty());
}

TEST(MotionInMemory, ViolatedConditionsAreMeasured) {
    Solved capped = solved_twelve();
    capped.numbers.caps[1] = soak::Cap{1.5, false};
    EXPECT_NEAR(static_cast<double>(passed_caps(capped).amount), 12.0 / 7 / 1.5 - 1.0, 1e-8);
    Solved missed = solved_twelve();
    missed.numbers.via = {{0.25, {0.9, {}, {}}}};
    EXPECT_GT(missed_conditions(missed).amount, 0.1L);
}

TEST(MotionInMemory, ViolatedPressureAngleIsMeasured) {
    Solved solved =
        soak::solved_from(SceneText::parse(text_of_file("cam_smallest.toml")), soak::Scope::memory);
    EXPECT_LE(passed_follower_limits(solved).amount, 1e-9L);
    solved.numbers.limits.at("pressure_angle") *= 0.99;
    EXPECT_GT(passed_follower_limits(solved).amount, 5e-3L);
}

TEST(MotionInMemory, ViolatedTrainLimitsAreMeasured) {
    Solved solved =
        soak::solved_from(SceneText::parse("[motion]\ntype = \"DRD\"\nlift_mm = 24\nrise_deg = 90\n"
                                           "speed_rpm = 300\n[spline]\ndegree = 5\nsegments = 8\n"
                                           "[objective]\nacceleration = 0.9\njerk = 0.1\n"
                                           "[dynamics]\nmass_kg = 2.5\nnatural_frequency_hz = 100\n"
                                           "damping_ratio = 0.02\n[limits]\nresidual_um = 20\n"),
                          soak::Scope::memory);
    ASSERT_TRUE(solved.motion && solved.numbers.train);
    EXPECT_LE(passed_follower_limits(solved).amount, 1e-9L);
    EXPECT_EQ(check_cam_limits(solved).value_or("none"), "");
    solved.numbers.limits.at("residual") = 0.99 * 24e-3 * solved.figures.train.residual;
    EXPECT_NEAR(static_cast<double>(passed_follower_limits(solved).amount), 1.0 / 0.99 - 1.0, 1e-9);
    EXPECT_FALSE(check_cam_limits(solved).value_or("").empty());
}

TEST(StabilityRow, FalseFigureIsWrong) {
    const SceneText scene = study_scene(MotionType::drd, 3, 12);
    const double optimum = study_objective(12.0 / 7, 36.0 / 7, 432.0 / 7);
    EXPECT_EQ(solved_row(scene, exactly(optimum, "")).judgement, Judgement::ok);
    EXPECT_EQ(solved_row(scene, exactly(optimum * (1.0 - 1e-7), "")).judgement, Judgement::wrong);
    EXPECT_EQ(solved_row(scene, exactly(optimum * (1.0 + 1e-7), "")).judgement, Judgement::wrong);
    Expectation impossible;
    impossible.verdicts = {Verdict::infeasible};
    EXPECT_EQ(solved_row(scene, impossible).judgement, Judgement::wrong);
    EXPECT_EQ(refused_row([] {}, "").judgement, Judgement::wrong);
    SceneText refused = scene;
    refused.at("spline").set("degree", "4");
    EXPECT_EQ(solved_row(refused, exactly(optimum, "")).judgement, Judgement::wrong);
}

TEST(ConditionNumber, GrowsSlowestForStates) {
    for (const int order : {2, 3}) {
        const Scene scene = scene_of(study_scene(MotionType::drd, 3, 32));
        const double states = condition_number(scene, DesignKind::states, order);
        EXPECT_GT(states, 1.0);
        EXPECT_LT(10.0 * states, condition_number(scene, DesignKind::ordinates, order));
        EXPECT_LT(2.0 * states, condition_number(scene, DesignKind::coefficients, order));
    }
    // One freedom: every map is a column, and perfectly conditioned.
    EXPECT_NEAR(condition_number(scene_of(study_scene(MotionType::drd, 3, 4)), DesignKind::ordinates, 2), 1.0,
                1e-12);
}

}  // namespace table_test
}  // namespace camopt::stability
