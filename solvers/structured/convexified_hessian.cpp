// SPDX-License-Identifier: MIT
#include "solvers/structured/convexified_hessian.hpp"

#include <Eigen/SparseCholesky>

#include <algorithm>
#include <cmath>

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

ConvexifiedHessian convexified(const Matrix& lower, const ActiveRows& active, double least) {
    constexpr double most_weight = 1e4, first_shift = 1e-4;
    const Eigen::Index size = lower.rows();
    const Matrix unit = identity(size);
    const double bound = row_sum(lower);
    ConvexifiedHessian result{lower + least * unit, VectorXd::Zero(size), 0.0};
    if (bound == 0.0 || positive_definite(result.lower)) return result;
    Matrix gram(size, size);
    if (active.normals.rows() > 0) {
        const Matrix normals = active.normals;
        gram = Matrix(Matrix(normals.transpose()) * normals).triangularView<Eigen::Lower>();
        for (double weight = bound; weight <= most_weight * bound; weight *= 10.0) {
            result.lower = lower + weight * gram + least * unit;
            if (!positive_definite(result.lower)) continue;
            result.slope = weight * (active.normals.transpose() * active.residuals);
            return result;
        }
        result.slope = bound * (active.normals.transpose() * active.residuals);
    }
    for (result.shift = first_shift * bound;; result.shift *= 4.0) {
        result.lower = lower + bound * gram + (result.shift + least) * unit;
        if (result.shift > bound || positive_definite(result.lower)) return result;
    }
}

}  // namespace camopt::structured
