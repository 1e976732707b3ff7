// SPDX-License-Identifier: MIT
#include "solvers/structured/linearized_problem.hpp"

#include <algorithm>
#include <cmath>

namespace camopt::structured {

using Eigen::Index;
using Eigen::VectorXd;

bool NlpPoint::finite() const {
    return std::isfinite(cost) && rows.allFinite() && gradient.allFinite() &&
           std::all_of(jacobian.begin(), jacobian.end(), [](double v) { return std::isfinite(v); });
}

NlpPoint evaluated(const Nlp& problem, VectorXd x) {
    NlpPoint point;
    point.x = std::move(x);
    point.rows.resize(problem.shape().constraints());
    point.cost = problem.cost(point.x);
    problem.constraints(point.x, point.rows);
    return point;
}

void differentiate(const Nlp& problem, NlpPoint& point) {
    point.gradient.resize(problem.shape().variables());
    point.jacobian.resize(static_cast<std::size_t>(problem.shape().jacobian.size()));
    problem.gradient(point.x, point.gradient);
    problem.jacobian(point.x, point.jacobian);
}

LinearizedProblem::LinearizedProblem(const Nlp& problem, const NlpPoint& point, const StepModel& model)
    : problem_(problem), model_(model), variables_(problem.shape().variables()), values_(point.jacobian) {
    const NlpShape& base = problem.shape();
    shape_.x_lower = model.step_lower / model.unit;
    shape_.x_upper = model.step_upper / model.unit;
    shape_.g_lower = (base.g_lower - model.rows) / model.unit;
    shape_.g_upper = (base.g_upper - model.rows) / model.unit;
    shape_.rows = base.rows;
    for (RowKind& row : shape_.rows) row.linear = true;
    shape_.jacobian = base.jacobian;
    for (Index j = 0; j < model.curvature.outerSize(); ++j)
        for (Eigen::SparseMatrix<double>::InnerIterator entry(model.curvature, j); entry; ++entry) {
            shape_.hessian.rows.push_back(static_cast<int>(entry.row()));
            shape_.hessian.columns.push_back(static_cast<int>(entry.col()));
        }
    shape_.convex = shape_.quadratic_cost = true;
    shape_.linear_cost = shape_.hessian.size() == 0;
    if (model.without_nonlinear_rows) drop_nonlinear_rows();
    if (model.penalty > 0.0) add_elastic_rows();
}

/// Their values need not even be finite.
void LinearizedProblem::drop_nonlinear_rows() {
    const NlpShape& base = problem_.shape();
    const auto linear = [&](int row) { return base.rows[static_cast<std::size_t>(row)].linear; };
    for (int i = 0; i < base.constraints(); ++i)
        if (!linear(i)) {
            shape_.g_lower[i] = -infinity;
            shape_.g_upper[i] = infinity;
        }
    for (std::size_t e = 0; e < values_.size(); ++e)
        if (!linear(base.jacobian.rows[e])) values_[e] = 0.0;
}

void LinearizedProblem::add_elastic_rows() {
    const NlpShape& base = problem_.shape();
    const int t = variables_;
    shape_.x_lower.conservativeResize(t + 1);
    shape_.x_upper.conservativeResize(t + 1);
    shape_.x_lower[t] = -model_.elastic_base / model_.unit;
    shape_.x_upper[t] = infinity;
    std::vector<int> extra_of(static_cast<std::size_t>(base.constraints()), -1);
    const auto add_entry = [&](int row, int column, double value) {
        shape_.jacobian.rows.push_back(row);
        shape_.jacobian.columns.push_back(column);
        values_.push_back(value);
    };
    std::vector<double> extra_lower;
    for (int i = 0; i < base.constraints(); ++i) {
        if (base.rows[static_cast<std::size_t>(i)].linear) continue;
        const bool upper = std::isfinite(base.g_upper[i]), lower = std::isfinite(base.g_lower[i]);
        const double room = model_.weights[i] * model_.elastic_base / model_.unit;
        shape_.g_upper[i] += room;
        shape_.g_lower[i] -= room;
        if (upper || lower) add_entry(i, t, upper ? -model_.weights[i] : model_.weights[i]);
        if (!upper || !lower) continue;
        const int row = base.constraints() + static_cast<int>(extra_rows_.size());
        extra_of[static_cast<std::size_t>(i)] = row;
        extra_rows_.push_back(i);
        extra_lower.push_back(shape_.g_lower[i]);
        shape_.g_lower[i] = -infinity;
        shape_.rows.push_back(shape_.rows[static_cast<std::size_t>(i)]);
        add_entry(row, t, model_.weights[i]);
    }
    for (std::size_t e = 0; e < base.jacobian.rows.size(); ++e) {
        const int row = extra_of[static_cast<std::size_t>(base.jacobian.rows[e])];
        if (row >= 0) add_entry(row, base.jacobian.columns[e], values_[e]);
    }
    const auto extra = static_cast<Index>(extra_lower.size());
    shape_.g_lower.conservativeResize(base.constraints() + extra);
    shape_.g_upper.conservativeResize(base.constraints() + extra);
    shape_.g_lower.tail(extra) = Eigen::Map<const VectorXd>(extra_lower.data(), extra);
    shape_.g_upper.tail(extra).setConstant(infinity);
}

double LinearizedProblem::cost(const ConstVectorRef& u) const {
    const VectorXd step = u.head(variables_);
    const VectorXd image = model_.curvature.selfadjointView<Eigen::Lower>() * step;
    double value = model_.slope.dot(step) + 0.5 * model_.unit * step.dot(image);
    if (u.size() > variables_) value += model_.penalty * u[variables_];
    return value / model_.cost_unit;
}

void LinearizedProblem::gradient(const ConstVectorRef& u, VectorRef out) const {
    const VectorXd step = u.head(variables_);
    const VectorXd image = model_.curvature.selfadjointView<Eigen::Lower>() * step;
    out.head(variables_) = (model_.slope + model_.unit * image) / model_.cost_unit;
    if (u.size() > variables_) out[variables_] = model_.penalty / model_.cost_unit;
}

void LinearizedProblem::constraints(const ConstVectorRef& u, VectorRef out) const {
    out.setZero();
    for (std::size_t e = 0; e < values_.size(); ++e)
        out[shape_.jacobian.rows[e]] += values_[e] * u[shape_.jacobian.columns[e]];
}

void LinearizedProblem::jacobian(const ConstVectorRef&, std::span<double> out) const {
    std::copy(values_.begin(), values_.end(), out.begin());
}

void LinearizedProblem::hessian(const ConstVectorRef&, double sigma, const ConstVectorRef&,
                                std::span<double> out) const {
    std::size_t k = 0;
    for (Index j = 0; j < model_.curvature.outerSize(); ++j)
        for (Eigen::SparseMatrix<double>::InnerIterator entry(model_.curvature, j); entry; ++entry)
            out[k++] = sigma * model_.unit / model_.cost_unit * entry.value();
}

std::string LinearizedProblem::variable_name(int index) const {
    return index < variables_ ? problem_.variable_name(index) : "common violation";
}

std::string LinearizedProblem::row_name(int index) const {
    return problem_.row_name(source_row(index));
}

RowOrigin LinearizedProblem::row_origin(int index) const {
    return problem_.row_origin(source_row(index));
}

int LinearizedProblem::source_row(int index) const {
    const int own = problem_.shape().constraints();
    return index < own ? index : extra_rows_[static_cast<std::size_t>(index - own)];
}

VectorXd LinearizedProblem::step_of(const VectorXd& u) const {
    return model_.unit * u.head(variables_);
}

double LinearizedProblem::elastic_of(const VectorXd& u) const {
    return u.size() > variables_ ? model_.elastic_base + model_.unit * u[variables_] : 0.0;
}

VectorXd LinearizedProblem::multipliers_of(const VectorXd& lambda) const {
    const int own = problem_.shape().constraints();
    VectorXd result = lambda.head(own);
    for (std::size_t k = 0; k < extra_rows_.size(); ++k)
        result[extra_rows_[k]] += lambda[own + static_cast<Index>(k)];
    return model_.cost_unit * result;
}

StepModel projection_model(const Nlp& problem, const NlpPoint& start) {
    const NlpShape& shape = problem.shape();
    StepModel model;
    model.slope = VectorXd::Zero(shape.variables());
    model.curvature.resize(shape.variables(), shape.variables());
    model.curvature.setIdentity();
    model.rows = start.rows;
    model.step_lower = shape.x_lower - start.x;
    model.step_upper = shape.x_upper - start.x;
    model.weights = VectorXd::Ones(shape.constraints());
    model.without_nonlinear_rows = true;
    return model;
}

}  // namespace camopt::structured
