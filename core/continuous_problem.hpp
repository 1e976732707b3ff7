// SPDX-License-Identifier: MIT
// The semi-infinite problem: constraints that hold at every cam angle, not only at samples.
//
// A grid Nlp is a relaxation with the rows of finitely many angles. The exchange driver solves it, asks for
// the continuous maxima of violation and adds their rows, until the worst one is below tolerance.
#pragma once

#include "core/nlp.hpp"

namespace camopt {

/// A local maximum over the cam angle of the violation of one rule.
struct Violation {
    int rule = 0;         ///< index of the rule in the problem
    Extremum where;       ///< the rule's own value there
    double amount = 0.0;  ///< relative to the rule's scale; > 0 is violated, < 0 is slack
    bool limit = false;   ///< a limit of the user's scene, not a peak variable that lags behind its curve
    /// Of rules over the whole motion: the parameters of the row besides the cam angle (a speed, …).
    std::vector<double> setting = {};
};

/// A box proved to hold at least one minimizer (or, for an infeasibility proof, every feasible point).
struct Box {
    Eigen::VectorXd lower, upper;
};

class ContinuousProblem {
 public:
    virtual ~ContinuousProblem() = default;

    /// The current grid problem. Stays valid until the next refine().
    [[nodiscard]] virtual const Nlp& grid() const = 0;

    /// A starting point: satisfies the equalities; limits may be violated.
    [[nodiscard]] virtual Eigen::VectorXd start() const = 0;

    /// x with its equalities met to round-off and its peak variables set to the continuous peaks of its
    /// curve, so that only user limits can be violated. cost(completed(x)) is the true objective.
    [[nodiscard]] virtual Eigen::VectorXd completed(const Eigen::VectorXd& x) const = 0;

    /// The true objective of the curve behind x; equals grid().cost(completed(x)).
    [[nodiscard]] virtual double objective(const Eigen::VectorXd& x) const = 0;

    /// The continuous local maxima of every rule at x, worst first, slack ones within `slack` included.
    [[nodiscard]] virtual std::vector<Violation> violations(const Eigen::VectorXd& x, double slack) const = 0;

    /// Adds rows at and next to these maxima; old rows keep their numbers. Returns the number of rows added:
    /// 0 when all exist already.
    virtual int refine(std::span<const Violation> worst) = 0;

    /// The same, with the active rows of the current grid: between active rows of one rule on both sides of a
    /// maximum, their weighted mean locates it to second order in their distance, and rows close around it
    /// are added. `row_multipliers`: of the grid's point at which the maxima were found.
    virtual int refine_pressed(std::span<const Violation> worst, const Eigen::VectorXd& /*row_multipliers*/) {
        return refine(worst);
    }

    /// The largest violation of any limit of the scene at x; -1 where all are satisfied with a larger margin
    /// than that.
    [[nodiscard]] virtual double worst_of_limits(const Eigen::VectorXd& x) const {
        double worst = -1.0;
        for (const Violation& violation : violations(x, 1.0))
            if (violation.limit) worst = std::max(worst, violation.amount);
        return worst;
    }

    /// Bounds on x proved to contain an optimum of the problem whose limits are relaxed by `relaxation` times
    /// their scales, given a curve with objective `incumbent` (infinity: none is known, then the box contains
    /// every feasible curve). Unbounded entries are ±infinity.
    [[nodiscard]] virtual Box box(double incumbent, double relaxation) const = 0;

    /// Whether the problem is proved convex over that box, so that tangents of its rows are bounds.
    [[nodiscard]] virtual bool convex(double /*incumbent*/) const { return grid().shape().convex; }

 protected:
    ContinuousProblem() = default;
    ContinuousProblem(const ContinuousProblem&) = default;
    ContinuousProblem& operator=(const ContinuousProblem&) = default;
};

}  // namespace camopt
