// SPDX-License-Identifier: MIT
// Exchange, repair, proof and verdict on a problem whose answer is known in closed form.
#include "solvers/certificate/certificate.hpp"
#include "solvers/exchange/exchange.hpp"
#include "solvers/structured/structured_solver.hpp"
#include "tests/solvers/exchange/disc_problem.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

namespace camopt {
namespace continuous_solve_test {

using testing_support::DiscProblem;

/// A backend that returns what it is told, to see what is made of it.
class PuppetSolver final : public Solver {
 public:
    explicit PuppetSolver(BackendResult result) : result_(std::move(result)) {}
    std::string_view name() const override { return "puppet"; }
    BackendResult minimize(const Nlp&, const Eigen::VectorXd&, const BackendOptions&,
                           const SolveControl&) const override {
        return result_;
    }

 private:
    BackendResult result_;
};

BackendResult says(Termination termination, Eigen::VectorXd x) {
    BackendResult result;
    result.termination = termination;
    result.x = std::move(x);
    return result;
}

TEST(Exchange, ReachesTheContinuousOptimum) {
    DiscProblem problem;
    const auto solver = make_structured_solver();
    const ExchangeResult result = minimize_by_exchange(problem, *solver, problem.start(), {}, {});
    EXPECT_TRUE(result.converged);
    EXPECT_GT(result.rounds, 2);
    EXPECT_NEAR(result.best.objective, -std::sqrt(2.0), 1e-8);
    EXPECT_LE(result.best.violation, 1e-9);
}

/// The structured solver, whose calls are noted.
class WatchedSolver final : public Solver {
 public:
    std::string_view name() const override { return solver_->name(); }
    BackendResult minimize(const Nlp& problem, const Eigen::VectorXd& start, const BackendOptions& options,
                           const SolveControl& control) const override {
        known.push_back(options.has_optimum);
        return solver_->minimize(problem, start, options, control);
    }
    mutable std::vector<bool> known;

 private:
    std::unique_ptr<Solver> solver_ = make_structured_solver();
};

TEST(Exchange, ExaminesOnlyFirstRoundWithPointInside) {
    const WatchedSolver inside, outside;
    DiscProblem problem, other;
    const ExchangeResult result = minimize_by_exchange(problem, inside, problem.start(), {}, {});
    std::vector<bool> expected(static_cast<std::size_t>(result.rounds), true);
    expected.front() = false;
    EXPECT_EQ(inside.known, expected);
    const Eigen::Vector2d far(2.0, 0.0);
    EXPECT_TRUE(minimize_by_exchange(other, outside, far, {}, {}).converged);
    ASSERT_GT(outside.known.size(), 1u);
    EXPECT_FALSE(outside.known[1]) << "no point inside is known before the second round";
}

TEST(ContinuousSolve, ProvesTheOptimumByDuality) {
    DiscProblem problem;
    const auto solver = make_structured_solver();
    const ContinuousResult result = solve_continuous(problem, *solver, {}, {}, {});
    EXPECT_EQ(result.certificate.verdict, Verdict::optimal);
    EXPECT_LE(*result.certificate.lower_bound, -std::sqrt(2.0));
    EXPECT_GT(*result.certificate.lower_bound, -std::sqrt(2.0) - 2e-7);
    EXPECT_LE(result.certificate.worst_violation, 0.0);
    ASSERT_TRUE(result.certificate.proof);
    EXPECT_EQ(recomputed_bound(*result.certificate.proof), *result.certificate.lower_bound);
}

TEST(ContinuousSolve, VerdictIgnoresBackendSuccess) {
    DiscProblem problem;
    const ContinuousResult result = solve_continuous(
        problem, PuppetSolver(says(Termination::converged, Eigen::Vector2d(0.1, 0.2))), {}, {}, {});
    EXPECT_EQ(result.certificate.verdict, Verdict::feasible);
    EXPECT_NEAR(result.certificate.objective, -0.3, 1e-15);
    ASSERT_TRUE(result.certificate.lower_bound);  // the structured solver's dual on the same grid
    EXPECT_LE(*result.certificate.lower_bound, -std::sqrt(2.0));
    EXPECT_GT(*result.certificate.lower_bound, -1.6);  // of its first, coarse grid: -1.5696
}

TEST(ContinuousSolve, ASmallViolationIsRepaired) {
    DiscProblem problem;
    const double beyond = (1.0 + 1e-6) / std::sqrt(2.0);
    const ContinuousResult result = solve_continuous(
        problem, PuppetSolver(says(Termination::converged, Eigen::Vector2d(beyond, beyond))), {}, {}, {});
    EXPECT_NE(result.certificate.verdict, Verdict::failed);
    EXPECT_LE(result.certificate.worst_violation, 0.0);
    EXPECT_NEAR(result.certificate.objective, -std::sqrt(2.0), 3e-6);
}

TEST(ContinuousSolve, LimitsWithoutRoomAreNotRepaired) {
    DiscProblem problem;
    const auto at = [&](double angle, double radius) {
        return judged(problem, Eigen::Vector2d(radius * std::cos(angle), radius * std::sin(angle)));
    };
    const Candidate point = at(std::numbers::pi / 4.0, 1.0 + 1e-13), far = at(0.0, 1.0 - 1e-14);
    EXPECT_EQ(pulled_inside(problem, point, far).objective, point.objective)
        << "most of the way to another point, for rounding";
    EXPECT_LE(pulled_inside(problem, point, at(0.0, 0.5)).violation, 0.0);
    EXPECT_LE(pulled_inside(problem, at(std::numbers::pi / 4.0, 1.0 + 1e-9), far).violation, 0.0);
}

TEST(DualityProof, MultipliersAreSharpenedToRounding) {
    DualityProof proof;  // min x0 + 2 x1 subject to x0 >= 1, x1 = 3; x0 + x1 >= 0 is not active
    proof.variables = {"x0", "x1"};
    proof.cost = Eigen::Vector2d(1.0, 2.0);
    proof.matrix.resize(3, 2);
    for (const auto& [row, column] : {std::pair{0, 0}, {1, 1}, {2, 0}, {2, 1}})
        proof.matrix.insert(row, column) = 1.0;
    proof.lower = Eigen::Vector3d(1.0, 3.0, 0.0);
    proof.upper = Eigen::Vector3d(infinity, 3.0, infinity);
    proof.multipliers = Eigen::Vector3d(-1.0 + 1e-9, -2.0 - 1e-9, -1e-12);
    proof.box = {Eigen::Vector2d::Constant(-1e6), Eigen::Vector2d::Constant(1e6)};
    proof.bound = recomputed_bound(proof);
    EXPECT_LT(proof.bound, 6.999);
    sharpen(proof, 7.0);
    EXPECT_NEAR(proof.bound, 7.0, 1e-8);
    EXPECT_LE(proof.bound, 7.0);
    EXPECT_EQ(proof.bound, recomputed_bound(proof));
}

TEST(DualityProof, NumbersBeyondSquaresAreLeft) {
    DualityProof proof;  // min x0 subject to 1e200 x0 >= 1e200
    proof.variables = {"x0"};
    proof.cost = Eigen::VectorXd::Constant(1, 1.0);
    proof.matrix.resize(1, 1);
    proof.matrix.insert(0, 0) = 1e200;
    proof.lower = Eigen::VectorXd::Constant(1, 1e200);
    proof.upper = Eigen::VectorXd::Constant(1, infinity);
    proof.multipliers = Eigen::VectorXd::Constant(1, -0.9e-200);
    proof.box = {Eigen::VectorXd::Constant(1, -2.0), Eigen::VectorXd::Constant(1, 2.0)};
    proof.bound = recomputed_bound(proof);
    const double before = proof.bound;
    sharpen(proof, 1.0);
    EXPECT_EQ(proof.bound, before);
    EXPECT_NEAR(before, 0.7, 1e-12);
}

/// min w m + x, x in [0, 1], a peak m >= x.
class LittleWeight final : public Nlp {
 public:
    explicit LittleWeight(double weight) : weight_(weight) {
        shape_.x_lower = Eigen::Vector2d::Zero();
        shape_.x_upper = Eigen::Vector2d(1.0, infinity);
        shape_.g_lower = Eigen::VectorXd::Constant(1, -infinity);
        shape_.g_upper = Eigen::VectorXd::Zero(1);
        shape_.rows.push_back({});
        shape_.jacobian = {{0, 0}, {0, 1}};
        shape_.convex = shape_.linear_cost = shape_.quadratic_cost = true;
    }
    double cost(const ConstVectorRef& x) const override { return x[0] + weight_ * x[1]; }
    void gradient(const ConstVectorRef&, VectorRef out) const override { out << 1.0, weight_; }
    void constraints(const ConstVectorRef& x, VectorRef out) const override { out[0] = x[0] - x[1]; }
    void jacobian(const ConstVectorRef&, std::span<double> out) const override {
        out[0] = 1.0;
        out[1] = -1.0;
    }
    void hessian(const ConstVectorRef&, double, const ConstVectorRef&, std::span<double>) const override {}
    std::string variable_name(int) const override { return "x"; }
    std::string row_name(int) const override { return "peak"; }

 private:
    double weight_;
};

TEST(DualityProof, PeakOfLittleWeightCostsNothing) {
    const LittleWeight problem(1e-17);
    const Eigen::VectorXd multiplier = Eigen::VectorXd::Constant(1, 1e-12);  // as accurate as a solver is
    const Box box{Eigen::Vector2d::Zero(), Eigen::Vector2d(1.0, 1e17)};      // of an incumbent of 1
    EXPECT_NEAR(duality_proof(problem, Eigen::Vector2d::Zero(), multiplier, box, "objective").bound, 0.0,
                1e-15);
}

TEST(ContinuousSolve, InfeasibilityProofIgnoresBackendStatus) {
    for (const Termination termination : {Termination::converged, Termination::infeasible}) {
        DiscProblem problem(1.0, 1.5);  // x0 >= 1.5 outside the unit disc
        const ContinuousResult result =
            solve_continuous(problem, PuppetSolver(says(termination, Eigen::Vector2d(1.5, 0.0))), {}, {}, {});
        EXPECT_EQ(result.certificate.verdict, Verdict::infeasible);
        ASSERT_TRUE(result.certificate.proof);
        EXPECT_NEAR(result.certificate.proof->bound, 0.5, 1e-6);  // least common violation: 50 %
        EXPECT_EQ(result.x.size(), 0);
    }
}

TEST(ContinuousSolve, LimitsWithoutRoomAreRelaxed) {
    const double beyond = 4e-10, allowed = JudgeOptions{}.tolerance;
    DiscProblem problem(1.0, 1.0 + beyond);  // x0 >= 1 + 4e-10 outside the unit disc
    const ContinuousResult result = solve_continuous(problem, *make_structured_solver(), {}, {}, {});
    EXPECT_EQ(result.certificate.verdict, Verdict::optimal);
    EXPECT_LE(result.certificate.worst_violation, allowed);
    EXPECT_GE(result.certificate.worst_violation, beyond);
    ASSERT_TRUE(result.certificate.proof);
    EXPECT_NEAR(result.certificate.proof->limits_relaxed_by, allowed, 0.01 * allowed);
    EXPECT_EQ(recomputed_bound(*result.certificate.proof), *result.certificate.lower_bound);
    // Of the disc of radius 1 + 1e-9 at x0 = 1 + 4e-10.
    EXPECT_NEAR(result.certificate.objective, -1.0 - std::sqrt(2.0 * (allowed - beyond)), 2e-7);
}

TEST(ContinuousSolve, ViolationWithinRoundingProvesNothing) {
    const auto verdict_of = [](double rounding) {
        DiscProblem problem(1.0, 1.0 + 1e-6, rounding);
        const PuppetSolver solver(says(Termination::converged, Eigen::Vector2d(1.0 + 1e-6, 0.0)));
        return solve_continuous(problem, solver, {}, {}, {}).certificate.verdict;
    };
    EXPECT_EQ(verdict_of(0.0), Verdict::infeasible);
    EXPECT_EQ(verdict_of(1e-7), Verdict::infeasible);
    EXPECT_EQ(verdict_of(1e-5), Verdict::failed);
}

TEST(ContinuousSolve, BackendWithoutPointFails) {
    DiscProblem problem(1.0, 0.999999);
    JudgeOptions judge;
    SolveControl stop;
    stop.stop_requested = [] { return true; };
    // Stopped before anything ran: only the start is known, and nobody asked for that.
    const ContinuousResult cancelled =
        solve_continuous(problem, PuppetSolver(says(Termination::numerical_failure, {})), {}, judge, stop);
    EXPECT_EQ(cancelled.certificate.verdict, Verdict::failed);
    EXPECT_EQ(cancelled.certificate.reason, "interrupted");
    EXPECT_EQ(cancelled.x.size(), 0);
    SolveControl late;
    late.deadline = Deadline::after(0.0);
    // Out of time the start is the best there is, and it is inside.
    const ContinuousResult kept =
        solve_continuous(problem, PuppetSolver(says(Termination::numerical_failure, {})), {}, judge, late);
    EXPECT_EQ(kept.certificate.verdict, Verdict::feasible);
    EXPECT_EQ(kept.certificate.reason, "time_limit");
    DiscProblem outside(1.0, 1.5);
    const ContinuousResult failed =
        solve_continuous(outside, PuppetSolver(says(Termination::numerical_failure, {})), {}, judge, stop);
    EXPECT_EQ(failed.certificate.verdict, Verdict::failed);
    EXPECT_EQ(failed.certificate.reason, "interrupted");
    const ContinuousResult silent =
        solve_continuous(outside, PuppetSolver(says(Termination::numerical_failure, {})), {}, judge, late);
    EXPECT_EQ(silent.certificate.reason, "time_limit");
    DiscProblem alone(1.0, 0.999999);
    const ContinuousResult nothing =
        solve_continuous(alone, PuppetSolver(says(Termination::numerical_failure, {})), {}, judge, {});
    EXPECT_EQ(nothing.certificate.reason, "numerical_failure");
}

TEST(Verdict, EachHasItsCondition) {
    const JudgeOptions options;
    Certificate certificate;
    certificate.objective = 1.0;
    certificate.worst_violation = 0.0;
    const auto verdict_of = [&](const Certificate& one) {
        Certificate copy = one;
        settle_verdict(copy, Termination::time_limit, options);
        return copy.verdict;
    };
    EXPECT_EQ(verdict_of(certificate), Verdict::feasible);
    certificate.stationarity = 1e-8;
    EXPECT_EQ(verdict_of(certificate), Verdict::local);
    certificate.gap = 1e-8;
    EXPECT_EQ(verdict_of(certificate), Verdict::optimal);
    certificate.worst_violation = 1e-6;
    EXPECT_EQ(verdict_of(certificate), Verdict::failed);
    certificate.worst_violation = std::nan("");
    EXPECT_EQ(verdict_of(certificate), Verdict::failed);
}

TEST(Elastic, FindsDeepestFeasiblePoint) {
    DiscProblem problem;
    const Feasibility found = find_feasible(problem, {}, {});
    EXPECT_LT(found.point.violation, -0.4);
    EXPECT_FALSE(found.proof);
}

/// The disc, looked at from where nothing has a value, as of an arm that does not reach.
class DiscFromNowhere final : public DiscProblem {
 public:
    Eigen::VectorXd start() const override { return Eigen::Vector2d(3.0, 0.0); }
    std::vector<Violation> violations(const Eigen::VectorXd& x, double slack) const override {
        if (x.norm() > 2.0) return {{0, {std::nan(""), 0.0, Side::right}, infinity, true}};
        return DiscProblem::violations(x, slack);
    }
};

TEST(Elastic, AStartWithoutAValueIsLeft) {
    DiscFromNowhere problem;
    const ElasticProblem elastic(problem);
    EXPECT_TRUE(elastic.start().allFinite());
    EXPECT_EQ(elastic.objective(elastic.start()), infinity);
    const Feasibility found = find_feasible(problem, {}, {});
    EXPECT_LT(found.point.violation, -0.4);
    EXPECT_FALSE(found.proof);
}

TEST(Duality, FittedMultipliersOfTheOptimumAreExact) {
    DiscProblem problem;
    const double r = 1.0 / std::sqrt(2.0);
    problem.refine(std::vector<Violation>{{0, {1.0, std::numbers::pi / 4.0, Side::right}, 0.0, true}});
    const Eigen::VectorXd multipliers = fitted_multipliers(problem.grid(), Eigen::Vector2d(r, r), 1e-6);
    EXPECT_NEAR(multipliers[multipliers.size() - 1], std::sqrt(2.0), 1e-8);
    EXPECT_NEAR(multipliers.sum(), std::sqrt(2.0), 1e-8);
    EXPECT_LT(stationarity_of(problem.grid(), Eigen::Vector2d(r, r), multipliers, 1e-6), 1e-8);
}

TEST(Duality, AnyMultipliersGiveLowerBound) {
    DiscProblem problem;
    for (int trial = 0; trial < 50; ++trial) {
        Eigen::VectorXd multipliers(problem.grid().shape().constraints());
        for (Eigen::Index i = 0; i < multipliers.size(); ++i)
            multipliers[i] = std::sin(7.0 * trial + 3.0 * static_cast<double>(i));
        const DualityProof proof = duality_proof(problem.grid(), Eigen::Vector2d::Zero(), multipliers,
                                                 problem.box(0.0, 0.0), "objective");
        EXPECT_LE(proof.bound, -std::sqrt(2.0));
        EXPECT_TRUE(std::isfinite(proof.bound));
    }
}

}  // namespace continuous_solve_test
}  // namespace camopt
