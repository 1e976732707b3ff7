// SPDX-License-Identifier: MIT
#include "solvers/structured/newton/condensed_pattern.hpp"

#include <algorithm>
#include <cstddef>

namespace camopt::structured {
namespace {

using RowMajor = RangeRows::RowMajor;

/// Goes through the matrix column by column.
class PatternBuilder {
 public:
    PatternBuilder(const ConvexModel& model, const RangeRows& ranges)
        : model_(model),
          ranges_(ranges),
          by_column_(ranges.matrix),
          variables_(static_cast<int>(model.variables())),
          size_(variables_ + static_cast<int>(ranges.equalities.size())),
          owner_(static_cast<std::size_t>(size_), -1),
          slot_(owner_),
          group_of_(static_cast<std::size_t>(ranges.ranges()), -1),
          curved_(static_cast<std::size_t>(variables_)),
          groups_at_(static_cast<std::size_t>(variables_)) {
        for (std::size_t g = 0; g < ranges.groups.size(); ++g) {
            const RangeRows::Group& group = ranges.groups[g];
            std::fill(group_of_.begin() + group.first, group_of_.begin() + group.last, static_cast<int>(g));
            groups_at_[static_cast<std::size_t>(group.variable)].push_back(static_cast<int>(g));
        }
        for (std::size_t e = 0; e < model.hessian.columns.size(); ++e)
            curved_[static_cast<std::size_t>(model.hessian.columns[e])].push_back(static_cast<int>(e));
    }

    void run(CondensedPattern& out) {
        out.hessian_slot.resize(model_.hessian.rows.size());
        out.width_slot.resize(ranges_.groups.size());
        for (int j = 0; j < size_; ++j) column(j, out);
        out.lower =
            Eigen::Map<const SymmetricFactor::Matrix>(size_, size_, static_cast<Eigen::Index>(inner_.size()),
                                                      outer_.data(), inner_.data(), values_.data());
    }

 private:
    void column(int j, CondensedPattern& out) {
        entries_.clear();
        claim(j, j);
        if (j < variables_) {
            each_entry(
                j, [&](int row, double) { claim(row, j); }, [&](int row, int, double) { claim(row, j); });
            for (const int e : curved_[static_cast<std::size_t>(j)])
                claim(model_.hessian.rows[static_cast<std::size_t>(e)], j);
        }
        std::ranges::sort(entries_);
        for (const int row : entries_) {
            slot_[static_cast<std::size_t>(row)] = static_cast<int>(inner_.size());
            inner_.push_back(row);
        }
        outer_.push_back(static_cast<int>(inner_.size()));
        values_.resize(inner_.size(), 0.0);
        if (j >= variables_) return;
        const auto at = [&](int row) { return slot_[static_cast<std::size_t>(row)]; };
        each_entry(
            j, [&](int row, double value) { values_[static_cast<std::size_t>(at(row))] = value; },
            [&](int row, int source, double product) {
                out.terms.push_back({at(row), source, product});
            });
        for (const int e : curved_[static_cast<std::size_t>(j)])
            out.hessian_slot[static_cast<std::size_t>(e)] =
                at(model_.hessian.rows[static_cast<std::size_t>(e)]);
        for (const int g : groups_at_[static_cast<std::size_t>(j)])
            out.width_slot[static_cast<std::size_t>(g)] = at(j);
    }

    void claim(int row, int column) {
        if (owner_[static_cast<std::size_t>(row)] == column) return;
        owner_[static_cast<std::size_t>(row)] = column;
        entries_.push_back(row);
    }

    /// Entries of column j on and below the diagonal: of_equality(row, value), of_term(row, source,
    /// product).
    template <typename OfEquality, typename OfTerm>
    void each_entry(int j, OfEquality&& of_equality, OfTerm&& of_term) const {
        const auto count = static_cast<int>(ranges_.ranges());
        for (Eigen::SparseMatrix<double>::InnerIterator own(by_column_, j); own; ++own) {
            const auto row = static_cast<int>(own.row());
            if (row >= count) {
                of_equality(variables_ + row - count, own.value());
                continue;
            }
            for (RowMajor::InnerIterator other(ranges_.matrix, row); other; ++other)
                if (other.col() >= j)
                    of_term(static_cast<int>(other.col()), row, own.value() * other.value());
            const int group = group_of_[static_cast<std::size_t>(row)];
            if (group < 0) continue;
            const int width = ranges_.groups[static_cast<std::size_t>(group)].variable;
            if (width > j) of_term(width, count + row, own.value());
        }
        for (const int g : groups_at_[static_cast<std::size_t>(j)]) {
            const RangeRows::Group& group = ranges_.groups[static_cast<std::size_t>(g)];
            for (auto row = static_cast<int>(group.first); row < static_cast<int>(group.last); ++row)
                for (RowMajor::InnerIterator other(ranges_.matrix, row); other; ++other)
                    if (other.col() > j) of_term(static_cast<int>(other.col()), count + row, other.value());
        }
    }

    const ConvexModel& model_;
    const RangeRows& ranges_;
    Eigen::SparseMatrix<double> by_column_;
    int variables_, size_;
    std::vector<int> owner_, slot_, group_of_;
    std::vector<std::vector<int>> curved_, groups_at_;
    std::vector<int> entries_, inner_, outer_ = {0};
    std::vector<double> values_;
};

}  // namespace

CondensedPattern::CondensedPattern(const ConvexModel& model, const RangeRows& ranges) {
    PatternBuilder(model, ranges).run(*this);
}

}  // namespace camopt::structured
