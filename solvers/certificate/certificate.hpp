// SPDX-License-Identifier: MIT
// The result and its proof. One verification for every backend.
//
// Proof by weak duality. For multipliers λ (sign as in core/nlp.hpp) and a box [l, u] that contains an
// optimum,
//     f* >= constant − Σ_i λ_i b_i + Σ_j min(r_j l_j, r_j u_j),   r = c + Gᵀλ,
// where row i is g_L <= G_i x <= g_U and b_i = g_U where λ_i > 0, g_L where λ_i < 0. c is the cost's gradient
// at the delivered point (a tangent, hence a lower bound, of a convex cost). The sum is rounded outward. A
// proof of infeasibility is the same bound for the elastic problem: its least common violation exceeds zero.
#pragma once

#include "core/continuous_problem.hpp"
#include "solvers/solver.hpp"

#include <Eigen/SparseCore>

#include <iosfwd>

namespace camopt {

// Why a verdict is not better, each with its word in files and messages.
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
    // About the scene.
    no_feasible_point,       ///< no feasible point was found, and infeasibility is not proved
    limits_contradict,       ///< proved: no feasible motion
    conditions_contradict,   ///< no curve of the spline space meets all the conditions
    limit_broken_at_rest,    ///< a limit is violated where the follower rests
    given_cam,               ///< the motion is that of a cam that exists: nothing was optimized
    limits_within_rounding,  ///< "limits_within_rounding_of_infeasible": no proof for such a point
    // About the proof.
    stationary,          ///< "stationary, not proved optimal"
    free_displacements,  ///< the search over free displacements left a gap
    free_angles,         ///< the search over the angles of a program left a gap
    // Failed tests of the delivered motion.
    breakpoints_too_close,
    coefficients_too_coarse,
    condition_not_met,
    cam_cannot_be_built,
    limit_not_kept,
    objective_not_of_the_curve
};

/// The word in files and messages, as in the comments above if it differs from the name.
[[nodiscard]] const char* name_of(Reason value);
/// The reason of this name; throws InputError for an unknown word.
[[nodiscard]] Reason reason_named(std::string_view name);
/// The reason for a search that ended like this.
[[nodiscard]] Reason reason_of(Termination termination);

/// By its word.
[[nodiscard]] inline bool operator==(Reason value, std::string_view name) {
    return name == name_of(value);
}
std::ostream& operator<<(std::ostream& stream, Reason value);

enum class Verdict { optimal, local, feasible, infeasible, failed };
[[nodiscard]] const char* name_of(Verdict value);
/// A motion that satisfies every limit was found.
[[nodiscard]] constexpr bool has_feasible_motion(Verdict verdict) {
    return verdict == Verdict::optimal || verdict == Verdict::local || verdict == Verdict::feasible;
}

enum class ProofKind {
    none,
    duality,          ///< DualityProof
    any_curve_limit,  ///< a bound for all curves (motions/bounds/any_curve_limit.hpp); free
                      ///< breakpoints
    boxes             ///< a DualityProof for each case of a choice: Certificate::cases
};
[[nodiscard]] const char* name_of(ProofKind value);

/// Everything needed to recompute a lower bound; only rows with a multiplier are stored.
struct DualityProof {
    /// "objective"; "least_common_violation" or "conditions" (then bound > 0 proves infeasibility)
    std::string statement;
    std::vector<std::string> variables;
    Eigen::VectorXd cost;  ///< c
    double constant = 0.0;
    std::vector<std::string> rows;                        ///< names for users; none: those of the origins
    std::vector<RowOrigin> origins;                       ///< where each of them comes from
    Eigen::SparseMatrix<double, Eigen::RowMajor> matrix;  ///< G, rows x variables
    Eigen::VectorXd lower, upper;                         ///< right-hand sides, ±infinity where open
    Eigen::VectorXd multipliers;
    Box box;
    double bound = 0.0;
    /// Above 0: the rows of the limits are relaxed by this times their scale, and the bound holds for every
    /// point that satisfies the limits to within it (solvers/exchange/continuous_solve.cpp).
    double limits_relaxed_by = 0.0;
};

/// The name of a row of a proof, for users.
[[nodiscard]] std::string row_name(const DualityProof& proof, std::size_t row);

/// What a case says of one segment, for programs: the direction of its stroke, or a range of its angle.
struct CasePart {
    int segment = 0;
    std::optional<bool> rises = {};  ///< or rests; false: falls or rests
    std::optional<std::array<double, 2>> angle_deg = {};

    friend bool operator==(const CasePart&, const CasePart&) = default;
};

/// One of the cases that cover the whole: `region` identifies it in words, `parts` in fields; `bound` holds
/// in it. `infeasible`: no feasible point there, and the proof's bound is above 0.
struct CaseProof {
    std::vector<std::string> region;
    double bound = 0.0;
    bool infeasible = false;
    std::shared_ptr<const DualityProof> proof = {};  ///< of a part of the rows: cases may share one
    std::vector<CasePart> parts = {};
};

/// The bound of a stored proof, recomputed from its numbers and rounded outward (long double, less an error
/// term). Throws ModelError for sizes that differ or a multiplier of an infinite right-hand side or bound.
[[nodiscard]] double recomputed_bound(const DualityProof& proof);

/// (objective − bound) / max(1, |objective|), 0 if the bound is above it by round-off. A bound that exceeds
/// the objective by more (bound_passes) does not belong to the point, and has no gap to it.
[[nodiscard]] double relative_gap(double objective, double bound);

/// Whether a bound exceeds an objective by more than `tolerance`, relative: then the point uses the tolerance
/// of its limits and lies outside the problem of the bound.
[[nodiscard]] bool bound_passes(double objective, double bound, double tolerance);

struct BoxProof;  // solvers/certificate/box_proof.hpp

struct Certificate {
    // Compiled once, in the source of this header: copies of so many members take a compiler long.
    Certificate();
    Certificate(const Certificate& other);
    // Not noexcept: sparse matrices of Eigen 3.4 that are moved are copied, for which memory may be missing.
    Certificate(Certificate&& other);  // NOLINT(performance-noexcept-move-constructor)
    Certificate& operator=(const Certificate& other);
    Certificate& operator=(Certificate&& other);  // NOLINT(performance-noexcept-move-constructor)
    ~Certificate();

    Verdict verdict = Verdict::failed;
    Reason reason = Reason::none;       ///< why it is not better
    double objective = infinity;        ///< true objective of the delivered curve
    std::optional<double> lower_bound;  ///< proved
    std::optional<double> gap;          ///< (objective − lower_bound) / max(1, |objective|)
    double worst_violation = infinity;  ///< continuous, relative to each rule's scale; <= 0 is satisfied
    std::optional<double> stationarity;  ///< ‖∇f + Jᵀλ + z‖∞ at the delivered point with the best multipliers
    ProofKind proof_kind = ProofKind::none;
    std::optional<DualityProof> proof;
    std::vector<CaseProof> cases;  ///< ProofKind::boxes: lower_bound is the least of their bounds
    /// ProofKind::boxes without cases: the planes and boxes from which the bound follows.
    std::shared_ptr<const BoxProof> box_proof;
    /// Keys of the limits that were enclosed along all of the delivered motion, and of those that were only
    /// sampled.
    std::vector<std::string> verified, unverified;
};

/// An optimum is proved, or that there is no feasible point.
[[nodiscard]] inline bool is_proved(const Certificate& certificate) {
    return certificate.verdict == Verdict::optimal || certificate.verdict == Verdict::infeasible;
}
/// Whether its proof is one for relaxed limits: only their tolerance gives the problem room.
[[nodiscard]] inline bool is_relaxed(const Certificate& certificate) {
    return certificate.proof && certificate.proof->limits_relaxed_by > 0.0;
}

// Lower bounds from multipliers, and multipliers for backends that have none.

/// Builds the proof from the problem's own derivatives at x (convex problems) and the given row multipliers;
/// those of a missing bound are set to zero. `bound` is filled in.
[[nodiscard]] DualityProof duality_proof(const Nlp& problem, const Eigen::VectorXd& x,
                                         const Eigen::VectorXd& row_multipliers, const Box& box,
                                         const std::string& statement);

/// A variable that only relaxes its rows (a peak) has the reduced cost c_j − Σ λ_i |a_ij|. Where that is
/// below zero by the accuracy of the multipliers, its upper bound counts, which for a peak of little weight
/// is wide: its multipliers, made smaller by what they are too large, prove more.
void balance_peaks(DualityProof& proof);

/// Moves the multipliers to where the reduced costs of variables that may have either sign vanish to
/// rounding, and the bound becomes `target` (the optimum), by nonnegative least squares: a solver's
/// tolerance, times wide boxes, can cost a proof more than its bound. Unchanged where that proves less, and
/// of problems too large for dense factorizations.
void sharpen(DualityProof& proof, double target);

/// Multipliers that fit best: min ‖∇f + Jᵀλ‖² over the rows within `active` of a bound (relative to their
/// size), with the sign of their bound. Solved by the structured solver.
[[nodiscard]] Eigen::VectorXd fitted_multipliers(const Nlp& problem, const Eigen::VectorXd& x, double active,
                                                 const SolveControl& control = {});

/// ‖∇f + Jᵀλ + z‖∞ with the best z for the variable bounds within `active`, plus the worst |λ_i · slack_i|.
[[nodiscard]] double stationarity_of(const Nlp& problem, const Eigen::VectorXd& x,
                                     const Eigen::VectorXd& row_multipliers, double active);

// Removes the proof from a certificate, or puts another one there. For the modules that verify results.

/// No bound, no gap, no proof: the proof belongs to another motion or problem.
inline void forget_proof(Certificate& certificate) {
    certificate.lower_bound.reset();
    certificate.gap.reset();
    certificate.proof.reset();
    certificate.box_proof.reset();
    certificate.proof_kind = ProofKind::none;
}

/// The bound of a relaxation and its proof, and the verdict that follows.
void take_bound(Certificate& certificate, const Certificate& relaxed, double wanted_gap);
/// The same of a motion whose own proof rests on rows that the scene does not have. Boxes of a proof hold
/// motions as good as its own: where the gap stays open, no bound is left.
void settle_by_relaxation(Certificate& certificate, const Certificate& relaxed, double wanted_gap);

}  // namespace camopt
