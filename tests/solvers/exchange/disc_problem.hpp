// SPDX-License-Identifier: MIT
// A continuous problem with a closed-form answer: the farthest point of the unit disc in the direction (1,
// 1), written as min −x0 − x1 subject to cos θ x0 + sin θ x1 <= radius for every θ. Optimum −√2 radius at
// 45°.
#pragma once

#include "core/continuous_problem.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>

namespace camopt::testing_support {

class DiscGrid final : public Nlp {
 public:
    DiscGrid(std::vector<double> angles, double radius, double least_x0, double rounding)
        : angles_(std::move(angles)) {
        const auto rows = static_cast<Eigen::Index>(angles_.size());
        shape_.x_lower = Eigen::Vector2d(least_x0, -10.0);
        shape_.x_upper = Eigen::Vector2d(10.0, 10.0);
        shape_.g_lower = Eigen::VectorXd::Constant(rows, -infinity);
        shape_.g_upper = Eigen::VectorXd::Constant(rows, radius);
        for (int i = 0; i < rows; ++i) {
            shape_.rows.push_back({true, true, radius, rounding});
            for (const int j : {0, 1}) {
                shape_.jacobian.rows.push_back(i);
                shape_.jacobian.columns.push_back(j);
            }
        }
        shape_.convex = shape_.linear_cost = shape_.quadratic_cost = true;
    }
    double cost(const ConstVectorRef& x) const override { return -x[0] - x[1]; }
    void gradient(const ConstVectorRef&, VectorRef out) const override { out.setConstant(-1.0); }
    void constraints(const ConstVectorRef& x, VectorRef out) const override {
        for (std::size_t i = 0; i < angles_.size(); ++i) {
            out[static_cast<Eigen::Index>(i)] = std::cos(angles_[i]) * x[0] + std::sin(angles_[i]) * x[1];
        }
    }
    void jacobian(const ConstVectorRef&, std::span<double> out) const override {
        for (std::size_t i = 0; i < angles_.size(); ++i) {
            out[2 * i] = std::cos(angles_[i]);
            out[2 * i + 1] = std::sin(angles_[i]);
        }
    }
    void hessian(const ConstVectorRef&, double, const ConstVectorRef&, std::span<double>) const override {}
    std::string variable_name(int index) const override { return "x" + std::to_string(index); }
    std::string row_name(int index) const override { return "disc at " + std::to_string(angles_[index]); }

 private:
    std::vector<double> angles_;
};

class DiscProblem : public ContinuousProblem {
 public:
    /// rounding: of the values of the rows, as they say of themselves.
    explicit DiscProblem(double radius = 1.0, double least_x0 = -10.0, double rounding = 0.0)
        : radius_(radius), least_x0_(least_x0), rounding_(rounding) {
        rebuild();
    }
    const Nlp& grid() const override { return *grid_; }
    Eigen::VectorXd start() const override { return Eigen::Vector2d(std::max(0.0, least_x0_), 0.0); }
    Eigen::VectorXd completed(const Eigen::VectorXd& x) const override { return x; }
    double objective(const Eigen::VectorXd& x) const override { return -x[0] - x[1]; }
    std::vector<Violation> violations(const Eigen::VectorXd& x, double slack) const override {
        const double amount = (x.norm() - radius_) / radius_;
        if (amount <= -slack) return {};
        return {{0, {x.norm(), std::atan2(x[1], x[0]), Side::right}, amount, true}};
    }
    int refine(std::span<const Violation> worst) override {
        const std::size_t before = angles_.size();
        for (const Violation& violation : worst) {
            const bool known = std::ranges::any_of(
                angles_, [&](double angle) { return std::abs(angle - violation.where.at) < 1e-10; });
            if (!known) angles_.push_back(violation.where.at);
        }
        if (angles_.size() > before) rebuild();
        return static_cast<int>(angles_.size() - before);
    }
    Box box(double, double) const override {
        return {Eigen::Vector2d(-10.0, -10.0), Eigen::Vector2d(10.0, 10.0)};
    }

 private:
    void rebuild() { grid_ = std::make_unique<DiscGrid>(angles_, radius_, least_x0_, rounding_); }

    double radius_, least_x0_, rounding_;
    std::vector<double> angles_{
        0.0, 0.3, 1.2, std::numbers::pi / 2.0, std::numbers::pi, -std::numbers::pi / 2.0};
    std::unique_ptr<DiscGrid> grid_;
};

}  // namespace camopt::testing_support
