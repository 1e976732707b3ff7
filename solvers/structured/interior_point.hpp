// SPDX-License-Identifier: MIT
// Internal to solvers/structured/: a primal–dual interior point for a ConvexModel.
//
// Rows that are not equalities get a slack s = C x, r_L <= s <= r_U. With w = (x, s), distances l = w − w_L >
// 0, u = w_U − w > 0 and their multipliers z_l, z_u >= 0 it solves, for μ → 0,
//     ∇f + Cᵀλ − z_l + z_u = 0,   λ = z_u − z_l (slacks),   C x = s,   l z_l = μ,   u z_u = μ.
// Distances and multipliers stay positive; the equations may start violated (infeasible start).
// Source: Mehrotra, On the implementation of a primal-dual interior point method, SIAM J. Optim. 2 (1992);
// Gondzio, Multiple centrality corrections, Comput. Optim. Appl. 6 (1996).
#pragma once

#include "solvers/solver.hpp"
#include "solvers/structured/convex_model.hpp"

#include <Eigen/Core>

#include <algorithm>
#include <chrono>
#include <cmath>

namespace camopt::structured {

/// w-vectors hold the variables first, then the rows. An absent bound has distance 1 and multiplier 0.
struct Iterate {
    Eigen::VectorXd w, lambda;
    Eigen::VectorXd lower_gap, upper_gap, lower_dual, upper_dual;
    [[nodiscard]] auto x(Eigen::Index variables) const { return w.head(variables); }
};

/// Relative errors of the scaled problem.
struct Errors {
    double primal = infinity, dual = infinity, gap = infinity;
    [[nodiscard]] double worst() const { return std::max({primal, dual, gap}); }
};

enum class Stop {
    converged,
    stagnated,  ///< no better iterate for a while
    breakdown,  ///< no factorization, or no step
    iteration_limit,
    time_limit,
    interrupted,
    evaluation_error,
    suspect_infeasible,  ///< the multipliers run away along what looks like a proof of infeasibility
    suspect_unbounded    ///< the point runs away downhill
};

struct InteriorPointLimits {
    double tolerance = 1e-10;  ///< on every member of Errors
    int max_iterations = 200;
    int patience = 12;       ///< iterations without a better iterate
    double shift = 1e-9;     ///< regularisation, see kkt_system.hpp
    int correctors = 2;      ///< centrality correctors an iteration, at most
    bool suspicious = true;  ///< stop at signs of infeasibility or unboundedness
    std::chrono::steady_clock::time_point deadline = std::chrono::steady_clock::time_point::max();
};

struct InteriorPointResult {
    Stop stop = Stop::breakdown;
    Iterate best;   ///< smallest Errors::worst()
    Errors errors;  ///< of `best`
    int iterations = 0;
    [[nodiscard]] bool has_point() const { return std::isfinite(errors.worst()); }
};

[[nodiscard]] InteriorPointResult interior_point(const ConvexModel& model, const Eigen::VectorXd& start,
                                                 const InteriorPointLimits& limits,
                                                 const SolveControl& control);

}  // namespace camopt::structured
