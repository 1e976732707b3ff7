// SPDX-License-Identifier: MIT
// Proved optima of a convex scene, and proofs that they are optima for other weights of its peaks too.
//
// f(w) = min over all motions of w · p, with the peaks p = (V, A, J, …), is concave and piecewise linear in
// w: a motion is optimal for a whole cone of weights, and for another weight of that cone only its
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
// Source: T. Gal, Postoptimal Analyses, Parametric Programming, and Related Topics (1995).
#pragma once

#include "objectives/grid/cam_problem.hpp"
#include "studies/delivered/solution.hpp"

#include <list>
#include <mutex>

namespace camopt {

/// A motion that is proved for the weights of one scene. Threads may ask it concurrently.
class ProvedOptimum {
 public:
    /// multipliers: of the rows of the problem's grid, as many as there were when it was proved.
    ProvedOptimum(CamProblem problem, Eigen::VectorXd x, Eigen::VectorXd multipliers);

    /// What solving its scene came to; `number`: of that solve, for those who count them.
    void join(Solution solution, int number);
    [[nodiscard]] const Solution& solution() const { return solution_; }
    [[nodiscard]] Eigen::Index variables() const { return x_.size(); }
    /// Of the motion for the weights of a scene that differs in these alone.
    [[nodiscard]] double objective_for(const Scene& scene) const;
    /// The solution of such a scene; none where the fitted multipliers do not prove the motion to within the
    /// tolerance of the scene's solver.
    [[nodiscard]] std::optional<Solution> solution_for(const Scene& scene);

 private:
    [[nodiscard]] std::vector<double> weights_for(const Scene& scene) const;
    [[nodiscard]] Eigen::MatrixXd step_for(const Eigen::VectorXd& multipliers, Eigen::MatrixXd rest);
    [[nodiscard]] Eigen::VectorXd fitted(const Eigen::VectorXd& cost);
    [[nodiscard]] Certificate certificate_for(const Scene& scene);

    std::mutex busy_;  ///< the problem takes the weights of the scene in question
    CamProblem problem_;
    Eigen::VectorXd x_, multipliers_, cost_;
    std::vector<int> weighed_;                    ///< variables that are peaks with a weight
    Eigen::MatrixXd slopes_;                      ///< D: rows x weighed; empty: not yet computed
    Eigen::SparseMatrix<double> rows_, columns_;  ///< G and its transpose; empty: not yet computed
    Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factor_;
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

    /// None: it must be solved.
    [[nodiscard]] std::optional<Solution> proved(const Scene& scene);

 private:
    std::shared_ptr<ProvedOptimum> proposed_;
    std::list<std::shared_ptr<ProvedOptimum>> known_;
};

}  // namespace camopt
