// SPDX-License-Identifier: MIT
#include "linear/rank_revealing_qr.hpp"
#include "splines/design_forms.hpp"

namespace camopt {

namespace {

// A mismatch larger than this, relative to the terms of the row, is a contradiction; a smaller one is
// round-off.
constexpr double contradiction = 1e-9;

/// A row of the system; `condition` is null for symmetry.
struct Candidate {
    AffineRow row;
    const PointCondition* condition = nullptr;
    [[nodiscard]] bool asked() const { return condition != nullptr && condition->asked; }
    [[nodiscard]] std::string name() const { return condition != nullptr ? condition->name : "symmetry"; }
};

double largest(const AffineRow& row) {
    double size = 0.0;
    for (const double weight : row.weights) size = std::max(size, std::abs(weight));
    return size;
}

std::vector<Candidate> candidates_of(const DesignForm& form, const SplineSpace& space,
                                     const std::vector<PointCondition>& conditions) {
    std::vector<int> new_index(form.entries.size(), -1);
    int next = 0;
    for (std::size_t j = 0; j < form.entries.size(); ++j) {
        if (!form.entries[j].fixed) new_index[j] = next++;
    }
    std::vector<Candidate> candidates;
    for (const Equality& row : form.rows)
        candidates.push_back({without_fixed(row.row, form, new_index), nullptr});
    for (const PointCondition& condition : conditions)
        candidates.push_back({condition_row(form, space, condition, new_index), &condition});
    return candidates;
}

/// Names the exact points of a dependency: the row itself if the user requested it, else the first such row
/// it depends on.
ConditionConflict conflict_of(const DependentRow& dependent, const std::vector<Candidate>& candidates) {
    const Candidate& own = candidates[dependent.row];
    ConditionConflict conflict{own.name(), {}, {}};
    bool named = own.asked();
    for (const auto& [row, factor] : dependent.combination) {
        if (!candidates[row].asked()) continue;
        const std::string& name = candidates[row].condition->name;
        if (!named) {
            conflict.condition = name;
            named = true;
        } else if (name != conflict.condition &&
                   std::ranges::find(conflict.others, name) == conflict.others.end()) {
            conflict.others.push_back(name);
        }
    }
    return conflict;
}

/// row_i = Σ f_k row_k with a different right-hand side: row_i less the combination says 0 = mismatch.
std::vector<ConflictRow> contradiction_rows(const DependentRow& dependent,
                                            const std::vector<Candidate>& candidates) {
    const double sign = dependent.mismatch > 0.0 ? -1.0 : 1.0;
    const Candidate& own = candidates[dependent.row];
    std::vector<ConflictRow> rows{{own.name(), own.row, sign}};
    for (const auto& [row, factor] : dependent.combination)
        rows.push_back({candidates[row].name(), candidates[row].row, -sign * factor});
    return rows;
}

/// One of a group is not reported: the others represent it.
bool was_asked_for(const DependentRow& dependent, const std::vector<Candidate>& candidates) {
    const auto by_itself = [&](int row) {
        return candidates[row].asked() && !candidates[row].condition->in_group;
    };
    const Candidate& own = candidates[dependent.row];
    if (own.asked()) return by_itself(dependent.row);
    return std::ranges::any_of(dependent.combination,
                               [&](const auto& part) { return by_itself(part.first); });
}

// A weight this small relative to the largest of its row is the round-off of zero: a derivative of a basis
// function at a zero of it.
constexpr double negligible_weight = 1e-13;

// Nearly parallel exact points make ill-conditioned rows: cos of the angle between them.
constexpr double nearly_parallel = 0.99;

double inner_product(const AffineRow& one, const AffineRow& other) {
    double sum = 0.0;
    for (std::size_t i = 0, j = 0; i < one.columns.size() && j < other.columns.size();) {
        if (one.columns[i] == other.columns[j]) sum += one.weights[i] * other.weights[j];
        const bool advance_one = one.columns[i] <= other.columns[j];
        const bool advance_other = other.columns[j] <= one.columns[i];
        i += advance_one ? 1 : 0;
        j += advance_other ? 1 : 0;
    }
    return sum;
}

double length(const AffineRow& row) {
    return std::sqrt(inner_product(row, row));
}

}  // namespace

Equality unlike(Equality condition, const std::vector<AffineRow>& others) {
    AffineRow& row = condition.row;
    constexpr double rounding = std::numeric_limits<double>::epsilon();
    // Each step removes one direction.
    for (std::size_t step = 0; step < others.size(); ++step) {
        const auto parallel = std::ranges::find_if(others, [&](const AffineRow& other) {
            return std::abs(inner_product(row, other)) > nearly_parallel * length(row) * length(other);
        });
        if (parallel == others.end()) return condition;
        const double before = length(row);
        row = combined(row, -inner_product(row, *parallel) / inner_product(*parallel, *parallel), *parallel);
        const double after = length(row);
        if (!(after > 0.0)) return condition;
        row.offset *= before / after;
        for (double& weight : row.weights) weight *= before / after;
        condition.uncertainty = std::max(condition.uncertainty, rounding) * (before / after);
    }
    return condition;
}

AffineRow condition_row(const DesignForm& form, const SplineSpace& space, const PointCondition& condition,
                        const std::vector<int>& new_index) {
    const int segment = space.segment_of(condition.at, condition.side);
    const double t = condition.at - space.breakpoints()[segment];
    AffineRow row = functional_of(form.maps[segment], t, condition.order);
    const double rounding = form.dense ? 0.0 : negligible_weight * largest(row);
    for (double& weight : row.weights)
        if (std::abs(weight) <= rounding) weight = 0.0;
    row = without_fixed(row, form, new_index);
    row.offset -= condition.value;
    return row;
}

ConditionSelection select_conditions(const DesignRequest& request) {
    DesignRequest by_coefficients = request;
    by_coefficients.kind = DesignKind::coefficients;
    const DesignForm form = raw_form(by_coefficients);
    std::vector<PointCondition> conditions = form.leftover;
    conditions.insert(conditions.end(), request.conditions.begin(), request.conditions.end());
    std::vector<Candidate> candidates = candidates_of(form, request.space, conditions);

    std::vector<Eigen::Triplet<double>> entries;
    Eigen::VectorXd right(candidates.size());
    for (std::size_t i = 0; i < candidates.size(); ++i) {
        AffineRow& row = candidates[i].row;
        const double size = largest(row);
        const double scale =
            size > 0.0 ? size : 1.0;  // unit rows: magnitudes of different derivatives are not comparable
        row.offset /= scale;
        right[static_cast<Eigen::Index>(i)] = -row.offset;
        for (std::size_t k = 0; k < row.columns.size(); ++k) {
            row.weights[k] /= scale;
            entries.emplace_back(static_cast<int>(i), row.columns[k], row.weights[k]);
        }
    }
    Eigen::SparseMatrix<double> matrix(right.size(), static_cast<Eigen::Index>(form.entries.size()));
    matrix.setFromTriplets(entries.begin(), entries.end());
    const RowDependence dependence = analyse_rows(matrix, right);

    ConditionSelection selection;
    for (const int row : dependence.independent) {
        const PointCondition* condition = candidates[row].condition;
        const bool leftover = row < static_cast<int>(form.rows.size() + form.leftover.size());
        if (condition != nullptr && !leftover) selection.kept.push_back(*condition);
    }
    for (const DependentRow& dependent : dependence.dependent) {
        double size_met = std::max(1.0, std::abs(right[dependent.row]));
        for (const auto& [row, factor] : dependent.combination)
            size_met = std::max(size_met, std::abs(factor * right[row]));
        if (std::abs(dependent.mismatch) > contradiction * size_met) {
            selection.contradictions.push_back(conflict_of(dependent, candidates));
            selection.contradictions.back().rows = contradiction_rows(dependent, candidates);
        } else if (was_asked_for(dependent, candidates)) {
            selection.redundant.push_back(conflict_of(dependent, candidates));
        }
    }
    return selection;
}

}  // namespace camopt
