// SPDX-License-Identifier: MIT
#include "splines/gram.hpp"

#include <Eigen/Cholesky>

namespace camopt {

namespace {

/// Rᵀ with ∫_0^h (y^{(order)})² dt = |R u|² for y = Σ_m u_m t^m: in t / h the Gram matrix of the monomials is
/// Hilbert's, of size 6 at most here.
Eigen::MatrixXd root_of_energy(int size, int order, double h) {
    const int terms = std::max(0, size - order);
    Eigen::MatrixXd hilbert(terms, terms);
    for (int m = 0; m < terms; ++m)
        for (int k = 0; k < terms; ++k) hilbert(m, k) = 1.0 / (m + k + 1);
    const Eigen::MatrixXd lower = hilbert.llt().matrixL();
    Eigen::MatrixXd root = Eigen::MatrixXd::Zero(terms, size);
    for (int m = order; m < size; ++m) {
        double factor = std::sqrt(h) * std::pow(h, m - order);
        for (int r = 0; r < order; ++r) factor *= m - r;
        root.col(m) = factor * lower.row(m - order).transpose();
    }
    return root;
}

}  // namespace

void QuadraticForm::scale(double factor, const Eigen::VectorXd& units) {
    const Eigen::SparseMatrix<double> rows_scaled = units.asDiagonal() * matrix;
    matrix = rows_scaled * units.asDiagonal();
    matrix *= factor;
    linear = factor * units.cwiseProduct(linear);
    const double root = std::sqrt(factor);
    roots = (root * roots * units.asDiagonal()).eval();
    offset *= root;
}

void EnergySum::add(const LocalMap& map, int order, double width, double weight) {
    const Eigen::MatrixXd root =
        std::sqrt(weight) * root_of_energy(static_cast<int>(map.offset.size()), order, width);
    const Eigen::MatrixXd by_entry = root * map.matrix;
    const Eigen::VectorXd offset = root * map.offset;
    const auto first = static_cast<int>(offset_.size());
    for (int row = 0; row < static_cast<int>(offset.size()); ++row) {
        offset_.push_back(offset[row]);
        for (int k = 0; k < static_cast<int>(map.columns.size()); ++k)
            roots_.emplace_back(first + row, map.columns[k], by_entry(row, k));
    }
}

void EnergySum::add(const AffineRow& row, double weight) {
    const double root = std::sqrt(weight);
    for (std::size_t k = 0; k < row.columns.size(); ++k)
        roots_.emplace_back(static_cast<int>(offset_.size()), row.columns[k], root * row.weights[k]);
    offset_.push_back(root * row.offset);
}

QuadraticForm EnergySum::form(double factor) const {
    QuadraticForm form;
    const double root = std::sqrt(factor);
    form.offset =
        root * Eigen::Map<const Eigen::VectorXd>(offset_.data(), static_cast<Eigen::Index>(offset_.size()));
    form.roots.resize(form.offset.size(), variables_);
    form.roots.setFromTriplets(roots_.begin(), roots_.end());
    form.roots *= root;
    form.matrix =
        Eigen::SparseMatrix<double>(form.roots.transpose()) * Eigen::SparseMatrix<double>(form.roots);
    form.linear = form.roots.transpose() * form.offset;
    return form;
}

}  // namespace camopt
