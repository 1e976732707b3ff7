// SPDX-License-Identifier: MIT
// Lower bounds from multipliers, and multipliers for backends that have none. See certificate.hpp for the
// formula.
#pragma once

#include "core/nlp.hpp"
#include "solvers/certificate/certificate.hpp"
#include "solvers/solver.hpp"

#include <string>

namespace camopt {

/// Builds the proof from the problem's own derivatives at x (convex problems) and the given row multipliers;
/// those of a missing bound are set to zero. `bound` is filled in.
[[nodiscard]] DualityProof duality_proof(const Nlp& problem, const Eigen::VectorXd& x,
                                         const Eigen::VectorXd& row_multipliers, const Box& box,
                                         const std::string& statement);

/// Multipliers that fit best: min ‖∇f + Jᵀλ‖² over the rows within `active` of a bound (relative to their
/// size), with the sign of their bound. Solved by the structured solver.
[[nodiscard]] Eigen::VectorXd fitted_multipliers(const Nlp& problem, const Eigen::VectorXd& x, double active,
                                                 const SolveControl& control = {});

/// ‖∇f + Jᵀλ + z‖∞ with the best z for the variable bounds within `active`, plus the worst |λ_i · slack_i|.
[[nodiscard]] double stationarity_of(const Nlp& problem, const Eigen::VectorXd& x,
                                     const Eigen::VectorXd& row_multipliers, double active);

// Removes the proof from a certificate. For the modules that verify results.

/// No bound, no gap, no proof: the proof belongs to another motion or problem.
inline void forget_proof(Certificate& certificate) {
    certificate.lower_bound.reset();
    certificate.gap.reset();
    certificate.proof.reset();
    certificate.box_proof.reset();
    certificate.proof_kind = ProofKind::none;
}

}  // namespace camopt
