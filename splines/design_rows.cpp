// SPDX-License-Identifier: MIT
#include "splines/design_rows.hpp"

#include "linear/rank_revealing_qr.hpp"

#include <Eigen/SparseCore>

#include <algorithm>
#include <cmath>

namespace camopt {

namespace {

// A mismatch larger than this, relative to the sizes that meet in the row, is a contradiction and not
// rounding.
constexpr double contradiction = 1e-9;
// A weight smaller than this beside the row's largest is rounding.
constexpr double negligible = 1e-13;

double largest(const AffineRow& row) {
    double size = 0.0;
    for (const double weight : row.weights) size = std::max(size, std::abs(weight));
    return size;
}

/// Names the exact points of a dependency: the row itself where it is one, else the first one it leans on.
ConditionConflict conflict_of(const DependentRow& dependent, const std::vector<CandidateRow>& candidates) {
    ConditionConflict conflict{candidates[dependent.row].name, {}, dependent.mismatch};
    bool named = candidates[dependent.row].from_condition;
    for (const auto& [row, factor] : dependent.combination) {
        if (!candidates[row].from_condition) continue;
        if (named) {
            conflict.others.push_back(candidates[row].name);
        } else {
            conflict.condition = candidates[row].name;
            named = true;
        }
    }
    return conflict;
}

bool involves_condition(const DependentRow& dependent, const std::vector<CandidateRow>& candidates) {
    return candidates[dependent.row].from_condition ||
           std::ranges::any_of(dependent.combination,
                               [&](const auto& part) { return candidates[part.first].from_condition; });
}

}  // namespace

RowSelection independent_rows(std::vector<CandidateRow> candidates, int size) {
    std::vector<Eigen::Triplet<double>> entries;
    Eigen::VectorXd right(candidates.size());
    RowSelection selection;
    for (std::size_t i = 0; i < candidates.size(); ++i) {
        AffineRow& row = candidates[i].row;
        const double scale = largest(row);
        if (scale > 0.0) {  // unit rows: sizes of different derivatives do not compare
            row.offset /= scale;
            for (double& weight : row.weights) weight /= scale;
        }
        right[static_cast<Eigen::Index>(i)] = -row.offset;
        int kept = 0;
        for (std::size_t k = 0; k < row.columns.size(); ++k) {
            if (std::abs(row.weights[k]) <= negligible) continue;
            entries.emplace_back(static_cast<int>(i), row.columns[k], row.weights[k]);
            ++kept;
        }
        if (kept == 1) selection.fixed_entries.push_back(entries.back().col());
    }
    Eigen::SparseMatrix<double> matrix(static_cast<Eigen::Index>(candidates.size()), size);
    matrix.setFromTriplets(entries.begin(), entries.end());
    const RowDependence dependence = analyse_rows(matrix, right);
    for (const int row : dependence.independent) {
        selection.rows.push_back({candidates[row].row, candidates[row].name});
    }
    for (const DependentRow& dependent : dependence.dependent) {
        double size_met = std::max(1.0, std::abs(right[dependent.row]));
        for (const auto& [row, factor] : dependent.combination) {
            size_met = std::max(size_met, std::abs(factor * right[row]));
        }
        if (std::abs(dependent.mismatch) > contradiction * size_met) {
            selection.contradictions.push_back(conflict_of(dependent, candidates));
        } else if (involves_condition(dependent, candidates)) {
            selection.redundant.push_back(conflict_of(dependent, candidates));
        }
    }
    return selection;
}

}  // namespace camopt
