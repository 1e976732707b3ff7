// SPDX-License-Identifier: MIT
#include "report/csv/motion_csv.hpp"

#include "report/csv/csv_line.hpp"
#include "tests/report/sample_solution.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

namespace camopt {
namespace motion_csv_test {

TEST(MotionCsv, HeaderCarriesUnits) {
    Solution solution = test::sample_solution();
    const auto header = [&] { return csv_records(motion_csv(solution), "motion.csv")[0].cells; };
    EXPECT_EQ(header(), (std::vector<std::string>{"theta_deg", "s_mm", "ds_mm_rad", "dds_mm_rad2",
                                                  "ddds_mm_rad3", "x", "y", "dy", "ddy", "dddy", "t_s",
                                                  "v_mm_s", "a_mm_s2", "j_mm_s3", "a_m_s2", "j_m_s3"}));
    solution.scene.motion.lift_is_angle = true;
    EXPECT_EQ(header()[2], "ds_deg_deg");
    EXPECT_EQ(header()[13], "j_deg_s3");
    EXPECT_EQ(header()[14], "v_rad_s");
    EXPECT_EQ(header()[16], "j_rad_s3");
    solution.scene.motion.speed.reset();
    EXPECT_EQ(header().size(), 10U);
}

TEST(MotionCsv, JerkJumpTakesTwoRows) {
    const Solution solution = test::sample_solution();
    const auto rows = motion_rows(*solution.curve, solution.peaks);
    int at_quarter = 0, at_half = 0;
    for (const MotionRow& row : rows) {
        at_quarter += row.x == 0.25 ? 1 : 0;
        at_half += row.x == 0.5 ? 1 : 0;
    }
    EXPECT_EQ(at_quarter, 2);  // 32 to −32
    EXPECT_EQ(at_half, 1);     // −32 on both sides
    EXPECT_EQ(rows.size(), 361U + 2U);
}

TEST(MotionCsv, ValuesFollowFromTheNormalisedOnes) {
    const Solution solution = test::sample_solution();
    const auto table = csv_records(motion_csv(solution), "motion.csv");
    const double rise = std::numbers::pi / 2, omega = 10 * std::numbers::pi;
    for (std::size_t i = 1; i < table.size(); i += 7) {
        const auto number = [&](std::size_t column) { return std::stod(table[i].cells[column]); };
        EXPECT_NEAR(number(0), 90 * number(5), 1e-12);
        EXPECT_NEAR(number(1), 10 * number(6), 1e-12);
        EXPECT_NEAR(number(3), 10 * number(8) / (rise * rise), 1e-11);
        EXPECT_NEAR(number(10), number(5) * rise / omega, 1e-15);
        EXPECT_NEAR(number(13), 10 * number(9) * std::pow(omega / rise, 3), 1e-6);
    }
    EXPECT_EQ(table.back().cells[6], "1");
}

TEST(MotionCsv, UnrepresentableBreakpointIsIncluded) {
    // Three segments: 1/3 and 120/360 may differ in the last bit, and the jump must still be seen.
    Eigen::MatrixXd pieces = Eigen::MatrixXd::Zero(4, 3);
    pieces(3, 1) = 1.0;
    const SplineCurve curve(SplineSpace(3, 2, {0.0, 1.0 / 3.0 + 1e-16, 2.0 / 3.0, 1.0}), pieces);
    Peaks peaks;
    peaks.jerk.value = 6.0;
    EXPECT_EQ(motion_rows(curve, peaks).size(), 361U + 2U);
}

}  // namespace motion_csv_test
}  // namespace camopt
