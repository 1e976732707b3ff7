// SPDX-License-Identifier: MIT
#include "studies/search/free_knot_step.hpp"

#include <algorithm>

namespace camopt {

Eigen::VectorXd lagrangian_slope(const Nlp& problem, const Eigen::VectorXd& x,
                                 const Eigen::VectorXd& multipliers) {
    const SparsityPattern& pattern = problem.shape().jacobian;
    std::vector<double> values(static_cast<std::size_t>(pattern.size()));
    problem.jacobian(x, values);
    Eigen::VectorXd slope(x.size());
    problem.gradient(x, slope);
    for (std::size_t k = 0; k < values.size(); ++k) {
        slope[pattern.columns[k]] += values[k] * multipliers[pattern.rows[k]];
    }
    return slope;
}

class FreeKnotStep::Program final : public Nlp {
 public:
    explicit Program(const FreeKnotStep& step)
        : step_(step), rows_(step.problem_.shape().constraints()), gradient_(step.x_.size()) {
        const Nlp& base = step.problem_;
        const NlpShape& shape = base.shape();
        base.constraints(step.x_, rows_);
        base.gradient(step.x_, gradient_);
        jacobian_.resize(static_cast<std::size_t>(shape.jacobian.size()));
        base.jacobian(step.x_, jacobian_);
        shape_.x_lower = shape.x_lower - step.x_;
        shape_.x_upper = shape.x_upper - step.x_;
        for (Eigen::Index j = step.first_; j < step.first_ + step.count_; ++j) {
            shape_.x_lower[j] = std::min(0.0, std::max(shape_.x_lower[j], -step.radius_));
            shape_.x_upper[j] = std::max(0.0, std::min(shape_.x_upper[j], step.radius_));
        }
        shape_.g_lower = shape.g_lower - rows_;
        shape_.g_upper = shape.g_upper - rows_;
        shape_.rows = shape.rows;
        for (RowKind& row : shape_.rows) row.linear = true;
        shape_.jacobian = shape.jacobian;
        shape_.convex = shape_.quadratic_cost = true;
        shape_.linear_cost = step.curvature_.isZero();
        if (shape_.linear_cost) return;
        for (Eigen::Index a = 0; a < step.count_; ++a) {
            for (Eigen::Index b = 0; b <= a; ++b) {
                shape_.hessian.rows.push_back(static_cast<int>(step.first_ + a));
                shape_.hessian.columns.push_back(static_cast<int>(step.first_ + b));
            }
        }
    }

    [[nodiscard]] double cost(const ConstVectorRef& d) const override {
        const auto moved = d.segment(step_.first_, step_.count_);
        return gradient_.dot(d) + 0.5 * moved.dot(step_.curvature_ * moved);
    }
    void gradient(const ConstVectorRef& d, VectorRef out) const override {
        out = gradient_;
        out.segment(step_.first_, step_.count_) += step_.curvature_ * d.segment(step_.first_, step_.count_);
    }
    void constraints(const ConstVectorRef& d, VectorRef out) const override {
        out.setZero();
        for (std::size_t k = 0; k < jacobian_.size(); ++k) {
            out[shape_.jacobian.rows[k]] += jacobian_[k] * d[shape_.jacobian.columns[k]];
        }
    }
    void jacobian(const ConstVectorRef&, std::span<double> out) const override {
        std::ranges::copy(jacobian_, out.begin());
    }
    void hessian(const ConstVectorRef&, double sigma, const ConstVectorRef&,
                 std::span<double> out) const override {
        for (std::size_t k = 0; k < out.size(); ++k) {
            out[k] = sigma * step_.curvature_(shape_.hessian.rows[k] - step_.first_,
                                              shape_.hessian.columns[k] - step_.first_);
        }
    }
    [[nodiscard]] std::string variable_name(int index) const override {
        return step_.problem_.variable_name(index);
    }
    [[nodiscard]] std::string row_name(int index) const override { return step_.problem_.row_name(index); }
    [[nodiscard]] RowOrigin row_origin(int index) const override { return step_.problem_.row_origin(index); }

 private:
    const FreeKnotStep& step_;
    Eigen::VectorXd rows_, gradient_;
    std::vector<double> jacobian_;
};

FreeKnotStep::FreeKnotStep(const Nlp& problem, const Eigen::VectorXd& x, Eigen::Index first,
                           Eigen::Index count, const Eigen::MatrixXd& curvature, double radius)
    : problem_(problem), x_(x), first_(first), count_(count), curvature_(curvature), radius_(radius) {}

BackendResult FreeKnotStep::solve(const Solver& solver, const BackendOptions& options,
                                  const SolveControl& control) const {
    return solver.minimize(Program(*this), Eigen::VectorXd::Zero(x_.size()), options, control);
}

double FreeKnotStep::gain(const Eigen::VectorXd& step) const {
    return -Program(*this).cost(step);
}

}  // namespace camopt
