// SPDX-License-Identifier: MIT
#include "objectives/grid/equality_projection.hpp"

#include <algorithm>
#include <cmath>

namespace camopt {

AffineRow unit_row(const AffineRow& row, const Eigen::VectorXd& column_scale) {
    AffineRow unit = row;
    double largest = 0.0;
    for (std::size_t k = 0; k < unit.columns.size(); ++k) {
        unit.weights[k] *= column_scale[unit.columns[k]];
        largest = std::max(largest, std::abs(unit.weights[k]));
    }
    for (double& weight : unit.weights) weight /= largest;
    unit.offset /= largest;
    return unit;
}

EqualityProjection::EqualityProjection(const std::vector<Equality>& rows, const Eigen::VectorXd& column_scale)
    : matrix_(static_cast<Eigen::Index>(rows.size()), column_scale.size()),
      offset_(static_cast<Eigen::Index>(rows.size())) {
    std::vector<Eigen::Triplet<double>> entries;
    for (int i = 0; i < static_cast<int>(rows.size()); ++i) {
        const AffineRow row = unit_row(rows[i].row, column_scale);
        for (std::size_t k = 0; k < row.columns.size(); ++k) {
            entries.emplace_back(i, row.columns[k], row.weights[k]);
        }
        offset_[i] = row.offset;
    }
    matrix_.setFromTriplets(entries.begin(), entries.end());
    if (matrix_.rows() > 0) normal_.compute(matrix_ * Eigen::SparseMatrix<double>(matrix_.transpose()));
}

Eigen::VectorXd EqualityProjection::project(Eigen::VectorXd x) const {
    if (matrix_.rows() == 0 || normal_.info() != Eigen::Success) return x;
    // The first step removes the residual, the next ones its round-off.
    constexpr int most_steps = 4;
    double defect = (matrix_ * x + offset_).cwiseAbs().maxCoeff();
    for (int step = 0; step < most_steps && defect > 0.0; ++step) {
        const Eigen::VectorXd next = x - matrix_.transpose() * normal_.solve(matrix_ * x + offset_);
        const double next_defect = (matrix_ * next + offset_).cwiseAbs().maxCoeff();
        if (!(next_defect < defect)) break;
        x = next;
        defect = next_defect;
    }
    return x;
}

}  // namespace camopt
