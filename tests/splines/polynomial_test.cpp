// SPDX-License-Identifier: MIT
#include "core/numbers/polynomial.hpp"

#include <gtest/gtest.h>

#include <random>

namespace camopt {
namespace polynomial_test {

Eigen::VectorXd with_roots(const std::vector<double>& roots) {
    Eigen::VectorXd polynomial = Eigen::VectorXd::Ones(1);
    for (const double root : roots) polynomial = product(polynomial, Eigen::Vector2d(-root, 1.0));
    return polynomial;
}

TEST(Polynomial, EvaluatesAndDifferentiates) {
    const Eigen::Vector4d p(1.0, -2.0, 3.0, 5.0);
    EXPECT_DOUBLE_EQ(evaluate_polynomial(p, 2.0), 1.0 - 4.0 + 12.0 + 40.0);
    EXPECT_EQ(differentiated(p), Eigen::Vector3d(-2.0, 6.0, 15.0));
    EXPECT_EQ(differentiated(Eigen::VectorXd::Ones(1)), Eigen::VectorXd::Zero(1));
}

TEST(Polynomial, FindsEveryPlantedSignChange) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> place(0.02, 0.98);
    for (int trial = 0; trial < 300; ++trial) {
        std::vector<double> roots(1 + trial % 6);
        for (double& root : roots) root = place(random);
        std::ranges::sort(roots);
        const auto crowded = [&] {
            for (std::size_t k = 1; k < roots.size(); ++k) {
                if (roots[k] - roots[k - 1] < 1e-2) return true;
            }
            return false;
        };
        if (crowded()) continue;
        const std::vector<double> found = sign_changes(with_roots(roots), 0.0, 1.0);
        ASSERT_EQ(found.size(), roots.size()) << "trial " << trial;
        for (std::size_t k = 0; k < roots.size(); ++k) EXPECT_NEAR(found[k], roots[k], 1e-9);
    }
}

TEST(Polynomial, ATouchedZeroIsNoSignChange) {
    EXPECT_TRUE(sign_changes(with_roots({0.5, 0.5}), 0.0, 1.0).empty());
    const std::vector<double> cubic_touch = sign_changes(with_roots({0.25, 0.25, 0.75}), 0.0, 1.0);
    ASSERT_EQ(cubic_touch.size(), 1u);
    EXPECT_NEAR(cubic_touch[0], 0.75, 1e-12);
}

TEST(Polynomial, FindsSignChangeAtStationaryPoint) {
    const std::vector<double> found = sign_changes(with_roots({0.5, 0.5, 0.5}), 0.0, 1.0);
    ASSERT_EQ(found.size(), 1u);
    EXPECT_NEAR(found[0], 0.5, 1e-5);
}

TEST(Polynomial, RootsOutsideTheIntervalDoNotCount) {
    EXPECT_TRUE(sign_changes(with_roots({-0.5, 1.5}), 0.0, 1.0).empty());
    EXPECT_TRUE(sign_changes(Eigen::VectorXd::Constant(1, 3.0), 0.0, 1.0).empty());
}

TEST(Polynomial, MaximumMatchesScanOrFloor) {
    std::mt19937 random(11);
    std::normal_distribution<double> number;
    int ruled_out = 0;
    for (int trial = 0; trial < 300; ++trial) {
        Eigen::VectorXd p(1 + trial % 20);
        for (double& coefficient : p) coefficient = number(random);
        double most = -1e300;
        for (int k = 0; k <= 2000; ++k) most = std::max(most, evaluate_polynomial(p, k / 2000.0));
        const double floor = 0.5;
        const std::optional<Extremum> found = maximum_above(p, floor);
        if (!found) {
            EXPECT_LE(most, floor);
            ++ruled_out;
            continue;
        }
        EXPECT_GE(found->value, most - 1e-13);
        EXPECT_LE(found->value, most + 1e-2);
        EXPECT_DOUBLE_EQ(evaluate_polynomial(p, found->at), found->value);
    }
    EXPECT_GT(ruled_out, 20);
}

}  // namespace polynomial_test
}  // namespace camopt
