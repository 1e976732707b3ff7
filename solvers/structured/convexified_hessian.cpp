// SPDX-License-Identifier: MIT
#include "solvers/structured/convexified_hessian.hpp"

#include <Eigen/SparseCholesky>

#include <algorithm>
#include <cmath>
#include <vector>

namespace camopt::structured {
namespace {

using Eigen::VectorXd;
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

/// Largest sum of absolute values of a row: a bound of every eigenvalue.
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
    // Little more than is needed: a large shift keeps the sequence at saddle points for long.
    for (int k = 0; k < halvings; ++k) {
        const double middle = 0.5 * (refused + result.shift);
        (positive_definite(base + middle * unit) ? result.shift : refused) = middle;
    }
    result.shift *= margin;
    result.lower = base + result.shift * unit;
    return result;
}

}  // namespace camopt::structured
