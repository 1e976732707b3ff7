// SPDX-License-Identifier: MIT
#include "tests/support/derivative_check.hpp"

#include "core/errors.hpp"
#include "core/nlp.hpp"
#include "solvers/test_problems.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

namespace camopt::test {
namespace derivative_check_test {

using testing::HasSubstr;

/// Passes everything through and spoils one derivative.
class Spoiled final : public Nlp {
 public:
    enum class What { gradient, jacobian, hessian, pattern };
    Spoiled(const Nlp& inner, What what) : Nlp(inner.shape()), inner_(inner), what_(what) {
        if (what != What::pattern) return;
        shape_.jacobian.rows.pop_back();
        shape_.jacobian.columns.pop_back();
    }
    [[nodiscard]] double cost(const ConstVectorRef& x) const override { return inner_.cost(x); }
    void gradient(const ConstVectorRef& x, VectorRef out) const override {
        inner_.gradient(x, out);
        if (what_ == What::gradient) out[2] *= 1.01;
    }
    void constraints(const ConstVectorRef& x, VectorRef out) const override { inner_.constraints(x, out); }
    void jacobian(const ConstVectorRef& x, std::span<double> out) const override {
        std::vector<double> all(inner_.shape().jacobian.rows.size());
        inner_.jacobian(x, all);
        std::copy_n(all.begin(), out.size(), out.begin());
        if (what_ == What::jacobian) out[5] += 0.1;
    }
    void hessian(const ConstVectorRef& x, double sigma, const ConstVectorRef& lambda,
                 std::span<double> out) const override {
        inner_.hessian(x, sigma, lambda, out);
        if (what_ == What::hessian) out[3] = -out[3];
    }
    [[nodiscard]] std::string variable_name(int index) const override { return inner_.variable_name(index); }
    [[nodiscard]] std::string row_name(int index) const override { return inner_.row_name(index); }

 private:
    const Nlp& inner_;
    What what_;
};

std::vector<Eigen::VectorXd> hs71_points() {
    // Inside, at the bounds 1 and 5 (one-sided differences), and near one.
    return {Eigen::Vector4d(1.7, 4.1, 2.3, 3.3), Eigen::Vector4d(1.0, 5.0, 5.0, 1.0),
            Eigen::Vector4d(1.0005, 4.9999, 3.0, 2.0)};
}

DerivativeReport report_of(Spoiled::What what) {
    const KnownProblem problem = hs71();
    const std::vector<Eigen::VectorXd> points{hs71_points().front()};
    return check_derivatives(Spoiled(*problem.nlp, what), points);
}

TEST(DerivativeCheck, PassesCorrectDerivativesAtBounds) {
    const KnownProblem problem = hs71();
    const DerivativeReport report = check_derivatives(*problem.nlp, hs71_points());
    EXPECT_TRUE(report.passed()) << describe(report.faults.front());
    EXPECT_LT(report.worst_error, 1e-8);
    EXPECT_EQ(report.entries, 3 * (4 + 8 + 10));
}

TEST(DerivativeCheck, PassesEmptyAndLargeProblems) {
    const KnownProblem problem = bounded_rosenbrock();
    const std::vector<Eigen::VectorXd> points{Eigen::Vector2d(-1.2, 1.0), Eigen::Vector2d(0.5, -300.0)};
    const DerivativeReport report = check_derivatives(*problem.nlp, points);
    EXPECT_TRUE(report.passed()) << describe(report.faults.front());
}

TEST(DerivativeCheck, PassesAFixedVariable) {
    const KnownProblem problem = fixed_variable_lp();
    const std::vector<Eigen::VectorXd> points{Eigen::Vector3d(1.0, 2.0, 0.5)};
    EXPECT_TRUE(check_derivatives(*problem.nlp, points).passed());
}

TEST(DerivativeCheck, NamesAWrongGradientEntry) {
    const DerivativeReport report = report_of(Spoiled::What::gradient);
    ASSERT_FALSE(report.passed());
    EXPECT_EQ(report.faults.front().kind, DerivativeKind::gradient);
    EXPECT_EQ(report.faults.front().variable, "x3");
    EXPECT_THAT(describe(report.faults.front()), HasSubstr("gradient by 'x3' at point 0"));
}

TEST(DerivativeCheck, NamesAWrongJacobianEntry) {
    const DerivativeReport report = report_of(Spoiled::What::jacobian);
    ASSERT_FALSE(report.passed());
    EXPECT_EQ(report.faults.front().kind, DerivativeKind::jacobian);
    EXPECT_THAT(describe(report.faults.front()), HasSubstr("jacobian of 'squares' by 'x2'"));
    EXPECT_NEAR(report.faults.front().given - report.faults.front().differenced, 0.1, 1e-8);
}

TEST(DerivativeCheck, NamesAWrongHessianEntry) {
    const DerivativeReport report = report_of(Spoiled::What::hessian);
    ASSERT_EQ(report.faults.size(), 1u);
    EXPECT_THAT(describe(report.faults.front()), HasSubstr("hessian of 'x3' by 'x1'"));
}

TEST(DerivativeCheck, FindsEntryMissingInPattern) {
    const DerivativeReport report = report_of(Spoiled::What::pattern);
    ASSERT_FALSE(report.passed());
    const auto& faults = report.faults;
    const auto missing =
        std::find_if(faults.begin(), faults.end(), [](const auto& f) { return !f.in_pattern; });
    ASSERT_NE(missing, faults.end());
    EXPECT_THAT(describe(*missing), HasSubstr("missing from the pattern"));
    EXPECT_THAT(describe(*missing), HasSubstr("'squares' by 'x4'"));
}

TEST(DerivativeCheck, CountsValuesThatAreNotFinite) {
    const KnownProblem problem = hs71();
    const HookedNlp spoiled(*problem.nlp, [](double) { return std::nan(""); });
    const DerivativeReport report = check_derivatives(spoiled, hs71_points());
    EXPECT_FALSE(report.passed());
    EXPECT_EQ(report.worst_error, infinity);
}

TEST(DerivativeCheck, RefusesWrongPointsAndOptions) {
    const KnownProblem problem = hs71();
    const std::vector<Eigen::VectorXd> wrong{Eigen::VectorXd::Zero(3)};
    EXPECT_THROW((void)check_derivatives(*problem.nlp, wrong), InputError);
    DerivativeCheckOptions options;
    options.step = 0.0;
    EXPECT_THROW((void)check_derivatives(*problem.nlp, hs71_points(), options), InputError);
}

TEST(CountingNlp, CountsCallsWithoutChangingValues) {
    const KnownProblem problem = hs71();
    EvaluationCounts counts;
    const CountingNlp counting(*problem.nlp, counts);
    const Eigen::VectorXd x = hs71_points().front();
    Eigen::VectorXd slope(4), expected_slope(4), g(2), expected_g(2);
    problem.nlp->gradient(x, expected_slope);
    problem.nlp->constraints(x, expected_g);
    std::vector<double> jacobian(8), hessian(10), expected(10);
    EXPECT_EQ(counting.cost(x), problem.nlp->cost(x));
    for (int i = 0; i < 2; ++i) counting.gradient(x, slope);
    for (int i = 0; i < 3; ++i) counting.constraints(x, g);
    for (int i = 0; i < 4; ++i) counting.jacobian(x, jacobian);
    for (int i = 0; i < 5; ++i) counting.hessian(x, 0.5, Eigen::Vector2d(1.0, -2.0), hessian);
    problem.nlp->hessian(x, 0.5, Eigen::Vector2d(1.0, -2.0), expected);
    EXPECT_EQ(slope, expected_slope);
    EXPECT_EQ(g, expected_g);
    EXPECT_EQ(hessian, expected);
    EXPECT_EQ(counts.cost, 1);
    EXPECT_EQ(counts.gradient, 2);
    EXPECT_EQ(counts.constraints, 3);
    EXPECT_EQ(counts.jacobian, 4);
    EXPECT_EQ(counts.hessian, 5);
    EXPECT_EQ(counting.row_name(1), "squares");
}

}  // namespace derivative_check_test
}  // namespace camopt::test
