// SPDX-License-Identifier: MIT
#include "linear/compressed_rows.hpp"

#include <algorithm>
#include <cstddef>
#include <numeric>

namespace camopt {
namespace {

double long_sum(int count, const int* column, const double* value, const double* x) {
    double a = 0.0, b = 0.0, c = 0.0, d = 0.0;  // four independent sums
    int k = 0;
    for (; k + 4 <= count; k += 4) {
        a += value[k] * x[column[k]];
        b += value[k + 1] * x[column[k + 1]];
        c += value[k + 2] * x[column[k + 2]];
        d += value[k + 3] * x[column[k + 3]];
    }
    for (; k < count; ++k) a += value[k] * x[column[k]];
    return (a + b) + (c + d);
}

/// Rows of Length entries each; Length 0: length known at run time.
template <int Length>
struct RowsOf {
    template <typename Keep>
    static void multiply(const int* row, const int* end, int length, const int* column, const double* value,
                         const double* x, Keep&& keep) {
        const int count = Length > 0 ? Length : length;
        for (; row != end; ++row, column += count, value += count) {
            if constexpr (Length == 0) {
                keep(*row, long_sum(count, column, value, x));
            } else {
                double sum = 0.0;
#pragma GCC unroll 12
                for (int k = 0; k < Length; ++k) sum += value[k] * x[column[k]];
                keep(*row, sum);
            }
        }
    }
};

/// Calls visit(RowsOf<length>) for short rows, RowsOf<0> for others.
template <typename Visit>
void with_length(int length, Visit&& visit) {
    switch (length) {
        case 1:
            return visit(RowsOf<1>{});
        case 2:
            return visit(RowsOf<2>{});
        case 3:
            return visit(RowsOf<3>{});
        case 4:
            return visit(RowsOf<4>{});
        case 5:
            return visit(RowsOf<5>{});
        case 6:
            return visit(RowsOf<6>{});
        case 8:
            return visit(RowsOf<8>{});
        case 10:
            return visit(RowsOf<10>{});
        default:
            return visit(RowsOf<0>{});
    }
}

}  // namespace

CompressedRows::CompressedRows(const Eigen::SparseMatrix<double, Eigen::RowMajor>& matrix)
    : row_(static_cast<std::size_t>(matrix.rows())) {
    arrange(matrix.outerIndexPtr(), matrix.innerIndexPtr(), matrix.valuePtr());
}

CompressedRows::CompressedRows(const Entries& entries, const std::vector<int>& names) : row_(names.size()) {
    arrange(entries.begin.data(), entries.columns.data(), entries.values.data());
    for (int& row : row_) row = names[static_cast<std::size_t>(row)];
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
    for (int row = 0; row < rows; ++row)
        row_[static_cast<std::size_t>(next[static_cast<std::size_t>(length_of(row))]++)] = row;
    column_.reserve(static_cast<std::size_t>(rows > 0 ? begin[rows] : 0));
    value_.reserve(column_.capacity());
    for (int k = 0; k < rows; ++k) {
        const int row = row_[static_cast<std::size_t>(k)];
        if (groups_.empty() || groups_.back().length != length_of(row))
            groups_.push_back({length_of(row), k, k, static_cast<int>(column_.size())});
        ++groups_.back().last;
        for (int e = begin[row]; e < begin[row + 1]; ++e) {
            column_.push_back(columns[e]);
            value_.push_back(values[e]);
        }
    }
}

void CompressedRows::multiply(const double* x, double* to) const {
    for (const Group& group : groups_)
        with_length(group.length, [&](auto rows) {
            rows.multiply(row_.data() + group.first, row_.data() + group.last, group.length,
                          column_.data() + group.entry, value_.data() + group.entry, x,
                          [&](int row, double sum) { to[row] = sum; });
        });
}

void CompressedRows::add_product(double factor, const Eigen::VectorXd& x, Eigen::VectorXd& out) const {
    double* const to = out.data();
    for (const Group& group : groups_)
        with_length(group.length, [&](auto rows) {
            rows.multiply(row_.data() + group.first, row_.data() + group.last, group.length,
                          column_.data() + group.entry, value_.data() + group.entry, x.data(),
                          [&](int row, double sum) { to[row] += factor * sum; });
        });
}

}  // namespace camopt
