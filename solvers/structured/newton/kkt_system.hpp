// SPDX-License-Identifier: MIT
// Internal to solvers/structured/: the Newton system of the interior point, reduced to
//
//     [ ∇²f + Σ   Cᵀ ] [ Δx ]   [ p ]      Σ: barrier curvature of the variables' bounds, >= 0
//     [    C     −D  ] [ Δλ ] = [ q ]      D: 1 / barrier curvature of the rows, 0 for equalities
//
// factorized with small shifts of the diagonal and solved without them. A breakdown raises the shifts; a
// solve that stays inaccurate tries other ones and keeps the best.
#pragma once

#include "linear/sparse_symmetric.hpp"
#include "solvers/structured/convex_model.hpp"

#include <Eigen/Core>

#include <memory>
#include <vector>

namespace camopt::structured {

class KktSystem {
 public:
    /// `shift`: regularisation to begin with.
    KktSystem(const ConvexModel& model, double shift);

    /// False: no shift up to the largest one gave a factor.
    [[nodiscard]] bool factorize(const std::vector<double>& hessian, const Eigen::VectorXd& sigma,
                                 const Eigen::VectorXd& d);
    struct Step {
        Eigen::VectorXd x, lambda;
        double residual = 0.0;
        bool finite = true;
    };
    [[nodiscard]] Step solve(const Eigen::VectorXd& p, const Eigen::VectorXd& q);
    [[nodiscard]] double shift() const { return shift_; }

 private:
    [[nodiscard]] bool factorize_shifted();
    Eigen::Index variables_, constraints_;
    double first_shift_, shift_;
    SymmetricFactor::Matrix lower_;
    std::vector<Eigen::Index> diagonal_, hessian_position_, off_diagonal_;
    std::unique_ptr<SymmetricFactor> factor_;
};

}  // namespace camopt::structured
