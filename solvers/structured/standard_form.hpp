// SPDX-License-Identifier: MIT
//
// Internal to solvers/structured/: an Nlp with linear rows as a well-scaled ConvexModel, and the inverse
// mapping.
//
// Fixed variables become constants, free and empty rows disappear, and with powers of two for S (columns),
// T (rows) and σ (cost)
//     x = S x̂,   Ĉ = T G S,   f̂(x̂) = σ f(S x̂),   λ = T λ̂ / σ,   z = S⁻¹ ẑ / σ.
// S and T equilibrate [∇²f Gᵀ; G 0] so that its rows have largest entries near 1.
// Source: Ruiz, A scaling algorithm to equilibrate both rows and columns norms in matrices, RAL-TR-2001-034.
#pragma once

#include "solvers/structured/interior_point.hpp"

namespace camopt::structured {

/// A Farkas proof of infeasibility: Jᵀ row_multipliers + bound_multipliers = 0 and −Σ λ_i b_i − Σ z_j
/// x_bound_j = 1 (see structured_solver.hpp).
struct Ray {
    Eigen::VectorXd row_multipliers, bound_multipliers;
};

class StandardForm {
 public:
    enum class Status {
        ready,
        infeasible,        ///< a row without variables contradicts itself: ray() is set
        crossed_bounds,    ///< a lower bound above its upper one
        evaluation_error,  ///< the Nlp returned a value that is not finite
    };

    /// `start`: where a cost that is not quadratic is scaled. The Nlp must outlive this object.
    StandardForm(const Nlp& problem, const Eigen::VectorXd& start);

    [[nodiscard]] Status status() const { return status_; }
    [[nodiscard]] const std::string& detail() const { return detail_; }
    [[nodiscard]] const std::optional<Ray>& ray() const { return ray_; }
    [[nodiscard]] const ConvexModel& model() const { return model_; }
    [[nodiscard]] double cost_scale() const { return cost_scale_; }

    [[nodiscard]] Eigen::VectorXd to_model(const Eigen::VectorXd& x) const;
    [[nodiscard]] Eigen::VectorXd to_problem(const Eigen::VectorXd& x) const;
    /// λ of the problem from λ̂ of the model; `cost_scale` = 1 for a ray.
    [[nodiscard]] Eigen::VectorXd row_multipliers(const Eigen::VectorXd& lambda, double cost_scale) const;
    /// λ̂ from λ; rows beyond those given have 0.
    [[nodiscard]] Eigen::VectorXd model_multipliers(const Eigen::VectorXd& lambda) const;
    /// −(gradient + Gᵀ λ) where a finite bound of the right side exists, 0 elsewhere.
    [[nodiscard]] Eigen::VectorXd bound_multipliers(const Eigen::VectorXd& gradient,
                                                    const Eigen::VectorXd& lambda) const;
    /// −Σ λ_i b_i − Σ z_j x_bound_j, with the constants of the rows moved into b.
    [[nodiscard]] double ray_value(const Ray& ray) const;

 private:
    void read(const Eigen::VectorXd& start);
    void leave_out_idle(const Eigen::VectorXd& start);
    void keep_rows();
    void equilibrate(const Eigen::VectorXd& start);
    void shrink_far_rows();
    void scale_cost(const Eigen::VectorXd& start);
    void fail(Status status, std::string detail);

    const Nlp& problem_;
    Status status_ = Status::ready;
    std::string detail_;
    std::optional<Ray> ray_;
    ConvexModel model_;
    Eigen::VectorXd base_;              ///< variables that are fixed or idle at their value, 0 elsewhere
    Eigen::VectorXd constant_;          ///< rows at x = 0
    Eigen::SparseMatrix<double> full_;  ///< G
    Eigen::VectorXd gradient_;          ///< of the cost, at the start
    std::vector<int> kept_variables_, kept_rows_;
    Eigen::VectorXd column_scale_, row_scale_;
    double cost_scale_ = 1.0;
};

}  // namespace camopt::structured
