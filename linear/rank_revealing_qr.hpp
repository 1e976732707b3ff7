// SPDX-License-Identifier: MIT
// Rank-revealing QR: which rows of a sparse system E x = e are independent, redundant or contradictory.
//
// QR of Eᵀ with column pivoting after each row of E is scaled to unit length. A dependent row i satisfies E_i
// = Σ_k combination_k E_{independent k}; its mismatch is e_i − Σ_k combination_k e_k (in the row's own
// units), set to exactly 0 where it is below tolerance · max(‖E_i‖, |e_i|, |combination_k e_k|). A zero row
// is dependent with an empty combination and the mismatch e_i. Of interchangeable rows the earlier ones stay
// independent (up to some thousand rows; beyond that the fill-reducing order decides).
#pragma once

#include "core/base/standard.hpp"

#include <Eigen/Core>
#include <Eigen/SparseCore>

namespace camopt {

struct DependentRow {
    int row = 0;
    std::vector<std::pair<int, double>>
        combination;        ///< (independent row, factor), factors above the tolerance only
    double mismatch = 0.0;  ///< 0 (to tolerance): redundant; else contradictory
};

struct RowDependence {
    std::vector<int> independent;         ///< ascending
    std::vector<DependentRow> dependent;  ///< ascending by row
};

/// `tolerance`: relative size below which a pivot counts as zero; the default allows for products of many
/// well-scaled rows. Uses SuiteSparseQR if this build has it, Eigen::SparseQR otherwise. Throws ModelError
/// for sizes that differ or an entry that is not finite.
[[nodiscard]] RowDependence analyse_rows(const Eigen::SparseMatrix<double>& matrix,
                                         const Eigen::VectorXd& right_side, double tolerance = 1e-10);

}  // namespace camopt

namespace camopt::internal {

// Internal to linear/: the triangular factor of a rank-revealing sparse QR, from the library of this build.
//
// M P = Q R, M with columns of length 1 (or 0). R is upper trapezoidal or a staircase: a column whose lowest
// entry opens a new row is a pivot, every other column depends on the pivots before it. One of
// rank_revealing_qr_spqr.cpp and rank_revealing_qr_eigen.cpp is compiled.

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
