// SPDX-License-Identifier: MIT
// A backend that counts its evaluations.
#pragma once

#include "core/nlp.hpp"
#include "solvers/solver.hpp"

namespace camopt {

/// Wraps every problem in a CountingNlp; the counts of all of them are summed.
class CountingSolver final : public Solver {
 public:
    explicit CountingSolver(std::unique_ptr<Solver> solver) : solver_(std::move(solver)) {}

    [[nodiscard]] std::string_view name() const override { return solver_->name(); }
    [[nodiscard]] BackendResult minimize(const Nlp& problem, const Eigen::VectorXd& start,
                                         const BackendOptions& options,
                                         const SolveControl& control) const override;
    [[nodiscard]] const EvaluationCounts& counts() const { return counts_; }

 private:
    std::unique_ptr<Solver> solver_;
    mutable EvaluationCounts counts_;
};

}  // namespace camopt
