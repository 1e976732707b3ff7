// SPDX-License-Identifier: MIT
// Internal to solvers/structured/: sequential quadratic programming (S l1 QP with a trust region) for
// problems with nonlinear rows, or not known to be convex.
//
// Each pass linearizes the nonlinear rows at the current point x and solves, by the interior point for linear
// rows,   min ∇fᵀd + ½ dᵀHd + ν t   over steps d in a trust region, with linear rows enforced and nonlinear
// ones relaxed by t w_i (step problem of linearized_problem.hpp; t is omitted once the rows are consistent).
// H is the Lagrangian's Hessian, convexified. The merit function is f + ν max_i violation_i / w_i; where the
// curvature of the rows spoils a good step, they are linearized again with their values at its end
// (second-order correction). Convex: tangents are cuts, so contradicting tangents prove infeasibility.
// Sources: Fletcher, Practical Methods of Optimization (1987), section 14.4 (S l1 QP); Conn, Gould, Toint,
// Trust-Region Methods (2000), chapter 15.
#pragma once

#include "solvers/backend_support.hpp"
#include "solvers/structured/linear_rows_solver.hpp"
#include "solvers/structured/linearized_problem.hpp"
#include "solvers/structured/standard_form.hpp"

namespace camopt::structured {

[[nodiscard]] BackendResult sequential_minimize(const Nlp& problem, const Eigen::VectorXd& start,
                                                const BackendOptions& options, const SolveControl& control);

// The state of one sequential solve.

/// Relative length of a step from which on its rows are taken for the active ones.
inline constexpr double near_by = 0.1;
/// t below which the linearized rows need no relaxation.
inline constexpr double free_elastic = 1e-8;

// One step of the sequential method, by the interior point for linear rows.
struct Step {
    bool usable = false;  ///< accurate enough to be tried
    Stop stop = Stop::breakdown;
    Eigen::VectorXd step;         ///< d
    double elastic = 0.0;         ///< t
    Eigen::VectorXd multipliers;  ///< of the Nlp's rows
    [[nodiscard]] bool stopped() const { return stop == Stop::time_limit || stop == Stop::interrupted; }
};

class StepSolver {
 public:
    StepSolver(const Nlp& problem, const InteriorPointLimits& limits, const SolveControl& control)
        : problem_(problem), limits_(limits), control_(control) {}

    [[nodiscard]] Step solve(const NlpPoint& point, const StepModel& model);

    /// Without relaxation, by the rows that carry these multipliers (active_set_step.hpp).
    [[nodiscard]] Step solve_held(const RowMatrix& jacobian, const StepModel& model,
                                  const Eigen::VectorXd& multipliers) const;

    /// With elastic rows, and with a penalty ν large enough: ν grows until the step reaches its part of the
    /// least violation that the linearized rows allow. Source: Byrd, Nocedal, Waltz, Steering exact penalty
    /// methods for nonlinear programming, Optim. Methods Softw. 23 (2008).
    struct Steered {
        Step step;
        Eigen::VectorXd least_multipliers;  ///< with Σ |λ_i| w_i = 1, if least_elastic was computed
        double least_elastic = 0.0;         ///< of any step; the violation itself if not computed
    };
    [[nodiscard]] Steered solve_elastic(const NlpPoint& point, StepModel& model, double violation);

    [[nodiscard]] int interior_iterations() const { return iterations_; }

 private:
    const Nlp& problem_;
    InteriorPointLimits limits_;
    const SolveControl& control_;
    [[nodiscard]] InteriorPointResult solve_form(const LinearizedProblem& linearized,
                                                 const StandardForm& form, const NlpPoint& point,
                                                 const StepModel& model, InteriorPointLimits limits);
    int iterations_ = 0;
    std::optional<PathPoint> near_;  ///< on the central path of the last problem without relaxation
};

class SequentialRun {
 public:
    SequentialRun(const Nlp& problem, const BackendOptions& options, const SolveControl& control);
    BackendResult run(const Eigen::VectorXd& start);

 private:
    std::optional<BackendResult> begin(const Eigen::VectorXd& start);
    [[nodiscard]] Eigen::VectorXd nudged() const;
    void take_multipliers();
    [[nodiscard]] bool near_known() const;
    std::optional<BackendResult> pass();
    void linearize();
    void convexify();
    [[nodiscard]] bool drop_left_rows(const Step& step);
    [[nodiscard]] StepModel step_model() const;
    Step next_step(StepModel& model);
    [[nodiscard]] Step held_step(const StepModel& model);
    std::optional<BackendResult> contradiction();
    [[nodiscard]] bool settled(const Step& step);
    bool take(const StepModel& model, Step step);
    [[nodiscard]] BackendResult finished() const;
    [[nodiscard]] BackendResult infeasible() const;
    [[nodiscard]] bool hopeless(double least_elastic);
    [[nodiscard]] bool stationary_in_violation(double least_elastic) const;
    void adapt_penalty(const StepModel& model, const Step& step);
    [[nodiscard]] double slope_change(const Eigen::VectorXd& step) const;
    [[nodiscard]] Eigen::VectorXd corrected_rows(const NlpPoint& trial, const Eigen::VectorXd& step) const;
    [[nodiscard]] NlpPoint moved(const Eigen::VectorXd& step) const;
    [[nodiscard]] double violation(const NlpPoint& point) const {
        return violation_of(shape_, point.rows, false);
    }
    /// Its relaxed rows carry all of ν. Where they are convex their curvature limits no step wrongly.
    [[nodiscard]] bool saturates(const Step& step) const {
        return !shape_.convex && step.elastic > free_elastic;
    }
    [[nodiscard]] double merit(const NlpPoint& point) const {
        return point.cost + penalty_ * violation(point);
    }
    /// Twice what makes it exact.
    [[nodiscard]] static double penalty_for(double needed) { return 2.0 * needed + 1e-6; }
    [[nodiscard]] bool kept(const NlpPoint& point) const {
        return keeps_rows(shape_, point, jacobian_, options_.tolerance);
    }
    [[nodiscard]] double cost_size() const { return std::max(1.0, std::abs(here_.cost)); }
    BackendResult ended(Termination termination, std::string why) const;

    const Nlp& problem_;
    const NlpShape& shape_;
    const BackendOptions& options_;
    const SolveControl& control_;
    SolveGuard guard_;
    StepSolver steps_;
    int most_passes_;
    Eigen::VectorXd weights_, reach_;
    std::vector<bool> curved_;  ///< variables in which something is not linear
    PatternedMatrix<RowMatrix> jacobian_pattern_;
    PatternedMatrix<Eigen::SparseMatrix<double>> hessian_pattern_;
    HessianConvexifier convexifier_;
    NlpPoint here_;
    RowMatrix jacobian_;
    ActiveRows active_;  ///< the active set of hessian_
    ConvexifiedHessian hessian_;
    Eigen::SparseMatrix<double> true_hessian_;
    Eigen::VectorXd multipliers_, least_multipliers_;
    double radius_, penalty_ = 1.0, last_length_ = infinity, least_elastic_ = 0.0;
    bool fresh_ = true, relaxed_ = true, spoiled_ = false;
    double marked_violation_ = infinity;
    int marked_pass_ = 0, reductions_ = 0;
    bool nudged_ = false, shrunk_ = false, flat_ = false;
    bool saturated_ = false;             ///< the multipliers are those of relaxed rows, which carry all of ν
    bool warm_ = false;                  ///< started with the multipliers of a neighbouring problem
    bool repairing_ = false;             ///< the start violates linear rows, which the first step satisfies
    Eigen::VectorXd known_multipliers_;  ///< at BackendOptions::near
    int passes_ = 0, polishing_ = 0, failures_ = 0, patience_ = 0;
    struct Best {
        NlpPoint point;
        Eigen::VectorXd multipliers;
        double error = infinity;  ///< stationarity or violation
        bool kept = false;        ///< every row to the tolerance
    };
    std::optional<Best> best_;
};

}  // namespace camopt::structured
