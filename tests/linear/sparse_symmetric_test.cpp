// SPDX-License-Identifier: MIT
#include "linear/sparse_symmetric.hpp"

#include "core/errors.hpp"

#include <Eigen/Dense>
#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace camopt {
namespace sparse_symmetric_test {

using Sparse = Eigen::SparseMatrix<double>;

struct System {
    Eigen::MatrixXd full;
    Sparse lower;
    std::vector<int> signs;
};

/// [diag(p) Cᵀ; C −diag(d)] with every diagonal entry stored.
System saddle(int variables, int rows, double p, double d, unsigned seed) {
    std::mt19937 random(seed);
    std::normal_distribution<double> normal;
    std::uniform_real_distribution<double> uniform(0.0, 1.0);
    System system;
    const int size = variables + rows;
    system.full = Eigen::MatrixXd::Zero(size, size);
    std::vector<Eigen::Triplet<double>> entries;
    for (int i = 0; i < size; ++i) {
        system.full(i, i) = i < variables ? p : -d;
        entries.emplace_back(i, i, system.full(i, i));
        system.signs.push_back(i < variables ? 1 : -1);
    }
    for (int i = 0; i < rows; ++i)
        for (int j = 0; j < variables; ++j) {
            if (i != j && uniform(random) > 0.3) continue;
            const double value = normal(random) + (i == j ? 3.0 : 0.0);
            entries.emplace_back(variables + i, j, value);
            system.full(variables + i, j) = system.full(j, variables + i) = value;
        }
    system.lower.resize(size, size);
    system.lower.setFromTriplets(entries.begin(), entries.end());
    return system;
}

TEST(SparseSymmetric, SolvesTheMatrixWithoutItsShifts) {
    for (unsigned seed = 1; seed <= 20; ++seed) {
        const System system = saddle(20, 12, 1.0, seed % 2 == 0 ? 0.0 : 1e-3, seed);
        const auto factor = make_simplicial_factor();
        factor->analyse(system.lower, system.signs);
        ASSERT_EQ(factor->factorize(system.lower, Eigen::VectorXd::Constant(32, 1e-4)), FactorOutcome::ok);
        const Eigen::VectorXd expected = Eigen::VectorXd::LinSpaced(32, -1.0, 2.0);
        const RefinedSolve solved = refined_solve(*factor, system.lower, system.full * expected);
        EXPECT_TRUE(solved.finite);
        EXPECT_LE(solved.residual, 1e-12);
        EXPECT_LE((solved.solution - expected).norm(), 1e-9);
    }
}

TEST(SparseSymmetric, SolvesConsistentSingularSystems) {
    System system = saddle(6, 4, 1.0, 0.0, 3);
    for (int j = 0; j < 6; ++j) {  // last row equals the first
        const double value = system.full(6, j);
        system.full(9, j) = system.full(j, 9) = value;
    }
    system.lower = Sparse(Eigen::MatrixXd(system.full.triangularView<Eigen::Lower>()).sparseView());
    for (int i = 6; i < 10; ++i) system.lower.coeffRef(i, i) = 0.0;
    system.lower.makeCompressed();
    const auto factor = make_simplicial_factor();
    factor->analyse(system.lower, system.signs);
    ASSERT_EQ(factor->factorize(system.lower, Eigen::VectorXd::Constant(10, 1e-8)), FactorOutcome::ok);
    const Eigen::VectorXd right_side = system.full * Eigen::VectorXd::Ones(10);
    const RefinedSolve solved = refined_solve(*factor, system.lower, right_side);
    EXPECT_LE((system.full * solved.solution - right_side).norm(), 1e-9);
}

TEST(SparseSymmetric, NamesBreakdowns) {
    Sparse lower(2, 2);
    lower.insert(0, 0) = 0.0;
    lower.insert(1, 1) = -1.0;
    lower.makeCompressed();
    const auto factor = make_simplicial_factor();
    factor->analyse(lower, {1, -1});
    EXPECT_EQ(factor->factorize(lower, Eigen::Vector2d::Zero()), FactorOutcome::zero_pivot);
    EXPECT_EQ(factor->factorize(lower, Eigen::Vector2d(1e-9, 0.0)), FactorOutcome::ok);
    lower.coeffRef(0, 0) = -2.0;
    EXPECT_EQ(factor->factorize(lower, Eigen::Vector2d::Zero()), FactorOutcome::wrong_sign);
    lower.coeffRef(0, 0) = std::nan("");
    EXPECT_EQ(factor->factorize(lower, Eigen::Vector2d::Zero()), FactorOutcome::not_finite);
    EXPECT_STREQ(name_of(FactorOutcome::wrong_sign), "wrong_sign");
}

TEST(SparseSymmetric, TakesNothingAndRejectsNonsense) {
    const auto factor = make_simplicial_factor();
    factor->analyse(Sparse(0, 0), {});
    EXPECT_EQ(factor->factorize(Sparse(0, 0), Eigen::VectorXd(0)), FactorOutcome::ok);
    EXPECT_EQ(refined_solve(*factor, Sparse(0, 0), Eigen::VectorXd(0)).solution.size(), 0);
    EXPECT_THROW(factor->analyse(Sparse(2, 2), {1, 1}), ModelError);  // no diagonal stored
    EXPECT_THROW(factor->analyse(Sparse(2, 2), {1}), ModelError);
}

}  // namespace sparse_symmetric_test
}  // namespace camopt
