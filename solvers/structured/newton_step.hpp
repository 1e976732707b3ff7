// SPDX-License-Identifier: MIT
// Internal to solvers/structured/: residuals of the optimality conditions and Newton directions for them.
#pragma once

#include "solvers/structured/interior_point.hpp"
#include "solvers/structured/kkt_system.hpp"

#include <Eigen/Core>

#include <vector>

namespace camopt::structured {

/// Which bounds exist: 1 or 0 for each entry of w. An equality row has none: its slack is a constant.
struct BoundMask {
    explicit BoundMask(const ConvexModel& model);
    Eigen::VectorXd lower_bound, upper_bound;  ///< 0 where absent
    Eigen::VectorXd lower, upper;
    Eigen::VectorXd equality;  ///< for each row
    double count = 0.0;        ///< of bounds
};

struct Residuals {
    Eigen::VectorXd dual;          ///< ∇f + Cᵀλ − z_l + z_u of the variables
    Eigen::VectorXd row;           ///< C x − s
    Eigen::VectorXd lower, upper;  ///< w − w_L − l, w_U − w − u
    Eigen::VectorXd gradient;
    double mu = 0.0;  ///< mean product of distance and multiplier
    [[nodiscard]] bool finite() const;
};

struct Direction {
    Eigen::VectorXd w, lambda, lower_gap, upper_gap, lower_dual, upper_dual;
    bool finite = true;
    Direction& operator+=(const Direction& other);
};

/// What the products l z_l and u z_u are to change by, to first order.
struct ProductChange {
    Eigen::VectorXd lower, upper;
};

class NewtonStep {
 public:
    NewtonStep(const ConvexModel& model, const BoundMask& mask, double shift);
    [[nodiscard]] Residuals residuals(const Iterate& point) const;
    /// Evaluates the Hessian and factorizes. False: breakdown, or a Hessian that is not finite (see
    /// `finite`).
    [[nodiscard]] bool prepare(const Iterate& point, bool& finite);
    /// With `residuals` null: only the products change.
    [[nodiscard]] Direction direction(const Iterate& point, const Residuals* residuals,
                                      const ProductChange& change);

 private:
    const ConvexModel& model_;
    const BoundMask& mask_;
    KktSystem system_;
    std::vector<double> hessian_;
    Eigen::VectorXd sigma_, d_;
};

/// Largest step in [0, 1] that keeps v + step·dv >= (1 − fraction) v for v > 0.
[[nodiscard]] double step_to_boundary(const Eigen::VectorXd& value, const Eigen::VectorXd& change,
                                      double fraction);

void advance(Iterate& point, const Direction& direction, double primal_step, double dual_step);

}  // namespace camopt::structured
