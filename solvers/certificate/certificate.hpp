// SPDX-License-Identifier: MIT
// What was found, and the proof of it. One judge for every backend.
//
// Proof by weak duality. For multipliers λ (sign as in core/nlp.hpp) and a box [l, u] that holds an optimum,
//     f* >= constant − Σ_i λ_i b_i + Σ_j min(r_j l_j, r_j u_j),   r = c + Gᵀλ,
// where row i is g_L <= G_i x <= g_U and b_i = g_U where λ_i > 0, g_L where λ_i < 0. c is the cost's gradient
// at the delivered point (a tangent, hence a lower bound, of a convex cost). The sum is rounded outward. A
// proof of infeasibility is the same bound for the elastic problem: its least common violation exceeds zero.
#pragma once

#include "core/continuous_problem.hpp"
#include "core/numbers/extremum.hpp"
#include "core/nlp.hpp"
#include "solvers/solver.hpp"

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <iosfwd>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace camopt {

// Why a verdict is not better than it is, each with the word that files and messages have for it.
enum class Reason {
    none,  ///< "": nothing is missing
    // How the search ended: as Termination.
    not_run,
    converged,
    acceptable,
    infeasible,
    unbounded,
    iteration_limit,
    time_limit,
    interrupted,
    numerical_failure,
    evaluation_error,
    unsupported,
    // What is known of the scene.
    no_feasible_point,       ///< nothing that keeps the limits was found, and no proof that there is nothing
    limits_contradict,       ///< proved: no motion keeps them
    conditions_contradict,   ///< no curve of the spline space meets all the conditions
    limit_broken_at_rest,    ///< a limit is broken where the follower stands
    limits_within_rounding,  ///< "limits_within_rounding_of_infeasible": of such a point nothing is proved
    // How far the proof came.
    stationary,          ///< "stationary, not proved optimal"
    free_displacements,  ///< the search over free displacements left a gap
    free_angles,         ///< the search over the angles of a program left a gap
    // What the delivered motion failed by.
    breakpoints_too_close,
    coefficients_too_coarse,
    condition_not_met,
    cam_cannot_be_built,
    limit_not_kept,
    objective_not_of_the_curve
};

/// The word in files and messages, as in the comments above where it is not the name.
[[nodiscard]] const char* name_of(Reason value);
/// The reason of this name; throws InputError for a word that is none.
[[nodiscard]] Reason reason_named(std::string_view name);
/// A search that ended like this is the reason.
[[nodiscard]] Reason reason_of(Termination termination);

/// By its word.
[[nodiscard]] inline bool operator==(Reason value, std::string_view name) {
    return name == name_of(value);
}
std::ostream& operator<<(std::ostream& stream, Reason value);

enum class Verdict { optimal, local, feasible, infeasible, failed };
[[nodiscard]] const char* name_of(Verdict value);

enum class ProofKind {
    none,
    duality,          ///< DualityProof
    any_curve_limit,  ///< no curve of any kind is better (motions/bounds/any_curve_limit.hpp); free
                      ///< breakpoints
    boxes             ///< a DualityProof for each case of a choice: Certificate::cases
};
[[nodiscard]] const char* name_of(ProofKind value);

/// Everything needed to recompute a lower bound by hand; only rows with a multiplier are kept.
struct DualityProof {
    /// "objective"; "least_common_violation" or "conditions" (then bound > 0 proves infeasibility)
    std::string statement;
    std::vector<std::string> variables;
    Eigen::VectorXd cost;  ///< c
    double constant = 0.0;
    std::vector<std::string> rows;                        ///< names for people; none: those of the origins
    std::vector<RowOrigin> origins;                       ///< where each of them comes from
    Eigen::SparseMatrix<double, Eigen::RowMajor> matrix;  ///< G, rows x variables
    Eigen::VectorXd lower, upper;                         ///< right sides, ±infinity where open
    Eigen::VectorXd multipliers;
    Box box;
    double bound = 0.0;
    /// Above 0: the rows of the limits stand moved out by this times their scale, and the bound is of every
    /// point that keeps the limits to within it (solvers/exchange/continuous_solve.cpp).
    double limits_relaxed_by = 0.0;
};

/// What a row of a proof is called, for people.
[[nodiscard]] std::string row_name(const DualityProof& proof, std::size_t row);

/// One of the cases that make up the whole: `region` says which, `bound` holds in it. `infeasible`: nothing
/// keeps the limits there, and the proof's bound is above 0.
struct CaseProof {
    std::vector<std::string> region;
    double bound = 0.0;
    bool infeasible = false;
    std::shared_ptr<const DualityProof> proof;  ///< of a part of the rows: cases may share one
};

/// The bound of a stored proof, recomputed from its own numbers and rounded outward (long double, less an
/// error term). Throws ModelError where sizes differ or a multiplier leans on an infinite right side or box.
[[nodiscard]] double recomputed_bound(const DualityProof& proof);

/// (objective − bound) / max(1, |objective|), 0 where the bound is above by rounding. A bound that passes the
/// objective by more (bound_passes) is none of the point, and has no gap to it.
[[nodiscard]] double relative_gap(double objective, double bound);

/// Whether a bound lies above an objective by more than `tolerance`, relative: then the point lies outside
/// the problem that the bound is of, by using the tolerance of its limits.
[[nodiscard]] bool bound_passes(double objective, double bound, double tolerance);

struct BoxProof;  // solvers/certificate/box_proof.hpp

struct Certificate {
    Verdict verdict = Verdict::failed;
    Reason reason = Reason::none;       ///< why it is not better
    double objective = infinity;        ///< true objective of the delivered curve
    std::optional<double> lower_bound;  ///< proved
    std::optional<double> gap;          ///< (objective − lower_bound) / max(1, |objective|)
    double worst_violation = infinity;  ///< continuous, relative to each rule's scale; <= 0 is kept
    std::optional<double> stationarity;  ///< ‖∇f + Jᵀλ + z‖∞ at the delivered point with the best multipliers
    ProofKind proof_kind = ProofKind::none;
    std::optional<DualityProof> proof;
    std::vector<CaseProof> cases;  ///< ProofKind::boxes: lower_bound is the least of their bounds
    /// ProofKind::boxes without cases: the planes and boxes that the bound follows from.
    std::shared_ptr<const BoxProof> box_proof;
    /// Keys of the limits that were enclosed along all of the delivered motion, and of those that were looked
    /// at in places alone, however close.
    std::vector<std::string> verified, unverified;
};

}  // namespace camopt
