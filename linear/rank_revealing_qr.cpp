// SPDX-License-Identifier: MIT
#include "linear/rank_revealing_qr.hpp"

#include "core/errors.hpp"

namespace camopt {
namespace {

using Sparse = Eigen::SparseMatrix<double>;
using internal::ColumnOrder;
using internal::TriangularFactor;

/// Up to this many rows a rank-deficient system is factorized again from left to right, so that the first of
/// two equal rows is kept; beyond it the fill of this order may cost too much.
constexpr Eigen::Index natural_order_limit = 3000;

void check(const Sparse& matrix, const Eigen::VectorXd& right_side) {
    if (matrix.rows() != right_side.size())
        throw ModelError("analyse_rows: the matrix has " + std::to_string(matrix.rows()) +
                         " rows, the right side " + std::to_string(right_side.size()));
    bool finite = right_side.allFinite();
    for (Eigen::Index j = 0; j < matrix.outerSize(); ++j)
        for (Sparse::InnerIterator entry(matrix, j); entry; ++entry)
            finite = finite && std::isfinite(entry.value());
    if (!finite) throw ModelError("analyse_rows: an entry is not finite");
}

/// Norm of each row, safe from overflow.
Eigen::VectorXd row_lengths(const Sparse& matrix) {
    Eigen::VectorXd largest = Eigen::VectorXd::Zero(matrix.rows()), squares = largest;
    for (Eigen::Index j = 0; j < matrix.outerSize(); ++j)
        for (Sparse::InnerIterator entry(matrix, j); entry; ++entry)
            largest[entry.row()] = std::max(largest[entry.row()], std::abs(entry.value()));
    for (Eigen::Index j = 0; j < matrix.outerSize(); ++j)
        for (Sparse::InnerIterator entry(matrix, j); entry; ++entry)
            if (largest[entry.row()] > 0.0)
                squares[entry.row()] += std::pow(entry.value() / largest[entry.row()], 2);
    return largest.cwiseProduct(squares.cwiseSqrt());
}

/// Eᵀ with columns of length 1 (or 0).
Sparse scaled_transpose(const Sparse& matrix, const Eigen::VectorXd& length) {
    Sparse result = matrix.transpose();
    for (Eigen::Index i = 0; i < result.outerSize(); ++i)
        for (Sparse::InnerIterator entry(result, i); entry; ++entry)
            if (length[i] > 0.0) entry.valueRef() /= length[i];  // a row may consist of stored zeros
    result.prune(0.0, 0.0);
    result.makeCompressed();
    return result;
}

/// Columns of R that open a new row (pivots), and the others.
struct Split {
    std::vector<Eigen::Index> pivots, others;
};

Split split_columns(const Sparse& upper) {
    Split split;
    for (Eigen::Index j = 0; j < upper.cols(); ++j) {
        Eigen::Index lowest = -1;
        for (Sparse::InnerIterator entry(upper, j); entry; ++entry)
            if (entry.value() != 0.0) lowest = std::max<Eigen::Index>(lowest, entry.row());
        const auto next = static_cast<Eigen::Index>(split.pivots.size());
        (lowest >= next ? split.pivots : split.others).push_back(j);
    }
    return split;
}

Sparse pivot_block(const Sparse& upper, const Split& split) {
    const auto rank = static_cast<Eigen::Index>(split.pivots.size());
    std::vector<Eigen::Triplet<double>> entries;
    for (Eigen::Index k = 0; k < rank; ++k)
        for (Sparse::InnerIterator entry(upper, split.pivots[k]); entry; ++entry)
            if (entry.row() <= k)
                entries.emplace_back(static_cast<int>(entry.row()), static_cast<int>(k), entry.value());
    Sparse block(rank, rank);
    block.setFromTriplets(entries.begin(), entries.end());
    return block;
}

struct System {
    const Eigen::VectorXd& right_side;
    const Eigen::VectorXd& length;
    double tolerance;
};

/// `factors`: of the scaled rows behind the pivots.
DependentRow described(int row, const Eigen::VectorXd& factors, const std::vector<int>& pivot_rows,
                       const System& system) {
    DependentRow result;
    result.row = row;
    double mismatch = system.right_side[row];
    double size = std::max(std::abs(mismatch), system.length[row]);
    for (Eigen::Index k = 0; k < factors.size(); ++k) {
        const int other = pivot_rows[k];
        const double factor = factors[k] * system.length[row] / system.length[other];
        mismatch -= factor * system.right_side[other];
        size = std::max(size, std::abs(factor * system.right_side[other]));
        if (std::abs(factors[k]) > system.tolerance) result.combination.emplace_back(other, factor);
    }
    std::sort(result.combination.begin(), result.combination.end());
    result.mismatch = std::abs(mismatch) <= system.tolerance * size ? 0.0 : mismatch;
    return result;
}

}  // namespace

RowDependence analyse_rows(const Sparse& matrix, const Eigen::VectorXd& right_side, double tolerance) {
    check(matrix, right_side);
    RowDependence result;
    const Eigen::VectorXd length = row_lengths(matrix);
    const Sparse columns = scaled_transpose(matrix, length);
    TriangularFactor factor;
    Split split;
    if (columns.nonZeros() == 0) {
        for (int i = 0; i < matrix.rows(); ++i) result.dependent.push_back({i, {}, right_side[i]});
        return result;
    }
    factor = internal::triangular_factor(columns, tolerance, ColumnOrder::fill_reducing);
    split = split_columns(factor.upper);
    if (!split.others.empty() && matrix.rows() <= natural_order_limit) {
        TriangularFactor natural = internal::triangular_factor(columns, tolerance, ColumnOrder::natural);
        Split natural_split = split_columns(natural.upper);
        if (natural_split.pivots.size() == split.pivots.size()) {
            factor = std::move(natural);
            split = std::move(natural_split);
        }
    }

    std::vector<int> pivot_rows;
    for (const Eigen::Index j : split.pivots) pivot_rows.push_back(factor.column[j]);
    const Sparse block = pivot_block(factor.upper, split);
    for (const Eigen::Index j : split.others) {
        const int row = factor.column[j];
        Eigen::VectorXd factors = Eigen::VectorXd::Zero(block.rows());
        if (length[row] > 0.0) {
            for (Sparse::InnerIterator entry(factor.upper, j); entry; ++entry)
                factors[entry.row()] = entry.value();
            block.triangularView<Eigen::Upper>().solveInPlace(factors);
        }
        result.dependent.push_back(described(row, factors, pivot_rows, {right_side, length, tolerance}));
        if (length[row] == 0.0) result.dependent.back() = {row, {}, right_side[row]};
    }
    result.independent = std::move(pivot_rows);
    std::sort(result.independent.begin(), result.independent.end());
    std::sort(result.dependent.begin(), result.dependent.end(),
              [](const DependentRow& a, const DependentRow& b) { return a.row < b.row; });
    return result;
}

}  // namespace camopt
