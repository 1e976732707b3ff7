// SPDX-License-Identifier: MIT
#include "linear/chain_factor.hpp"

#include "core/errors.hpp"
#include "linear/compressed_rows.hpp"
#include "linear/kernels.hpp"
#include "linear/sparse_symmetric.hpp"
#include "tests/support/refusal.hpp"

#include <Eigen/Dense>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

namespace camopt {
namespace chain_factor_test {

using testing_support::refusal;

using Sparse = Eigen::SparseMatrix<double>;

struct System {
    Sparse lower;
    Eigen::MatrixXd full;
    std::vector<int> signs;
};

/// A motion's Newton matrix in small: at every knot (y, y', y'') with curvature on y'' alone, two equalities
/// that integrate from knot to knot, and `border` variables that touch every y''.
System chain(int knots, int border, unsigned seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> positive(0.5, 2.0);
    std::normal_distribution<double> normal;
    const double h = 0.1;
    const int states = 3 * knots, variables = states + border, size = variables + 2 * (knots - 1);
    std::vector<Eigen::Triplet<double>> entries;
    System system;
    for (int i = 0; i < size; ++i) {
        const bool curved = i < states && i % 3 == 2;
        const double diagonal = curved ? positive(random) : i >= states && i < variables ? 10.0 * knots : 0.0;
        entries.emplace_back(i, i, diagonal);
        system.signs.push_back(i < variables ? 1 : -1);
    }
    for (int k = 0; k < knots; ++k)
        for (int b = 0; b < border; ++b) entries.emplace_back(states + b, 3 * k + 2, 0.3 * normal(random));
    for (int k = 0; k + 1 < knots; ++k) {
        const int row = variables + 2 * k, from = 3 * k, to = 3 * (k + 1);
        entries.emplace_back(row, from, 1.0);
        entries.emplace_back(row, from + 1, h);
        entries.emplace_back(row, from + 2, h * h / 3.0);
        entries.emplace_back(row, to, -1.0);
        entries.emplace_back(row, to + 2, h * h / 6.0);
        entries.emplace_back(row + 1, from + 1, 1.0);
        entries.emplace_back(row + 1, from + 2, h / 2.0);
        entries.emplace_back(row + 1, to + 1, -1.0);
        entries.emplace_back(row + 1, to + 2, h / 2.0);
    }
    // The ends: y and y' of the first knot are held by a little curvature, so that the matrix is regular.
    entries.emplace_back(0, 0, 1.0);
    entries.emplace_back(1, 1, 1.0);
    system.lower.resize(size, size);
    system.lower.setFromTriplets(entries.begin(), entries.end());
    system.full = Eigen::MatrixXd(system.lower).selfadjointView<Eigen::Lower>();
    return system;
}

double error_of(SymmetricFactor& factor, const System& system) {
    EXPECT_EQ(factor.factorize(system.lower, Eigen::VectorXd::Zero(system.lower.rows())), FactorOutcome::ok);
    const Eigen::VectorXd expected = Eigen::VectorXd::LinSpaced(system.lower.rows(), -1.0, 2.0);
    Eigen::VectorXd x = system.full * expected;
    factor.solve_in_place(x);
    return (x - expected).lpNorm<Eigen::Infinity>();
}

TEST(ChainFactor, SolvesFreeVariablesWithoutShift) {
    for (const int border : {0, 1, 3, 5}) {
        for (unsigned seed = 1; seed <= 5; ++seed) {
            const System system = chain(60, border, seed);
            const auto factor = make_chain_factor(system.lower, system.signs);
            ASSERT_NE(factor, nullptr) << border;
            EXPECT_LE(error_of(*factor, system), 1e-8) << "border " << border << ", seed " << seed;
        }
    }
}

TEST(ChainFactor, FindsBorderAndNarrowBand) {
    const System system = chain(100, 3, 7);
    const auto order = chain_order(system.lower, system.signs);
    ASSERT_TRUE(order.has_value());
    EXPECT_EQ(order->border, (std::vector<int>{300, 301, 302}));
    EXPECT_LE(order->half_bandwidth, 8);
    int pairs = 0;
    for (const char opens : order->opens_pair) pairs += opens;
    EXPECT_EQ(pairs, 2 * 99);  // every equality has a partner
}

TEST(ChainFactor, ReordersShuffledChains) {
    const System plain = chain(60, 2, 3);
    const int variables = 3 * 60 + 2;
    std::vector<int> shuffled(static_cast<std::size_t>(variables));
    for (int i = 0; i < variables; ++i) shuffled[static_cast<std::size_t>(i)] = i;
    std::shuffle(shuffled.begin(), shuffled.end(), std::mt19937(5));
    std::vector<Eigen::Triplet<double>> entries;
    for (int j = 0; j < plain.lower.outerSize(); ++j)
        for (Sparse::InnerIterator entry(plain.lower, j); entry; ++entry) {
            const auto moved = [&](int i) {
                return i < variables ? shuffled[static_cast<std::size_t>(i)] : i;
            };
            const int a = moved(static_cast<int>(entry.row())), b = moved(j);
            entries.emplace_back(std::max(a, b), std::min(a, b), entry.value());
        }
    System system{Sparse(plain.lower.rows(), plain.lower.cols()), {}, plain.signs};
    system.lower.setFromTriplets(entries.begin(), entries.end());
    system.full = Eigen::MatrixXd(system.lower).selfadjointView<Eigen::Lower>();
    const auto factor = make_symmetric_factor(FactorKind::automatic, system.lower, system.signs);
    EXPECT_LE(error_of(*factor, system), 1e-8);
}

TEST(ChainFactor, RefusesWhatIsNoChain) {
    // A grid of neighbours has a band as wide as its side in every order.
    const int side = 60, size = side * side;
    std::vector<Eigen::Triplet<double>> entries;
    for (int i = 0; i < size; ++i) {
        entries.emplace_back(i, i, 5.0);
        if (i % side != 0) entries.emplace_back(i, i - 1, -1.0);
        if (i >= side) entries.emplace_back(i, i - side, -1.0);
    }
    Sparse lower(size, size);
    lower.setFromTriplets(entries.begin(), entries.end());
    const std::vector<int> signs(static_cast<std::size_t>(size), 1);
    EXPECT_EQ(make_chain_factor(lower, signs), nullptr);
    EXPECT_EQ(make_symmetric_factor(FactorKind::chain, lower, signs)->name(), "simplicial");
}

TEST(ChainFactor, NamesABreakdown) {
    Sparse lower(2, 2);
    lower.insert(0, 0) = 0.0;
    lower.insert(1, 1) = 1.0;
    const auto factor = make_chain_factor(lower, {1, 1});
    ASSERT_NE(factor, nullptr);
    EXPECT_EQ(factor->factorize(lower, Eigen::VectorXd::Zero(2)), FactorOutcome::zero_pivot);
    lower.coeffRef(0, 0) = -1.0;
    EXPECT_EQ(factor->factorize(lower, Eigen::VectorXd::Zero(2)), FactorOutcome::wrong_sign);
    lower.coeffRef(0, 0) = std::nan("");
    EXPECT_EQ(factor->factorize(lower, Eigen::VectorXd::Zero(2)), FactorOutcome::not_finite);
    EXPECT_EQ(refusal<ModelError>([&] { (void)factor->factorize(lower, Eigen::VectorXd::Zero(3)); }),
              "SymmetricFactor: not the analysed pattern");
}

TEST(ChainFactor, WideKernelsAgreeWithBaseline) {
    if (!has_wide_kernels()) GTEST_SKIP() << "no AVX2 here";
    const KernelSet before = kernel_set();
    for (const int border : {0, 3, 5}) {  // 5: widths known at run time only
        const System system = chain(60, border, 13);
        const Eigen::VectorXd right_side = Eigen::VectorXd::LinSpaced(system.lower.rows(), -1.0, 2.0);
        const auto solution = [&](KernelSet set) {
            use_kernels(set);
            const auto factor = make_chain_factor(system.lower, system.signs);
            EXPECT_EQ(factor->factorize(system.lower, Eigen::VectorXd::Zero(right_side.size())),
                      FactorOutcome::ok);
            Eigen::VectorXd x = right_side;
            factor->solve_in_place(x);
            return x;
        };
        const Eigen::VectorXd baseline = solution(KernelSet::baseline), wide = solution(KernelSet::wide);
        // The residuals are compared: how many digits of x agree depends on the matrix.
        const double size =
            system.full.cwiseAbs().rowwise().sum().maxCoeff() * baseline.cwiseAbs().maxCoeff();
        EXPECT_LE((system.full * (wide - baseline)).lpNorm<Eigen::Infinity>(), 1e-13 * size) << border;
        EXPECT_EQ(solution(KernelSet::wide), wide);  // to the last bit

        const Eigen::SparseMatrix<double, Eigen::RowMajor> rows = system.lower;
        const auto product = [&](KernelSet set) {
            use_kernels(set);
            Eigen::VectorXd out(rows.rows());
            CompressedRows(rows).multiply(right_side, out);
            return out;
        };
        const Eigen::VectorXd largest = rows.cwiseAbs() * right_side.cwiseAbs();
        EXPECT_LE((product(KernelSet::wide) - product(KernelSet::baseline)).cwiseAbs().maxCoeff(),
                  4e-16 * largest.maxCoeff())
            << border;
    }
    use_kernels(before);
}

TEST(SymmetricFactors, AllKindsAgree) {
    const System system = chain(40, 3, 11);
    for (const FactorKind kind : {FactorKind::automatic, FactorKind::chain, FactorKind::simplicial,
                                  FactorKind::cholmod, FactorKind::klu}) {
        const bool of_suitesparse = kind == FactorKind::cholmod || kind == FactorKind::klu;
        if (of_suitesparse && !has_suitesparse_factors()) continue;
        const auto factor = make_symmetric_factor(kind, system.lower, system.signs);
        const Eigen::VectorXd expected = Eigen::VectorXd::LinSpaced(system.lower.rows(), -1.0, 2.0);
        static_cast<void>(
            factor->factorize(system.lower, Eigen::VectorXd::Constant(system.lower.rows(), 1e-9)));
        const RefinedSolve solved = refined_solve(*factor, system.lower, system.full * expected);
        EXPECT_LE((solved.solution - expected).lpNorm<Eigen::Infinity>(), 1e-7) << factor->name();
    }
}

}  // namespace chain_factor_test
}  // namespace camopt
