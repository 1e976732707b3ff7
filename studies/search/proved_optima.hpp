// SPDX-License-Identifier: MIT
// Proved optima of a convex scene, and proofs for other weights of its peaks or other limits on them.
//
// Weights. // f(w) = min over all motions of w · p, with the peaks p = (V, A, J, …), is concave and piecewise
// linear in w: a motion is optimal for a whole cone of weights, and for another weight of that cone only its
// multipliers are missing. With the Jacobian G of the rows at the motion and multipliers λ for the cost c,
// Gᵀλ = −c, those for c + δ are fitted by weighted least squares,
//
//     λ(δ) = λ + D δ,   D = −Λ G (Gᵀ Λ G)⁻¹,   Λ = diag |λ|.
//
// Λ leaves inactive rows at 0 and keeps the relative change of every multiplier small, so that signs last as
// long as they can; D is computed once for each optimum. Where signs turn all the same, the fit is repeated
// around the new λ. Any multipliers give a true bound (weak duality,
// solvers/certificate/certificate.hpp): where it meets w · p, the motion is proved optimal without a solve,
// and has its own certificate. Of equal optima the smoothest is the same: they are those of equal p.
//
// Limits. The numbers of limits on peaks are right-hand sides b of rows. Multipliers for one b are feasible
// for every other: they bound the optimum for b + δ by f − λᵀδ, exactly as long as the same rows carry them.
// Where they determine the motion, it moves with b by
//
//     x(δ) = x + M δ,   M = (Nᵀ N)⁻¹ Nᵀ E,   N: these rows and the equalities, E: where δ stands in their b.
//
// M is computed once for each optimum. Where the objective of x(δ) meets the bound it is proved, with its own
// certificate, and there is no tie to break.
#pragma once

#include "objectives/grid/cam_problem.hpp"
#include "studies/delivered/solution.hpp"

#include <list>
#include <mutex>

namespace camopt {

/// One rise, or rise and return, of the same lift or another one, with no cam, follower train or motor and no
/// set points, and the same limits with other numbers for the peaks of both sides: but for these numbers the
/// normalised motions and their costs are the same.
[[nodiscard]] bool differ_in_peak_limits_only(const Scene& one, const Scene& other);

/// A motion that is proved for one scene. Threads may ask it concurrently.
class ProvedOptimum {
 public:
    /// multipliers: of the rows of the problem's grid, as many as there were when it was proved.
    ProvedOptimum(CamProblem problem, Eigen::VectorXd x, Eigen::VectorXd multipliers);

    /// What solving its scene came to; `number`: of that solve, for those who count them.
    void join(Solution solution, int number);
    [[nodiscard]] const Solution& solution() const { return solution_; }
    [[nodiscard]] Eigen::Index variables() const { return x_.size(); }
    /// Of scenes that differ in weights alone the objective of the motion for them; of scenes that differ in
    /// limits alone the bound for them, with the opposite sign. Of several optima the one that may serve a
    /// scene has the least.
    [[nodiscard]] double rank_for(const Scene& scene) const;
    /// The solution of such a scene; none where the multipliers do not prove the motion to within the
    /// tolerance of the scene's solver.
    [[nodiscard]] std::optional<Solution> solution_for(const Scene& scene);

 private:
    [[nodiscard]] std::vector<double> weights_for(const Scene& scene) const;
    [[nodiscard]] Eigen::MatrixXd step_for(const Eigen::VectorXd& multipliers, Eigen::MatrixXd rest);
    [[nodiscard]] Eigen::VectorXd fitted(const Eigen::VectorXd& cost);
    [[nodiscard]] Eigen::MatrixXd moves() const;
    [[nodiscard]] std::vector<double> uppers_for(const Scene& scene) const;
    void pose(const Scene& scene);
    /// Of x with these multipliers; no bound where there is none.
    [[nodiscard]] Certificate proved(const Eigen::VectorXd& x, const Eigen::VectorXd& multipliers) const;
    [[nodiscard]] Certificate certificate_for(const Scene& scene);
    [[nodiscard]] std::optional<Solution> same_motion_for(const Scene& scene);
    [[nodiscard]] std::optional<Solution> moved_motion_for(const Scene& scene);

    std::mutex busy_;  ///< the problem takes the weights and limits of the scene in question
    CamProblem problem_;
    Eigen::VectorXd x_, multipliers_, cost_;
    std::vector<int> weighed_;                    ///< variables that are peaks with a weight
    Eigen::MatrixXd slopes_;                      ///< D: rows x weighed; empty: not yet computed
    Eigen::SparseMatrix<double> rows_, columns_;  ///< G and its transpose; empty: not yet computed
    Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factor_;
    std::optional<Eigen::MatrixXd> moves_;  ///< of moves(); none: not yet computed
    Solution solution_;
    int number_ = 0;
};

/// The optima of one scene, the one used last in front.
class ProvedOptima {
 public:
    /// A convex problem is proved: its optimum waits for its solution. Nothing of it is kept where that does
    /// not come.
    void propose(CamProblem problem, const Eigen::VectorXd& x, const Eigen::VectorXd& multipliers);
    void withdraw() { proposed_.reset(); }
    /// The solution of `scene`, whose optimum was proposed. Optima of other scenes are let go.
    void settle(const Solution& solution, int number);

    /// None: it must be solved. Also where `accepts` refuses the solution of another motion than a known one.
    [[nodiscard]] std::optional<Solution> proved(const Scene& scene,
                                                 const std::function<bool(const Solution&)>& accepts);

 private:
    std::shared_ptr<ProvedOptimum> proposed_;
    std::list<std::shared_ptr<ProvedOptimum>> known_;
};

}  // namespace camopt
