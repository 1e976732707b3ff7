// SPDX-License-Identifier: MIT
// The options of camopt's own solver (solvers/structured/structured_solver.hpp), and its entry in the
// registry.
#pragma once

#include "linear/sparse_symmetric.hpp"
#include "solvers/registry.hpp"

namespace camopt {

/// Of "regularisation" where conditions nearly depend on each other, or segments differ by orders of
/// magnitude: the default holds their multipliers back, and errors fall late.
inline constexpr double fine_regularisation = 1e-12;

struct StructuredOptions {
    /// Iterations, the elastic phase apart; BackendOptions::max_iterations cuts it further. >= 1. Problems
    /// that need more than 60 are badly posed.
    int max_iterations = 200;
    /// Diagonal shift of the scaled Newton matrix, in [1e-14, 1e-3]. Larger where native_status names
    /// breakdowns.
    double regularisation = 1e-9;
    /// Centrality correctors an iteration at most, 0 … 10. More for large problems, where a factorization
    /// costs much more than a solve.
    int correctors = 1;
    /// Of the Newton matrix (linear/sparse_symmetric.hpp). automatic: the fastest as measured.
    FactorKind factor = FactorKind::automatic;
    /// Iterations without a better point before the search ends with the best one. >= 2.
    int patience = 12;
    /// Of problems with nonlinear rows, or not known to be convex: linearizations at most; iterations of
    /// BackendOptions count these. >= 1.
    int max_passes = 200;
    /// How far the first linearization is trusted, in units of a variable, or of its value where that is
    /// larger; in [1e-8, 1e8]. Smaller where first steps are rejected.
    double first_radius = 1.0;
    void validate() const;  ///< throws InputError
};

/// Reads the members by name. Throws InputError for an unknown
/// name, a value of the wrong kind or out of range.
[[nodiscard]] StructuredOptions structured_options(const std::map<std::string, OptionValue>& native);

/// Always present: it needs only Eigen.
[[nodiscard]] SolverEntry structured_entry();

}  // namespace camopt
