// SPDX-License-Identifier: MIT
// Internal to solvers/structured/: residuals of the optimality conditions and Newton directions for them.
//
// With the bounds of bound_list.hpp, gaps g_b and multipliers z_b,
//
//     ∇f + C_Eᵀ λ_E − Σ_b σ_b z_b ∇t_b = 0,   C_E x = e,   σ_b (t_b − value_b) = g_b,   g_b z_b = μ.
//
// Nothing here allocates after construction.
#pragma once

#include "solvers/structured/bound_list.hpp"
#include "solvers/structured/condensed_system.hpp"
#include "solvers/structured/interior_point.hpp"
#include "solvers/structured/kkt_system.hpp"

#include <Eigen/Core>

#include <memory>
#include <vector>

namespace camopt::structured {

struct Residuals {
    Eigen::VectorXd dual;      ///< of the variables
    Eigen::VectorXd equality;  ///< C x − e, one a row, 0 for inequalities
    Eigen::VectorXd bound;     ///< σ_b (t_b − value_b) − g_b
    Eigen::VectorXd gradient;
    double mu = 0.0;  ///< mean of g_b z_b
    [[nodiscard]] bool finite() const;
};

struct Direction {
    Eigen::VectorXd x, lambda, gap, dual;
    bool finite = true;
    void resize(const ConvexModel& model, const BoundList& bounds);
    Direction& operator+=(const Direction& other);
};

class NewtonStep {
 public:
    NewtonStep(const ConvexModel& model, const BoundList& bounds, const InteriorPointLimits& limits);

    void residuals(const Iterate& point, Residuals& out);
    /// Evaluates the Hessian and factorizes. False: breakdown, or a Hessian that is not finite (see
    /// `finite`).
    [[nodiscard]] bool prepare(const Iterate& point, bool& finite);
    /// The products g_b z_b are to change by `change`, to first order. With `residuals` null they alone.
    void direction(const Iterate& point, const Residuals* residuals, const Eigen::VectorXd& change,
                   Direction& out);

 private:
    [[nodiscard]] bool prepare_careful();
    void solve(double goal);

    const ConvexModel& model_;
    const BoundList& bounds_;
    double tolerance_;
    double shift_;
    CondensedSystem system_;
    std::unique_ptr<KktSystem> careful_;  ///< takes over where the condensed system is too inaccurate
    bool careful_is_current_ = false;
    std::vector<double> hessian_;
    Eigen::VectorXd inverse_gap_, sigma_, d_, force_x_, force_row_, p_, q_, image_;
    NewtonUnknowns solution_;
    double goal_ = 0.0;  ///< largest entry that the residual of a direction may have
    bool solved_ = false;
};

/// Largest step in [0, 1] that keeps v + step·dv >= (1 − fraction) v for v > 0.
[[nodiscard]] double step_to_boundary(const Eigen::VectorXd& value, const Eigen::VectorXd& change,
                                      double fraction);

void advance(Iterate& point, const Direction& direction, double primal_step, double dual_step);

}  // namespace camopt::structured
