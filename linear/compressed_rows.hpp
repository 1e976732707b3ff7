// SPDX-License-Identifier: MIT
// A sparse matrix A for products in the inner loop of a solver: no temporaries, no allocation.
//
// Rows of equal length are grouped, so that short ones (a sampled rule has two to five entries) are unrolled.
// Store Aᵀ as a separate matrix: scattering rows into a result serializes on shared entries of a dense
// column.
#pragma once

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <vector>

namespace camopt {

class CompressedRows {
 public:
    CompressedRows() = default;
    explicit CompressedRows(const Eigen::SparseMatrix<double, Eigen::RowMajor>& matrix);
    /// Row k has the entries [begin[k], begin[k + 1]) of `columns` and `values`. It is row names[k] of A,
    /// whose other rows are absent: a product leaves their entries of `out` unchanged.
    struct Entries {
        std::vector<int> begin, columns;
        std::vector<double> values;
    };
    CompressedRows(const Entries& entries, const std::vector<int>& names);

    /// out = A x; `out` already has the right size.
    void multiply(const Eigen::VectorXd& x, Eigen::VectorXd& out) const { multiply(x.data(), out.data()); }
    void multiply(const double* x, double* out) const;
    /// out += factor · A x
    void add_product(double factor, const Eigen::VectorXd& x, Eigen::VectorXd& out) const;

 private:
    void arrange(const int* begin, const int* columns, const double* values);
    struct Group {
        int length = 0, first = 0, last = 0;  ///< entries a row; rows [first, last) of the new order
        int entry = 0;                        ///< of the first row
    };
    std::vector<Group> groups_;
    std::vector<int> row_;  ///< of the matrix, in the new order
    std::vector<int> column_;
    std::vector<double> value_;
};

}  // namespace camopt
