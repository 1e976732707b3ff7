// SPDX-License-Identifier: MIT
// One step of the breakpoints: a convex quadratic program around a motion.
#pragma once

#include "core/nlp.hpp"
#include "solvers/solver.hpp"

#include <Eigen/Core>

namespace camopt {

/// ∇f + Jᵀ multipliers at x.
[[nodiscard]] Eigen::VectorXd lagrangian_slope(const Nlp& problem, const Eigen::VectorXd& x,
                                               const Eigen::VectorXd& multipliers);

class FreeKnotStep {
 public:
    /// min ∇fᵀd + ½ d_tᵀ B d_t over the rows of `problem` linearized at x; d_t are `count` entries from
    /// `first` on, within ±radius.
    FreeKnotStep(const Nlp& problem, const Eigen::VectorXd& x, Eigen::Index first, Eigen::Index count,
                 const Eigen::MatrixXd& curvature, double radius);

    /// x of the result is the step d; of a step that cannot keep all rows the one of least violation.
    [[nodiscard]] BackendResult solve(const Solver& solver, const BackendOptions& options,
                                      const SolveControl& control) const;
    /// −∇fᵀd − ½ d_tᵀ B d_t.
    [[nodiscard]] double gain(const Eigen::VectorXd& step) const;

 private:
    class Program;
    const Nlp& problem_;
    const Eigen::VectorXd& x_;
    Eigen::Index first_, count_;
    const Eigen::MatrixXd& curvature_;
    double radius_;
};

}  // namespace camopt
