// SPDX-License-Identifier: MIT
//
// Internal to solvers/structured/: a primal–dual interior point method for a ConvexModel.
//
// For every finite bound b of a variable or an inequality row t_b it has the gap g_b > 0 to the bound and
// its multiplier z_b > 0, and solves, for μ → 0,
//     ∇f + C_Eᵀ λ_E − Σ_b σ_b z_b ∇t_b = 0,   C_E x = e,   σ_b (t_b − value_b) = g_b,   g_b z_b = μ,
// σ_b = +1 for lower bounds, −1 for upper ones (range_rows.hpp has them in pairs).
// Gaps and multipliers stay positive; the equations may start violated (infeasible start).
// Source: Mehrotra, On the implementation of a primal-dual interior point method, SIAM J. Optim. 2 (1992);
// Gondzio, Multiple centrality corrections, Comput. Optim. Appl. 6 (1996).
#pragma once

#include "linear/sparse_symmetric.hpp"
#include "solvers/solver.hpp"
#include "solvers/structured/convex_model.hpp"

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <vector>

namespace camopt::structured {

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
    double shift = 1e-9;  ///< regularisation, see condensed_system.hpp
    FactorKind factor = FactorKind::automatic;
    int correctors = 2;      ///< centrality correctors per iteration, at most
    bool suspicious = true;  ///< stop at signs of infeasibility or unboundedness
    bool keep_path = false;  ///< requests InteriorPointResult::path
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

}  // namespace camopt::structured
