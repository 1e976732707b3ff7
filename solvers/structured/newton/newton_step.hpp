// SPDX-License-Identifier: MIT
// Internal to solvers/structured/: the Newton system of the interior point, residuals of its optimality
// conditions and directions for them.
#pragma once

#include "linear/compressed_rows.hpp"
#include "solvers/structured/newton/side_kernels.hpp"
#include "solvers/structured/range_rows.hpp"

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
    Eigen::VectorXd all;    ///< [x; λ], λ one per equality
    Eigen::VectorXd image;  ///< [C x; E x]
    Eigen::VectorXd nu;     ///< ν, one per side
};

struct NewtonRightSide {
    Eigen::VectorXd all;  ///< [p; q]
    Eigen::VectorXd force;
};

class CondensedSystem {
 public:
    CondensedSystem(const ConvexModel& model, const RangeRows& ranges, FactorKind kind, double shift);

    /// `hessian`: values of ∇²f in the order of ConvexModel::hessian. Runs `pass`, whose weights and squares
    /// are set here; its curvatures must live until the last solve, as `hessian`. False: breakdown.
    [[nodiscard]] bool factorize(const std::vector<double>& hessian, SidePoint pass);

    /// The solution, refined until the largest entry of the residual is at most `goal` or stops decreasing.
    /// The last pass that used products() was that of the forces.
    struct Accuracy {
        double residual = 0.0;  ///< largest entry; infinite: not finite
        bool reached = true;
    };
    [[nodiscard]] Accuracy solve(const NewtonRightSide& right_side, double goal, NewtonUnknowns& out);

    [[nodiscard]] const SymmetricFactor& factor() const { return *factor_; }
    [[nodiscard]] const SideLayout& layout() const { return layout_; }
    [[nodiscard]] const SideKernels& passes() const { return passes_; }
    /// Where a pass puts what the next product with the transpose reads.
    [[nodiscard]] SideProducts products() { return {joined_.data(), sums_.data()}; }

    /// image = [C x; E x]
    void multiply(const double* x, Eigen::VectorXd& image) const { rows_.multiply(x, image.data()); }
    /// out = base + factor (Eᵀ λ + Cᵀ (ν_l − ν_u) + Wᵀ (ν_l + ν_u)), ν in products(); both of size variables.
    void add_transposed(double factor, const double* lambda, const double* base, double* out);

 private:
    void divide_into_segments();
    void apply_factor(NewtonUnknowns& out);
    double residual(const NewtonRightSide& right_side, const NewtonUnknowns& at);

    const ConvexModel& model_;
    const RangeRows& ranges_;
    const SideKernels& passes_ = side_kernels();
    double first_shift_, shift_;
    bool trusted_ = false;  ///< the current factor
    std::vector<SideSegment> segments_;
    SideLayout layout_;
    CompressedRows rows_, columns_;  ///< [C; E] and its transpose
    SymmetricFactor::Matrix lower_;
    CompressedRows assembly_;                     ///< entries of lower_ from weight_
    std::vector<int> hessian_slot_, width_slot_;  ///< see condensed_pattern
    std::unique_ptr<SymmetricFactor> factor_;
    const std::vector<double>* hessian_ = nullptr;
    const double* curvature_ = nullptr;
    Eigen::VectorXd weight_;         ///< [K_l + K_u; (K_l − K_u) d]
    Eigen::VectorXd joined_, sums_;  ///< [ν_l − ν_u; λ] and Σ d (ν_l + ν_u) per segment
    Eigen::VectorXd shifts_, rest_;
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
    void resize(Eigen::Index variables, const RangeRows& ranges);
};

struct Residuals {
    Eigen::VectorXd dual;      ///< of the variables
    Eigen::VectorXd equality;  ///< E x − e
    Eigen::VectorXd bound;     ///< one per side: t + w − l − g
    Eigen::VectorXd gradient;
    double mu = 0.0;             ///< mean of g z
    double largest_bound = 0.0;  ///< entry of `bound`
    double bound_total = 0.0;    ///< its sum
    double dual_limit = 0.0;     ///< Σ z l
    [[nodiscard]] bool finite() const;
};

struct Direction {
    Eigen::VectorXd x, lambda, gap, dual;
    double steepest_gap = 0.0, steepest_dual = 0.0;              ///< largest −δg / g and −δz / z, >= 0
    double gap_dual = 0.0, dual_gap = 0.0, change_change = 0.0;  ///< Σ g δz, Σ z δg, Σ δg δz
    bool finite = true;
    void resize(Eigen::Index variables, const RangeRows& ranges);
    /// Largest step in [0, 1] that keeps g + step·δg >= (1 − fraction) g; the same for z.
    [[nodiscard]] double primal_step(double fraction) const { return within(fraction, steepest_gap); }
    [[nodiscard]] double dual_step(double fraction) const { return within(fraction, steepest_dual); }

 private:
    static double within(double fraction, double steepest) {
        return steepest > fraction ? fraction / steepest : 1.0;
    }
};

struct DirectionRequest {
    const Residuals* residuals = nullptr;  ///< null: only the products change
    /// Of the products g z: `rule` and its numbers; the rest is filled in.
    SideForces change;
    const Direction* base = nullptr;  ///< added, without residuals; null: nothing
};

class NewtonStep {
 public:
    NewtonStep(const ConvexModel& model, const RangeRows& ranges, const InteriorPointLimits& limits);

    void residuals(Iterate& point, Residuals& out);
    /// Of `to` = the point after steps along a direction; `to` may be the point.
    struct Steps {
        double primal = 0.0, dual = 0.0;
    };
    void advance(const Iterate& point, const Direction& direction, const Steps& steps, Iterate& to,
                 Residuals& out);
    /// Evaluates the Hessian and factorizes. False: breakdown, or a Hessian that is not finite (see
    /// `finite`).
    [[nodiscard]] bool prepare(const Iterate& point, bool& finite);
    void direction(const Iterate& point, const DirectionRequest& request, Direction& out);

 private:
    void evaluate(Iterate& at, SideResiduals pass, Residuals& out);
    [[nodiscard]] bool prepare_careful(const Iterate& point);
    void solve(const Iterate& point, double goal);
    [[nodiscard]] double size_of_right_side(const Iterate& point) const;
    void solve_carefully(double known_residual);

    const ConvexModel& model_;
    const RangeRows& ranges_;
    double tolerance_;
    double shift_;
    bool exact_;
    CondensedSystem system_;
    std::unique_ptr<KktSystem> careful_;  ///< used where the condensed system is too inaccurate
    bool careful_is_current_ = false;
    std::vector<double> hessian_;
    Eigen::VectorXd inverse_gap_, inverse_dual_, curvature_, image_, change_;
    Eigen::VectorXd variable_curvature_, row_flatness_;  ///< of the full system: Σ and D
    NewtonRightSide right_side_;
    NewtonUnknowns solution_;
    double wrong_ = 0.0;  ///< largest residual at the point, or the mean product g z
    double goal_ = 0.0;   ///< largest entry that the residual of a direction may have
    bool solved_ = false;
};

}  // namespace camopt::structured
