// SPDX-License-Identifier: MIT
// Internal to solvers/structured/: the convex problem, the primal–dual interior point that solves it, and the
// searches by it for feasibility and boundedness.
#pragma once

#include "linear/sparse_symmetric.hpp"
#include "solvers/solver.hpp"

namespace camopt::structured {

// The problem that the interior point solves,
//
//     min f(x)   subject to   x_L <= x <= x_U,   r_L <= C x <= r_U,
//
// f convex, every row with at least one finite side, every variable with x_L < x_U. Usually the scaled form
// of an Nlp (standard_form.hpp) or the elastic problem made of one.

enum class CostKind { linear, quadratic, smooth };

class ConvexCost {
 public:
    virtual ~ConvexCost() = default;
    [[nodiscard]] virtual double value(const Eigen::VectorXd& x) const = 0;
    virtual void gradient(const Eigen::VectorXd& x, Eigen::VectorXd& out) const = 0;
    /// In the order of ConvexModel::hessian.
    virtual void hessian(const Eigen::VectorXd& x, std::span<double> out) const = 0;
};

class LinearCost final : public ConvexCost {
 public:
    explicit LinearCost(Eigen::VectorXd coefficients, double constant = 0.0)
        : coefficients_(std::move(coefficients)), constant_(constant) {}
    [[nodiscard]] double value(const Eigen::VectorXd& x) const override {
        return constant_ + coefficients_.dot(x);
    }
    void gradient(const Eigen::VectorXd&, Eigen::VectorXd& out) const override { out = coefficients_; }
    void hessian(const Eigen::VectorXd&, std::span<double>) const override {}

 private:
    Eigen::VectorXd coefficients_;
    double constant_;
};

struct ConvexModel {
    using Matrix = Eigen::SparseMatrix<double>;
    Matrix rows;  ///< C
    Eigen::VectorXd row_lower, row_upper, x_lower, x_upper;
    SparsityPattern hessian;  ///< lower triangle
    CostKind kind = CostKind::linear;
    /// The user's cost of 1 in these units, <= 1: errors are relative to that or to the cost, whichever is
    /// larger.
    double cost_unit = 1.0;
    std::unique_ptr<ConvexCost> cost;

    [[nodiscard]] Eigen::Index variables() const { return x_lower.size(); }
    [[nodiscard]] Eigen::Index constraints() const { return row_lower.size(); }
    [[nodiscard]] bool is_equality(Eigen::Index row) const { return row_lower[row] == row_upper[row]; }
};

// Internal to solvers/structured/: a primal–dual interior point method for a ConvexModel.
//
// For every finite bound b of a variable or an inequality row t_b it has the gap g_b > 0 to the bound and
// its multiplier z_b > 0, and solves, for μ → 0,
//     ∇f + C_Eᵀ λ_E − Σ_b σ_b z_b ∇t_b = 0,   C_E x = e,   σ_b (t_b − value_b) = g_b,   g_b z_b = μ,
// σ_b = +1 for lower bounds, −1 for upper ones (range_rows.hpp has them in pairs).
// Gaps and multipliers stay positive; the equations may start violated (infeasible start).
// Source: Mehrotra, On the implementation of a primal-dual interior point method, SIAM J. Optim. 2 (1992);
// Gondzio, Multiple centrality corrections, Comput. Optim. Appl. 6 (1996).

struct PrimalDualPoint {
    Eigen::VectorXd x;
    Eigen::VectorXd lambda;  ///< one per row; of an inequality −Σ σ_b z_b over its bounds
};

/// A point near the central path, its products g z about `mu`.
struct CentralPoint {
    PrimalDualPoint point;
    double mu = 0.0;
    double gap = 0.0;  ///< as in Errors
};

/// Relative errors of the scaled problem.
struct Errors {
    double primal = infinity, dual = infinity, gap = infinity;
    [[nodiscard]] double worst() const { return std::max({primal, dual, gap}); }
};

enum class Stop {
    converged,
    stagnated,  ///< no better iterate for several iterations
    breakdown,  ///< no factorization, or no step
    iteration_limit,
    time_limit,
    interrupted,
    evaluation_error,
    suspect_infeasible,  ///< the multipliers diverge along an apparent Farkas ray
    suspect_unbounded    ///< the objective decreases without bound
};

struct InteriorPointLimits {
    double tolerance = 1e-10;  ///< on every member of Errors
    int max_iterations = 200;
    int patience = 12;    ///< iterations without a better iterate
    double shift = 1e-9;  ///< regularisation, see newton_step.hpp
    FactorKind factor = FactorKind::automatic;
    int correctors = 2;      ///< centrality correctors per iteration, at most
    bool suspicious = true;  ///< stop at signs of infeasibility or unboundedness
    bool keep_path = false;  ///< requests InteriorPointResult::path
    /// Every step reduces what is wrong at the point, even where rows are nearly dependent: few problems need
    /// it, and others take several times as long with it.
    bool exact_steps = false;
    Deadline deadline = {};
};

struct InteriorPointResult {
    Stop stop = Stop::breakdown;
    PrimalDualPoint best;  ///< smallest Errors::worst()
    Errors errors;         ///< of `best`
    int iterations = 0;
    std::vector<CentralPoint> path;
    [[nodiscard]] bool has_point() const { return std::isfinite(errors.worst()); }
};

/// A cold start: from any point.
[[nodiscard]] InteriorPointResult interior_point(const ConvexModel& model, const Eigen::VectorXd& start,
                                                 const InteriorPointLimits& limits,
                                                 const SolveControl& control);
/// From a point near the path of a neighbouring model.
[[nodiscard]] InteriorPointResult interior_point(const ConvexModel& model, const CentralPoint& near,
                                                 const InteriorPointLimits& limits,
                                                 const SolveControl& control);

// Internal to solvers/structured/: feasibility, and boundedness of the cost on the feasible set.
//
// Elastic problem:  min t   subject to   r_L − t <= C x <= r_U + t,  x_L <= x <= x_U,  t >= 0. It always has
// a solution. t* > 0 means infeasible, and its row multipliers are the proof: Cᵀλ + z = 0 and −Σ λ_i b_i − Σ
// z_j x_bound_j = t*, Σ |λ_i| = 1. Recession problem: min ∇fᵀd over directions d with |d| <= 1 that no bound,
// row or curvature limits; a negative optimum means unbounded.

struct ElasticResult {
    Stop stop = Stop::breakdown;
    Eigen::VectorXd x;       ///< point of least common violation
    double violation = 0.0;  ///< t*
    Eigen::VectorXd lambda;
    double accuracy = infinity;  ///< Errors::worst() of the solution
    int iterations = 0;
};
[[nodiscard]] ElasticResult least_violation(const ConvexModel& model, const Eigen::VectorXd& start,
                                            const InteriorPointLimits& limits, const SolveControl& control);

struct RecessionResult {
    bool descends = false;  ///< a direction of unlimited descent exists (given a feasible point)
    Eigen::VectorXd direction;
    int iterations = 0;
};
/// Of a smooth cost only the gradient and Hessian at `point` are used.
[[nodiscard]] RecessionResult recession(const ConvexModel& model, const Eigen::VectorXd& point,
                                        const InteriorPointLimits& limits, const SolveControl& control);

}  // namespace camopt::structured
