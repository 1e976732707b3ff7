// SPDX-License-Identifier: MIT
// Scenes with an elastic follower: proved, recomputed by an integrator that knows nothing of them, kept at
// every speed of their range; and what is refused.
#include "core/errors.hpp"
#include "core/units.hpp"
#include "objectives/grid/cam_problem.hpp"
#include "objectives/response/response_rule.hpp"
#include "objectives/response/train_figures.hpp"
#include "objectives/rules/point_rule.hpp"
#include "objectives/scene_model.hpp"
#include "report/csv/sweep_csv.hpp"
#include "report/json/json_text.hpp"
#include "report/solve/motion_remarks.hpp"
#include "studies/check/scene_check.hpp"
#include "studies/compare/comparison.hpp"
#include "studies/delivered/solution_parts.hpp"
#include "studies/pareto/sweep_front.hpp"
#include "studies/response/train_study.hpp"
#include "studies/solve/solve.hpp"
#include "studies/sweep/sweep_plan.hpp"
#include "tests/dynamics/stiff_integrator.hpp"
#include "tests/support/refusal.hpp"
#include "tests/support/scene_kit.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace camopt {
namespace train_scenes_test {

using namespace testing_support;

template <class... Settings>
TestScene slide(const char* dynamics, const Settings&... settings) {
    return scene_named("elastic_slide")
        .with(std::string("dynamics = { mass_kg = 2.5, ") + dynamics + " }", settings...);
}

constexpr const char* soft = "natural_frequency_hz = 70, damping_ratio = 0.02";
constexpr const char* ranged =
    "natural_frequency_hz = 70, damping_ratio = 0.02, speed_range_rpm = [285, 315]";
constexpr const char* pressed =
    "natural_frequency_hz = 70, damping_ratio = 0.02, return_spring_n_mm = 8, preload_n = 150";
constexpr const char* two_masses =
    "natural_frequency_hz = 80, damping_ratio = 0.03, "
    "stage = [{ mass_kg = 0.8, stiffness_n_mm = 2500, damping_ratio = 0.01 }]";

/// As a program makes it that fills the members by hand.
TEST(TrainScenes, TrainWithoutFormulasIsRefused) {
    Scene scene = slide(soft, "limits.residual_um = 30");
    scene.dynamics->formulas = nullptr;
    EXPECT_TRUE(says(refusal([&] { (void)solve(scene); }), "a follower train without its formulas"));
}

// No dwell, no transient: there is no acceleration of 0.
TEST(TrainScenes, ProgramWithoutDwellHasNoTransient) {
    const Solution solution =
        solve(scene_named("elastic_slide")
                  .with("motion = { type = 'program', lift_mm = 40, speed_rpm = 275.4, segments = ["
                        "{ kind = 'spline', angle_deg = 180, to = 1 }, { kind = 'spline', angle_deg = 180, "
                        "to = 0 }] }",
                        "spline = { segments = 6 }", "objective = { velocity = 0.7, acceleration = 0.4 }",
                        "dynamics = { mass_kg = 3.299, natural_frequency_hz = 22.51, return_spring_n_mm = 1, "
                        "preload_n = 10 }"));
    ASSERT_TRUE(solution.train);
    EXPECT_FALSE(solution.train->acceleration);
    const Json json = train_json(solution);
    EXPECT_TRUE(json["acceleration"].is_null());
    EXPECT_TRUE(json["residual"].is_null());
    const std::vector<std::string> sentences = train_sentences(solution);
    ASSERT_EQ(sentences.size(), 2U);
    EXPECT_NE(sentences.back().find("no dwell: the motion never rests"), std::string::npos);
}

struct Named {
    const char* name;
    TestScene scene;
};

std::vector<Named> ten_scenes() {
    return {
        {"residual", slide(soft, "objective = { acceleration = 0.6, residual = 0.4 }")},
        {"residual limit", slide(soft, "limits.residual_um = 30")},
        {"dynamic acceleration",
         slide(soft, "objective = { acceleration = 0.5, jerk = 0.1, dynamic_acceleration = 0.5 }")},
        {"range", slide(ranged, "objective = { acceleration = 0.6, jerk = 0.1, residual = 0.3 }")},
        {"range limit",
         slide(ranged, "objective = { acceleration = 0.6, jerk = 0.1 }", "limits.residual_um = 40")},
        {"force limit", slide(pressed, "objective = { velocity = 0.3, acceleration = 0.5 }",
                              "limits.dynamic_contact_force_min_n = 90")},
        {"chain", slide(two_masses, "objective = { acceleration = 0.6, jerk = 0.05, residual = 0.4 }")},
        {"undamped", slide("stiffness_n_mm = 900, damping_ratio = 0",
                           "objective = { rms_acceleration = 0.6, residual = 0.4 }")},
        {"damped", slide("stiffness_n_mm = 900, damping_ratio = 0.7",
                         "objective = { acceleration = 0.6, residual = 0.4 }")},
        {"overdamped", slide("natural_frequency_hz = 70, damping_ratio = 1.4",
                             "objective = { acceleration = 0.6, jerk = 0.1, dynamic_acceleration = 0.4 }")},
    };
}

TEST(TrainScenes, TenAreProved) {
    for (const auto& [text, given] : ten_scenes()) {
        const Solution solution = solve(given);
        EXPECT_EQ(solution.certificate.verdict, Verdict::optimal) << text;
        ASSERT_TRUE(solution.certificate.gap.has_value()) << text;
        EXPECT_LE(*solution.certificate.gap, 1e-7) << text;
        // What is reported adds up to what was minimized.
        EXPECT_NEAR(defined_objective(solution), solution.certificate.objective, 1e-8) << text;
    }
}

TEST(TrainScenes, ASmallWeightIsReportedToo) {
    const Solution solution = solve(slide(soft, "objective.residual = 5e-4"));
    EXPECT_EQ(solution.certificate.verdict, Verdict::optimal);
    ASSERT_TRUE(solution.train);
    ASSERT_EQ(solution.train->terms.size(), 1u);
    EXPECT_EQ(solution.train->terms[0].weight, 5e-4);
    EXPECT_NEAR(defined_objective(solution), solution.certificate.objective, 1e-9);
}

TEST(TrainScenes, DerivativesAreRight) {
    for (const auto& [text, given] : ten_scenes()) {
        const Scene scene = given;
        CamProblem problem(scene_model(scene, DesignKind::states, reference_peaks(scene)));
        const Eigen::VectorXd x = problem.start();
        // With the rows of the train at the start.
        ASSERT_GT(problem.refine(problem.violations(x, 1e9)), 0) << text;
        for (const DerivativeError& error : derivative_errors(problem.grid(), x))
            EXPECT_EQ(error.wrong, 0) << error.kind << ' ' << error.where << '\n' << text;
    }
}

/// Each row at the motion it was made for is the rule's own value.
TEST(TrainScenes, RowsAreWhatTheMotionDoes) {
    for (const auto& [text, given] : ten_scenes()) {
        const Scene scene = given;
        CamProblem problem(scene_model(scene, DesignKind::states, reference_peaks(scene)));
        const Eigen::VectorXd x = problem.random_start(3);
        const CamModel& model = problem.model();
        int seen = 0;
        for (const Violation& violation : problem.violations(x, 1e9)) {
            if (violation.setting.empty()) continue;
            const PointRule& rule = *model.rules[static_cast<std::size_t>(violation.rule)];
            AffineRow row =
                rule.whole()->row(model.design, violation.where.at, violation.where.side, violation.setting);
            double value = row.value(problem.design_values(x));
            if (!rule.parameters().empty()) value -= x[model.design.size() + rule.parameters().front()];
            EXPECT_NEAR(value, violation.where.value, 1e-9 * std::max(1.0, std::abs(value))) << text;
            ++seen;
        }
        EXPECT_GT(seen, 0) << text;
    }
}

/// Amplitude of one mass after the rise, by the integrator alone: m.
double integrated_residual(const Scene& scene, const Motion& motion, double speed) {
    const DynamicsSpec& spec = *scene.dynamics;
    const TrainStage output = spec.output();
    const double end = scene.motion.unit_angle() / speed, lift = scene.motion.lift;
    stiff::Chain chain{{{output.mass, output.stiffness, output.damping}}, spec.return_stiffness, {}};
    chain.input = [&](double time) {
        const MotionPoint at = motion.at(std::clamp(time / end, 0.0, 1.0));
        return stiff::Input{lift * at.derivative[0], lift * at.derivative[1] / end,
                            lift * at.derivative[2] / (end * end)};
    };
    const std::vector<double> state = stiff::integrated(chain, end, 1e-12);
    const double w = std::sqrt((output.stiffness + spec.return_stiffness) / output.mass);
    const double damping = output.damping / (2.0 * w * output.mass);
    const double rest = lift * output.stiffness / (output.stiffness + spec.return_stiffness);
    const double z = state[0] - rest;
    return std::hypot(z, (state[1] + damping * w * z) / (w * std::sqrt(1.0 - damping * damping)));
}

TEST(TrainScenes, ResidualIsThatOfAnIntegrator) {
    const Scene scene =
        slide(ranged, "objective = { acceleration = 0.6, jerk = 0.1 }", "limits.residual_um = 40");
    const Solution solution = solve(scene);
    ASSERT_TRUE(solution.train && solution.train->residual);
    EXPECT_NEAR(solution.train->residual->value * scene.motion.lift, 40e-6, 1e-10);
    for (const double rpm : {285.0, 292.5, 300.0, 311.1, 315.0})
        EXPECT_LE(integrated_residual(scene, *solution.motion, rpm * units::revolution_per_minute),
                  40e-6 * (1.0 + 1e-6))
            << rpm;
    const double worst = solution.train->residual->speed;
    EXPECT_NEAR(integrated_residual(scene, *solution.motion, worst), 40e-6, 1e-9);
    // A rigid follower's optimum breaks it: the limit does something.
    const Solution rigid = solve(without_train(scene));
    EXPECT_GT(integrated_residual(scene, *rigid.motion, 300 * units::revolution_per_minute), 60e-6);
    EXPECT_LT(rigid.certificate.objective, solution.certificate.objective);
}

/// Nothing exceeds its limit between the speeds that the exchange looked at.
TEST(TrainScenes, AreSatisfiedAtEverySpeed) {
    const Scene scene = slide(ranged, "dynamics.return_spring_n_mm = 8", "dynamics.preload_n = 120",
                              "objective = { acceleration = 0.6, jerk = 0.1 }",
                              "limits = { residual_um = 30, dynamic_contact_force_min_n = 60 }");
    const Solution solution = solve(scene);
    ASSERT_EQ(solution.certificate.verdict, Verdict::optimal);
    const auto pieces = scene.dynamics->formulas->pieces(*solution.motion);
    const EventPieces event = pieces_of_event(pieces, motion_events(scene.motion).front());
    double largest = 0.0, least = infinity;
    for (int k = 0; k < 1000; ++k) {
        const double rpm = 285.0 + 30.0 * k / 999.0;
        const auto train = train_at(scene, rpm * units::revolution_per_minute);
        const EventResponse response(*train, event);
        largest = std::max(largest, response.residual() * scene.motion.lift);
        least = std::min(least, -response.largest(train->contact_force(), -1.0, true).value);
    }
    EXPECT_LE(largest, 30e-6 * (1.0 + 1e-6));
    EXPECT_GE(largest, 29e-6);
    EXPECT_GE(least, 60.0 * (1.0 - 1e-6));
}

/// A closed program, two events, shapes beside splines.
TEST(TrainScenes, ProgramsAreProvedToo) {
    const Solution solution =
        solve(scene_named("elastic_slide")
                  .with("motion = { type = 'program', lift_mm = 20, speed_rpm = 200, segments = ["
                        "{ kind = 'law', law = 'cycloidal', angle_deg = 100, to = 1 }, { kind = 'dwell', "
                        "angle_deg = 80 },"
                        "{ kind = 'spline', angle_deg = 110, to = 0 }, { kind = 'dwell', angle_deg = 70 }] }",
                        "spline = { degree = 3, segments = 16 }",
                        "objective = { acceleration = 0.5, residual = 0.5 }",
                        "dynamics = { mass_kg = 4, stiffness_n_mm = 300, damping_ratio = 0.03 }"));
    EXPECT_EQ(solution.certificate.verdict, Verdict::optimal);
    ASSERT_TRUE(solution.train);
    // The law rings, whatever the spline does: it is the worst.
    EXPECT_NEAR(solution.train->residual->at, 100.0 / 110.0, 1e-9);
}

TEST(TrainScenes, WithoutDynamicsThereIsNothing) {
    const Scene scene = TestScene("motion = { type = 'DRD', lift_mm = 24 }\nobjective.acceleration = 1\n");
    const CamModel model = scene_model(scene, DesignKind::states, reference_peaks(scene));
    for (const PlacedRule& rule : model.rules) EXPECT_EQ(rule->whole(), nullptr);
    EXPECT_FALSE(solve(scene).train);
}

/// Rows of a sweep over weight and limit of the train carry its figures, and come back from their file.
TEST(TrainScenes, SweepsHaveTheTrainsFigures) {
    const TestScene given = slide(pressed, "objective = { acceleration = 1, jerk = 0.1 }",
                                  "limits.dynamic_contact_force_min_n = 20");
    const SweepAxis axes[] = {{{"objective.residual"}, {0.0, 0.3}}, {{"limits.residual_um"}, {60.0, 200.0}}};
    const SweepPlan plan = sweep_grid(axes);
    EXPECT_TRUE(is_weight_key("objective.residual"));
    SweepScenes scenes(plan, [&](std::span<const std::string> settings) {
        return given.with_all({settings.begin(), settings.end()}).read();
    });
    SweepTable table;
    table.columns = check_rows(scenes);
    EXPECT_TRUE(table.columns.train);
    EXPECT_EQ(table.columns.criteria, (std::vector<std::string>{"acceleration", "jerk", "residual"}));
    for (int row = 0; row < plan.rows(); ++row) {
        const Solution solution = solve(scenes.scene(row));
        table.rows.push_back(sweep_row(row, plan.row(row), solution));
        const SweepTrain& train = table.rows.back().train;
        ASSERT_TRUE(train.residual && train.dynamic_acceleration && train.contact_force) << row;
        EXPECT_LE(*train.residual * 24e3, plan.row(row)[1] * (1.0 + 1e-7)) << row;
        EXPECT_GE(*train.contact_force, 20.0 * (1.0 - 1e-7)) << row;
        EXPECT_EQ(*train.dynamic_acceleration, solution.train->acceleration->value) << row;
    }
    mark_front(table);
    const SweepTable read = read_sweep_csv(sweep_csv(table), "sweep.csv");
    for (int row = 0; row < plan.rows(); ++row) {
        const SweepTrain &before = table.rows[row].train, &after = read.rows[row].train;
        EXPECT_EQ(before.residual, after.residual);
        EXPECT_EQ(before.dynamic_acceleration, after.dynamic_acceleration);
        EXPECT_EQ(before.contact_force, after.contact_force);
    }
    EXPECT_EQ(sweep_csv(read), sweep_csv(table));
}

/// Laws are held against the limits of the train, each as it responds itself.
TEST(TrainScenes, LawsAreJudgedByTheTrain) {
    const Scene scene = slide(pressed, "objective = { acceleration = 1, jerk = 0.1 }",
                              "limits = { residual_um = 100, dynamic_contact_force_min_n = 20 }");
    const Comparison comparison = compare(scene);
    int broken = 0, judged = 0;
    for (const ComparisonRow& row : comparison.rows) {
        if (!row.misfit.empty()) continue;
        ASSERT_EQ(row.limits.size(), 2U) << row.title;
        const double residual = worst_response(scene, ResponseKind::residual, *row.motion).value * 24e3;
        EXPECT_NEAR(row.limits[0].reached.worst, residual, 1e-9 * residual) << row.title;
        if (row.is_optimum()) {
            EXPECT_TRUE(row.feasible);
            continue;
        }
        EXPECT_EQ(row.limits[0].kept, residual <= 100.0 * (1.0 + 1e-7)) << row.title;
        const double least = worst_response(scene, ResponseKind::contact_force, *row.motion).value;
        EXPECT_EQ(row.limits[1].kept, least >= 20.0 * (1.0 - 1e-6)) << row.title;
        ++judged;
        if (!row.feasible) ++broken;
    }
    EXPECT_GE(judged, 5);
    EXPECT_GE(broken, 1);
}

TEST(TrainScenes, SaysWhatIsWrong) {
    const auto refused = [](const TestScene& scene, const std::string& words) {
        const std::string said = refusal([&] { (void)solve(scene); });
        EXPECT_NE(said.find(words), std::string::npos) << said;
    };
    refused(TestScene(
                "motion = { type = 'DRD', lift_mm = 24 }\nobjective = { acceleration = 1, residual = 1 }\n"),
            "only together with a [dynamics] table");
    refused(slide("natural_frequency_hz = 70, stiffness_n_mm = 5"), "only one of the two");
    refused(scene_named("elastic_slide").with("dynamics = { mass_kg = 2.5 }"),
            "one of natural_frequency and stiffness");
    refused(slide("natural_frequency_hz = 70, damping_ratio = 2.5"), "damping_ratio");
    refused(slide("natural_frequency_hz = 70, speed_range_rpm = [300, 200]"), "two speeds > 0 that ascend");
    refused(slide("natural_frequency_hz = 70, speed_range_rpm = [300]"), "found 1 numbers");
    refused(slide("natural_frequency_hz = 70", "limits.dynamic_contact_force_min_n = 3"),
            "without a force towards the cam");
    refused(slide("natural_frequency_hz = 70", "objective = { residual = 1 }"), "no weight or cap on a peak");
    refused(slide("natural_frequency_hz = 70, return_spring_n_mm = 900"), "return spring alone");
    refused(slide("natural_frequency_hz = 70, stage = [{ mass_kg = 1 }]"), "stiffness");
    refused(scene_named("elastic_slide").with("motion = { type = 'DRD', lift_mm = 24 }"), "without a speed");
    // A reference that does not ring cannot be divided by.
    refused(slide("natural_frequency_hz = 80",
                  "objective = { acceleration = 1, residual = 1, reference = 'cycloidal' }"),
            "a law that vibrates");
}

/// The table of the command, against the published single rise.
TEST(TrainStudy, ComparesAsPublished) {
    const Scene scene = slide("natural_frequency_hz = 50, damping_ratio = 0.05");
    // Half a turn of 90 degrees at 300 rpm takes 50 ms: 2.5 periods.
    const double speed = 300 * units::revolution_per_minute;
    const TrainStudy study = train_study(scene, {speed, speed, 1});
    EXPECT_FALSE(study.static_optimum);
    const auto row = std::ranges::find(study.rows, "cycloidal", &TrainRow::motion);
    ASSERT_NE(row, study.rows.end());
    EXPECT_NEAR(row->frequency_ratio, 2.5, 1e-12);
    EXPECT_NEAR(row->residual, 0.0176562072, 6e-11);
    EXPECT_NEAR(row->peak_deflection, 0.03893278, 6e-9);
    EXPECT_NEAR(row->peak_acceleration, 9.6237141, 6e-8);
    EXPECT_FALSE(row->lifts_off());
}

/// Laws take each stroke's own lift and angle: 15 mm in 60 degrees, twice, and 30 mm back in 80 degrees.
TEST(TrainStudy, ComparesLawsInEachStroke) {
    const Scene scene = scene_named("elastic_three_strokes");
    const double speed = *scene.motion.speed;
    const TrainStudy study = train_study(scene, {speed, speed, 1});
    EXPECT_EQ(study.strokes.size(), 3U);
    EXPECT_EQ(study.rows.size(), 3 * study.motions.size());
    EXPECT_EQ(study.lift_off_speeds.size(), study.rows.size());
    const double periods = 21.915 * 60.0 / 180.0;  // of the rises of 60 degrees
    int found = 0;
    for (const TrainRow& row : study.rows) {
        if (row.motion != "cycloidal") continue;
        EXPECT_EQ(row.stroke, ++found);
        EXPECT_NEAR(row.frequency_ratio, row.stroke == 3 ? periods * 80.0 / 60.0 : periods, 1e-9);
        if (row.stroke == 3) continue;
        EXPECT_NEAR(row.residual * 30e3, 6.299, 1e-3);  // µm
        EXPECT_NEAR(row.peak_acceleration * 0.03 * std::pow(speed / scene.motion.unit_angle(), 2), 0.914,
                    1e-3);
    }
    EXPECT_EQ(found, 3);
}

/// Just below the speed of lift-off the force is positive, just above negative.
TEST(TrainStudy, LiftsOffWhereTheForceEnds) {
    const Scene scene = slide(pressed);
    const double speed = 300 * units::revolution_per_minute;
    const TrainStudy study = train_study(scene, {speed, 1.2 * speed, 3});
    int found = 0;
    for (std::size_t i = 0; i < study.motions.size(); ++i) {
        if (!study.lift_off_speeds[i]) continue;
        const double off = *study.lift_off_speeds[i];
        const TrainStudy near = train_study_of(study.optimum, {}, {off * (1 - 1e-9), off * (1 + 1e-9), 2});
        EXPECT_FALSE(near.rows[2 * i].lifts_off()) << study.motions[i].first;
        EXPECT_TRUE(near.rows[2 * i + 1].lifts_off()) << study.motions[i].first;
        if (++found == 3) break;  // each takes a whole study
    }
    EXPECT_GE(found, 1);
}

}  // namespace train_scenes_test
}  // namespace camopt
