// SPDX-License-Identifier: MIT
#include "solvers/structured/hessian_convexifier.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace camopt::structured {

namespace {

using Eigen::Index;
using Eigen::VectorXd;
using Matrix = Eigen::SparseMatrix<double>;

/// Largest sum of absolute values of a row: a bound of every eigenvalue (Gershgorin).
double row_sum(const Matrix& lower) {
    VectorXd sums = VectorXd::Zero(lower.rows());
    for (Index j = 0; j < lower.outerSize(); ++j)
        for (Matrix::InnerIterator entry(lower, j); entry; ++entry) {
            sums[entry.row()] += std::abs(entry.value());
            if (entry.row() != entry.col()) sums[entry.col()] += std::abs(entry.value());
        }
    return sums.size() > 0 ? sums.maxCoeff() : 0.0;
}

}  // namespace

ActiveRows ActiveRows::part(const std::function<bool(Index)>& chosen) const {
    std::vector<Eigen::Triplet<double>> entries;
    std::vector<double> kept;
    for (Index i = 0; i < residuals.size(); ++i) {
        if (!chosen(i)) continue;
        const int row = static_cast<int>(kept.size());
        for (decltype(normals)::InnerIterator entry(normals, i); entry; ++entry)
            entries.emplace_back(row, static_cast<int>(entry.col()), entry.value());
        kept.push_back(residuals[i]);
    }
    ActiveRows result;
    result.normals.resize(static_cast<Index>(kept.size()), normals.cols());
    result.normals.setFromTriplets(entries.begin(), entries.end());
    result.residuals = Eigen::Map<const VectorXd>(kept.data(), static_cast<Index>(kept.size()));
    return result;
}

/// False: an entry that trial_ has no place for.
bool HessianConvexifier::read_values(const Matrix& lower, const ActiveRows& active) {
    if (trial_.rows() != lower.rows()) return false;
    own_.setZero(trial_.nonZeros());
    gram_.setZero(trial_.nonZeros());
    const Matrix by_column = active.normals;
    bool complete = true;
    const auto add = [&](VectorXd& values, Index row, double value) {
        const int place = place_[static_cast<std::size_t>(row)];
        if (place < 0)
            complete = false;
        else
            values[place] += value;
    };
    for (Index j = 0; j < trial_.outerSize() && complete; ++j) {
        const int begin = trial_.outerIndexPtr()[j], end = trial_.outerIndexPtr()[j + 1];
        const int* const rows = trial_.innerIndexPtr();
        for (int p = begin; p < end; ++p) place_[static_cast<std::size_t>(rows[p])] = p;
        for (Matrix::InnerIterator entry(lower, j); entry; ++entry) add(own_, entry.row(), entry.value());
        for (Matrix::InnerIterator own(by_column, j); own; ++own)
            for (decltype(active.normals)::InnerIterator entry(active.normals, own.row()); entry; ++entry)
                if (entry.col() >= j) add(gram_, entry.col(), own.value() * entry.value());
        for (int p = begin; p < end; ++p) place_[static_cast<std::size_t>(rows[p])] = -1;
    }
    return complete;
}

void HessianConvexifier::grow(const Matrix& lower, const ActiveRows& active) {
    const Index size = lower.rows();
    std::vector<Eigen::Triplet<double>> entries;
    const auto add = [&](Index row, Index column) {
        entries.emplace_back(static_cast<int>(row), static_cast<int>(column), 1.0);
    };
    for (Index j = 0; j < size; ++j) add(j, j);
    for (const Matrix* known : {&std::as_const(trial_), &lower})
        for (Index j = 0; j < known->outerSize(); ++j)
            for (Matrix::InnerIterator entry(*known, j); entry; ++entry) add(entry.row(), j);
    for (Index i = 0; i < active.normals.rows(); ++i)
        for (decltype(active.normals)::InnerIterator one(active.normals, i); one; ++one)
            for (decltype(active.normals)::InnerIterator other(active.normals, i); other; ++other)
                if (other.col() > one.col()) add(other.col(), one.col());
    trial_.resize(size, size);
    trial_.setFromTriplets(entries.begin(), entries.end());
    place_.assign(static_cast<std::size_t>(size), -1);
    factor_ = make_symmetric_factor(FactorKind::automatic, trial_,
                                    std::vector<int>(static_cast<std::size_t>(size), 1));
}

void HessianConvexifier::read(const Matrix& lower, const ActiveRows& active, double least) {
    if (!read_values(lower, active)) {
        grow(lower, active);
        static_cast<void>(read_values(lower, active));
    }
    for (Index j = 0; j < trial_.outerSize(); ++j) own_[trial_.outerIndexPtr()[j]] += least;
}

bool HessianConvexifier::is_definite(double weight, double shift) {
    Eigen::Map<VectorXd>(trial_.valuePtr(), trial_.nonZeros()) = own_ + weight * gram_;
    return factor_->factorize(trial_, VectorXd::Constant(trial_.rows(), shift)) == FactorOutcome::ok;
}

/// Slightly more than needed: a large shift keeps the sequence at saddle points for long.
double HessianConvexifier::least_shift(double weight, double bound) {
    constexpr double first_shift = 1e-4, growth = 4.0, margin = 1.2;
    constexpr int halvings = 4;
    double refused = 0.0, shift = first_shift * bound;
    for (; shift < bound && !is_definite(weight, shift); shift *= growth) refused = shift;
    for (int k = 0; k < halvings; ++k) {
        const double middle = 0.5 * (refused + shift);
        (is_definite(weight, middle) ? shift : refused) = middle;
    }
    return margin * shift;
}

ConvexifiedHessian HessianConvexifier::convexified(const Matrix& lower, const ActiveRows& active,
                                                   double least) {
    constexpr int weights = 5;
    read(lower, active, least);
    ConvexifiedHessian result;
    result.slope = VectorXd::Zero(lower.rows());
    const double bound = row_sum(lower);
    double weight = 0.0;
    if (bound > 0.0 && !is_definite(0.0, 0.0)) {
        weight = bound;
        result.holds = active.normals.rows() > 0;
        bool definite = false;
        for (int k = 0; k < weights && result.holds && !definite; ++k)
            definite = is_definite(weight = bound * std::pow(10.0, k), 0.0);
        if (!definite) result.shift = least_shift(weight = bound, bound);
        if (result.holds) result.slope = weight * (active.normals.transpose() * active.residuals);
    }
    result.lower = trial_;
    Eigen::Map<VectorXd> values(result.lower.valuePtr(), result.lower.nonZeros());
    values = own_ + weight * gram_;
    for (Index j = 0; j < trial_.outerSize(); ++j) values[trial_.outerIndexPtr()[j]] += result.shift;
    result.lower.prune([](Index, Index, double value) { return value != 0.0; });
    return result;
}

}  // namespace camopt::structured
