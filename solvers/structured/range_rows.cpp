// SPDX-License-Identifier: MIT
#include "solvers/structured/range_rows.hpp"

#include <bit>
#include <cstdint>
#include <numeric>

namespace camopt::structured {
namespace {

using Eigen::Index;
using RowMajor = RangeRows::RowMajor;

/// One range before sorting. The core row is `sign` times the row (or variable) `core`.
struct Draft {
    int core_row = -1, core_variable = -1;
    double sign = 1.0;
    int width_variable = -1;
    double width = 0.0;
    double lower = -infinity, upper = infinity;
    RangeRows::Source lower_source, upper_source;
};

class Drafting {
 public:
    Drafting(const ConvexModel& model, const RowMajor& by_row) : model_(model), by_row_(by_row) {
        const auto rows = static_cast<std::uint64_t>(model.constraints());
        const int bits = static_cast<int>(std::bit_width(rows)) + 2;
        table_shift_ = 64 - bits;
        waiting_.assign(std::size_t{1} << bits, -1);
        drafts_.reserve(static_cast<std::size_t>(rows));
    }

    std::vector<Draft> run() {
        for (int j = 0; j < static_cast<int>(model_.variables()); ++j)
            if (std::isfinite(model_.x_lower[j]) || std::isfinite(model_.x_upper[j])) add_variable(j);
        for (int i = 0; i < static_cast<int>(model_.constraints()); ++i)
            if (!model_.is_equality(i) && !joins_twin(i)) add_row(i);
        return std::move(drafts_);
    }

 private:
    [[nodiscard]] bool has_one_side(int i) const {
        return std::isfinite(model_.row_lower[i]) != std::isfinite(model_.row_upper[i]);
    }
    /// Of a row with one side: +1 if it is a x <= u.
    [[nodiscard]] double upward(int i) const { return std::isfinite(model_.row_upper[i]) ? 1.0 : -1.0; }
    [[nodiscard]] double right_side(int i) const {
        return upward(i) > 0.0 ? model_.row_upper[i] : -model_.row_lower[i];
    }

    void add_variable(int j) {
        Draft draft;
        draft.core_variable = j;
        draft.lower = model_.x_lower[j];
        draft.upper = model_.x_upper[j];
        draft.lower_source = {-1, j, 1.0};
        draft.upper_source = {-1, j, -1.0};
        drafts_.push_back(draft);
    }

    void add_row(int i) {
        Draft draft;
        draft.core_row = i;
        draft.lower = model_.row_lower[i];
        draft.upper = model_.row_upper[i];
        draft.lower_source = {i, -1, 1.0};
        draft.upper_source = {i, -1, -1.0};
        drafts_.push_back(draft);
    }

    /// Equal for rows whose entries differ only in their signs.
    [[nodiscard]] std::uint64_t key_of(int i) const {
        std::uint64_t key = 1469598103934665603ULL;
        const auto mix = [&](std::uint64_t part) { key = (key ^ part) * 1099511628211ULL; };
        for (RowMajor::InnerIterator entry(by_row_, i); entry; ++entry) {
            mix(static_cast<std::uint64_t>(entry.col()));
            mix(std::bit_cast<std::uint64_t>(std::abs(entry.value())));
        }
        return key * 0x9E3779B97F4A7C15ULL;  // distributes the key over its first bits
    }

    /// Whether row i, with one side, is the twin of an earlier one; else it is stored for a later twin.
    bool joins_twin(int i) {
        if (!has_one_side(i)) return false;
        int& waiting = waiting_[static_cast<std::size_t>(key_of(i) >> table_shift_)];
        if (waiting >= 0) {
            Draft& draft = drafts_[static_cast<std::size_t>(waiting)];
            if (become_twins(draft.core_row, i, draft)) {
                waiting = -1;
                return true;
            }
        }
        waiting = static_cast<int>(drafts_.size());
        return false;
    }

    /// With both rows as a x <= u: a = c + e x_w and −c + e x_w.
    bool become_twins(int first, int second, Draft& draft) const {
        const double turn = upward(first), other_turn = upward(second);
        int width_variable = -1;
        double width = 0.0;
        RowMajor::InnerIterator own(by_row_, first), other(by_row_, second);
        for (; own && other; ++own, ++other) {
            const double a = turn * own.value(), b = other_turn * other.value();
            if (own.col() != other.col() || std::abs(a) != std::abs(b)) return false;
            if (a != b) continue;
            if (width_variable >= 0) return false;
            width_variable = static_cast<int>(own.col());
            width = -a;
        }
        if (own || other) return false;
        const bool nothing_but_width = width_variable >= 0 && by_row_.row(first).nonZeros() == 1;
        if (nothing_but_width) return false;
        draft.sign = turn;
        draft.width_variable = width_variable;
        draft.width = width;
        draft.upper = right_side(first);
        draft.lower = -right_side(second);
        draft.upper_source = {first, -1, -turn};
        draft.lower_source = {second, -1, -other_turn};
        return true;
    }

    const ConvexModel& model_;
    const RowMajor& by_row_;
    std::vector<Draft> drafts_;
    /// Draft of the last row with one side by the first bits of its key, −1: none. A collision loses a pair
    /// occasionally, no more.
    std::vector<int> waiting_;
    int table_shift_ = 0;
};

/// Fills a matrix row after row.
class RowFiller {
 public:
    RowFiller(RowMajor& matrix, Index rows, Index columns, Index entries) : matrix_(matrix) {
        matrix_.resize(rows, columns);
        matrix_.resizeNonZeros(entries);
        matrix_.outerIndexPtr()[0] = 0;
    }
    void add(int column, double value) {
        matrix_.innerIndexPtr()[entries_] = column;
        matrix_.valuePtr()[entries_++] = value;
    }
    void add_row_of(const RowMajor& from, int row, double sign, int except) {
        for (RowMajor::InnerIterator entry(from, row); entry; ++entry)
            if (entry.col() != except) add(static_cast<int>(entry.col()), sign * entry.value());
    }
    void end_row() { matrix_.outerIndexPtr()[++row_] = entries_; }
    void finish() { matrix_.resizeNonZeros(entries_); }

 private:
    RowMajor& matrix_;
    int entries_ = 0;
    Index row_ = 0;
};

}  // namespace

RangeRows::RangeRows(const ConvexModel& model) {
    const RowMajor by_row = model.rows;
    const std::vector<Draft> drafts = Drafting(model, by_row).run();
    std::vector<int> order(drafts.size());
    std::iota(order.begin(), order.end(), 0);
    std::ranges::stable_sort(order, {},
                             [&](int k) { return drafts[static_cast<std::size_t>(k)].width_variable; });
    for (int i = 0; i < static_cast<int>(model.constraints()); ++i)
        if (model.is_equality(i)) equalities.push_back(i);
    const auto count = static_cast<Index>(drafts.size());
    width.resize(count);
    limit.setZero(2 * count);
    present.setZero(2 * count);
    source.resize(static_cast<std::size_t>(2 * count));
    RowFiller filler(matrix, count + static_cast<Index>(equalities.size()), model.variables(),
                     by_row.nonZeros() + count);
    for (Index r = 0; r < count; ++r) {
        const Draft& draft = drafts[static_cast<std::size_t>(order[static_cast<std::size_t>(r)])];
        width[r] = draft.width;
        if (draft.width_variable >= 0) {
            if (groups.empty() || groups.back().variable != draft.width_variable)
                groups.push_back({draft.width_variable, r, r});
            groups.back().last = r + 1;
        }
        const auto side = [&](Index at, double value, const Source& from) {
            if (!std::isfinite(value)) return;
            limit[at] = value;
            present[at] = 1.0;
            source[static_cast<std::size_t>(at)] = from;
        };
        side(r, draft.lower, draft.lower_source);
        side(count + r, -draft.upper, draft.upper_source);
        if (draft.core_variable >= 0)
            filler.add(draft.core_variable, 1.0);
        else
            filler.add_row_of(by_row, draft.core_row, draft.sign, draft.width_variable);
        filler.end_row();
    }
    sides_present = static_cast<Index>(present.sum());
    for (const int i : equalities) {
        filler.add_row_of(by_row, i, 1.0, -1);
        filler.end_row();
    }
    filler.finish();
    equal_to.resize(static_cast<Index>(equalities.size()));
    for (Index k = 0; k < equal_to.size(); ++k)
        equal_to[k] = model.row_lower[equalities[static_cast<std::size_t>(k)]];
}

void RangeRows::slides(const Eigen::VectorXd& x, const Eigen::VectorXd& image, Eigen::VectorXd& out) const {
    const Index count = ranges();
    out.head(count) = image.head(count);
    out.tail(count) = -image.head(count);
    for (const Group& group : groups) {
        const Index size = group.last - group.first;
        out.segment(group.first, size) += x[group.variable] * width.segment(group.first, size);
        out.segment(count + group.first, size) += x[group.variable] * width.segment(group.first, size);
    }
}

Eigen::VectorXd RangeRows::row_multipliers(const Eigen::VectorXd& of_equalities,
                                           const Eigen::VectorXd& of_sides) const {
    int rows = 0;
    for (const Source& from : source) rows = std::max(rows, from.row + 1);
    for (const int row : equalities) rows = std::max(rows, row + 1);
    Eigen::VectorXd result = Eigen::VectorXd::Zero(rows);
    for (std::size_t k = 0; k < equalities.size(); ++k)
        result[equalities[k]] = of_equalities[static_cast<Index>(k)];
    for (std::size_t b = 0; b < source.size(); ++b)
        if (source[b].row >= 0) result[source[b].row] -= source[b].sign * of_sides[static_cast<Index>(b)];
    return result;
}

}  // namespace camopt::structured
