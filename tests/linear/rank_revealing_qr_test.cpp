// SPDX-License-Identifier: MIT
#include "linear/rank_revealing_qr.hpp"

#include "core/errors.hpp"
#include "tests/support/refusal.hpp"

#include <Eigen/Dense>
#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace camopt {
namespace rank_revealing_qr_test {

using testing_support::refusal;

using Sparse = Eigen::SparseMatrix<double>;

Sparse to_sparse(const Eigen::MatrixXd& dense) {
    return dense.sparseView();
}

/// Every row is named once, and every combination rebuilds its row and its mismatch.
void expect_consistent(const Eigen::MatrixXd& matrix, const Eigen::VectorXd& right_side,
                       const RowDependence& found, double tolerance) {
    ASSERT_EQ(static_cast<Eigen::Index>(found.independent.size() + found.dependent.size()), matrix.rows());
    for (const DependentRow& dependent : found.dependent) {
        Eigen::RowVectorXd rest = matrix.row(dependent.row);
        double mismatch = right_side[dependent.row];
        for (const auto& [row, factor] : dependent.combination) {
            EXPECT_TRUE(std::binary_search(found.independent.begin(), found.independent.end(), row));
            rest -= factor * matrix.row(row);
            mismatch -= factor * right_side[row];
        }
        const double length = matrix.row(dependent.row).norm();
        EXPECT_LE(rest.norm(), tolerance * length);
        EXPECT_NEAR(dependent.mismatch, mismatch, tolerance * (1.0 + length) * 10.0);
    }
}

TEST(RankRevealingQr, TakesEmptyMatrices) {
    const RowDependence none = analyse_rows(Sparse(0, 5), Eigen::VectorXd(0));
    EXPECT_TRUE(none.independent.empty());
    EXPECT_TRUE(none.dependent.empty());
    const RowDependence no_columns = analyse_rows(Sparse(2, 0), Eigen::Vector2d(0.0, 3.0));
    ASSERT_EQ(no_columns.dependent.size(), 2u);
    EXPECT_EQ(no_columns.dependent[1].mismatch, 3.0);
}

TEST(RankRevealingQr, ZeroRowsAreDependent) {
    Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(3, 4);
    matrix(1, 2) = 5.0;
    const RowDependence found = analyse_rows(to_sparse(matrix), Eigen::Vector3d(0.0, 1.0, -2.0));
    EXPECT_EQ(found.independent, std::vector<int>{1});
    ASSERT_EQ(found.dependent.size(), 2u);
    EXPECT_EQ(found.dependent[0].mismatch, 0.0);
    EXPECT_EQ(found.dependent[1].mismatch, -2.0);
    EXPECT_TRUE(found.dependent[0].combination.empty());
    EXPECT_TRUE(found.dependent[1].combination.empty());
}

TEST(RankRevealingQr, StoredZeroRowIsDependent) {
    for (const double other : {0.0, 5.0}) {
        Eigen::SparseMatrix<double> matrix(2, 3);
        matrix.insert(0, 1) = 0.0;
        matrix.insert(1, 2) = other;
        const RowDependence found = analyse_rows(matrix, Eigen::Vector2d(0.875, 1.0));
        ASSERT_FALSE(found.dependent.empty());
        EXPECT_EQ(found.dependent[0].row, 0);
        EXPECT_EQ(found.dependent[0].mismatch, 0.875);
        EXPECT_EQ(found.independent.size(), other > 0.0 ? 1u : 0u);
    }
}

TEST(RankRevealingQr, KeepsFirstOfEqualRows) {
    Eigen::MatrixXd matrix(4, 3);
    matrix << 1, 2, 0, 0, 1, 1, 2, 4, 0, 0, 3, 3;
    const RowDependence found = analyse_rows(to_sparse(matrix), Eigen::Vector4d(1.0, 2.0, 2.0, 7.0));
    EXPECT_EQ(found.independent, (std::vector<int>{0, 1}));
    ASSERT_EQ(found.dependent.size(), 2u);
    ASSERT_EQ(found.dependent[0].combination.size(), 1u);
    EXPECT_EQ(found.dependent[0].combination[0].first, 0);
    EXPECT_NEAR(found.dependent[0].combination[0].second, 2.0, 1e-14);
    EXPECT_EQ(found.dependent[0].mismatch, 0.0);
    EXPECT_NEAR(found.dependent[1].mismatch, 1.0, 1e-13);
}

TEST(RankRevealingQr, MoreRowsThanColumns) {
    std::mt19937 random(7);
    std::normal_distribution<double> normal;
    const Eigen::MatrixXd matrix = Eigen::MatrixXd::NullaryExpr(12, 5, [&] { return normal(random); });
    const Eigen::VectorXd right_side = matrix * Eigen::VectorXd::Ones(5);
    const RowDependence found = analyse_rows(to_sparse(matrix), right_side);
    EXPECT_EQ(found.independent.size(), 5u);
    expect_consistent(matrix, right_side, found, 1e-10);
    for (const DependentRow& row : found.dependent) EXPECT_EQ(row.mismatch, 0.0);
}

TEST(RankRevealingQr, FindsRedundantAndContradictoryRows) {
    std::mt19937 random(11);
    std::normal_distribution<double> normal;
    std::uniform_real_distribution<double> uniform(0.0, 1.0);
    for (int trial = 0; trial < 60; ++trial) {
        const int base = 5 + trial % 20, planted = 1 + trial % 6, columns = base + 3 + trial % 7;
        Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(base + planted, columns);
        for (int i = 0; i < base; ++i) {
            matrix(i, i) = 1.0 + uniform(random);
            for (int j = 0; j < columns; ++j)
                if (uniform(random) < 0.2) matrix(i, j) += normal(random);
        }
        Eigen::VectorXd right_side = Eigen::VectorXd::Zero(base + planted);
        for (int i = 0; i < base; ++i) right_side[i] = normal(random);
        int contradictory = 0;
        for (int i = base; i < base + planted; ++i) {
            for (int k = 0; k < 3; ++k) {
                const int source = static_cast<int>(uniform(random) * base);
                const double factor = 1.0 + uniform(random);
                matrix.row(i) += factor * matrix.row(source);
                right_side[i] += factor * right_side[source];
            }
            if (i % 2 == 0) {
                right_side[i] += 0.5;
                ++contradictory;
            }
        }
        const RowDependence found = analyse_rows(to_sparse(matrix), right_side);
        EXPECT_EQ(static_cast<int>(found.independent.size()), base) << trial;
        expect_consistent(matrix, right_side, found, 1e-9);
        int counted = 0;
        for (const DependentRow& row : found.dependent) counted += row.mismatch != 0.0 ? 1 : 0;
        EXPECT_EQ(counted, contradictory) << trial;
    }
}

TEST(RankRevealingQr, BandedSplineRows) {
    // Cubic B-spline values (1, 4, 1)/6 at 500 knots, then second differences of some of them.
    const int rows = 500, planted = 20;
    std::vector<Eigen::Triplet<double>> entries;
    Eigen::VectorXd right_side = Eigen::VectorXd::LinSpaced(rows + planted, -1.0, 1.0);
    for (int i = 0; i < rows; ++i) {
        entries.emplace_back(i, i, 1.0 / 6.0);
        entries.emplace_back(i, i + 1, 4.0 / 6.0);
        entries.emplace_back(i, i + 2, 1.0 / 6.0);
    }
    for (int k = 0; k < planted; ++k) {
        const int i = 20 * k + 5, row = rows + k;
        const double step = 1.0 / 64.0;
        const double factors[3] = {1.0 / (step * step), -2.0 / (step * step), 1.0 / (step * step)};
        right_side[row] = 0.0;
        for (int d = 0; d < 3; ++d) {
            entries.emplace_back(row, i + d, factors[d] / 6.0);
            entries.emplace_back(row, i + d + 1, 4.0 * factors[d] / 6.0);
            entries.emplace_back(row, i + d + 2, factors[d] / 6.0);
            right_side[row] += factors[d] * right_side[i + d];
        }
    }
    Sparse matrix(rows + planted, rows + 2);
    matrix.setFromTriplets(entries.begin(), entries.end());
    const RowDependence found = analyse_rows(matrix, right_side);
    ASSERT_EQ(found.dependent.size(), static_cast<std::size_t>(planted));
    for (int k = 0; k < planted; ++k) {
        EXPECT_EQ(found.dependent[static_cast<std::size_t>(k)].row, rows + k);
        EXPECT_EQ(found.dependent[static_cast<std::size_t>(k)].mismatch, 0.0);
        EXPECT_EQ(found.dependent[static_cast<std::size_t>(k)].combination.size(), 3u);
    }
}

TEST(RankRevealingQr, BadlyScaledRows) {
    std::mt19937 random(3);
    std::normal_distribution<double> normal;
    Eigen::MatrixXd matrix = Eigen::MatrixXd::NullaryExpr(8, 10, [&] { return normal(random); });
    matrix.row(6) = matrix.row(0) - 2.0 * matrix.row(3);
    Eigen::VectorXd right_side = matrix * Eigen::VectorXd::LinSpaced(10, 1.0, 2.0);
    right_side[6] += 0.25;
    for (int i = 0; i < 8; ++i) {
        const double factor = std::pow(10.0, 4.0 * i - 14.0);
        matrix.row(i) *= factor;
        right_side[i] *= factor;
    }
    const RowDependence found = analyse_rows(to_sparse(matrix), right_side);
    ASSERT_EQ(found.dependent.size(), 1u);
    EXPECT_EQ(found.dependent[0].row, 6);
    EXPECT_NEAR(found.dependent[0].mismatch / 1e10, 0.25, 1e-9);
    ASSERT_EQ(found.dependent[0].combination.size(), 2u);
    EXPECT_NEAR(found.dependent[0].combination[0].second, 1e24, 1e14);
    EXPECT_NEAR(found.dependent[0].combination[1].second, -2e12, 1e2);
}

TEST(RankRevealingQr, RejectsInvalidInput) {
    EXPECT_EQ(refusal<ModelError>([&] { (void)analyse_rows(Sparse(2, 2), Eigen::VectorXd::Zero(3)); }),
              "analyse_rows: the matrix has 2 rows, the right side 3");
    Eigen::MatrixXd matrix = Eigen::MatrixXd::Identity(2, 2);
    matrix(0, 1) = std::nan("");
    EXPECT_EQ(refusal<ModelError>([&] { (void)analyse_rows(to_sparse(matrix), Eigen::VectorXd::Zero(2)); }),
              "analyse_rows: an entry is not finite");
    EXPECT_EQ(refusal<ModelError>([&] {
                  (void)analyse_rows(to_sparse(Eigen::MatrixXd::Identity(2, 2)),
                                     Eigen::Vector2d(1.0, std::nan("")));
              }),
              "analyse_rows: an entry is not finite");
}

}  // namespace rank_revealing_qr_test
}  // namespace camopt
