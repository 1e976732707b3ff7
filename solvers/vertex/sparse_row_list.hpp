// SPDX-License-Identifier: MIT
// Compressed sparse rows that can be appended and removed.
#pragma once

#include <Eigen/Core>

#include <cstddef>
#include <vector>

namespace camopt {

class SparseRowList {
 public:
    [[nodiscard]] int size() const { return static_cast<int>(begin_.size()) - 1; }
    void add(const Eigen::VectorXd& row) {
        for (Eigen::Index j = 0; j < row.size(); ++j) {
            if (row[j] != 0.0) entries_.push_back({static_cast<int>(j), row[j]});
        }
        begin_.push_back(entries_.size());
    }
    /// `stay`: ascending.
    void keep(const std::vector<int>& stay) {
        std::size_t to = 0, rows = 0;
        for (const int row : stay) {
            const auto from = static_cast<std::size_t>(row);
            const std::size_t end = begin_[from + 1];
            for (std::size_t k = begin_[from]; k < end; ++k) entries_[to++] = entries_[k];
            begin_[++rows] = to;
        }
        entries_.resize(to);
        begin_.resize(rows + 1);
    }
    /// visit(column, entry) of the nonzeros, in the order of the columns.
    template <class Visit>
    void each(int row, const Visit& visit) const {
        const auto at = static_cast<std::size_t>(row);
        for (std::size_t k = begin_[at]; k < begin_[at + 1]; ++k)
            visit(entries_[k].column, entries_[k].value);
    }
    [[nodiscard]] double dot(int row, const Eigen::VectorXd& x) const {
        double sum = 0.0;
        each(row, [&](int column, double value) { sum += value * x[column]; });
        return sum;
    }
    [[nodiscard]] Eigen::VectorXd times(const Eigen::VectorXd& x) const {
        Eigen::VectorXd product(size());
        for (int row = 0; row < size(); ++row) product[row] = dot(row, x);
        return product;
    }

 private:
    struct Entry {
        int column;
        double value;
    };
    std::vector<std::size_t> begin_{0};
    std::vector<Entry> entries_;
};

}  // namespace camopt
