// SPDX-License-Identifier: MIT
// A cam problem that nobody here wrote (benchmarks/outside/camshape.hpp), with proved optima: what the
// backends say of it.
#include "benchmarks/outside/camshape.hpp"

#include "core/nlp.hpp"
#include "solvers/registry.hpp"
#include "tests/support/derivative_check.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace camopt {
namespace camshape_test {

using benchmarks::Camshape;
using benchmarks::camshape_optima;
using benchmarks::CamshapeOptimum;
using benchmarks::violation_of;

TEST(Camshape, ItsDerivativesAreThoseOfItsValues) {
    for (const int radii : {2, 3, 7}) {
        const Camshape problem(radii);
        Eigen::VectorXd x = problem.straight_line();
        for (int i = 0; i < radii; ++i) x[i] += 0.02 * std::sin(3.0 * i + 1.0);
        const DerivativeReport report = check_derivatives(problem, std::vector{x});
        EXPECT_TRUE(report.passed()) << describe(report.faults.front());
        EXPECT_GT(report.entries, 0);
    }
}

bool converges(const BackendResult& result) {
    return result.termination == Termination::converged || result.termination == Termination::acceptable;
}

BackendResult solved(const std::string& solver, const Camshape& problem, double seconds) {
    BackendOptions options;
    options.max_seconds = seconds;
    if (solver.starts_with("nlopt.") && solver != "nlopt.slsqp") options.max_iterations = 20'000;
    return make_solver(solver)->minimize(problem, problem.straight_line(), options, {});
}

class CamshapeBackend : public testing::TestWithParam<std::string> {};

/// A backend may fail here; it may not claim what is not so.
TEST_P(CamshapeBackend, ClaimsNothingThatIsNotSo) {
    for (const SolverEntry& entry : solver_entries())
        if (entry.name == GetParam() && !entry.available)
            GTEST_SKIP() << entry.name << " is not in this build: " << entry.remedy;
    const CamshapeOptimum& optimum = camshape_optima().front();
    const Camshape problem(optimum.radii);
    // MMA and COBYLA go on to the limit; the three that must converge have time to.
    const bool must_converge =
        GetParam() == "ipopt" || GetParam() == "nlopt.slsqp" || GetParam() == "structured";
    const BackendResult result = solved(GetParam(), problem, must_converge ? 20.0 : 0.4);
    const bool is_feasible = result.x.size() == optimum.radii && violation_of(problem, result.x) <= 1e-6;
    EXPECT_TRUE(is_feasible || !converges(result)) << result.native_status;
    if (is_feasible) {
        EXPECT_GE(problem.cost(result.x), optimum.cost - 1e-7) << "below what is proved";
    }
    if (must_converge) {
        ASSERT_TRUE(converges(result)) << result.native_status;
        EXPECT_NEAR(problem.cost(result.x), optimum.cost, 1e-8);
    }
}

INSTANTIATE_TEST_SUITE_P(All, CamshapeBackend, testing::ValuesIn([] {
                             std::vector<std::string> names;
                             for (const SolverEntry& entry : solver_entries())
                                 if (!entry.needs_convex) names.push_back(entry.name);
                             return names;
                         }()),
                         [](const auto& info) {
                             std::string name = info.param;
                             std::ranges::replace(name, '.', '_');
                             return name;
                         });

/// Multipliers of relaxed rows once fed the Hessian: shifts of 1e11 stopped every step that satisfies the
/// rows.
TEST(Camshape, StructuredNeedsFewPasses) {
    for (const CamshapeOptimum& optimum : camshape_optima()) {
        if (optimum.radii > 200) continue;
        SCOPED_TRACE(optimum.radii);
        const Camshape problem(optimum.radii);
        const BackendResult result = solved("structured", problem, 20.0);
        ASSERT_EQ(result.termination, Termination::converged) << result.native_status;
        EXPECT_NEAR(problem.cost(result.x) / optimum.cost, 1.0, 1e-9);
        EXPECT_LT(violation_of(problem, result.x), 1e-9);
        EXPECT_LE(result.iterations, 20);
    }
}

TEST(Camshape, IpoptFindsProvedOptimaOfEverySize) {
    for (const SolverEntry& entry : solver_entries())
        if (entry.name == "ipopt" && !entry.available)
            GTEST_SKIP() << "no Ipopt in this build: " << entry.remedy;
    for (const CamshapeOptimum& optimum : camshape_optima()) {
        SCOPED_TRACE(optimum.radii);
        const Camshape problem(optimum.radii);
        const BackendResult result = solved("ipopt", problem, 60.0);
        ASSERT_TRUE(converges(result)) << result.native_status;
        EXPECT_NEAR(problem.cost(result.x), optimum.cost, 1e-8);
        EXPECT_LT(violation_of(problem, result.x), 1e-8);
    }
}

}  // namespace camshape_test
}  // namespace camopt
