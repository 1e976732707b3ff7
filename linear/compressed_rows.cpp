// SPDX-License-Identifier: MIT
#include "linear/compressed_rows.hpp"

#include <numeric>

namespace camopt {

CompressedRows::CompressedRows(const Eigen::Ref<const Matrix>& matrix)
    : row_(static_cast<std::size_t>(matrix.rows())) {
    arrange(matrix.outerIndexPtr(), matrix.innerIndexPtr(), matrix.valuePtr());
}

CompressedRows::CompressedRows(const Entries& entries, const std::vector<int>& names) : row_(names.size()) {
    arrange(entries.begin.data(), entries.columns.data(), entries.values.data());
    for (int& row : row_) row = names[row];
}

/// Rows by their length, each length in the order of the matrix.
void CompressedRows::arrange(const int* begin, const int* columns, const double* values) {
    const auto rows = static_cast<int>(row_.size());
    const auto length_of = [&](int row) { return begin[row + 1] - begin[row]; };
    int longest = 0;
    for (int row = 0; row < rows; ++row) longest = std::max(longest, length_of(row));
    std::vector<int> next(static_cast<std::size_t>(longest) + 2, 0);
    for (int row = 0; row < rows; ++row) ++next[static_cast<std::size_t>(length_of(row)) + 1];
    std::partial_sum(next.begin(), next.end(), next.begin());
    for (int row = 0; row < rows; ++row) row_[static_cast<std::size_t>(next[length_of(row)]++)] = row;
    column_.reserve(static_cast<std::size_t>(rows > 0 ? begin[rows] : 0));
    value_.reserve(column_.capacity());
    for (int k = 0; k < rows; ++k) {
        const int row = row_[k];
        if (groups_.empty() || groups_.back().length != length_of(row))
            groups_.push_back({length_of(row), k, k, static_cast<int>(column_.size())});
        ++groups_.back().last;
        for (int e = begin[row]; e < begin[row + 1]; ++e) {
            column_.push_back(columns[e]);
            value_.push_back(values[e]);
        }
    }
}

}  // namespace camopt
