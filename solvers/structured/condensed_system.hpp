// SPDX-License-Identifier: MIT
// Internal to solvers/structured/: the Newton system of the interior point,
//
//     [ ∇²f + Σ   Cᵀ ] [ Δx ]   [ p ]      Σ: barrier curvature of the variables' bounds, >= 0
//     [    C     −D  ] [ Δλ ] = [ q ]      D: 1 / barrier curvature of the rows, 0 for equalities
//
// with the inequalities (D > 0) eliminated: what is factorized is
//
//     [ ∇²f + Σ + C_Iᵀ D_I⁻¹ C_I   C_Eᵀ ]
//     [            C_E               0  ]
//
// whose pattern never changes. A solve is refined on the residual of the whole system, so that neither the
// elimination nor shifts of the diagonal cost accuracy.
#pragma once

#include "linear/compressed_rows.hpp"
#include "linear/sparse_symmetric.hpp"
#include "solvers/structured/convex_model.hpp"

#include <Eigen/Core>

#include <memory>
#include <vector>

namespace camopt::structured {

struct NewtonUnknowns {
    Eigen::VectorXd x, lambda;
    Eigen::VectorXd image;  ///< C x
};

class CondensedSystem {
 public:
    CondensedSystem(const ConvexModel& model, FactorKind kind, double shift);

    /// `hessian`: values of ∇²f in the order of ConvexModel::hessian; `d`: one a row, 0 for equalities. Both
    /// vectors must live until the last solve. False: breakdown.
    [[nodiscard]] bool factorize(const std::vector<double>& hessian, const Eigen::VectorXd& sigma,
                                 const Eigen::VectorXd& d);

    /// The solution, refined until the largest entry of the residual is at most `goal` or falls no more;
    /// `image` = C x. A goal that is infinite asks for no residual at all.
    struct Accuracy {
        double residual = 0.0;  ///< largest entry; infinite: not finite
        bool reached = true;
    };
    [[nodiscard]] Accuracy solve(const Eigen::VectorXd& p, const Eigen::VectorXd& q, double goal,
                                 NewtonUnknowns& out);

    [[nodiscard]] const SymmetricFactor& factor() const { return *factor_; }
    [[nodiscard]] const CompressedRows& rows() const { return rows_; }
    [[nodiscard]] const CompressedRows& columns() const { return columns_; }

 private:
    /// values_[slot] += product · weight[row]
    struct Term {
        int slot, row;
        double product;
    };
    void find_pattern();
    int number_equalities();
    [[nodiscard]] std::vector<std::vector<int>> hessian_by_column() const;
    void apply_factor(const Eigen::VectorXd& p, const Eigen::VectorXd& q, NewtonUnknowns& out);
    double residual(const Eigen::VectorXd& p, const Eigen::VectorXd& q, const NewtonUnknowns& at);

    const ConvexModel& model_;
    double first_shift_, shift_;
    CompressedRows rows_, columns_;  ///< C, Cᵀ
    SymmetricFactor::Matrix lower_;
    std::vector<Term> terms_;
    std::vector<double> constant_;  ///< what no iteration changes: the equalities
    std::vector<int> diagonal_, hessian_slot_;
    std::vector<int> equality_;  ///< place of each row in the matrix, −1: an inequality
    std::vector<int> equality_rows_;
    std::unique_ptr<SymmetricFactor> factor_;
    const std::vector<double>* hessian_ = nullptr;
    const Eigen::VectorXd* sigma_ = nullptr;
    const Eigen::VectorXd* d_ = nullptr;
    Eigen::VectorXd weight_, shifts_, right_side_, weighted_, rest_p_, rest_q_, gathered_;
    NewtonUnknowns step_;
};

}  // namespace camopt::structured
