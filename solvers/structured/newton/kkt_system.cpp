// SPDX-License-Identifier: MIT
#include "solvers/structured/newton/kkt_system.hpp"

#include <algorithm>
#include <cstddef>

namespace camopt::structured {
namespace {

constexpr double largest_kkt_shift = 1e-2;  // of entries near 1: beyond it the factor preconditions nothing
constexpr double kkt_shift_growth =
    100.0;                           // a breakdown is rare; few retries matter more than the least shift
constexpr double good_solve = 1e-8;  // relative; above it other shifts are tried and the best is kept
constexpr RefinementLimits refinement{1e-14, 20};

Eigen::Index position_of(const SymmetricFactor::Matrix& matrix, int row, int column) {
    const int* begin = matrix.innerIndexPtr() + matrix.outerIndexPtr()[column];
    const int* end = matrix.innerIndexPtr() + matrix.outerIndexPtr()[column + 1];
    return std::lower_bound(begin, end, row) - matrix.innerIndexPtr();
}

}  // namespace

KktSystem::KktSystem(const ConvexModel& model, double shift)
    : variables_(model.variables()),
      constraints_(model.constraints()),
      first_shift_(shift),
      shift_(shift),
      factor_(make_simplicial_factor()) {
    const auto size = static_cast<int>(variables_ + constraints_);
    std::vector<Eigen::Triplet<double>> entries;
    entries.reserve(static_cast<std::size_t>(size + model.hessian.size()));
    for (int i = 0; i < size; ++i) entries.emplace_back(i, i, 0.0);
    for (int e = 0; e < model.hessian.size(); ++e)
        entries.emplace_back(model.hessian.rows[static_cast<std::size_t>(e)],
                             model.hessian.columns[static_cast<std::size_t>(e)], 0.0);
    const auto offset = static_cast<int>(variables_);
    for (Eigen::Index j = 0; j < variables_; ++j)
        for (ConvexModel::Matrix::InnerIterator entry(model.rows, j); entry; ++entry)
            entries.emplace_back(offset + static_cast<int>(entry.row()), static_cast<int>(j), entry.value());
    lower_.resize(size, size);
    lower_.setFromTriplets(entries.begin(), entries.end());
    lower_.makeCompressed();
    for (int i = 0; i < size; ++i) diagonal_.push_back(position_of(lower_, i, i));
    for (int e = 0; e < model.hessian.size(); ++e)
        hessian_position_.push_back(position_of(lower_, model.hessian.rows[static_cast<std::size_t>(e)],
                                                model.hessian.columns[static_cast<std::size_t>(e)]));
    for (std::size_t e = 0; e < hessian_position_.size(); ++e)
        if (model.hessian.rows[e] != model.hessian.columns[e]) off_diagonal_.push_back(hessian_position_[e]);
    std::vector<int> signs(static_cast<std::size_t>(size), 1);
    std::fill(signs.begin() + variables_, signs.end(), -1);
    factor_->analyse(lower_, std::move(signs));
}

bool KktSystem::factorize(const std::vector<double>& hessian, const Eigen::VectorXd& sigma,
                          const Eigen::VectorXd& d) {
    double* values = lower_.valuePtr();
    for (Eigen::Index j = 0; j < variables_; ++j) values[diagonal_[static_cast<std::size_t>(j)]] = sigma[j];
    for (Eigen::Index i = 0; i < constraints_; ++i)
        values[diagonal_[static_cast<std::size_t>(variables_ + i)]] = -d[i];
    for (const Eigen::Index p : off_diagonal_) values[p] = 0.0;
    for (std::size_t e = 0; e < hessian.size(); ++e) values[hessian_position_[e]] += hessian[e];

    for (shift_ = first_shift_; shift_ <= largest_kkt_shift; shift_ *= kkt_shift_growth)
        if (factorize_shifted()) return true;
    shift_ = largest_kkt_shift;
    return false;
}

bool KktSystem::factorize_shifted() {
    const FactorOutcome outcome =
        factor_->factorize(lower_, Eigen::VectorXd::Constant(lower_.rows(), shift_));
    // A wrong sign is rounding, the matrix being quasi-definite. As a preconditioner such a factor is often
    // still excellent, and better than one with a larger shift: the residual of the solve decides.
    return outcome == FactorOutcome::ok || outcome == FactorOutcome::wrong_sign;
}

KktSystem::Step KktSystem::solve(const Eigen::VectorXd& p, const Eigen::VectorXd& q) {
    Eigen::VectorXd right_side(variables_ + constraints_);
    right_side << p, q;
    RefinedSolve best = refined_solve(*factor_, lower_, right_side, refinement);
    double best_shift = shift_;
    const double tried_first = shift_;
    for (const double factor : {10.0, 100.0, 0.01, 1e3, 1e4}) {
        if (best.finite && best.residual <= good_solve) break;
        shift_ = tried_first * factor;
        if (!factorize_shifted()) continue;
        RefinedSolve trial = refined_solve(*factor_, lower_, right_side, refinement);
        if (!trial.finite || (best.finite && trial.residual >= best.residual)) continue;
        best = std::move(trial);
        best_shift = shift_;
    }
    if (shift_ != best_shift) {
        shift_ = best_shift;
        static_cast<void>(factorize_shifted());
    }
    return {best.solution.head(variables_), best.solution.tail(constraints_), best.residual, best.finite};
}

}  // namespace camopt::structured
