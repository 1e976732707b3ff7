// SPDX-License-Identifier: MIT
#include "tests/soak/stability/condition_number.hpp"

#include "core/errors.hpp"
#include "objectives/grid/cam_problem.hpp"
#include "objectives/scene_model.hpp"

#include <cmath>
#include <limits>
#include <vector>

namespace camopt::stability {

namespace {

using Matrix = Eigen::MatrixXd;

void add_row(Matrix& matrix, int row, const AffineRow& values) {
    for (std::size_t k = 0; k < values.columns.size(); ++k)
        matrix(row, values.columns[k]) += values.weights[k];
}

Matrix equality_matrix(const MotionFamily& family) {
    Matrix matrix = Matrix::Zero(static_cast<int>(family.equalities().size()), family.size());
    for (int row = 0; row < matrix.rows(); ++row) add_row(matrix, row, family.equalities()[row].row);
    return matrix;
}

Matrix sample_matrix(const MotionFamily& family, int order) {
    const auto& pieces = family.pieces();
    const int count = static_cast<int>(pieces.size());
    Matrix matrix = Matrix::Zero(2 * count + 1, family.size());
    for (int k = 0; k < count; ++k) {
        add_row(matrix, 2 * k, family.functional(pieces[k].begin, order, Side::right));
        add_row(matrix, 2 * k + 1, family.functional(0.5 * (pieces[k].begin + pieces[k].end), order));
    }
    add_row(matrix, 2 * count, family.functional(family.end(), order, Side::left));
    return matrix;
}

// Eigen's decompositions of this file took 40 s to compile.

/// Orthonormal basis of the null space of E: the last columns of the product of the reflections that make
/// its transpose triangular.
Matrix null_space(const Matrix& equalities) {
    Matrix rest = equalities.transpose();
    std::vector<Eigen::VectorXd> mirrors;
    for (Eigen::Index k = 0; k < rest.cols(); ++k) {
        Eigen::VectorXd mirror = rest.col(k);
        mirror.head(k).setZero();
        mirror(k) += std::copysign(mirror.norm(), mirror(k));
        mirror /= mirror.norm();
        for (Eigen::Index j = k; j < rest.cols(); ++j) rest.col(j) -= 2.0 * mirror.dot(rest.col(j)) * mirror;
        mirrors.push_back(std::move(mirror));
    }
    Matrix basis = Matrix::Zero(rest.rows(), rest.rows() - rest.cols());
    for (Eigen::Index j = 0; j < basis.cols(); ++j) basis(rest.cols() + j, j) = 1.0;
    for (auto mirror = mirrors.rbegin(); mirror != mirrors.rend(); ++mirror)
        for (Eigen::Index j = 0; j < basis.cols(); ++j)
            basis.col(j) -= 2.0 * mirror->dot(basis.col(j)) * *mirror;
    return basis;
}

/// One-sided Jacobi: turns pairs of columns until all are orthogonal; their lengths are the singular values.
double ratio_of_singular_values(Matrix matrix) {
    constexpr int most_sweeps = 60;
    bool turned = true;
    for (int sweep = 0; turned && sweep < most_sweeps; ++sweep) {
        turned = false;
        for (Eigen::Index p = 0; p < matrix.cols(); ++p) {
            for (Eigen::Index q = p + 1; q < matrix.cols(); ++q) {
                const double left = matrix.col(p).squaredNorm(), right = matrix.col(q).squaredNorm();
                const double both = matrix.col(p).dot(matrix.col(q));
                if (std::abs(both) <= std::numeric_limits<double>::epsilon() * std::sqrt(left * right))
                    continue;
                turned = true;
                const double slope = (right - left) / (2.0 * both);
                const double tangent = std::copysign(1.0 / (std::abs(slope) + std::hypot(1.0, slope)), slope);
                const double cosine = 1.0 / std::hypot(1.0, tangent);
                const Eigen::VectorXd before = matrix.col(p);
                matrix.col(p) = cosine * (before - tangent * matrix.col(q));
                matrix.col(q) = cosine * (matrix.col(q) + tangent * before);
            }
        }
    }
    double least = std::numeric_limits<double>::infinity(), largest = 0.0;
    for (Eigen::Index k = 0; k < matrix.cols(); ++k) {
        least = std::min(least, matrix.col(k).norm());
        largest = std::max(largest, matrix.col(k).norm());
    }
    return largest / least;
}

}  // namespace

double condition_number(const Scene& scene, DesignKind kind, int order) {
    const CamModel model = scene_model(scene, kind, reference_peaks(scene));
    if (model.design.freedom() == 0)
        throw InputError("condition_number: found a motion without freedom; allowed: one with some");
    const Eigen::VectorXd scales = design_scales(model);
    const Matrix basis = null_space(equality_matrix(model.design) * scales.asDiagonal());
    return ratio_of_singular_values(sample_matrix(model.design, order) * scales.asDiagonal() * basis);
}

}  // namespace camopt::stability
