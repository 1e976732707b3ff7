// SPDX-License-Identifier: MIT
//
// Internal to solvers/structured/: the problem that the interior point solves,
//
//     min f(x)   subject to   x_L <= x <= x_U,   r_L <= C x <= r_U,
//
// f convex, every row with at least one finite side, every variable with x_L < x_U. Usually the scaled form
// of an Nlp (standard_form.hpp) or the elastic problem made of one (infeasibility.hpp).
#pragma once

#include "core/nlp.hpp"

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <memory>
#include <span>
#include <utility>

namespace camopt::structured {

enum class CostKind { linear, quadratic, smooth };

class ConvexCost {
 public:
    virtual ~ConvexCost() = default;
    [[nodiscard]] virtual double value(const Eigen::VectorXd& x) const = 0;
    virtual void gradient(const Eigen::VectorXd& x, Eigen::VectorXd& out) const = 0;
    /// In the order of ConvexModel::hessian.
    virtual void hessian(const Eigen::VectorXd& x, std::span<double> out) const = 0;
};

class LinearCost final : public ConvexCost {
 public:
    explicit LinearCost(Eigen::VectorXd coefficients, double constant = 0.0)
        : coefficients_(std::move(coefficients)), constant_(constant) {}
    [[nodiscard]] double value(const Eigen::VectorXd& x) const override {
        return constant_ + coefficients_.dot(x);
    }
    void gradient(const Eigen::VectorXd&, Eigen::VectorXd& out) const override { out = coefficients_; }
    void hessian(const Eigen::VectorXd&, std::span<double>) const override {}

 private:
    Eigen::VectorXd coefficients_;
    double constant_;
};

struct ConvexModel {
    using Matrix = Eigen::SparseMatrix<double>;
    Matrix rows;  ///< C
    Eigen::VectorXd row_lower, row_upper, x_lower, x_upper;
    SparsityPattern hessian;  ///< lower triangle
    CostKind kind = CostKind::linear;
    /// The user's cost of 1 in these units, <= 1: errors are relative to that or to the cost, whichever is
    /// larger.
    double cost_unit = 1.0;
    std::unique_ptr<ConvexCost> cost;

    [[nodiscard]] Eigen::Index variables() const { return x_lower.size(); }
    [[nodiscard]] Eigen::Index constraints() const { return row_lower.size(); }
    [[nodiscard]] bool is_equality(Eigen::Index row) const { return row_lower[row] == row_upper[row]; }
};

}  // namespace camopt::structured
