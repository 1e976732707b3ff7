// SPDX-License-Identifier: MIT
#include "core/errors.hpp"
#include "linear/rank_revealing_qr.hpp"

#include <Eigen/OrderingMethods>
#include <Eigen/SparseQR>

namespace camopt::internal {
namespace {

template <class Ordering>
TriangularFactor factor_with(const Eigen::SparseMatrix<double>& matrix, double tolerance) {
    Eigen::SparseQR<Eigen::SparseMatrix<double>, Ordering> qr;
    qr.setPivotThreshold(tolerance);
    qr.compute(matrix);
    if (qr.info() != Eigen::Success) throw ModelError("sparse QR failed: " + qr.lastErrorMessage());
    TriangularFactor result;
    result.upper = qr.matrixR();
    const auto& permutation = qr.colsPermutation().indices();
    result.column.resize(static_cast<std::size_t>(matrix.cols()));
    for (Eigen::Index j = 0; j < matrix.cols(); ++j) result.column[j] = permutation[j];
    return result;
}

}  // namespace

TriangularFactor triangular_factor(const Eigen::SparseMatrix<double>& matrix, double tolerance,
                                   ColumnOrder order) {
    if (order == ColumnOrder::natural) return factor_with<Eigen::NaturalOrdering<int>>(matrix, tolerance);
    return factor_with<Eigen::COLAMDOrdering<int>>(matrix, tolerance);
}

}  // namespace camopt::internal
