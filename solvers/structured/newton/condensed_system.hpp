// SPDX-License-Identifier: MIT
//
// Internal to solvers/structured/: the Newton system of the interior point,
//
//     ∇²f Δx + Eᵀ Δλ + Cᵀ (ν_l − ν_u) + Wᵀ (ν_l + ν_u) = p,   E Δx = q,
//     ν_l = K_l (Δt + Δw) − f_l,   ν_u = K_u (Δw − Δt) − f_u,
//
// with the ranges of range_rows.hpp (t = C x, w = W x), the curvatures K of their sides (z/g, >= 0) and
// the forces f. ν is eliminated; the matrix to be factorized is
//
//     [ ∇²f + Cᵀ(K_l + K_u)C + Cᵀ(K_l − K_u)W + Wᵀ(K_l − K_u)C + Wᵀ(K_l + K_u)W   Eᵀ ]
//     [                                  E                                       0  ]
//
// of fixed pattern. A solve is refined on the residual of the whole system, so that neither the elimination
// nor shifts of the diagonal cost accuracy.
#pragma once

#include "linear/compressed_rows.hpp"
#include "linear/sparse_symmetric.hpp"
#include "solvers/structured/interior_point.hpp"
#include "solvers/structured/range_rows.hpp"

#include <Eigen/Core>

#include <memory>
#include <vector>

namespace camopt::structured {

struct NewtonUnknowns {
    Eigen::VectorXd x, lambda;  ///< λ: one per equality
    Eigen::VectorXd slide;      ///< [Δt + Δw; Δw − Δt], one per side
    Eigen::VectorXd nu;         ///< ν, one per side
};

struct NewtonRightSide {
    Eigen::VectorXd p, q, force;
};

class CondensedSystem {
 public:
    CondensedSystem(const ConvexModel& model, const RangeRows& ranges, FactorKind kind, double shift);

    /// `hessian`: values of ∇²f in the order of ConvexModel::hessian; `curvature`: K, one per side. Both must
    /// live until the last solve. False: breakdown.
    [[nodiscard]] bool factorize(const std::vector<double>& hessian, const Eigen::VectorXd& curvature);

    /// The solution, refined until the largest entry of the residual is at most `goal` or stops decreasing.
    struct Accuracy {
        double residual = 0.0;  ///< largest entry; infinite: not finite
        bool reached = true;
    };
    [[nodiscard]] Accuracy solve(const NewtonRightSide& right_side, double goal, NewtonUnknowns& out);

    [[nodiscard]] const SymmetricFactor& factor() const { return *factor_; }

    /// image = [C x; E x]
    void multiply(const Eigen::VectorXd& x, Eigen::VectorXd& image) const { rows_.multiply(x, image); }
    /// out += factor (Eᵀ λ + Cᵀ (ν_l − ν_u) + Wᵀ (ν_l + ν_u))
    void add_transposed(double factor, const Eigen::VectorXd& lambda, const Eigen::VectorXd& nu,
                        Eigen::VectorXd& out);

 private:
    void apply_factor(const Eigen::VectorXd& p, const Eigen::VectorXd& q, NewtonUnknowns& out);
    double residual(const NewtonRightSide& right_side, const NewtonUnknowns& at);

    const ConvexModel& model_;
    const RangeRows& ranges_;
    double first_shift_, shift_;
    CompressedRows rows_, columns_;  ///< [C; E] and its transpose
    SymmetricFactor::Matrix lower_;
    CompressedRows assembly_;                     ///< entries of lower_ from weight_
    std::vector<int> hessian_slot_, width_slot_;  ///< see condensed_pattern
    std::unique_ptr<SymmetricFactor> factor_;
    const std::vector<double>* hessian_ = nullptr;
    const Eigen::VectorXd* curvature_ = nullptr;
    Eigen::VectorXd weight_;  ///< [K_l + K_u; (K_l − K_u) d]
    Eigen::VectorXd shifts_, right_side_, image_, joined_, rest_p_, rest_q_;
    NewtonUnknowns step_;
};

}  // namespace camopt::structured
