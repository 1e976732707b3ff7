// SPDX-License-Identifier: MIT
// One suite over every backend of the registry that this build has, each with the problems that it can solve.
#include "core/errors.hpp"
#include "core/nlp.hpp"
#include "solvers/registry.hpp"
#include "solvers/test_problems.hpp"
#include "tests/support/derivative_check.hpp"
#include "tests/support/refusal.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <cmath>
#include <thread>

namespace camopt::test {
namespace backend_conformance_test {

using testing_support::refusal;

using testing::AnyOf;
using testing::HasSubstr;

const SolverEntry& entry_of(const std::string& name) {
    for (const SolverEntry& entry : solver_entries())
        if (entry.name == name) return entry;
    throw InputError("no such solver: " + name);
}

/// What may honestly be asked of each backend.
struct Reach {
    double cost = 1e-9;         ///< relative to max(1, |cost|)
    double x = 1e-4;            ///< of the point, where it is unique
    int most_variables = 1000;  ///< of the problems it is asked to solve
    bool may_run_out = false;   ///< ends at its limit on evaluations, near the optimum all the same
};

Reach reach_of(const std::string& solver) {
    if (!solver.starts_with("nlopt.")) return {};
    if (solver == "nlopt.isres") return {1e-4, 1e-2, 5, true};
    // Kinked problems are not for L-BFGS; the simplexes lose their way in more than a few variables.
    if (solver == "nlopt.auglag.lbfgs") return {1e-6, 1e-4, 11, false};
    if (solver.starts_with("nlopt.auglag.")) return {1e-5, 1e-2, 5, true};
    return {1e-6, 1e-4, 1000, false};
}

bool has_equalities(const NlpShape& shape) {
    for (int row = 0; row < shape.constraints(); ++row)
        if (shape.g_lower[row] == shape.g_upper[row]) return true;
    return false;
}

bool refuses(const SolverEntry& entry, const KnownProblem& problem) {
    return has_equalities(problem.nlp->shape()) && !entry.takes_equalities;
}

bool finished(Termination termination) {
    return termination == Termination::converged || termination == Termination::acceptable;
}

struct Interrupted : std::runtime_error {
    using std::runtime_error::runtime_error;
    int code = 42;
};

/// Of a backend by its name.
class AnyBackend : public testing::Test {
 protected:
    void use(const std::string& name) {
        name_ = name;
        solver_ = make_solver(name);
        options_.max_seconds = 20.0;
        reach_ = reach_of(name);
        if (!entry().needs_derivatives) options_.max_iterations = 20000;
    }
    [[nodiscard]] const SolverEntry& entry() const { return entry_of(name_); }
    [[nodiscard]] bool takes_equalities() const { return entry().takes_equalities; }
    /// Problems every backend takes: one that needs many iterations, one with few.
    [[nodiscard]] KnownProblem long_problem() const {
        return takes_equalities() ? weighted_peaks_lp(12) : bounded_rosenbrock();
    }
    [[nodiscard]] KnownProblem short_problem() const {
        return takes_equalities() ? projection_qp() : unconstrained_qp();
    }
    [[nodiscard]] BackendResult minimize(const Nlp& problem, const Eigen::VectorXd& start) const {
        return solver_->minimize(problem, start, options_, control_);
    }
    void expect_solved(const KnownProblem& problem) const {
        SCOPED_TRACE(problem.name + ": " + problem.source);
        const BackendResult result = minimize(*problem.nlp, problem.start);
        EXPECT_FALSE(result.native_status.empty());
        if (refuses(entry(), problem)) {
            EXPECT_EQ(result.termination, Termination::unsupported);
            EXPECT_THAT(result.native_status, HasSubstr("takes no equality rows"));
            return;
        }
        ASSERT_TRUE(ended_well(result)) << name_of(result.termination) << " " << result.native_status;
        ASSERT_EQ(result.x.size(), problem.start.size());
        EXPECT_NEAR(problem.nlp->cost(result.x), problem.cost,
                    reach_.cost * std::max(1.0, std::abs(problem.cost)));
        EXPECT_LT(violation(*problem.nlp, result.x), 1e-8);
        if (problem.x.size()) {
            EXPECT_LT((result.x - problem.x).lpNorm<Eigen::Infinity>(), reach_.x);
        }
        expect_multipliers(problem, result);
    }

    [[nodiscard]] bool ended_well(const BackendResult& result) const {
        return finished(result.termination) ||
               (reach_.may_run_out && result.termination == Termination::iteration_limit);
    }

    std::string name_;
    std::unique_ptr<Solver> solver_;
    Reach reach_;
    BackendOptions options_;
    SolveControl control_;

 private:
    void expect_multipliers(const KnownProblem& problem, const BackendResult& result) const {
        ASSERT_EQ(result.row_multipliers.has_value(), entry().gives_multipliers);
        ASSERT_EQ(result.bound_multipliers.has_value(), entry().gives_multipliers);
        if (!result.row_multipliers) return;
        EXPECT_LT(stationarity(*problem.nlp, result.x, *result.row_multipliers, *result.bound_multipliers),
                  1e-7);
        EXPECT_LT(complementarity(*problem.nlp, result.x, *result.row_multipliers, *result.bound_multipliers),
                  1e-7);
    }
};

std::string word_of(std::string name) {
    std::replace(name.begin(), name.end(), '.', '_');
    return name;
}

/// Backends that this build has, and that fit.
template <class Fits>
auto backends_that(const Fits& fits) {
    std::vector<std::string> names;
    for (const SolverEntry& entry : solver_entries())
        if (entry.available && fits(entry)) names.push_back(entry.name);
    return testing::ValuesIn(names);
}

std::string test_name(const testing::TestParamInfo<std::string>& info) {
    return word_of(info.param);
}

struct Solving {
    std::string solver, problem;
    std::function<KnownProblem()> make;
};

void PrintTo(const Solving& one, std::ostream* out) {
    *out << one.solver << " " << one.problem;
}

/// Each backend with the problems that are not beyond it.
std::vector<Solving> solvings() {
    const std::vector<std::pair<std::string, std::function<KnownProblem()>>> problems = {
        {"corner_lp", corner_lp},
        {"degenerate_lp", degenerate_lp},
        {"equality_lp", equality_lp},
        {"two_sided_lp", two_sided_lp},
        {"fixed_variable_lp", fixed_variable_lp},
        {"all_fixed_lp", all_fixed_lp},
        {"least_acceleration_lp_9", [] { return least_acceleration_lp(9); }},
        {"least_acceleration_lp_25", [] { return least_acceleration_lp(25); }},
        {"weighted_peaks_lp_12", [] { return weighted_peaks_lp(12); }},
        {"weighted_peaks_lp_20", [] { return weighted_peaks_lp(20); }},
        {"unconstrained_qp", unconstrained_qp},
        {"projection_qp", projection_qp},
        {"least_square_acceleration_qp", [] { return least_square_acceleration_qp(10); }},
        {"bounded_rosenbrock", bounded_rosenbrock},
        {"start_outside_bounds", [] {
             KnownProblem problem = fixed_variable_lp();
             problem.start << -100.0, 100.0, 3.0;
             return problem;
         }}};
    std::vector<Solving> all;
    for (const SolverEntry& entry : solver_entries())
        for (const auto& [name, make] : problems) {
            const KnownProblem problem = make();
            const bool beyond = problem.start.size() > reach_of(entry.name).most_variables ||
                                (entry.needs_convex && !problem.nlp->shape().convex);
            if (entry.available && (refuses(entry, problem) || !beyond))
                all.push_back({entry.name, name, make});
        }
    return all;
}

class BackendProblem : public AnyBackend, public testing::WithParamInterface<Solving> {
    void SetUp() override { use(GetParam().solver); }
};

TEST_P(BackendProblem, IsSolvedOrRefused) {
    expect_solved(GetParam().make());
}

INSTANTIATE_TEST_SUITE_P(Registry, BackendProblem, testing::ValuesIn(solvings()), [](const auto& info) {
    return word_of(info.param.solver) + "_" + info.param.problem;
});

class Backend : public AnyBackend, public testing::WithParamInterface<std::string> {
    void SetUp() override { use(GetParam()); }
};

TEST_P(Backend, IsNamedAsInTheRegistry) {
    EXPECT_EQ(solver_->name(), GetParam());
}

class GeneralBackend : public Backend {};

TEST_P(GeneralBackend, SolvesHs71) {
    KnownProblem problem = hs71();
    problem.cost = 17.01401728;  // to ten digits, the book gives nine
    options_.tolerance = 1e-10;
    const BackendResult result = minimize(*problem.nlp, problem.start);
    ASSERT_TRUE(ended_well(result)) << result.native_status;
    EXPECT_NEAR(problem.nlp->cost(result.x), problem.cost, reach_.may_run_out ? 17.0 * reach_.cost : 2e-7);
    EXPECT_LT((result.x - problem.x).lpNorm<Eigen::Infinity>(), reach_.may_run_out ? reach_.x : 1e-5);
    EXPECT_LT(violation(*problem.nlp, result.x), 1e-8);
    if (result.row_multipliers) {
        EXPECT_LT((*result.row_multipliers)[0], 0.0) << "the product leans on its lower bound";
        EXPECT_GT((*result.row_multipliers)[1], 0.0);
        EXPECT_LT((*result.bound_multipliers)[0], 0.0) << "x1 leans on its lower bound";
    }
}

INSTANTIATE_TEST_SUITE_P(Registry, GeneralBackend, backends_that([](const SolverEntry& entry) {
                             return !entry.needs_convex && entry.takes_equalities;
                         }),
                         test_name);
GTEST_ALLOW_UNINSTANTIATED_PARAMETERIZED_TEST(GeneralBackend);  // a build with the structured one alone

TEST_P(Backend, DoesNotCallInfeasibleProblemSolved) {
    const bool notices = entry().gives_multipliers;
    if (!notices) options_.max_seconds = 0.3;  // MMA and CCSAQ go on to the limit
    const KnownProblem problem = infeasible_lp();
    const BackendResult result = minimize(*problem.nlp, problem.start);
    RecordProperty("termination", name_of(result.termination));
    EXPECT_FALSE(finished(result.termination)) << result.native_status;
    if (notices) {
        EXPECT_EQ(result.termination, Termination::infeasible);
    }
}

TEST_P(Backend, SaysInfeasibleWhereBoundsCross) {
    QuadraticData data;
    data.slope = Eigen::VectorXd::Ones(1);
    data.x_lower = Eigen::VectorXd::Constant(1, 2.0);
    data.x_upper = Eigen::VectorXd::Constant(1, 1.0);
    const auto problem = quadratic_problem(data);
    EXPECT_EQ(minimize(*problem, Eigen::VectorXd::Zero(1)).termination, Termination::infeasible);
}

TEST_P(Backend, DoesNotCallAnUnboundedProblemSolved) {
    options_.max_iterations = 500;
    const KnownProblem problem = unbounded_lp();
    const BackendResult result = minimize(*problem.nlp, problem.start);
    EXPECT_FALSE(finished(result.termination)) << result.native_status;
    if (GetParam() == "ipopt" || GetParam() == "nlopt.slsqp") {
        EXPECT_EQ(result.termination, Termination::unbounded);
    }
}

/// Searches only within bounds, and makes them up where there are none.
class BoxedBackend : public Backend {};

TEST_P(BoxedBackend, BoxEdgeIsNotReportedOptimal) {
    const KnownProblem problem = unbounded_lp();
    const BackendResult result = minimize(*problem.nlp, problem.start);
    EXPECT_EQ(result.termination, Termination::unbounded) << result.native_status;
    EXPECT_THAT(result.native_status, HasSubstr("search radius"));
}

INSTANTIATE_TEST_SUITE_P(Registry, BoxedBackend,
                         backends_that([](const SolverEntry& entry) { return entry.name == "nlopt.isres"; }),
                         test_name);
GTEST_ALLOW_UNINSTANTIATED_PARAMETERIZED_TEST(BoxedBackend);  // a build without NLopt

TEST_P(Backend, TakesOrRefusesMoreEqualitiesThanVariables) {
    const KnownProblem problem = overdetermined();
    const BackendResult result = minimize(*problem.nlp, problem.start);
    if (result.termination == Termination::unsupported) {
        EXPECT_NE(GetParam(), "structured");
        EXPECT_EQ(result.native_status, !takes_equalities() ? "takes no equality rows, this problem has 3"
                                        : GetParam() == "ipopt"
                                            ? "Not_Enough_Degrees_Of_Freedom"
                                            : "INVALID_ARGS: too many equality constraints");
        return;
    }
    ASSERT_TRUE(finished(result.termination)) << name_of(result.termination) << " " << result.native_status;
    EXPECT_LT((result.x - problem.x).lpNorm<Eigen::Infinity>(), 1e-6);
}

TEST_P(Backend, StopsAtIterationLimitWithPoint) {
    options_.max_iterations = 2;
    const KnownProblem problem = long_problem();
    const BackendResult result = minimize(*problem.nlp, problem.start);
    EXPECT_EQ(result.termination, Termination::iteration_limit) << result.native_status;
    ASSERT_EQ(result.x.size(), problem.start.size());
    EXPECT_TRUE(result.x.allFinite());
}

TEST_P(Backend, StopsAtTimeLimitWithPoint) {
    options_.max_seconds = 0.02;
    const KnownProblem problem = long_problem();
    const HookedNlp slow(*problem.nlp, [](double cost) {
        std::this_thread::sleep_for(std::chrono::milliseconds(25));  // some ask for a linear cost but once
        return cost;
    });
    const auto begin = std::chrono::steady_clock::now();
    const BackendResult result = minimize(slow, problem.start);
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - begin;
    EXPECT_EQ(result.termination, Termination::time_limit) << result.native_status;
    EXPECT_EQ(result.x.size(), problem.start.size());
    EXPECT_LT(seconds.count(), 5.0);
}

TEST_P(Backend, StopsOnRequestWithAPoint) {
    int polls = 0;
    control_.stop_requested = [&polls] { return ++polls > 2; };
    const KnownProblem problem = long_problem();
    const BackendResult result = minimize(*problem.nlp, problem.start);
    EXPECT_EQ(result.termination, Termination::interrupted) << result.native_status;
    EXPECT_EQ(result.x.size(), problem.start.size());
    EXPECT_LT(polls, 50);
}

TEST_P(Backend, ReportsACostThatIsNotFinite) {
    const KnownProblem problem = short_problem();
    for (const double value : {std::nan(""), infinity}) {
        const HookedNlp spoiled(*problem.nlp, [value](double) { return value; });
        const BackendResult result = minimize(spoiled, problem.start);
        EXPECT_EQ(result.termination, Termination::evaluation_error) << result.native_status;
    }
}

TEST_P(Backend, StopsWhenCostBecomesNonfinite) {
    int calls = 0;
    const KnownProblem problem = long_problem();
    const HookedNlp spoiled(*problem.nlp,
                            [&calls](double cost) { return ++calls > 3 ? std::nan("") : cost; });
    const BackendResult result = minimize(spoiled, problem.start);
    if (finished(result.termination)) {  // allowed where the cost is known by its derivatives, but then it
                                         // must be right
        EXPECT_NEAR(problem.nlp->cost(result.x), problem.cost, 1e-6);
        EXPECT_LT(violation(*problem.nlp, result.x), 1e-8);
    }
    EXPECT_LT(calls, 5000);
    if (result.x.size()) {
        EXPECT_TRUE(result.x.allFinite());
    }
}

TEST_P(Backend, CarriesAnExceptionWithItsType) {
    const KnownProblem problem = short_problem();
    for (const int first : {0, 2}) {
        int calls = 0;
        const HookedNlp throwing(*problem.nlp, [&calls, first](double cost) -> double {
            if (calls++ >= first) throw Interrupted("from the cost");
            return cost;
        });
        try {
            (void)minimize(throwing, problem.start);
            ADD_FAILURE() << "no exception";
        } catch (const Interrupted& caught) {
            EXPECT_STREQ(caught.what(), "from the cost");
            EXPECT_EQ(caught.code, 42);
        }
    }
}

TEST_P(Backend, CarriesAnExceptionOfTheStopRequest) {
    control_.stop_requested = []() -> bool { throw Interrupted("from the stop request"); };
    const KnownProblem problem = short_problem();
    EXPECT_THROW((void)minimize(*problem.nlp, problem.start), Interrupted);
}

TEST_P(Backend, RefusesWrongInput) {
    const KnownProblem problem = corner_lp();
    EXPECT_EQ(refusal([&] { (void)minimize(*problem.nlp, Eigen::VectorXd::Zero(5)); }),
              "start of the solve: found 5 entries, the problem has 2 variables");
    EXPECT_EQ(refusal([&] { (void)minimize(*problem.nlp, Eigen::Vector2d(0.0, std::nan(""))); }),
              "start of the solve: an entry is not finite");
    BackendOptions bad;
    bad.tolerance = 0.0;
    EXPECT_EQ(refusal([&] { (void)solver_->minimize(*problem.nlp, problem.start, bad, {}); }),
              "solver option 'tolerance': found 0, allowed is a number in (0, 1)");
    bad = {};
    bad.native["xyz"] = 1.0;
    const std::string message =
        refusal([&] { (void)solver_->minimize(*problem.nlp, problem.start, bad, {}); });
    EXPECT_EQ(message.find("unknown option 'xyz' of " + std::string(solver_->name()) + "; allowed: "), 0U)
        << message;
}

TEST_P(Backend, GivesTheSameAnswerTwice) {
    const KnownProblem problem = long_problem();
    const BackendResult first = minimize(*problem.nlp, problem.start),
                        second = minimize(*problem.nlp, problem.start);
    EXPECT_EQ(first.x, second.x);
    EXPECT_EQ(first.iterations, second.iterations);
}

TEST_P(Backend, SolvesInSeveralThreadsAtOnce) {
    std::atomic<int> solved = 0;
    std::vector<std::thread> threads;
    const bool few = !takes_equalities() || reach_.most_variables < 11;
    for (int t = 0; t < 4; ++t)
        threads.emplace_back([&] {
            const KnownProblem problem = few ? corner_lp() : least_acceleration_lp(9);
            for (int i = 0; i < 5; ++i) {
                const BackendResult result = minimize(*problem.nlp, problem.start);
                if (ended_well(result) &&
                    std::abs(problem.nlp->cost(result.x) - problem.cost) < std::max(1e-5, 5.0 * reach_.cost))
                    ++solved;
            }
        });
    for (std::thread& thread : threads) thread.join();
    EXPECT_EQ(solved, 20);
}

INSTANTIATE_TEST_SUITE_P(Registry, Backend, backends_that([](const SolverEntry&) { return true; }),
                         test_name);

TEST(KnownProblems, HaveRightDerivatives) {
    std::vector<KnownProblem> all;
    all.push_back(corner_lp());
    all.push_back(weighted_peaks_lp(12));
    all.push_back(least_square_acceleration_qp(6));
    all.push_back(hs71());
    all.push_back(bounded_rosenbrock());
    for (const KnownProblem& problem : all) {
        Eigen::VectorXd point = problem.start.cwiseMax(problem.nlp->shape().x_lower);
        point = point.cwiseMin(problem.nlp->shape().x_upper);
        const DerivativeReport report = check_derivatives(*problem.nlp, {&point, 1});
        EXPECT_TRUE(report.passed()) << problem.name << ": " << describe(report.faults.front());
    }
}

}  // namespace backend_conformance_test
}  // namespace camopt::test
