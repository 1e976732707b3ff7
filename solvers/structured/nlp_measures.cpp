// SPDX-License-Identifier: MIT
#include "solvers/structured/linearized_problem.hpp"

namespace camopt::structured {

namespace {

using Eigen::Index;
using Eigen::VectorXd;

constexpr double at_bound = 1e-7;     // relative distance
constexpr double significant = 1e-6;  // part of the largest multiplier above which a row counts as active
constexpr double rounding = 1e-14;

double excess(const NlpShape& shape, const VectorXd& rows, Index i) {
    return std::max({shape.g_lower[i] - rows[i], rows[i] - shape.g_upper[i], 0.0});
}

}  // namespace

double violation_of(const NlpShape& shape, const VectorXd& rows, bool linear) {
    double worst = 0.0;
    for (Index i = 0; i < rows.size(); ++i)
        if (kind_of(shape, i).linear == linear)
            worst = std::max(worst, excess(shape, rows, i) / kind_of(shape, i).scale);
    return worst;
}

bool keeps_rows(const NlpShape& shape, const NlpPoint& point, const RowMatrix& jacobian, double tolerance) {
    for (Index i = 0; i < point.rows.size(); ++i) {
        double noise = 0.0;
        for (RowMatrix::InnerIterator entry(jacobian, i); entry; ++entry)
            noise += rounding * std::abs(entry.value()) * (1.0 + std::abs(point.x[entry.col()]));
        if (excess(shape, point.rows, i) > std::max(tolerance * kind_of(shape, i).scale, noise)) return false;
    }
    return true;
}

double needed_penalty(const NlpShape& shape, const VectorXd& multipliers) {
    double needed = 0.0;
    for (Index i = 0; i < multipliers.size(); ++i)
        if (!kind_of(shape, i).linear) needed += std::abs(multipliers[i]) * kind_of(shape, i).scale;
    return needed;
}

double Stationarity::error() const {
    const VectorXd rest = lagrangian_gradient();
    double worst = 0.0;
    for (Index j = 0; j < rest.size(); ++j) {
        const double bound = rest[j] > 0.0 ? shape.x_lower[j] : shape.x_upper[j];
        if (std::abs(point.x[j] - bound) > at_bound * (1.0 + std::abs(point.x[j])))
            worst = std::max(worst, std::abs(rest[j]));
    }
    return worst;
}

ActiveRows Stationarity::active_rows(double reach) const {
    VectorXd force = VectorXd::Zero(multipliers.size()), length = force;
    for (Index i = 0; i < multipliers.size(); ++i) {
        length[i] = jacobian.row(i).norm();
        force[i] = std::abs(multipliers[i]) * length[i];
    }
    const double least = significant * (force.size() > 0 ? force.maxCoeff() : 0.0);
    std::vector<Eigen::Triplet<double>> entries;
    std::vector<double> residuals;
    const auto row = [&] { return static_cast<int>(residuals.size()); };
    for (Index i = 0; i < force.size(); ++i) {
        const bool equality = shape.g_lower[i] == shape.g_upper[i];
        if (length[i] == 0.0 || (!equality && !(force[i] > least))) continue;
        const double side = multipliers[i] > 0.0 ? shape.g_upper[i] : shape.g_lower[i];
        const double residual = std::isfinite(side) ? (point.rows[i] - side) / length[i] : 0.0;
        const double slack = multipliers[i] > 0.0 ? -residual : residual;
        if (!equality && slack > reach) continue;
        for (RowMatrix::InnerIterator entry(jacobian, i); entry; ++entry)
            entries.emplace_back(row(), static_cast<int>(entry.col()), entry.value() / length[i]);
        residuals.push_back(residual);
    }
    const VectorXd rest = lagrangian_gradient();
    for (Index j = 0; j < rest.size(); ++j) {
        const double bound = rest[j] > 0.0 ? shape.x_lower[j] : shape.x_upper[j];
        const bool held =
            std::abs(point.x[j] - bound) <= at_bound * (1.0 + std::abs(bound)) && std::abs(rest[j]) > least;
        if (!held && shape.x_lower[j] != shape.x_upper[j]) continue;
        entries.emplace_back(row(), static_cast<int>(j), 1.0);
        residuals.push_back(0.0);
    }
    ActiveRows result;
    result.normals.resize(row(), shape.variables());
    result.normals.setFromTriplets(entries.begin(), entries.end());
    result.residuals = Eigen::Map<const VectorXd>(residuals.data(), row());
    return result;
}

VectorXd bound_multipliers(const NlpShape& shape, const VectorXd& gradient) {
    VectorXd result = -gradient;
    for (Index j = 0; j < result.size(); ++j)
        if (!std::isfinite(result[j] > 0.0 ? shape.x_upper[j] : shape.x_lower[j])) result[j] = 0.0;
    return result;
}

std::vector<bool> curved_variables(const NlpShape& shape) {
    std::vector<bool> curved(static_cast<std::size_t>(shape.variables()), false);
    for (std::size_t e = 0; e < shape.jacobian.rows.size(); ++e)
        if (!kind_of(shape, shape.jacobian.rows[e]).linear)
            curved[static_cast<std::size_t>(shape.jacobian.columns[e])] = true;
    for (std::size_t e = 0; !shape.linear_cost && e < shape.hessian.rows.size(); ++e) {
        curved[static_cast<std::size_t>(shape.hessian.rows[e])] = true;
        curved[static_cast<std::size_t>(shape.hessian.columns[e])] = true;
    }
    return curved;
}

std::vector<double> lagrangian_hessian(const Nlp& problem, const VectorXd& x, const VectorXd& multipliers) {
    std::vector<double> values(static_cast<std::size_t>(problem.shape().hessian.size()));
    problem.hessian(x, 1.0, multipliers, values);
    for (double& value : values)
        if (!std::isfinite(value)) value = 0.0;
    return values;
}

}  // namespace camopt::structured
