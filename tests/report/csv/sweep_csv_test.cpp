// SPDX-License-Identifier: MIT
// sweep.csv is written and read back to the last bit; what is damaged is refused.
#include "report/csv/sweep_csv.hpp"

#include "input/loading/load_scene.hpp"
#include "report/csv/csv_line.hpp"
#include "studies/solve/solve.hpp"
#include "studies/sweep/sweep_run.hpp"
#include "tests/support/refusal.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <string>

namespace camopt {
namespace sweep_csv_test {

using testing_support::refusal;
using testing_support::says;

SweepRow random_row(int number, std::mt19937_64& generator) {
    std::uniform_real_distribution<double> exponent(-12.0, 12.0);
    std::uniform_int_distribution<long> count(0, 1'000'000'000'000);
    std::bernoulli_distribution absent(0.2);
    const auto value = [&] { return std::pow(10.0, exponent(generator)); };
    const auto maybe = [&]() -> std::optional<double> {
        if (absent(generator)) return std::nullopt;
        return value();
    };
    SweepRow row;
    row.number = number;
    row.settings = {value(), -value()};
    row.verdict = static_cast<Verdict>(number % 5);
    row.reason = number % 3 == 0 ? "" : "error: \"no\", said\nthe solver, and gave up";
    for (auto* one : {&row.objective, &row.lower_bound, &row.gap, &row.any_curve_limit}) *one = maybe();
    for (auto& figure : row.figures) figure = maybe();
    row.dimensions[0] = maybe();
    row.dimensions[2] = maybe();
    row.cam = {maybe(), maybe(), maybe()};
    if (number % 2 == 0) row.active_limits = {"limits.velocity", "limits.pressure_angle_deg"};
    if (number % 3 == 0) row.proved_from = number + 1;
    row.iterations = number;
    row.exchange_rounds = 3;
    row.evaluations = {count(generator), 2, 3, 4, 5, count(generator)};
    row.seconds_solve = value();
    row.seconds_total = value();
    row.on_front = absent(generator);
    return row;
}

void expect_same(const SweepRow& one, const SweepRow& other) {
    EXPECT_EQ(one.number, other.number);
    EXPECT_EQ(one.settings, other.settings);
    EXPECT_EQ(one.verdict, other.verdict);
    EXPECT_EQ(one.reason, other.reason);
    EXPECT_EQ(one.objective, other.objective);
    EXPECT_EQ(one.lower_bound, other.lower_bound);
    EXPECT_EQ(one.gap, other.gap);
    EXPECT_EQ(one.any_curve_limit, other.any_curve_limit);
    EXPECT_EQ(one.figures, other.figures);
    for (int i = 0; i < dimension_count; ++i) {
        const auto& expected = other.dimensions[static_cast<std::size_t>(i)];
        ASSERT_EQ(one.dimensions[static_cast<std::size_t>(i)].has_value(), expected.has_value());
        // Lengths stand there in mm: the same to one rounding, and written the same again (below).
        if (!expected) continue;
        EXPECT_DOUBLE_EQ(*one.dimensions[static_cast<std::size_t>(i)], *expected);
    }
    for (const SweepCamColumn& column : sweep_cam_columns()) {
        const auto &found = one.cam.*column.value, &expected = other.cam.*column.value;
        ASSERT_EQ(found.has_value(), expected.has_value()) << column.name;
        if (!expected) continue;
        EXPECT_DOUBLE_EQ(*found, *expected) << column.name;
    }
    EXPECT_EQ(one.active_limits, other.active_limits);
    EXPECT_EQ(one.proved_from, other.proved_from);
    EXPECT_EQ(one.iterations, other.iterations);
    EXPECT_EQ(one.exchange_rounds, other.exchange_rounds);
    EXPECT_EQ(one.evaluations.cost, other.evaluations.cost);
    EXPECT_EQ(one.evaluations.hessian, other.evaluations.hessian);
    EXPECT_EQ(one.evaluations.profile_points, other.evaluations.profile_points);
    EXPECT_EQ(one.seconds_solve, other.seconds_solve);
    EXPECT_EQ(one.seconds_total, other.seconds_total);
    EXPECT_EQ(one.on_front, other.on_front);
}

SweepTable random_table() {
    std::mt19937_64 generator(7);
    SweepTable table{{{"objective.velocity", "motion.segments[1].to"},
                      {DimensionIndex::base_radius, DimensionIndex::offset},
                      false,
                      false,
                      {}},
                     {}};
    for (int i = 0; i < 500; ++i) table.rows.push_back(random_row(i, generator));
    return table;
}

TEST(SweepCsv, ReadsBackTheSameTable) {
    const SweepTable table = random_table();
    const std::string text = sweep_csv(table);
    const SweepTable read = read_sweep_csv(text, "sweep.csv");
    EXPECT_EQ(read.columns.keys, table.columns.keys);
    EXPECT_EQ(read.columns.dimensions, table.columns.dimensions);
    ASSERT_EQ(read.rows.size(), table.rows.size());
    for (std::size_t i = 0; i < table.rows.size(); ++i) {
        SCOPED_TRACE(i);
        expect_same(read.rows[i], table.rows[i]);
    }
    EXPECT_EQ(sweep_csv(read), text);
}

TEST(SweepCsv, KeepsFiguresOfTheMotor) {
    SweepTable table = random_table();
    table.columns.drive = true;
    for (SweepRow& row : table.rows)
        if (row.number % 4 != 0) row.drive = {1.0 / (row.number + 3), 2.5, 0.1 * row.number};
    const std::string text = sweep_csv(table);
    EXPECT_TRUE(says(text.substr(0, text.find('\n')),
                     ",motor_torque_nm,motor_torque_rms_nm,motor_speed_rpm,active_limits"));
    const SweepTable read = read_sweep_csv(text, "sweep.csv");
    EXPECT_TRUE(read.columns.drive);
    for (std::size_t i = 0; i < table.rows.size(); ++i) {
        EXPECT_EQ(read.rows[i].drive.torque, table.rows[i].drive.torque);
        EXPECT_EQ(read.rows[i].drive.speed.has_value(), table.rows[i].drive.speed.has_value());
    }
    EXPECT_EQ(sweep_csv(read), text);
}

TEST(SweepCsv, KeepsChosenSpring) {
    SweepTable table = random_table();
    table.columns.spring = true;
    for (SweepRow& row : table.rows)
        if (row.number % 3 != 0) row.spring.preload = 7.25 * row.number;
    const std::string text = sweep_csv(table);
    EXPECT_TRUE(says(text.substr(0, text.find('\n')), ",preload,spring_rate,active_limits"));
    const SweepTable read = read_sweep_csv(text, "sweep.csv");
    EXPECT_TRUE(read.columns.spring);
    for (std::size_t i = 0; i < table.rows.size(); ++i) {
        EXPECT_EQ(read.rows[i].spring.preload, table.rows[i].spring.preload);
        EXPECT_FALSE(read.rows[i].spring.spring_rate);
    }
    EXPECT_EQ(sweep_csv(read), text);
}

/// Only where the cam differs from row to row; each figure is that of the row's own solve.
TEST(SweepCsv, CamPropertiesEqualSingleSolves) {
    const std::string text =
        "[motion]\ntype = \"RR\"\nlift_mm = 16\nrise_deg = 90\nreturn_deg = 90\n"
        "[objective]\nvelocity = 0.4\nacceleration = 0.4\njerk = 0.2\n[spline]\nsegments = 8\n"
        "[cam]\ntype = \"disk\"\nfollower = \"translating_roller\"\nbase_radius_mm = 20\n"
        "roller_radius_mm = 5\n";
    const SceneReading read_scene = [&](std::span<const std::string> settings) {
        return scene_of_toml(text, {settings.begin(), settings.end()});
    };
    const SweepPlan plan = sweep_grid(std::vector{varied_key("cam.base_radius_mm=20,24,28")});
    SweepScenes scenes(plan, read_scene);
    const SweepTable table{check_rows(scenes), solve_chunk(scenes, {0, 3})};
    const SweepTable read = read_sweep_csv(sweep_csv(table), "sweep.csv");
    ASSERT_EQ(read.rows.size(), 3U);
    EXPECT_TRUE(read.columns.dimensions.empty());  // the keys alone ask for the columns
    for (const SweepRow& row : read.rows) {
        const CamSummary cam = solve(scenes.scene(row.number)).cam->summary;
        ASSERT_TRUE(row.cam.pressure_angle && row.cam.convex_radius && row.cam.concave_radius) << row.number;
        EXPECT_NEAR(*row.cam.pressure_angle, cam.pressure_angle.value, 1e-6) << row.number;
        EXPECT_NEAR(*row.cam.convex_radius, cam.convex_radius->value, 1e-7) << row.number;
        EXPECT_NEAR(*row.cam.concave_radius, cam.concave_radius->value, 1e-5) << row.number;
    }
    EXPECT_GT(*read.rows[0].cam.pressure_angle, *read.rows[2].cam.pressure_angle + 0.05);
    EXPECT_LT(*read.rows[0].cam.convex_radius, *read.rows[2].cam.convex_radius - 0.005);

    const SweepPlan weights = sweep_grid(std::vector{varied_key("objective.jerk=0,1")});
    SweepScenes same_cam(weights, read_scene);
    const auto names = sweep_csv_columns(check_rows(same_cam));
    EXPECT_EQ(std::ranges::count(names, "pressure_angle_deg"), 0);
}

TEST(SweepCsv, RefusesForeignTables) {
    SweepTable table = random_table();
    table.rows.resize(1);
    table.rows[0].reason.clear();
    const std::string text = sweep_csv(table);
    const auto said = [](const std::string& wrong) {
        return refusal([&] { (void)read_sweep_csv(wrong, "s.csv"); });
    };
    ASSERT_EQ(said(text), "no refusal");
    const auto with = [&](const std::string& old, const std::string& replacement) {
        std::string wrong = text;
        wrong.replace(wrong.find(old), old.size(), replacement);
        return said(wrong);
    };
    EXPECT_TRUE(says(said(""), "s.csv:1: found nothing"));
    EXPECT_TRUE(says(with("torque", "force"), "s.csv:1: found other columns"));
    EXPECT_TRUE(says(with("verdict", "word"), "s.csv:1: found other columns"));
    EXPECT_TRUE(says(with("optimal", "best"), "s.csv:2: verdict: found \"best\""));
    EXPECT_TRUE(says(with("\n0,", "\n,"), "s.csv:2: row: found \"\"; allowed: a number"));
    EXPECT_TRUE(says(with("\n0,", "\n0.5,"), "s.csv:2: row: found \"0.5\""));
    EXPECT_TRUE(says(with("\n0,", "\n0,1,"), "s.csv:2: found 34 cells; allowed: 33"));
    EXPECT_TRUE(says(with("optimal", "\"optimal"), "quote that does not end"));
    for (std::size_t end = text.find('\n') + 2; end < text.size(); ++end)
        EXPECT_NE(said(text.substr(0, end)), "no refusal") << "cut off after " << end << " bytes";
}

TEST(CsvReader, TakesQuotesAndBothLineEndings) {
    const auto records = csv_records("a,b\r\n\"1,\"\"2\"\"\n3\",\r\nlast", "t");
    ASSERT_EQ(records.size(), 3U);
    EXPECT_EQ(records[0].cells, (std::vector<std::string>{"a", "b"}));
    EXPECT_EQ(records[1].cells, (std::vector<std::string>{"1,\"2\"\n3", ""}));
    EXPECT_EQ(records[2].cells, std::vector<std::string>{"last"});
    EXPECT_EQ(records[1].line, 2);
    EXPECT_EQ(records[2].line, 4);
    EXPECT_TRUE(csv_records("", "t").empty());
    EXPECT_TRUE(
        says(refusal([] { (void)csv_records("a\n\"b", "t"); }), "t:2: found a quote that does not end"));
    EXPECT_TRUE(says(refusal([] { (void)csv_records("\"a\"b", "t"); }), "behind a closing quote"));
}

}  // namespace sweep_csv_test
}  // namespace camopt
