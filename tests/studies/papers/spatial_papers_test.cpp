// SPDX-License-Identifier: MIT
// The reports of papers 001 and 002: what they say is what was found independently.
#include "benchmarks/papers/papers.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

namespace camopt {
namespace spatial_papers_test {

const PaperTable& table_of(const PaperReport& report, const std::string& key) {
    return *std::ranges::find(report.tables, key, &PaperTable::key);
}
double number(const PaperTable& table, std::size_t row, const std::string& column) {
    const auto place = std::ranges::find(table.columns, column, &PaperColumn::key) - table.columns.begin();
    return std::get<double>(table.rows.at(row).at(static_cast<std::size_t>(place)));
}

const PaperReport& barrel() {
    static const PaperReport report = paper_002_as_printed();
    return report;
}
const PaperReport& rotating() {
    static const PaperReport report = paper_001();
    return report;
}

TEST(Paper002, IndexRotatesOneSeventh) {
    const PaperTable& given = table_of(barrel(), "given");
    EXPECT_NEAR(number(given, 0, "ours"), 360.0 / 7.0, 1e-11);
    EXPECT_LT(std::abs(number(given, 0, "difference")), 0.005);
    EXPECT_NEAR(number(given, 5, "ours"), 14.660765716752, 1e-12);
    EXPECT_NEAR(number(given, 7, "ours"), 857.1429, 5e-5);
    EXPECT_NEAR(number(given, 8, "ours"), 0.190476190476, 1e-12);
    EXPECT_NEAR(number(given, 9, "ours"), 8.291935606, 1e-8);
    EXPECT_NEAR(number(given, 10, "ours"), 136.761891, 1e-6);
    EXPECT_TRUE(barrel().faults.empty());
}

TEST(Paper002, PrintedLawEndsAtTheWrongPlace) {
    const PaperTable& law = table_of(barrel(), "modified_sine");
    const std::size_t last = law.rows.size() - 1;
    EXPECT_NEAR(number(law, last, "printed"), 0.3699, 5e-5);
    // Equation (5) as printed, by hand: T_1 V T − S_1 sin(π/4) at T = T_1 / 2 = 1/16.
    constexpr double pi = std::numbers::pi;
    const double peak = 1.0 / (0.25 / pi + 1.0 / (pi * pi));
    ASSERT_EQ(number(law, 1, "t"), 0.0625);
    EXPECT_NEAR(number(law, 1, "printed"),
                0.125 * (0.25 * peak / pi) * 0.0625 - 0.0625 * peak / (pi * pi) * std::sqrt(0.5), 1e-15);
    for (std::size_t i = 0; i <= last; ++i)
        EXPECT_NEAR(number(law, i, "corrected"), number(law, i, "catalogue"), 1e-15);
}

TEST(Paper002, ContactAnglesAndPoints) {
    const PaperTable& points = table_of(barrel(), "points_280");
    // Rows: + near, + far, − near, − far.
    EXPECT_NEAR(number(points, 2, "theta_r_rad"), 1.0169753167658479, 1e-14);
    EXPECT_NEAR(number(points, 1, "theta_r_rad"), -2.2629248173952397, 1e-14);
    EXPECT_NEAR(number(points, 2, "x_mm"), -143.41135814182, 1e-11);
    EXPECT_NEAR(number(points, 1, "z_mm"), -24.443988626445, 1e-11);
}

TEST(Paper002, OptimisedMotionBeatsModifiedSine) {
    const PaperReport whole = paper_002();
    EXPECT_TRUE(whole.faults.empty());
    const PaperTable& rows = table_of(whole, "optimised");
    ASSERT_EQ(rows.rows.size(), 4U);  // the law and the optimum: here, and with the smallest distance
    EXPECT_NEAR(number(rows, 0, "pressure_angle_deg"), 43.7789637201, 1e-9);
    EXPECT_LT(number(rows, 1, "pressure_angle_deg"), 42.0 + 1e-6);
    for (const char* peak : {"velocity", "acceleration", "jerk"})
        EXPECT_LT(number(rows, 1, peak), number(rows, 0, peak)) << peak;
    for (const std::size_t row : {2U, 3U}) EXPECT_LT(number(rows, row, "pressure_angle_deg"), 40.0 + 1e-6);
    EXPECT_LT(number(rows, 3, "center_distance_mm"), 0.8 * number(rows, 2, "center_distance_mm"));
    EXPECT_GT(number(rows, 3, "least_g"), 0.5 - 1e-6);
}

const PaperSeries& series_of(const PaperReport& report, const std::string& figure, const std::string& name) {
    return *std::ranges::find(std::ranges::find(report.figures, figure, &PaperFigure::key)->series, name,
                              &PaperSeries::title);
}

TEST(SpatialPapers, DisplacementFiguresAreInDegrees) {
    const PaperSeries& index = series_of(barrel(), "figure_2", "displacement");
    EXPECT_NEAR(std::ranges::max(index.y) - std::ranges::min(index.y), 360.0 / 7.0, 1e-9);
    EXPECT_NEAR(std::ranges::max(index.x), 360.0, 1e-9);
    // Its slope is the velocity beside it, 50 times as large.
    for (const PaperReport* report : {&barrel(), &rotating()}) {
        const char* const figure = report == &barrel() ? "figure_2" : "figure_5";
        const PaperSeries& s = series_of(*report, figure, "displacement");
        const PaperSeries& velocity = series_of(*report, figure, "50 x velocity");
        const double fastest = std::ranges::max(velocity.y);
        int compared = 0;
        for (std::size_t i = 1; i < s.x.size(); ++i) {
            if (s.x[i] - s.x[i - 1] < 1e-6 || s.x[i] - s.x[i - 1] > 2.0) continue;
            const double slope = (s.y[i] - s.y[i - 1]) / (s.x[i] - s.x[i - 1]);
            EXPECT_NEAR(50.0 * slope, 0.5 * (velocity.y[i] + velocity.y[i - 1]), 0.02 * fastest) << s.x[i];
            ++compared;
        }
        EXPECT_GT(compared, 100);
    }
}

TEST(SpatialPapers, ForwardChecksAreWithinTheirClaim) {
    for (const PaperReport* report : {&barrel(), &rotating()}) {
        const PaperTable& check = table_of(*report, "forward_check");
        for (std::size_t i = 0; i < check.rows.size(); ++i) {
            if (number(check, i, "points") < 1601) continue;
            EXPECT_LT(number(check, i, "deviation_positive_rad"), 1e-8);
            EXPECT_LT(number(check, i, "deviation_negative_rad"), 1e-8);
        }
    }
}

TEST(Paper001, PrintedFormulasFailAndCorrectedOnesHold) {
    const PaperTable& formulas = table_of(rotating(), "formulas");
    EXPECT_NEAR(number(formulas, 0, "as_printed"), 1.1e-2, 5e-4);
    EXPECT_LT(number(formulas, 0, "corrected"), 1e-14);
    EXPECT_LT(number(formulas, 1, "as_printed"), 1e-14);
    EXPECT_EQ(number(formulas, 2, "as_printed"), 179.0);
    EXPECT_EQ(number(formulas, 2, "corrected"), 0.0);
    EXPECT_NEAR(number(formulas, 3, "as_printed"), -1.0, 1e-15);
    EXPECT_NEAR(number(formulas, 3, "corrected"), 1.0, 1e-15);
}

TEST(Paper001, OnePositionToTheDigitsGiven) {
    const PaperTable& points = table_of(rotating(), "points_240");
    const auto expect_row = [&](std::size_t row, double x, double y, double z, double tolerance) {
        EXPECT_NEAR(number(points, row, "x"), x, tolerance);
        EXPECT_NEAR(number(points, row, "y"), y, tolerance);
        EXPECT_NEAR(number(points, row, "z"), z, tolerance);
    };
    expect_row(3, 52.6706073834329, -31.9137075983702, -16.9246486812652, 1e-12);
    expect_row(4, -0.845782789417134, 0.488312921145936, -0.21494642162105, 1e-14);
    expect_row(5, -29.7635020353842, 1.30277781742056, -63.5061236562194, 1e-12);
    EXPECT_NEAR(number(points, 7, "x"), -1.0471975511966, 1e-13);
    EXPECT_NEAR(number(points, 7, "y"), 0.216636968809034, 1e-14);
}

}  // namespace spatial_papers_test
}  // namespace camopt
