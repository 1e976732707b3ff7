// SPDX-License-Identifier: MIT
// Problems that are not convex: a convex relaxation first, then a search from several starts.
//
// The relaxation leaves out every rule that is not known to be convex. Where its optimum keeps those rules
// too, it is the optimum of the whole, proved. Where it has no motion at all, neither has the whole.
// Otherwise its bound stands beside the best of the seeded starts (StartKind), and where neither settles it
// the best motion is bounded over boxes (studies/bound/box_bound.hpp).
//
// The searches run one after the other on one grid that keeps what each of them added. One that comes next to
// the best motion of those before it ends there, where its solver asks (SolveControl::known): it would find
// the same minimum again. Where all of them found nothing within the limits, the plan's next solver begins
// them again.
#pragma once

#include "studies/search/planned_run.hpp"

namespace camopt {

/// The entries whose motion is nearest to another one, of the same space written otherwise.
[[nodiscard]] Eigen::VectorXd same_motion(const MotionFamily& family, const MotionChain& motion);

/// One search, and the multipliers of its last grid.
struct SearchState {
    Candidate found;
    Eigen::VectorXd multipliers;
    bool converged = false;  ///< to a minimum
};

/// What it is given by reference outlives it.
class StartSearch {
 public:
    StartSearch(CamProblem problem, const Solver& solver, ExchangeOptions exchange, const JudgeOptions& judge,
                const SolveControl& control)
        : problem_(std::move(problem)),
          solver_(&solver),
          exchange_(std::move(exchange)),
          judge_(judge),
          control_(&control) {}

    /// Starts of these numbers (start_kind()); relaxed: empty if there is none.
    void run(int first, int end, unsigned seed, const Eigen::VectorXd& relaxed);
    void run_from(const Eigen::VectorXd& start);
    /// Of a neighbouring problem's motion: to its end, wherever that lies.
    void continue_from(const Eigen::VectorXd& x);
    /// Another backend, without the options of the first one; its starts count anew.
    void go_on_with(const Solver& solver, const SolveControl& control);

    [[nodiscard]] const SearchState& best() const { return best_; }
    /// Something that keeps the limits.
    [[nodiscard]] bool found() const {
        return best_.found.x.size() > 0 && best_.found.violation <= judge_.tolerance;
    }
    [[nodiscard]] int ran() const { return ran_; }
    [[nodiscard]] const ExchangeResult& totals() const { return totals_; }
    [[nodiscard]] const CamProblem& problem() const { return problem_; }
    /// Of all searches.
    [[nodiscard]] const ContinuousSeconds& seconds() const { return seconds_; }

 private:
    [[nodiscard]] Eigen::VectorXd start_of(int index, unsigned seed, const Eigen::VectorXd& relaxed) const;
    [[nodiscard]] Eigen::VectorXd start_from(const Eigen::VectorXd& design) const;
    bool ends(int done);
    [[nodiscard]] SolveControl beside_best(SolveControl control) const;
    SearchState search(const Eigen::VectorXd& start, const SolveControl& control);
    void keep(SearchState search);

    CamProblem problem_;
    const Solver* solver_;
    ExchangeOptions exchange_;
    const JudgeOptions& judge_;
    const SolveControl* control_;
    SearchState best_;
    ExchangeResult totals_;
    ContinuousSeconds seconds_;
    int ran_ = 0;
};

struct StartsResult {
    ContinuousResult result;
    int starts = 0;  ///< searches that ran; 0 where the relaxation settled everything
    std::shared_ptr<CamProblem> relaxation = {};  ///< that did; `result` is its optimum
    bool next_solver_ran = false, found_by_next = false;
};

/// model: that of the run.
[[nodiscard]] StartsResult solve_from_starts(const PlannedRun& run, const CamModel& model,
                                             const Solver& solver);

}  // namespace camopt
