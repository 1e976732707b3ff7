// SPDX-License-Identifier: MIT
// Internal to linear/: the triangular factor of a rank-revealing sparse QR, from the library of this build.
//
// M P = Q R, M with columns of length 1 (or 0). R is upper trapezoidal or a staircase: a column whose lowest
// entry opens a new row is a pivot, every other column depends on the pivots before it. One of
// rank_revealing_qr_spqr.cpp and rank_revealing_qr_eigen.cpp is compiled.
#pragma once

#include <Eigen/SparseCore>

#include <vector>

namespace camopt::internal {

enum class ColumnOrder {
    fill_reducing,  ///< the library's choice
    natural         ///< left to right: earlier columns become pivots, at the cost of fill in R
};

struct TriangularFactor {
    Eigen::SparseMatrix<double> upper;  ///< R
    std::vector<int> column;            ///< column of M behind each column of R
};

/// A column whose remaining norm is at most `tolerance` counts as dependent. Throws ModelError if the library
/// fails (out of memory).
[[nodiscard]] TriangularFactor triangular_factor(const Eigen::SparseMatrix<double>& matrix, double tolerance,
                                                 ColumnOrder order);

}  // namespace camopt::internal
