// SPDX-License-Identifier: MIT
// The problem with chained columns is the same problem: values, derivatives, optimum, multipliers.
#include "solvers/chained_columns.hpp"

#include "core/errors.hpp"
#include "core/nlp.hpp"
#include "solvers/registry.hpp"
#include "solvers/test_problems.hpp"
#include "tests/support/derivative_check.hpp"
#include "tests/support/refusal.hpp"

#include <gtest/gtest.h>

#include <random>
#include <set>

namespace camopt::test {
namespace chained_columns_test {

using testing_support::refusal;

using Eigen::VectorXd;

/// min Σ (y_k − k)²/2 + P + Q  s.t.  y_k² + y_k y_{k+1} − P <= 0, y_k − 2 Q <= 1, P >= 1 (a row), 0 <= P <=
/// 90: curved rows with a peak that enters linearly.
class CurvedPeaks final : public Nlp {
 public:
    explicit CurvedPeaks(int count) : count_(count) {
        const int n = count + 2, m = 2 * (count - 1) + 1;
        shape_.x_lower = VectorXd::Constant(n, -infinity);
        shape_.x_upper = VectorXd::Constant(n, infinity);
        shape_.x_lower[count] = 0.0;
        shape_.x_upper[count] = 90.0;
        shape_.g_lower = VectorXd::Constant(m, -infinity);
        shape_.g_upper = VectorXd::Zero(m);
        for (int k = 0; k + 1 < count; ++k) {
            add_row({k, k + 1, count}, false);
            add_row({k, count + 1}, true);
            shape_.g_upper[2 * k + 1] = 1.0;
        }
        add_row({count}, true);
        shape_.g_lower[m - 1] = 1.0;
        shape_.g_upper[m - 1] = infinity;
        for (int k = 0; k < count; ++k) {
            add_hessian(k, k);
            if (k > 0) add_hessian(k, k - 1);
        }
    }
    [[nodiscard]] double cost(const ConstVectorRef& x) const override {
        double sum = x[count_] + x[count_ + 1];
        for (int k = 0; k < count_; ++k) sum += 0.5 * (x[k] - k) * (x[k] - k);
        return sum;
    }
    void gradient(const ConstVectorRef& x, VectorRef out) const override {
        for (int k = 0; k < count_; ++k) out[k] = x[k] - k;
        out.tail(2).setOnes();
    }
    void constraints(const ConstVectorRef& x, VectorRef out) const override {
        for (int k = 0; k + 1 < count_; ++k) {
            out[2 * k] = x[k] * x[k] + x[k] * x[k + 1] - x[count_];
            out[2 * k + 1] = x[k] - 2.0 * x[count_ + 1];
        }
        out[2 * (count_ - 1)] = x[count_];
    }
    void jacobian(const ConstVectorRef& x, std::span<double> out) const override {
        std::size_t i = 0;
        for (int k = 0; k + 1 < count_; ++k) {
            out[i++] = 2.0 * x[k] + x[k + 1];
            out[i++] = x[k];
            out[i++] = -1.0;
            out[i++] = 1.0;
            out[i++] = -2.0;
        }
        out[i] = 1.0;
    }
    void hessian(const ConstVectorRef&, double sigma, const ConstVectorRef& lambda,
                 std::span<double> out) const override {
        std::size_t i = 0;
        for (int k = 0; k < count_; ++k) {
            out[i++] = sigma + (k + 1 < count_ ? 2.0 * lambda[2 * k] : 0.0);
            if (k > 0) out[i++] = lambda[2 * (k - 1)];
        }
    }
    [[nodiscard]] std::string variable_name(int index) const override {
        return index < count_ ? "y" : index == count_ ? "P" : "Q";
    }
    [[nodiscard]] std::string row_name(int) const override { return "row"; }

 private:
    void add_row(std::initializer_list<int> columns, bool linear) {
        const int row = static_cast<int>(shape_.rows.size());
        shape_.rows.push_back({linear, false, 1.0});
        for (const int column : columns) {
            shape_.jacobian.rows.push_back(row);
            shape_.jacobian.columns.push_back(column);
        }
    }
    void add_hessian(int row, int column) {
        shape_.hessian.rows.push_back(row);
        shape_.hessian.columns.push_back(column);
    }
    int count_;
};

VectorXd random_point(int size, unsigned seed) {
    std::mt19937 generator(seed);
    std::uniform_real_distribution<double> uniform(-1.0, 1.0);
    return VectorXd::NullaryExpr(size, [&](Eigen::Index) { return uniform(generator); });
}

TEST(DenseColumns, ArePeaksSharedByManyRows) {
    const CurvedPeaks base(60);
    EXPECT_EQ(dense_columns(base.shape()), (std::vector<int>{60, 61}));
    EXPECT_EQ(dense_columns(weighted_peaks_lp(12).nlp->shape(), 0.28), (std::vector<int>{13, 14, 15}));
}

TEST(DenseColumns, FullyDenseProblemsAreUnchanged) {
    EXPECT_TRUE(dense_columns(weighted_peaks_lp(12).nlp->shape(), 0.001).empty());
    EXPECT_TRUE(dense_columns(hs71().nlp->shape()).empty()) << "every variable is in the Hessian";
}

TEST(ChainedColumns, EqualCopiesReproduceBaseValues) {
    const CurvedPeaks base(60);
    const ChainedColumns chained(base, dense_columns(base.shape()), VectorXd::Zero(62));
    EXPECT_EQ(chained.copies(), 4) << "59 first columns in groups of 24: three groups for each of two peaks";
    EXPECT_EQ(chained.shape().variables(), 66);
    EXPECT_EQ(chained.shape().constraints(), base.shape().constraints() + 4);
    for (const unsigned seed : {1u, 2u, 3u}) {
        const VectorXd x = random_point(62, seed), z = chained.chained(x);
        EXPECT_EQ(chained.unchained(z), x);
        EXPECT_DOUBLE_EQ(chained.cost(z), base.cost(x));
        VectorXd g(base.shape().constraints()), all(chained.shape().constraints());
        base.constraints(x, g);
        chained.constraints(z, all);
        EXPECT_LT((all.head(g.size()) - g).lpNorm<Eigen::Infinity>(), 1e-15);
        EXPECT_EQ(all.tail(4), VectorXd::Zero(4));
    }
}

TEST(ChainedColumns, RowsSeeTheirOwnCopyOnly) {
    const CurvedPeaks base(60);
    const ChainedColumns chained(base, {60}, VectorXd::Zero(62));
    ASSERT_EQ(chained.copies(), 2);
    VectorXd z = chained.chained(random_point(62, 4)), before(chained.shape().constraints()), after = before;
    chained.constraints(z, before);
    z[63] += 1.0;  // the last copy: rows of y_48 … y_58
    chained.constraints(z, after);
    for (int k = 0; k < 59; ++k) EXPECT_NEAR(after[2 * k] - before[2 * k], k >= 48 ? -1.0 : 0.0, 1e-14) << k;
    EXPECT_EQ(after[118], before[118]) << "a row without other columns stays with the first copy";
    EXPECT_NEAR(after[120] - before[120], -1.0, 1e-14) << "the tie of the second to the third copy";
}

TEST(ChainedColumns, HasRightDerivativesWhereCopiesDiffer) {
    const CurvedPeaks base(60);
    const ChainedColumns chained(base, {60, 61}, VectorXd::Zero(62));
    std::vector<VectorXd> points;
    for (const unsigned seed : {5u, 6u})
        points.push_back(random_point(chained.shape().variables(), seed).array() + 2.0);
    const DerivativeReport report = check_derivatives(chained, points);
    EXPECT_TRUE(report.passed()) << describe(report.faults.front());
}

TEST(ChainedColumns, NamesAreDistinct) {
    const CurvedPeaks base(60);
    const ChainedColumns chained(base, {60, 61}, VectorXd::Zero(62));
    EXPECT_EQ(chained.variable_name(60), "P");
    EXPECT_EQ(chained.variable_name(62), "P, copy 2");
    EXPECT_EQ(chained.variable_name(65), "Q, copy 3");
    EXPECT_EQ(chained.row_name(119), "P = P, copy 2");
    std::set<std::string> names;
    for (int j = 60; j < chained.shape().variables(); ++j) names.insert(chained.variable_name(j));
    EXPECT_EQ(names.size(), 6u);
}

TEST(ChainedColumns, RefusesColumnsThatAreNotLinear) {
    const CurvedPeaks base(60);
    EXPECT_EQ(
        refusal<ModelError>([&] { (void)ChainedColumns(base, {3}, VectorXd::Zero(62)); }),
        "chained columns: column 3 has an entry in the Hessian, allowed are columns that enter linearly");
    EXPECT_EQ(refusal<ModelError>([&] { (void)ChainedColumns(base, {62}, VectorXd::Zero(62)); }),
              "chained columns: there is no column 62, allowed are 0 … 61");
}

/// Solves the chained problem with the solver that is always there and judges the answer by the base problem.
void expect_same_optimum(const Nlp& base, const std::vector<int>& columns, const VectorXd& start,
                         double cost) {
    const ChainedColumns chained(base, columns, start);
    ASSERT_GT(chained.copies(), 0);
    const BackendResult result = make_solver("structured")->minimize(chained, chained.chained(start), {}, {});
    ASSERT_EQ(result.termination, Termination::converged) << result.native_status;
    const VectorXd x = chained.unchained(result.x), rows = chained.unchained_rows(*result.row_multipliers),
                   bounds = chained.unchained(*result.bound_multipliers);
    EXPECT_NEAR(base.cost(x), cost, 1e-8 * std::max(1.0, std::abs(cost)));
    EXPECT_LT(violation(base, x), 1e-8);
    EXPECT_LT(stationarity(base, x, rows, bounds), 1e-7);
    EXPECT_LT(complementarity(base, x, rows, bounds), 1e-7);
}

TEST(ChainedColumns, OptimumAndMultipliersOfLinearPeaks) {
    const KnownProblem wide = least_acceleration_lp(75);
    expect_same_optimum(*wide.nlp, {76}, wide.start, wide.cost);
}

TEST(ChainedColumns, OptimumAndMultipliersOfCurvedRows) {
    const CurvedPeaks base(60);
    VectorXd start = VectorXd::Constant(62, 0.5);
    start.tail(2).setConstant(2.0);
    const BackendResult plain = make_solver("structured")->minimize(base, start, {}, {});
    ASSERT_EQ(plain.termination, Termination::converged) << plain.native_status;
    expect_same_optimum(base, {60, 61}, start, base.cost(plain.x));
}

/// What Ipopt makes of it: with and without chained columns the same answer, in the base problem's own sizes.
TEST(ChainedColumns, AreAnOptionOfIpopt) {
    for (const SolverEntry& entry : solver_entries())
        if (entry.name == "ipopt" && !entry.available) GTEST_SKIP() << entry.remedy;
    const KnownProblem problem = least_acceleration_lp(75);
    for (const char* wish : {"no", "yes", "auto"}) {
        BackendOptions options;
        options.native["chain_dense_columns"] = std::string(wish);
        const BackendResult result = make_solver("ipopt")->minimize(*problem.nlp, problem.start, options, {});
        ASSERT_EQ(result.termination, Termination::converged) << wish << ": " << result.native_status;
        ASSERT_EQ(result.x.size(), problem.start.size());
        EXPECT_NEAR(problem.nlp->cost(result.x), problem.cost, 1e-8);
        EXPECT_LT(violation(*problem.nlp, result.x), 1e-8);
        EXPECT_LT(stationarity(*problem.nlp, result.x, *result.row_multipliers, *result.bound_multipliers),
                  1e-7);
        EXPECT_LT(complementarity(*problem.nlp, result.x, *result.row_multipliers, *result.bound_multipliers),
                  1e-7);
    }
}

}  // namespace chained_columns_test
}  // namespace camopt::test
