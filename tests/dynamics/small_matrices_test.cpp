// SPDX-License-Identifier: MIT
#include "dynamics/small_matrices.hpp"

#include <Eigen/SVD>
#include <gtest/gtest.h>
#include <unsupported/Eigen/MatrixFunctions>

#include <cmath>
#include <numbers>
#include <random>

namespace camopt {

namespace {

using Eigen::MatrixXd;

double norm_of(const MatrixXd& matrix) {
    return matrix.cwiseAbs().colwise().sum().maxCoeff();
}

TEST(MatrixExponential, AgreesWithEigen) {
    std::mt19937 random(2005);
    std::normal_distribution<double> number;
    std::uniform_real_distribution<double> magnitude(-6.0, 2.0);
    for (int i = 0; i < 400; ++i) {
        const Eigen::Index n = 1 + i % 20;
        MatrixXd matrix = MatrixXd::NullaryExpr(n, n, [&] { return number(random); });
        matrix *= std::pow(10.0, magnitude(random)) / norm_of(matrix);
        const MatrixXd found = exponential_of(matrix), expected = matrix.exp();
        EXPECT_LE(norm_of(found - expected), 1e-13 * std::max(1.0, norm_of(matrix)) * norm_of(expected))
            << "size " << n << ", norm " << norm_of(matrix);
    }
}

/// A rotation: every power of it is known, for any norm.
TEST(MatrixExponential, TurnsByTheAngle) {
    for (const double angle : {1e-9, 0.5, 5.0, 6.0, 100.0 * std::numbers::pi + 0.25}) {
        MatrixXd matrix(2, 2);
        matrix << 0.0, -angle, angle, 0.0;
        MatrixXd expected(2, 2);
        expected << std::cos(angle), -std::sin(angle), std::sin(angle), std::cos(angle);
        EXPECT_LE(norm_of(exponential_of(matrix) - expected), 2e-15 * (1.0 + angle)) << angle;
    }
}

/// The series ends: 1/k! above the diagonal.
TEST(MatrixExponential, EndsWhereTheSeriesEnds) {
    constexpr Eigen::Index n = 12;
    const MatrixXd found = exponential_of(
        MatrixXd::NullaryExpr(n, n, [](Eigen::Index r, Eigen::Index c) { return c == r + 1 ? 1.0 : 0.0; }));
    for (Eigen::Index r = 0; r < n; ++r)
        for (Eigen::Index c = 0; c < n; ++c)
            EXPECT_NEAR(found(r, c), c < r ? 0.0 : 1.0 / std::tgamma(static_cast<double>(c - r + 1)), 1e-15)
                << r << " " << c;
}

TEST(MatrixExponential, EdgesAreDefined) {
    EXPECT_EQ(exponential_of(MatrixXd(0, 0)).size(), 0);
    EXPECT_LE(norm_of(exponential_of(MatrixXd::Zero(3, 3)) - MatrixXd::Identity(3, 3)), 1e-15);
    EXPECT_TRUE(std::isnan(exponential_of(MatrixXd::Constant(2, 2, INFINITY))(0, 0)));
}

MatrixXd random_matrix(std::mt19937& random, Eigen::Index rows, Eigen::Index columns) {
    std::normal_distribution<double> number;
    return MatrixXd::NullaryExpr(rows, columns, [&] { return number(random); });
}

TEST(SmallMatrices, SingularValuesMatchEigen) {
    std::mt19937 random(1965);
    for (Eigen::Index rows = 1; rows <= 6; ++rows)
        for (Eigen::Index columns = 1; columns <= rows; ++columns) {
            const MatrixXd matrix = random_matrix(random, rows, columns), root = triangular_root(matrix);
            EXPECT_TRUE(root.isUpperTriangular(0.0));
            EXPECT_LE(norm_of(root.transpose() * root - matrix.transpose() * matrix),
                      1e-13 * norm_of(root) * norm_of(root));
            const Eigen::VectorXd expected = Eigen::JacobiSVD<MatrixXd>(matrix).singularValues().reverse();
            EXPECT_LE((singular_values(matrix) - expected).cwiseAbs().maxCoeff(),
                      1e-13 * expected[columns - 1]);
        }
}

TEST(SmallMatrices, EigenvectorsComposeTheMatrix) {
    std::mt19937 random(1961);
    for (Eigen::Index n = 1; n <= 8; ++n) {
        const MatrixXd matrix = random_matrix(random, n, n);
        const Eigenvectors found = eigenvectors_of(matrix);
        const Eigen::MatrixXcd composed = found.right * found.values.asDiagonal() * found.left;
        EXPECT_LE((composed - matrix).cwiseAbs().maxCoeff(), 1e-11);
        EXPECT_LE((found.right * found.left - MatrixXd::Identity(n, n)).cwiseAbs().maxCoeff(), 1e-11);
    }
}

TEST(SmallMatrices, SingularSystemHasFiniteSolution) {
    MatrixXd matrix(2, 2);
    matrix << 1.0, 2.0, 2.0, 4.0;
    const Eigen::VectorXd found = solution_of(matrix, Eigen::Vector2d(3.0, 6.0));
    ASSERT_TRUE(found.allFinite());
    EXPECT_LE((matrix * found - Eigen::Vector2d(3.0, 6.0)).norm(), 1e-14);
}

}  // namespace

}  // namespace camopt
