// SPDX-License-Identifier: MIT
#include "solvers/structured/linearized_problem.hpp"

#include <Eigen/SparseCholesky>

#include <algorithm>

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

using Matrix = Eigen::SparseMatrix<double>;

Matrix identity(Eigen::Index size) {
    Matrix result(size, size);
    result.setIdentity();
    return result;
}

bool positive_definite(const Matrix& lower) {
    const Eigen::SimplicialLLT<Matrix, Eigen::Lower> factor(lower);
    return factor.info() == Eigen::Success;
}

/// Largest sum of absolute values of a row: a bound of every eigenvalue (Gershgorin).
double row_sum(const Matrix& lower) {
    VectorXd sums = VectorXd::Zero(lower.rows());
    for (Eigen::Index j = 0; j < lower.outerSize(); ++j)
        for (Matrix::InnerIterator entry(lower, j); entry; ++entry) {
            sums[entry.row()] += std::abs(entry.value());
            if (entry.row() != entry.col()) sums[entry.col()] += std::abs(entry.value());
        }
    return sums.size() > 0 ? sums.maxCoeff() : 0.0;
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

VectorXd Stationarity::lagrangian_gradient() const {
    return point.gradient + jacobian.transpose() * multipliers;
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

Eigen::SparseMatrix<double> lagrangian_hessian(const Nlp& problem, const VectorXd& x,
                                               const VectorXd& multipliers) {
    const NlpShape& shape = problem.shape();
    std::vector<double> values(static_cast<std::size_t>(shape.hessian.size()));
    problem.hessian(x, 1.0, multipliers, values);
    std::vector<Eigen::Triplet<double>> entries;
    entries.reserve(values.size());
    for (std::size_t e = 0; e < values.size(); ++e)
        entries.emplace_back(std::max(shape.hessian.rows[e], shape.hessian.columns[e]),
                             std::min(shape.hessian.rows[e], shape.hessian.columns[e]),
                             std::isfinite(values[e]) ? values[e] : 0.0);
    Eigen::SparseMatrix<double> result(shape.variables(), shape.variables());
    result.setFromTriplets(entries.begin(), entries.end());
    return result;
}

ActiveRows ActiveRows::part(const std::function<bool(Eigen::Index)>& chosen) const {
    std::vector<Eigen::Triplet<double>> entries;
    std::vector<double> kept;
    for (Eigen::Index i = 0; i < residuals.size(); ++i) {
        if (!chosen(i)) continue;
        const int row = static_cast<int>(kept.size());
        for (decltype(normals)::InnerIterator entry(normals, i); entry; ++entry)
            entries.emplace_back(row, static_cast<int>(entry.col()), entry.value());
        kept.push_back(residuals[i]);
    }
    ActiveRows result;
    result.normals.resize(static_cast<Eigen::Index>(kept.size()), normals.cols());
    result.normals.setFromTriplets(entries.begin(), entries.end());
    result.residuals = Eigen::Map<const VectorXd>(kept.data(), static_cast<Eigen::Index>(kept.size()));
    return result;
}

ConvexifiedHessian convexified(const Matrix& lower, const ActiveRows& active, double least) {
    constexpr double first_shift = 1e-4, growth = 4.0, margin = 1.2;
    constexpr int weights = 5, halvings = 4;
    const Eigen::Index size = lower.rows();
    const Matrix unit = identity(size);
    const double bound = row_sum(lower);
    ConvexifiedHessian result{lower + least * unit, VectorXd::Zero(size)};
    if (bound == 0.0 || positive_definite(result.lower)) return result;
    Matrix gram(size, size);
    if (active.normals.rows() > 0) {
        const Matrix normals = active.normals;
        gram = Matrix(Matrix(normals.transpose()) * normals).triangularView<Eigen::Lower>();
        result.holds = true;
        double weight = bound;
        for (int k = 0; k < weights; ++k, weight *= 10.0) {
            result.lower = lower + weight * gram + least * unit;
            if (!positive_definite(result.lower)) continue;
            result.slope = weight * (active.normals.transpose() * active.residuals);
            return result;
        }
        result.slope = bound * (active.normals.transpose() * active.residuals);
    }
    const Matrix base = lower + bound * gram + least * unit;
    double refused = 0.0;
    for (result.shift = first_shift * bound; result.shift < bound; result.shift *= growth) {
        if (positive_definite(base + result.shift * unit)) break;
        refused = result.shift;
    }
    // Slightly more than needed: a large shift keeps the sequence at saddle points for long.
    for (int k = 0; k < halvings; ++k) {
        const double middle = 0.5 * (refused + result.shift);
        (positive_definite(base + middle * unit) ? result.shift : refused) = middle;
    }
    result.shift *= margin;
    result.lower = base + result.shift * unit;
    return result;
}

}  // namespace camopt::structured
