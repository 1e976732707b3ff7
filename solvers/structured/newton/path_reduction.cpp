// SPDX-License-Identifier: MIT
#include "solvers/structured/newton/path_reduction.hpp"

#include <numeric>

namespace camopt::structured {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

// Trees with fewer rows stay: the band of the chain handles them.
constexpr int least_rows = 8;
// Each sum is a dense row; more of them cost more than the eliminated variables save.
constexpr int most_trees = 4;
// A τ beyond this would lose digits of the small rows.
constexpr double widest_parts = 1e3;

/// A cost that does not depend on the eliminated variables.
class ReducedCost final : public ConvexCost {
 public:
    ReducedCost(const ConvexCost& full, std::vector<int> kept, Index variables)
        : full_(full),
          kept_(std::move(kept)),
          point_(VectorXd::Zero(variables)),
          gradient_(VectorXd::Zero(variables)) {}
    double value(const VectorXd& x) const override { return full_.value(point(x)); }
    void gradient(const VectorXd& x, VectorXd& out) const override {
        full_.gradient(point(x), gradient_);
        out.resize(x.size());
        for (Index k = 0; k < x.size(); ++k) out[k] = gradient_[kept_[static_cast<std::size_t>(k)]];
    }
    void hessian(const VectorXd& x, std::span<double> out) const override { full_.hessian(point(x), out); }

 private:
    const VectorXd& point(const VectorXd& x) const {
        for (Index k = 0; k < x.size(); ++k) point_[kept_[static_cast<std::size_t>(k)]] = x[k];
        return point_;
    }
    const ConvexCost& full_;
    std::vector<int> kept_;
    mutable VectorXd point_, gradient_;
};

/// Connected components of rows.
class Forest {
 public:
    explicit Forest(int rows) : parent_(static_cast<std::size_t>(rows)) {
        std::iota(parent_.begin(), parent_.end(), 0);
    }
    int root(int row) {
        while (at(row) != row) row = at(row) = at(at(row));
        return row;
    }
    /// False: they are connected already.
    bool join(int a, int b) {
        a = root(a);
        b = root(b);
        at(a) = b;
        return a != b;
    }
    [[nodiscard]] int size() const { return static_cast<int>(parent_.size()); }

 private:
    int& at(int row) { return parent_[static_cast<std::size_t>(row)]; }
    std::vector<int> parent_;
};

}  // namespace

struct PathReduction::Candidate {
    int variable, first, second;
    double first_entry, second_entry;
};

/// The candidates that join trees, listed at each of their rows: 2 k is candidate k at its first row, 2 k + 1
/// at its second.
class PathReduction::Edges {
 public:
    Edges(const std::vector<Candidate>& candidates, Forest& forest)
        : first_(static_cast<std::size_t>(forest.size()), -1), after_(2 * candidates.size(), -1) {
        for (std::size_t k = 0; k < candidates.size(); ++k) {
            const Candidate& edge = candidates[k];
            if (!forest.join(edge.first, edge.second)) continue;
            put(edge.first, static_cast<int>(2 * k));
            put(edge.second, static_cast<int>(2 * k + 1));
        }
    }
    [[nodiscard]] int first(int row) const { return first_[static_cast<std::size_t>(row)]; }
    [[nodiscard]] int after(int edge) const { return after_[static_cast<std::size_t>(edge)]; }

 private:
    void put(int row, int edge) {
        after_[static_cast<std::size_t>(edge)] = first(row);
        first_[static_cast<std::size_t>(row)] = edge;
    }
    std::vector<int> first_, after_;
};

PathReduction::PathReduction(const ConvexModel& model, const VectorXd& start) : full_(model) {
    const std::vector<Candidate> found = candidates(start);
    if (static_cast<int>(found.size()) < least_rows - 1) return;
    join(found);
    if (removed_.empty()) return;
    number();
    build();
    reduced_.cost = reduced_cost(start);
}

std::unique_ptr<ConvexCost> PathReduction::reduced_cost(const VectorXd& start) const {
    if (full_.kind != CostKind::linear)
        return std::make_unique<ReducedCost>(*full_.cost, kept_variables_, full_.variables());
    VectorXd gradient(start.size());
    full_.cost->gradient(start, gradient);
    const double constant = full_.cost->value(start) - gradient.dot(start);
    return std::make_unique<LinearCost>(reduced(gradient), constant);
}

std::vector<PathReduction::Candidate> PathReduction::candidates(const VectorXd& start) const {
    std::vector<char> in_cost(static_cast<std::size_t>(full_.variables()), 0);
    VectorXd gradient(start.size());
    full_.cost->gradient(start, gradient);
    for (Index j = 0; j < gradient.size(); ++j)
        in_cost[static_cast<std::size_t>(j)] = gradient[j] != 0.0 ? 1 : 0;
    for (const auto* indices : {&full_.hessian.rows, &full_.hessian.columns})
        for (const int j : *indices) in_cost[static_cast<std::size_t>(j)] = 1;
    std::vector<Candidate> result;
    const int* begin = full_.rows.outerIndexPtr();
    for (int j = 0; j < static_cast<int>(full_.variables()); ++j) {
        if (begin[j + 1] - begin[j] != 2 || in_cost[static_cast<std::size_t>(j)] != 0) continue;
        if (std::isfinite(full_.x_lower[j]) || std::isfinite(full_.x_upper[j])) continue;
        const int* row = full_.rows.innerIndexPtr() + begin[j];
        const double* entry = full_.rows.valuePtr() + begin[j];
        if (full_.is_equality(row[0]) && full_.is_equality(row[1]))
            result.push_back({j, row[0], row[1], entry[0], entry[1]});
    }
    return result;
}

/// Finds the trees, the factor of every row in its sum, and the order of back-substitution.
void PathReduction::join(const std::vector<Candidate>& candidates) {
    const auto rows = static_cast<int>(full_.constraints());
    Forest forest(rows);
    const Edges edges(candidates, forest);
    std::vector<int> size(static_cast<std::size_t>(rows), 0);
    for (int i = 0; i < rows; ++i) ++size[static_cast<std::size_t>(forest.root(i))];
    row_.assign(static_cast<std::size_t>(rows), -1);
    part_.assign(static_cast<std::size_t>(rows), 1.0);
    std::vector<char> seen(static_cast<std::size_t>(rows), 0);
    int trees = 0;
    for (int top = 0; top < rows; ++top) {
        if (seen[static_cast<std::size_t>(top)] != 0 ||
            size[static_cast<std::size_t>(forest.root(top))] < least_rows)
            continue;
        std::vector<int> queue{top};
        std::vector<Removed> found;
        seen[static_cast<std::size_t>(top)] = 1;
        double least = 1.0, most = 1.0;
        for (std::size_t head = 0; head < queue.size(); ++head) {
            const int row = queue[head];
            for (int k = edges.first(row); k >= 0; k = edges.after(k)) {
                const Candidate& edge = candidates[static_cast<std::size_t>(k / 2)];
                const bool forward = k % 2 == 0;
                const int next = forward ? edge.second : edge.first;
                if (seen[static_cast<std::size_t>(next)] != 0) continue;
                const double here = forward ? edge.first_entry : edge.second_entry;
                const double there = forward ? edge.second_entry : edge.first_entry;
                const double part = -part_[static_cast<std::size_t>(row)] * here / there;
                seen[static_cast<std::size_t>(next)] = 1;
                part_[static_cast<std::size_t>(next)] = part;
                row_[static_cast<std::size_t>(next)] = top;  // temporarily: the row that becomes the sum
                least = std::min(least, std::abs(part));
                most = std::max(most, std::abs(part));
                found.push_back({edge.variable, next, row, there, here});
                queue.push_back(next);
            }
        }
        if (trees == most_trees || most > widest_parts * least) {
            for (const int row : queue) {
                part_[static_cast<std::size_t>(row)] = 1.0;
                row_[static_cast<std::size_t>(row)] = -1;
            }
            continue;
        }
        ++trees;
        // A row determines its own variable once those of the rows below it are known.
        removed_.insert(removed_.end(), found.rbegin(), found.rend());
    }
}

/// Renumbers the remaining rows and variables.
void PathReduction::number() {
    variable_.assign(static_cast<std::size_t>(full_.variables()), 0);
    for (const Removed& removed : removed_) variable_[static_cast<std::size_t>(removed.variable)] = -1;
    for (std::size_t j = 0; j < variable_.size(); ++j) {
        if (variable_[j] < 0) continue;
        variable_[j] = static_cast<int>(kept_variables_.size());
        kept_variables_.push_back(static_cast<int>(j));
    }
    for (int& row : row_) row = row < 0 ? row_count_++ : row_[static_cast<std::size_t>(row)];
}

void PathReduction::build() {
    reduced_.row_lower.setZero(row_count_);
    for (std::size_t i = 0; i < row_.size(); ++i)
        reduced_.row_lower[row_[i]] += part_[i] * full_.row_lower[static_cast<Index>(i)];
    reduced_.row_upper = reduced_.row_lower;
    for (std::size_t i = 0; i < row_.size(); ++i)
        if (!full_.is_equality(static_cast<Index>(i)))
            reduced_.row_upper[row_[i]] = full_.row_upper[static_cast<Index>(i)];
    reduced_.rows.resize(row_count_, static_cast<Index>(kept_variables_.size()));
    reduced_.rows.reserve(full_.rows.nonZeros());
    std::vector<std::pair<int, double>> column;
    for (std::size_t k = 0; k < kept_variables_.size(); ++k) {
        column.clear();
        for (ConvexModel::Matrix::InnerIterator entry(full_.rows, kept_variables_[k]); entry; ++entry) {
            const auto row = static_cast<std::size_t>(entry.row());
            column.emplace_back(row_[row], part_[row] * entry.value());
        }
        append_column(static_cast<Index>(k), column);
    }
    reduced_.rows.finalize();
    reduced_.x_lower = full_.x_lower(kept_variables_);
    reduced_.x_upper = full_.x_upper(kept_variables_);
    const auto renumber = [&](const std::vector<int>& from, std::vector<int>& to) {
        for (const int j : from) to.push_back(variable_[static_cast<std::size_t>(j)]);
    };
    renumber(full_.hessian.rows, reduced_.hessian.rows);
    renumber(full_.hessian.columns, reduced_.hessian.columns);
    reduced_.kind = full_.kind;
    reduced_.cost_unit = full_.cost_unit;
}

/// Entries of the same row are added; zero sums are omitted.
void PathReduction::append_column(Index k, std::vector<std::pair<int, double>>& column) {
    std::ranges::sort(column);
    reduced_.rows.startVec(k);
    for (std::size_t e = 0; e < column.size();) {
        const int row = column[e].first;
        double sum = 0.0;
        for (; e < column.size() && column[e].first == row; ++e) sum += column[e].second;
        if (sum != 0.0) reduced_.rows.insertBack(row, k) = sum;
    }
}

VectorXd PathReduction::reduced(const VectorXd& x) const {
    if (removed_.empty()) return x;
    return x(kept_variables_);
}

VectorXd PathReduction::restored(const VectorXd& x) const {
    if (removed_.empty()) return x;
    VectorXd result = VectorXd::Zero(full_.variables());
    result(kept_variables_) = x;
    VectorXd rest = full_.row_lower - full_.rows * result;  // the residual of a row for its own variable
    for (const Removed& removed : removed_) {
        result[removed.variable] = rest[removed.row] / removed.entry;
        rest[removed.other_row] -= removed.other_entry * result[removed.variable];
    }
    return result;
}

VectorXd PathReduction::restored_multipliers(const VectorXd& lambda) const {
    if (removed_.empty()) return lambda;
    VectorXd result(full_.constraints());
    for (Index i = 0; i < result.size(); ++i)
        result[i] = part_[static_cast<std::size_t>(i)] * lambda[row_[static_cast<std::size_t>(i)]];
    return result;
}

VectorXd PathReduction::reduced_multipliers(const VectorXd& lambda) const {
    if (removed_.empty()) return lambda;
    VectorXd result(row_count_);
    for (Index i = 0; i < lambda.size(); ++i)
        result[row_[static_cast<std::size_t>(i)]] = lambda[i] / part_[static_cast<std::size_t>(i)];
    return result;
}

}  // namespace camopt::structured
