// SPDX-License-Identifier: MIT
#include "benchmarks/stability/condition_number.hpp"

#include "core/errors.hpp"
#include "objectives/grid/cam_problem.hpp"
#include "objectives/scene_model.hpp"

#include <Eigen/QR>
#include <Eigen/SVD>

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

/// Orthonormal basis of the null space of E.
Matrix null_space(const Matrix& equalities) {
    const int size = static_cast<int>(equalities.cols());
    const int rows = static_cast<int>(equalities.rows());
    if (rows == 0) return Matrix::Identity(size, size);
    const Eigen::HouseholderQR<Matrix> factors(equalities.transpose());
    Matrix last = Matrix::Zero(size, size - rows);
    last.bottomRows(size - rows).setIdentity();
    last.applyOnTheLeft(factors.householderQ());
    return last;
}

}  // namespace

double condition_number(const Scene& scene, DesignKind kind, int order) {
    const CamModel model = scene_model(scene, kind, reference_peaks(scene));
    if (model.design.freedom() == 0)
        throw InputError("condition_number: found a motion without freedom; allowed: one with some");
    const Eigen::VectorXd scales = design_scales(model);
    const Matrix basis = null_space(equality_matrix(model.design) * scales.asDiagonal());
    const Matrix map = sample_matrix(model.design, order) * scales.asDiagonal() * basis;
    const Eigen::BDCSVD<Matrix> factors(map);
    return factors.singularValues()(0) / factors.singularValues()(map.cols() - 1);
}

}  // namespace camopt::stability
