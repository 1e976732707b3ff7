// SPDX-License-Identifier: MIT
// Internal to solvers/structured/: the Newton system of the interior point, residuals of its optimality
// conditions and directions for them.
#pragma once

#include "linear/compressed_rows.hpp"
#include "linear/sparse_symmetric.hpp"
#include "solvers/structured/interior_point.hpp"
#include "solvers/structured/range_rows.hpp"

#include <Eigen/Core>

#include <memory>
#include <vector>

namespace camopt::structured {

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

// Internal to solvers/structured/: residuals of the optimality conditions and Newton directions for them.
//
// With the ranges of range_rows.hpp (t = C x, w = W x), gaps g and multipliers z of their sides,
//
//     ∇f + Eᵀ λ − Cᵀ (z_l − z_u) − Wᵀ (z_l + z_u) = 0,   E x = e,
//     t + w − l = g_l,   w − t + u = g_u,   g z = μ.
//
// Nothing here allocates after construction.

// Internal to solvers/structured/: the Newton system of the interior point, reduced to
//
//     [ ∇²f + Σ   Cᵀ ] [ Δx ]   [ p ]      Σ: barrier curvature of the variables' bounds, >= 0
//     [    C     −D  ] [ Δλ ] = [ q ]      D: 1 / barrier curvature of the rows, 0 for equalities
//
// factorized with small shifts of the diagonal and solved without them. A breakdown raises the shifts; a
// solve that stays inaccurate tries other ones and keeps the best.
class KktSystem {
 public:
    /// `shift`: initial regularisation.
    KktSystem(const ConvexModel& model, double shift);

    /// False: no factorization with any shift up to the largest.
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

struct Iterate {
    Eigen::VectorXd x;
    Eigen::VectorXd lambda;     ///< one per equality
    Eigen::VectorXd gap, dual;  ///< g, z: one per side; 1 and 0 for a missing side
};

struct Residuals {
    Eigen::VectorXd dual;      ///< of the variables
    Eigen::VectorXd equality;  ///< E x − e
    Eigen::VectorXd bound;     ///< one per side: t + w − l − g
    Eigen::VectorXd gradient;
    double mu = 0.0;  ///< mean of g z
    [[nodiscard]] bool finite() const;
};

struct Direction {
    Eigen::VectorXd x, lambda, gap, dual;
    bool finite = true;
    void resize(Eigen::Index variables, const RangeRows& ranges);
    Direction& operator+=(const Direction& other);
};

class NewtonStep {
 public:
    NewtonStep(const ConvexModel& model, const RangeRows& ranges, const InteriorPointLimits& limits);

    void residuals(const Iterate& point, Residuals& out);
    /// Evaluates the Hessian and factorizes. False: breakdown, or a Hessian that is not finite (see
    /// `finite`).
    [[nodiscard]] bool prepare(const Iterate& point, bool& finite);
    /// 1/g and 1/z of the point last prepared; finite for missing sides.
    [[nodiscard]] const Eigen::VectorXd& inverse_gap() const { return inverse_gap_; }
    [[nodiscard]] const Eigen::VectorXd& inverse_dual() const { return inverse_dual_; }
    /// Changes the products g z by `change`, to first order. `residuals` null: only the products.
    void direction(const Iterate& point, const Residuals* residuals, const Eigen::VectorXd& change,
                   Direction& out);

 private:
    [[nodiscard]] bool prepare_careful(const Iterate& point);
    void solve(const Iterate& point, double goal);
    void solve_carefully(double known_residual);
    void keep_products(const Iterate& point, const Eigen::VectorXd& change, Direction& out) const;

    const ConvexModel& model_;
    const RangeRows& ranges_;
    double tolerance_;
    double shift_;
    CondensedSystem system_;
    std::unique_ptr<KktSystem> careful_;  ///< used where the condensed system is too inaccurate
    bool careful_is_current_ = false;
    std::vector<double> hessian_;
    Eigen::VectorXd inverse_gap_, inverse_dual_, curvature_, image_, slide_;
    Eigen::VectorXd variable_curvature_, row_flatness_;  ///< of the full system: Σ and D
    NewtonRightSide right_side_;
    NewtonUnknowns solution_;
    double goal_ = 0.0;  ///< largest entry that the residual of a direction may have
    bool solved_ = false;
};

/// Largest step in [0, 1] that keeps v + step·dv >= (1 − fraction) v for v > 0, from 1/v.
[[nodiscard]] double step_to_boundary(const Eigen::VectorXd& inverse, const Eigen::VectorXd& change,
                                      double fraction);

void advance(Iterate& point, const Direction& direction, double primal_step, double dual_step);

}  // namespace camopt::structured
