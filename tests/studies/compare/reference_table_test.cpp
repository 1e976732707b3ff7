// SPDX-License-Identifier: MIT
// The reference table's figures. Exact optima of n = 4 … 12 are fractions; the others were found with linear
// programs (HiGHS, exchange of the binding angles), independent of camopt. The printed ones are those of the
// paper.
#include "studies/papers/reference_table.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace camopt {

namespace reference_table_test {

constexpr double figure_digits = 2e-8;  // relative: the independent figures have nine digits
constexpr double proved_gap = 1e-7;

double objective_of(double velocity, double acceleration, double jerk) {
    return 0.4 * velocity / 1.76 + 0.4 * acceleration / 5.53 + 0.2 * jerk / 69.0;
}

const ReferenceTable& reference_table() {
    static const ReferenceTable table = spline_versus_modified_sine();
    return table;
}

const ConvergenceRow& row_of(int segments) {
    return *std::ranges::find(reference_table().convergence, segments, &ConvergenceRow::segments);
}

void expect_relative(double found, double expected, double tolerance) {
    EXPECT_NEAR(found, expected, tolerance * std::abs(expected));
}

void expect_figures(const PeakFigures& figures, const PeakFigures& expected, double tolerance) {
    EXPECT_NEAR(figures.velocity, expected.velocity, tolerance);
    EXPECT_NEAR(figures.acceleration, expected.acceleration, tolerance);
    EXPECT_NEAR(figures.jerk, expected.jerk, 10 * tolerance);
    EXPECT_NEAR(figures.objective, expected.objective, tolerance);
}

TEST(ReferenceTable, EveryRowIsProvedOptimal) {
    const ReferenceTable& table = reference_table();
    ASSERT_EQ(table.convergence.size(), 10u);
    ASSERT_EQ(table.weights.size(), 5u);
    const auto expect_proved = [](const Solution& solution) {
        EXPECT_EQ(solution.certificate.verdict, Verdict::optimal) << solution.scene.title;
        ASSERT_TRUE(solution.certificate.gap.has_value()) << solution.scene.title;
        EXPECT_LE(*solution.certificate.gap, proved_gap) << solution.scene.title;
        EXPECT_LE(*solution.certificate.lower_bound, solution.certificate.objective);
    };
    for (const ConvergenceRow& row : table.convergence) expect_proved(row.optimum);
    for (const WeightEffectRow& row : table.weights) expect_proved(row.optimum);
}

TEST(ReferenceTable, FewSegmentOptimaAreFractions) {
    struct Exact {
        int segments;
        double velocity, acceleration, jerk;
    };
    for (const Exact& exact :
         {Exact{4, 2, 8, 32}, Exact{6, 2, 6, 36}, Exact{8, 2, 16.0 / 3, 128.0 / 3},
          Exact{10, 5.0 / 3, 50.0 / 9, 500.0 / 9}, Exact{12, 12.0 / 7, 36.0 / 7, 432.0 / 7}}) {
        SCOPED_TRACE(exact.segments);
        const Solution& optimum = row_of(exact.segments).optimum;
        expect_relative(optimum.certificate.objective,
                        objective_of(exact.velocity, exact.acceleration, exact.jerk), figure_digits);
        // The objective pins each peak less sharply than itself.
        expect_relative(optimum.peaks.velocity.value, exact.velocity, 1e-6);
        expect_relative(optimum.peaks.acceleration.value, exact.acceleration, 1e-6);
        expect_relative(optimum.peaks.jerk.value, exact.jerk, 1e-6);
    }
}

TEST(ReferenceTable, OptimaAgreeWithIndependentLinearPrograms) {
    struct Known {
        int segments;
        double objective, tolerance;
    };
    for (const Known& known : {Known{6, 0.992889664, figure_digits}, Known{8, 0.963991515, figure_digits},
                               Known{10, 0.941666978, figure_digits}, Known{12, 0.940489277, figure_digits},
                               Known{14, 0.950998, 6e-7}, Known{16, 0.947449535, figure_digits},
                               Known{24, 0.940489277, figure_digits}, Known{32, 0.938020776, figure_digits},
                               Known{64, 0.937411870, figure_digits}}) {
        SCOPED_TRACE(known.segments);
        expect_relative(row_of(known.segments).optimum.certificate.objective, known.objective,
                        known.tolerance);
    }
}

TEST(ReferenceTable, PrintedPointsReproducePrintedPeaks) {
    for (const int segments : {6, 8, 12}) {
        SCOPED_TRACE(segments);
        const ConvergenceRow& row = row_of(segments);
        ASSERT_TRUE(row.printed && row.points_exact && row.points_end_acceleration);
        EXPECT_FALSE(row.corrected_exact.has_value());
        EXPECT_NEAR(*row.points_end_acceleration, 0.0, 1e-4);
        EXPECT_NEAR(row.points_exact->velocity, row.printed->velocity, 2e-3);
        EXPECT_NEAR(row.points_exact->acceleration, row.printed->acceleration, 6e-3);
        EXPECT_NEAR(row.points_exact->jerk, row.printed->jerk, 6e-2);
        EXPECT_NEAR(row.points_exact->objective, row.printed->objective, 3e-4);
    }
}

TEST(ReferenceTable, TenSegmentMisprintIsCorrected) {
    const ConvergenceRow& row = row_of(10);
    ASSERT_TRUE(row.points_exact && row.corrected_exact && row.points_end_acceleration);
    // Clamped cubic spline through the printed points, solved in fractions; the other rows leave less than
    // 1e-4.
    EXPECT_NEAR(*row.points_end_acceleration, -0.0318099, 6e-8);
    EXPECT_NEAR(row.points_exact->acceleration, 5.867, 6e-4);
    EXPECT_NEAR(row.points_exact->jerk, 57.53, 6e-3);
    expect_figures(*row.corrected_exact, {1.688, 5.520, 55.20, 0.94292}, 6e-4);
    EXPECT_NEAR(row.corrected_exact->objective, 0.94292, 6e-6);
}

TEST(ReferenceTable, FiveWeightingsHaveOneOptimum) {
    const std::array<double, 5> objectives = {0.941666978, 0.918914645, 0.944549556, 0.938784400,
                                              0.958731228};
    for (std::size_t i = 0; i < objectives.size(); ++i) {
        SCOPED_TRACE(i);
        const WeightEffectRow& row = reference_table().weights[i];
        expect_relative(row.optimum.certificate.objective, objectives[i], figure_digits);
        EXPECT_NEAR(row.fourth_ordinate, 1.0 / 3.0, 1e-6);
        EXPECT_LT(row.limit.objective, row.optimum.certificate.objective);
    }
}

TEST(ReferenceTable, LowerBoundIsBelowEveryRow) {
    const LimitCurve& limit = reference_table().limit;
    expect_relative(limit.objective, 0.9371963699, 1e-10);
    ASSERT_TRUE(limit.velocity && limit.acceleration && limit.jerk);
    EXPECT_NEAR(*limit.velocity, 1.7455851, 1e-6);
    EXPECT_NEAR(*limit.acceleration, 5.2837114, 1e-6);
    EXPECT_NEAR(*limit.jerk, 54.609086, 1e-5);
    for (const ConvergenceRow& row : reference_table().convergence)
        EXPECT_LT(limit.objective, row.optimum.certificate.objective) << row.segments;
}

TEST(ReferenceTable, ImpulseLawsHaveInfiniteJerk) {
    const auto law = std::ranges::find(reference_table().laws, "parabolic", &LawComparisonRow::key);
    ASSERT_NE(law, reference_table().laws.end());
    EXPECT_TRUE(std::isinf(law->exact->jerk));
    EXPECT_FALSE(law->loss_percent.has_value());
    const auto sine = std::ranges::find(reference_table().laws, "modified_sine", &LawComparisonRow::key);
    ASSERT_NE(sine, reference_table().laws.end());
    EXPECT_NEAR(*sine->loss_percent, 100.0 * (sine->exact->objective / 0.940489277 - 1.0), 1e-4);
}

TEST(ReferenceTable, LawsMatchPrintOutsideRoundingFaults) {
    // Half of the last digit printed. Printed otherwise: the velocity of 3-4-5 (1.875), the acceleration of
    // 4-5-6-7 (7.513) and the jerk of the cycloid (39.48).
    int compared = 0;
    for (const LawComparisonRow& row : reference_table().laws) {
        if (!row.printed || !row.exact) continue;
        const bool other_velocity = row.key == "polynomial_345";
        const bool other_acceleration = row.key == "polynomial_4567";
        EXPECT_NEAR(row.printed->velocity, row.exact->velocity, other_velocity ? 0.0151 : 0.0051) << row.key;
        EXPECT_NEAR(row.printed->acceleration, row.exact->acceleration, other_acceleration ? 0.0069 : 0.0051)
            << row.key;
        if (std::isfinite(row.exact->jerk)) {
            EXPECT_NEAR(row.printed->jerk, row.exact->jerk, 0.55) << row.key;
        }
        ++compared;
    }
    EXPECT_EQ(compared, 8);
}

TEST(ReferenceTable, StopsWhenAsked) {
    const ReferenceTable table = spline_versus_modified_sine({[] { return true; }, {}});
    EXPECT_TRUE(table.convergence.empty());
}

}  // namespace reference_table_test
}  // namespace camopt
