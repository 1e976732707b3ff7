// SPDX-License-Identifier: MIT
// Chunks of rows solved, and the Pareto front over them.
#include "studies/sweep/sweep_run.hpp"

#include "studies/pareto/sweep_front.hpp"
#include "studies/solve/solve.hpp"
#include "tests/studies/scenes_for_tests.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <string>
#include <vector>

namespace camopt {
namespace sweep_run_test {

using testing_support::paper_objective;

SweepScenes scenes_of(const SweepPlan& plan, const Scene& base) {
    return {plan, [base](std::span<const std::string> settings) {
                Scene scene = base;
                for (const std::string& setting : settings) {
                    const std::string key = setting.substr(0, setting.find('='));
                    const double value = std::stod(setting.substr(setting.find('=') + 1));
                    if (key == "objective.velocity") scene.objective.velocity = value;
                    if (key == "objective.acceleration") scene.objective.acceleration = value;
                    if (key == "objective.jerk") scene.objective.jerk = value;
                    if (key == "limits.velocity") scene.limits.velocity = PeakLimit{value, key, value, ""};
                }
                return scene;
            }};
}

TEST(Chunking, CoversEveryRowOnce) {
    for (const int rows : {1, 24, 25, 26, 50, 231})
        for (const int size : {1, 7, 25, 1000}) {
            const Chunking chunking{rows, size};
            int next = 0;
            for (int chunk = 0; chunk < chunking.count(); ++chunk) {
                EXPECT_EQ(chunking.range(chunk).begin, next);
                EXPECT_GT(chunking.range(chunk).size(), 0);
                EXPECT_LE(chunking.range(chunk).size(), size);
                next = chunking.range(chunk).end;
            }
            EXPECT_EQ(next, rows);
        }
}

TEST(Chunking, SmallSweepsHaveSmallChunks) {
    Scene base = paper_objective(MotionType::drd, 3, 32);
    const auto size_for = [&](const std::string& key, int rows) {
        const SweepPlan plan{{key}, std::vector<double>(static_cast<std::size_t>(rows), 0.2)};
        SweepScenes scenes = scenes_of(plan, base);
        return chunk_size_for(scenes);
    };
    for (const char* key : {"spline.segments", "objective.jerk"}) {
        EXPECT_EQ(size_for(key, 1), 1);
        EXPECT_EQ(size_for(key, 16), 1);
        EXPECT_EQ(size_for(key, 17), 2);
        EXPECT_EQ(size_for(key, 231), 15);
        EXPECT_EQ(size_for(key, 400), 25);
    }
    EXPECT_EQ(size_for("spline.segments", 1'000'000), default_chunk_size);
    EXPECT_EQ(size_for("objective.jerk", 1'000'000), weight_chunk_size);
    base.spline.segments = 1024;
    EXPECT_EQ(size_for("objective.jerk", 1'000'000), default_chunk_size) << "slow solves";
    base.spline.segments = 32;
    base.objective.torque = 0.3;
    base.objective.reference.torque = 5.5;
    EXPECT_EQ(size_for("objective.jerk", 1'000'000), default_chunk_size) << "not convex";
}

TEST(SweepRun, EveryRowEqualsItsColdSolve) {
    const Scene base = paper_objective(MotionType::drd, 3, 12);
    const SweepPlan plan = sweep_grid(std::vector{simplex_weights(4)});
    SweepScenes scenes = scenes_of(plan, base);
    int reported = 0;
    const std::vector<SweepRow> rows =
        solve_chunk(scenes, {3, 11}, {}, [&](const SweepRow& row) { EXPECT_EQ(row.number, 3 + reported++); });
    ASSERT_EQ(rows.size(), 8U);
    EXPECT_EQ(reported, 8);
    for (const SweepRow& row : rows) {
        SCOPED_TRACE(row_text(plan, row.number));
        const Solution cold = solve(scenes.scene(row.number));
        EXPECT_EQ(row.verdict, cold.certificate.verdict);
        EXPECT_EQ(row.verdict, Verdict::optimal);
        ASSERT_TRUE(row.objective && row.gap && row.lower_bound && row.any_curve_limit);
        EXPECT_NEAR(*row.objective, cold.certificate.objective, 1e-8);
        EXPECT_NEAR(*row.any_curve_limit, cold.any_curve_limit->objective, 1e-12);
        EXPECT_LE(*row.lower_bound, *row.objective + 1e-9);
        EXPECT_LE(*row.gap, 1e-7);
        const std::vector<double> settings(plan.row(row.number).begin(), plan.row(row.number).end());
        EXPECT_EQ(row.settings, settings);
        const double weighted =
            settings[0] * *row.figure(SweepFigure::velocity) / cold.reference_peaks.velocity.value +
            settings[1] * *row.figure(SweepFigure::acceleration) / cold.reference_peaks.acceleration.value +
            settings[2] * *row.figure(SweepFigure::jerk) / cold.reference_peaks.jerk.value;
        EXPECT_NEAR(weighted, *row.objective, 1e-12);
        EXPECT_GT(*row.figure(SweepFigure::torque), 0.0);
        EXPECT_GT(*row.figure(SweepFigure::rms_jerk), 0.0);
        const bool solved = !row.proved_from;
        EXPECT_EQ(row.iterations > 0, solved);
        EXPECT_EQ(row.exchange_rounds > 0, solved);
        EXPECT_EQ(row.evaluations.cost > 0, solved);
        EXPECT_EQ(row.evaluations.profile_points, 0);
        EXPECT_GE(row.seconds_total, row.seconds_solve);
        for (const auto& dimension : row.dimensions) EXPECT_FALSE(dimension);
    }
}

TEST(SweepRun, NamesLimitsAndKeepsInfeasibleRows) {
    const SweepPlan plan = sweep_grid(std::vector{varied_key("limits.velocity=0.9,1.5,3")});
    SweepScenes scenes = scenes_of(plan, paper_objective(MotionType::drd, 3, 12));
    const std::vector<SweepRow> rows = solve_chunk(scenes, {0, 3});
    ASSERT_EQ(rows.size(), 3U);
    EXPECT_EQ(rows[0].verdict, Verdict::infeasible);  // a rise of 1 over 1 needs V > 1
    EXPECT_FALSE(rows[0].objective || rows[0].figure(SweepFigure::velocity));
    EXPECT_TRUE(rows[0].active_limits.empty());
    EXPECT_EQ(rows[1].active_limits, std::vector<std::string>{"limits.velocity"});
    EXPECT_NEAR(*rows[1].figure(SweepFigure::velocity), 1.5, 1e-8);
    EXPECT_TRUE(rows[2].active_limits.empty());
}

TEST(SweepRun, ThrowingRowFailsAlone) {
    const SweepPlan plan = sweep_grid(std::vector{varied_key("limits.velocity=2,3,4")});
    const Scene base = paper_objective(MotionType::drd, 3, 8);
    SweepScenes scenes(plan, [base](std::span<const std::string> settings) {
        if (settings[0] == "limits.velocity=3") throw std::runtime_error("out of paper");
        return base;
    });
    const std::vector<SweepRow> rows = solve_chunk(scenes, {0, 3});
    ASSERT_EQ(rows.size(), 3U);
    EXPECT_EQ(rows[0].verdict, Verdict::optimal);
    EXPECT_EQ(rows[1].verdict, Verdict::failed);
    EXPECT_EQ(rows[1].reason, "error: out of paper");
    EXPECT_EQ(rows[1].settings, std::vector{3.0});
    EXPECT_EQ(rows[2].verdict, Verdict::optimal);
}

TEST(SweepRun, StopsOnRequest) {
    const SweepPlan plan = sweep_grid(std::vector{simplex_weights(4)});
    SweepScenes scenes = scenes_of(plan, paper_objective(MotionType::drd, 3, 8));
    bool stop = false;
    const SolveControl control{[&] { return stop; }, {}};
    const auto rows =
        solve_chunk(scenes, {0, 15}, control, [&](const SweepRow& row) { stop = row.number == 4; });
    EXPECT_EQ(rows.size(), 5U);
}

SweepRow peaks(int number, std::vector<double> settings, double velocity, double jerk) {
    SweepRow row;
    row.number = number;
    row.settings = std::move(settings);
    row.verdict = Verdict::optimal;
    row.figures[0] = velocity;
    row.figures[1] = 1.0 / velocity;  // no criterion
    row.figures[2] = jerk;
    return row;
}

std::vector<bool> front(SweepTable table) {
    mark_front(table);
    std::vector<bool> marks;
    for (const SweepRow& row : table.rows) marks.push_back(row.on_front);
    return marks;
}

/// The definition, row against row; figures that are absent play no part.
std::vector<bool> front_by_comparing_all(const SweepTable& table) {
    const auto dominates = [](const SweepRow& winner, const SweepRow& loser) {
        bool better = false;
        for (std::size_t i = 0; i < 3; ++i) {
            if (!winner.figures[i] || !loser.figures[i]) continue;
            const double own = *winner.figures[i], other = *loser.figures[i];
            if (own > other * (1.0 + front_tolerance)) return false;
            better = better || own < other * (1.0 - front_tolerance);
        }
        return better;
    };
    std::vector<bool> marks;
    for (const SweepRow& one : table.rows)
        marks.push_back(one.is_feasible() && std::ranges::none_of(table.rows, [&](const SweepRow& rival) {
                            return rival.is_feasible() && dominates(rival, one);
                        }));
    return marks;
}

TEST(SweepFront, ManyRowsMatchDefinition) {
    std::mt19937 generator(11);  // NOLINT(cert-msc51-cpp): the same every time
    std::uniform_real_distribution<double> uniform(0.0, 1.0);
    for (const bool has_gaps : {false, true}) {
        SweepTable table{
            {.keys = {"objective.jerk"}, .dimensions = {}, .criteria = {"velocity", "acceleration", "jerk"}},
            {}};
        for (int number = 0; number < 1500; ++number) {
            // Near the surface V·A·J = 1, some of them equal to the millionth, some off the front.
            SweepRow row = peaks(number, {0}, 1.0, 1.0);
            const double velocity = 0.5 + std::round(20.0 * uniform(generator)) / 20.0;
            const double acceleration = 0.5 + uniform(generator);
            row.figures[0] = velocity * (1.0 + 0.4 * front_tolerance * uniform(generator));
            row.figures[1] = acceleration;
            row.figures[2] = (1.0 + 0.02 * std::floor(3.0 * uniform(generator))) / (velocity * acceleration);
            if (has_gaps && number % 17 == 0) {
                for (std::size_t i = 0; i < 3; ++i) *row.figures[i] *= 2.0;  // or it would beat them all
                row.figures[number % 3].reset();
            }
            if (number % 29 == 0) row.verdict = Verdict::infeasible;
            table.rows.push_back(row);
        }
        const std::vector<bool> marks = front(table);
        EXPECT_EQ(marks, front_by_comparing_all(table));
        const auto kept = std::ranges::count(marks, true);
        EXPECT_GT(kept, 100);
        EXPECT_LT(kept, 1400);
    }
}

TEST(SweepFront, AreNondominatedRows) {
    SweepTable table{{.keys = {"objective.jerk"}, .dimensions = {}, .criteria = {"velocity", "jerk"}}, {}};
    table.rows = {peaks(0, {0}, 1.0, 5.0), peaks(1, {1}, 2.0, 3.0), peaks(2, {2}, 2.0, 4.0),
                  peaks(3, {3}, 3.0, 3.5), peaks(4, {4}, 4.0, 1.0), peaks(5, {5}, 0.1, 0.1)};
    table.rows[5].verdict = Verdict::failed;  // its figures count for nothing
    EXPECT_EQ(front(table), (std::vector{true, true, false, false, true, false}));
}

TEST(SweepFront, EqualWithinToleranceIsNotDominated) {
    SweepTable table{{.keys = {"objective.jerk"}, .dimensions = {}, .criteria = {"velocity", "jerk"}}, {}};
    table.rows = {peaks(0, {0}, 2.0, 3.0), peaks(1, {1}, 2.0 * (1 + 5e-7), 3.0),
                  peaks(2, {2}, 2.0, 3.0 * (1 + 3e-6)), peaks(3, {3}, 2.0 * (1 + 5e-7), 2.9)};
    // Row 3 costs nothing that counts and is better: rows 0 to 2 are not on the front.
    EXPECT_EQ(front(table), (std::vector{false, false, false, true}));
    table.rows.pop_back();
    EXPECT_EQ(front(table), (std::vector{true, true, false}));
}

TEST(SweepFront, OtherSettingsAreOtherFronts) {
    SweepTable table{
        {.keys = {"spline.segments", "objective.jerk"}, .dimensions = {}, .criteria = {"velocity", "jerk"}},
        {}};
    table.rows = {peaks(0, {8, 0}, 2.0, 3.0), peaks(1, {8, 1}, 2.5, 3.5), peaks(2, {16, 0}, 1.0, 1.0)};
    EXPECT_EQ(front(table), (std::vector{true, false, true}));
}

TEST(SweepFront, WeighsDimensionsAndOffsetMagnitude) {
    SweepTable table{{.keys = {"objective.offset"},
                      .dimensions = {DimensionIndex::offset},
                      .criteria = {"velocity", "offset"}},
                     {}};
    table.rows = {peaks(0, {0}, 2.0, 3.0), peaks(1, {1}, 2.0, 3.0), peaks(2, {2}, 1.9, 3.0)};
    const auto offset = static_cast<std::size_t>(DimensionIndex::offset);
    table.rows[0].dimensions[offset] = -0.005;
    table.rows[1].dimensions[offset] = 0.004;
    table.rows[2].dimensions[offset] = 0.006;
    EXPECT_EQ(front(table), (std::vector{false, true, true}));
}

}  // namespace sweep_run_test
}  // namespace camopt
