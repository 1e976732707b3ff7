// SPDX-License-Identifier: MIT
// Searches of a problem that is not convex, one after the other from seeded starts, on one grid that keeps
// what each of them added. One that comes next to the best motion of those before it ends there, where its
// solver asks (SolveControl::known): it would find the same minimum again.
#pragma once

#include "objectives/grid/cam_problem.hpp"
#include "solvers/exchange/exchange.hpp"

namespace camopt {

/// One search, and the multipliers of its last grid.
struct SearchState {
    Candidate found;
    Eigen::VectorXd multipliers;
    bool converged = false;  ///< to a minimum
};

/// What it is given by reference outlives it.
class StartSearch {
 public:
    StartSearch(CamProblem problem, const Solver& solver, const ExchangeOptions& exchange,
                const JudgeOptions& judge, const SolveControl& control)
        : problem_(std::move(problem)),
          solver_(solver),
          exchange_(exchange),
          judge_(judge),
          control_(control) {}

    /// Starts of these numbers: a motion that the scene brings (CamModel::start_design), `relaxed` where it
    /// is not empty, the smoothest motion, random ones.
    void run(int first, int end, unsigned seed, const Eigen::VectorXd& relaxed);
    void run_from(const Eigen::VectorXd& start);
    /// Of a neighbouring problem's motion: to its end, wherever that lies.
    void continue_from(const Eigen::VectorXd& x);

    [[nodiscard]] const SearchState& best() const { return best_; }
    /// Something that keeps the limits.
    [[nodiscard]] bool found() const {
        return best_.found.x.size() > 0 && best_.found.violation <= judge_.tolerance;
    }
    [[nodiscard]] int ran() const { return ran_; }
    [[nodiscard]] const ExchangeResult& totals() const { return totals_; }
    [[nodiscard]] const CamProblem& problem() const { return problem_; }

 private:
    [[nodiscard]] Eigen::VectorXd start_of(int index, unsigned seed, const Eigen::VectorXd& relaxed) const;
    [[nodiscard]] Eigen::VectorXd start_from(const Eigen::VectorXd& design) const;
    bool ends(int done);
    [[nodiscard]] SolveControl beside_best(SolveControl control) const;
    SearchState search(const Eigen::VectorXd& start, const SolveControl& control);
    void keep(SearchState search);

    CamProblem problem_;
    const Solver& solver_;
    const ExchangeOptions& exchange_;
    const JudgeOptions& judge_;
    const SolveControl& control_;
    SearchState best_;
    ExchangeResult totals_;
    int ran_ = 0;
};

}  // namespace camopt
