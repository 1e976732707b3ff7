// SPDX-License-Identifier: MIT
// Elastic problem: the least common violation, min t such that every limit can be satisfied when relaxed by t
// times its scale.
//
// t* > 0, proved by weak duality, proves the scene infeasible, for any backend. t* < 0 gives a point inside
// all limits, towards which a slightly violating one is pulled back.
#pragma once

#include "core/continuous_problem.hpp"
#include "solvers/certificate/certificate.hpp"
#include "solvers/exchange/exchange.hpp"

#include <memory>

namespace camopt {

/// Variables: those of the base problem, then t >= −least_slack. Cost t.
class ElasticProblem final : public ContinuousProblem {
 public:
    /// Slack of half a limit is deep enough inside.
    static constexpr double least_slack = 0.5;

    /// Refining the elastic problem refines `base`, which must outlive it.
    explicit ElasticProblem(ContinuousProblem& base);
    ~ElasticProblem() override;

    [[nodiscard]] const Nlp& grid() const override;
    [[nodiscard]] Eigen::VectorXd start() const override;
    [[nodiscard]] Eigen::VectorXd completed(const Eigen::VectorXd& x) const override;
    [[nodiscard]] double objective(const Eigen::VectorXd& x) const override;
    [[nodiscard]] std::vector<Violation> violations(const Eigen::VectorXd& x, double slack) const override;
    [[nodiscard]] double worst_of_limits(const Eigen::VectorXd& x) const override;
    int refine(std::span<const Violation> worst) override;
    int refine_pressed(std::span<const Violation> worst, const Eigen::VectorXd& row_multipliers) override;
    [[nodiscard]] Box box(double incumbent, double relaxation) const override;
    [[nodiscard]] bool convex(double incumbent) const override;

 private:
    class Grid;
    ContinuousProblem& base_;
    std::unique_ptr<Grid> grid_;
};

struct Feasibility {
    Candidate point;                    ///< of the base problem, with the least violation
    std::optional<DualityProof> proof;  ///< of infeasibility, where its bound is > 0
    Termination termination = Termination::not_run;
};

/// Convex problems only. Uses the structured solver.
[[nodiscard]] Feasibility find_feasible(ContinuousProblem& problem, const ExchangeOptions& options,
                                        const SolveControl& control);

}  // namespace camopt
