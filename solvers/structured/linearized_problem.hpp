// SPDX-License-Identifier: MIT
//
// Internal to solvers/structured/: an Nlp linearized at one point, as a problem with linear rows for a step
// d = h u.
//
//     min (cᵀd + ½ dᵀHd + ν t) / (h F)   subject to   d_L <= d <= d_U,   t = t_0 + h τ >= 0,
//         g_L <= g + G d <= g_U            (linear rows),
//         g_L − w t <= g + G d <= g_U + w t  (nonlinear rows; ν = 0: t = 0, no relaxation).
//
// h (`unit`) and F (`cost_unit`) scale a small step of a large cost to order 1, where the interior point
// works to full accuracy; t_0 (`elastic_base`) is the violation at d = 0. Rows have the numbers of the Nlp;
// with ν > 0 the lower sides of nonlinear rows with two sides follow them.
#pragma once

#include "core/nlp.hpp"

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <vector>

namespace camopt::structured {

/// Values of an Nlp at x; the derivatives only after differentiate().
struct NlpPoint {
    Eigen::VectorXd x, rows, gradient;
    std::vector<double> jacobian;
    double cost = infinity;
    [[nodiscard]] bool finite() const;
};
[[nodiscard]] NlpPoint evaluated(const Nlp& problem, Eigen::VectorXd x);
void differentiate(const Nlp& problem, NlpPoint& point);
[[nodiscard]] Eigen::SparseMatrix<double, Eigen::RowMajor> jacobian_of(const Nlp& problem,
                                                                       const NlpPoint& point);

struct StepModel {
    Eigen::VectorXd slope;                   ///< c
    Eigen::SparseMatrix<double> curvature;   ///< H, lower triangle, positive semidefinite
    Eigen::VectorXd rows;                    ///< g
    Eigen::VectorXd step_lower, step_upper;  ///< d_L, d_U
    Eigen::VectorXd weights;                 ///< w, one for every row
    double penalty = 0.0;                    ///< ν
    double elastic_base = 0.0;               ///< t_0
    double unit = 1.0, cost_unit = 1.0;      ///< h, F
    bool without_nonlinear_rows = false;
    bool sharp = false;  ///< to be solved to round-off
};

class LinearizedProblem final : public Nlp {
 public:
    /// `point` with its derivatives; everything must outlive this object.
    LinearizedProblem(const Nlp& problem, const NlpPoint& point, const StepModel& model);

    [[nodiscard]] double cost(const ConstVectorRef& u) const override;
    void gradient(const ConstVectorRef& u, VectorRef out) const override;
    void constraints(const ConstVectorRef& u, VectorRef out) const override;
    void jacobian(const ConstVectorRef&, std::span<double> out) const override;
    void hessian(const ConstVectorRef&, double sigma, const ConstVectorRef&,
                 std::span<double> out) const override;
    [[nodiscard]] std::string variable_name(int index) const override;
    [[nodiscard]] std::string row_name(int index) const override;
    [[nodiscard]] RowOrigin row_origin(int index) const override;

    [[nodiscard]] Eigen::VectorXd step_of(const Eigen::VectorXd& u) const;
    [[nodiscard]] double elastic_of(const Eigen::VectorXd& u) const;  ///< t
    /// λ of the Nlp's rows from those of this problem.
    [[nodiscard]] Eigen::VectorXd multipliers_of(const Eigen::VectorXd& lambda) const;

 private:
    /// Of the problem, the origin of row `index` of this one.
    [[nodiscard]] int source_row(int index) const;
    void drop_nonlinear_rows();
    void add_elastic_rows();
    const Nlp& problem_;
    const StepModel& model_;
    int variables_;
    std::vector<double> values_;   ///< of the Jacobian
    std::vector<int> extra_rows_;  ///< rows of the Nlp behind the rows after its own
};

/// min ½ ‖x − start‖² over the linear rows and the bounds of the Nlp.
[[nodiscard]] StepModel projection_model(const Nlp& problem, const NlpPoint& start);

}  // namespace camopt::structured
