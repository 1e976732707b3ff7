// SPDX-License-Identifier: MIT
#include "dynamics/matrix_exponential.hpp"

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

}  // namespace

}  // namespace camopt
