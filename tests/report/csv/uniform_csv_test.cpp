// SPDX-License-Identifier: MIT
// table.csv: evenly spaced rows with chosen columns.
#include "core/errors.hpp"
#include "report/csv/csv_line.hpp"
#include "report/csv/motion_csv.hpp"
#include "tests/report/sample_solution.hpp"
#include "tests/support/refusal.hpp"

#include <gtest/gtest.h>

#include <charconv>
#include <cmath>
#include <string>
#include <vector>

namespace camopt {
namespace uniform_csv_test {

using testing_support::says;

double number(const std::string& cell) {
    double value = std::nan("");
    std::from_chars(cell.data(), cell.data() + cell.size(), value);
    return value;
}

std::vector<CsvRecord> records_of(const UniformTable& table) {
    return csv_records(table.text, "table.csv");
}

std::string fault_of(const Solution& solution, const UniformTableOptions& options) {
    return testing_support::refusal([&] { (void)uniform_table(solution, options); });
}

TEST(UniformTable, AnglesEndExactlyWithoutDrift) {
    const Solution solution = test::program_solution();  // a whole turn
    const UniformTable table = uniform_table(solution, {.rows = 36'001, .columns = {"theta_deg"}});
    const std::vector<CsvRecord> records = records_of(table);
    ASSERT_EQ(records.size(), 36'002U);
    EXPECT_TRUE(table.whole_turn);
    for (int i = 0; i <= 36'000; ++i)
        ASSERT_EQ(number(records[static_cast<std::size_t>(i) + 1].cells[0]), 360.0 * i / 36'000) << i;
    EXPECT_EQ(table.words(), "36001 rows over the revolution, 0 to 360 deg");
}

TEST(UniformTable, OpenMotionEndsWithoutWrapping) {
    const UniformTable table =
        uniform_table(test::sample_solution(), {.step_deg = 0.7, .columns = {"theta_deg", "s_mm"}});
    const std::vector<CsvRecord> records = records_of(table);
    EXPECT_FALSE(table.whole_turn);
    EXPECT_EQ(records.back().cells[0], "90");
    EXPECT_NEAR(number(records.back().cells[1]), 10.0, 1e-12);
    EXPECT_NEAR(table.last_step_deg, 90.0 - 0.7 * 128, 1e-9);
    EXPECT_TRUE(says(table.words(), "the last step is 0.4 deg"));
    EXPECT_EQ(uniform_table(test::sample_solution(), {.step_deg = 0.5}).last_step_deg, 0.0);
}

// lift 10 mm, rise 90 deg, 300 rpm: omega = 10 π rad/s; y' = 2, y'' = 0, y''' = −32 in the middle.
TEST(UniformTable, ColumnUnitsDescribeSameMotion) {
    const double omega = 10.0 * std::acos(-1.0), rise = std::acos(0.0);
    const UniformTable table = uniform_table(
        test::sample_solution(), {.rows = 3,
                                  .columns = {"y", "dy", "dddy", "s_in", "ds_mm_rad", "ds_mm_deg", "v_mm_s",
                                              "v_in_s", "j_m_s3", "t_s"}});
    const std::vector<std::string> cells = records_of(table)[2].cells;
    EXPECT_NEAR(number(cells[0]), 0.5, 1e-14);
    EXPECT_NEAR(number(cells[1]), 2.0, 1e-14);
    EXPECT_NEAR(number(cells[2]), -32.0, 1e-12);
    EXPECT_NEAR(number(cells[3]), 5.0 / 25.4, 1e-14);
    EXPECT_NEAR(number(cells[4]), 20.0 / rise, 1e-12);
    EXPECT_NEAR(number(cells[5]), 20.0 / 90.0, 1e-14);
    EXPECT_NEAR(number(cells[6]), 20.0 / rise * omega, 1e-10);
    EXPECT_NEAR(number(cells[7]), 20.0 / 25.4 / rise * omega, 1e-11);
    EXPECT_NEAR(number(cells[8]), -0.01 * 32.0 * std::pow(omega / rise, 3), 1e-9);
    EXPECT_NEAR(number(cells[9]), 45.0 / 360.0 / 5.0, 1e-15);
}

// At the top, 10 mm up and at rest in all derivatives but the jerk, the spring of 10 N/mm and its 60 N press.
TEST(UniformTable, ForcesAddLoadColumns) {
    const UniformTable table = uniform_table(
        test::cam_solution(),
        {.rows = 5, .columns = {"s_mm", "force_n", "torque_nm", "normal_force_n", "hertz_pressure_mpa"}});
    const std::vector<std::string> top = records_of(table).back().cells;
    EXPECT_NEAR(number(top[0]), 10.0, 1e-12);
    EXPECT_NEAR(number(top[1]), 160.0, 1e-9);
    EXPECT_NEAR(number(top[2]), 0.0, 1e-9);
    EXPECT_NEAR(number(top[3]), 160.0, 1e-9);
    EXPECT_GT(number(top[4]), 100.0);
    EXPECT_TRUE(says(fault_of(test::cam_solution(), {.columns = {"moment_nm"}}),
                     "which needs a cam with [forces] and a lift that is an angle"));
    EXPECT_TRUE(says(fault_of(test::sample_solution(), {.columns = {"torque_nm"}}),
                     "which needs a cam with [forces]; allowed: "));
}

TEST(UniformTable, UsesRequestedDigits) {
    const UniformTable table =
        uniform_table(test::sample_solution(), {.rows = 4, .columns = {"theta_deg", "s_mm"}, .digits = 4});
    EXPECT_EQ(records_of(table)[2].cells[0], "30");
    EXPECT_EQ(records_of(table)[3].cells[0], "60");
    EXPECT_LE(records_of(table)[2].cells[1].size(), 5U);
}

TEST(UniformTable, RefusalsNameWhatIsAllowed) {
    const Solution solution = test::sample_solution();
    EXPECT_TRUE(
        says(fault_of(solution, {.columns = {"speed"}}), "--columns: found \"speed\"; allowed: theta_deg, "));
    EXPECT_TRUE(
        says(fault_of(solution, {.columns = {"pressure_angle_deg"}}), "which needs a plane cam; allowed: "));
    EXPECT_TRUE(says(fault_of(solution, {.columns = {"s_deg"}}), "which needs a lift that is an angle"));
    Solution slow = solution;
    slow.scene.motion.speed.reset();
    EXPECT_TRUE(says(fault_of(slow, {.columns = {"v_mm_s"}}), "which needs motion.speed_rpm"));
    EXPECT_TRUE(says(fault_of(solution, {.step_deg = 91.0}),
                     "--step-deg: found 91; allowed: a number > 0 and <= 90"));
    EXPECT_NE(fault_of(solution, {.step_deg = -1.0}), "no refusal");
    EXPECT_TRUE(says(fault_of(solution, {.digits = 18}), "allowed: 1 to 17"));
    EXPECT_NE(fault_of(test::infeasible_solution(), {}), "no refusal");
    EXPECT_THROW((void)column_names("theta_deg,,s_mm"), InputError);
    EXPECT_EQ(column_names("theta_deg, s_mm"), (std::vector<std::string>{"theta_deg", "s_mm"}));
}

}  // namespace uniform_csv_test
}  // namespace camopt
