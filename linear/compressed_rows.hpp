// SPDX-License-Identifier: MIT
// A sparse matrix A for products in the inner loop of a solver: no temporaries, no allocation.
//
// Rows of equal length are grouped, so that short ones (a sampled rule has two to five entries) are unrolled.
// Store Aᵀ as a separate matrix: scattering rows into a result serializes on shared entries of a dense
// column.
#pragma once

#include "core/base/standard.hpp"
#include "linear/kernels.hpp"

#include <Eigen/Core>
#include <Eigen/SparseCore>

namespace camopt {

class CompressedRows {
 public:
    CompressedRows() = default;
    using Matrix = Eigen::SparseMatrix<double, Eigen::RowMajor>;
    explicit CompressedRows(const Eigen::Ref<const Matrix>& matrix);
    /// Row k has the entries [begin[k], begin[k + 1]) of `columns` and `values`. It is row names[k] of A,
    /// whose other rows are absent: a product leaves their entries of `out` unchanged.
    struct Entries {
        std::vector<int> begin, columns;
        std::vector<double> values;
    };
    CompressedRows(const Entries& entries, const std::vector<int>& names);

    /// out = A x; `out` already has the right size.
    void multiply(const Eigen::VectorXd& x, Eigen::VectorXd& out) const { multiply(x.data(), out.data()); }
    void multiply(const double* x, double* out) const { kernels_->multiply(rows(), x, out); }
    /// out = base + factor · A x; `base` may be `out`.
    void add_product(double factor, const double* x, const double* base, double* out) const {
        kernels_->add_product(rows(), factor, x, base, out);
    }

 private:
    void arrange(const int* begin, const int* columns, const double* values);
    [[nodiscard]] RowGroups rows() const {
        return {groups_.data(), static_cast<int>(groups_.size()), row_.data(), column_.data(), value_.data()};
    }
    const LinearKernels* kernels_ = &linear_kernels();
    std::vector<RowGroups::Group> groups_;
    std::vector<int> row_;  ///< of the matrix, in the new order
    std::vector<int> column_;
    std::vector<double> value_;
};

}  // namespace camopt
