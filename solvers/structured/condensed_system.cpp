// SPDX-License-Identifier: MIT
#include "solvers/structured/condensed_system.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace camopt::structured {
namespace {

using Eigen::Index;
using Eigen::VectorXd;
using RowMajor = Eigen::SparseMatrix<double, Eigen::RowMajor>;

constexpr double largest_shift = 1e-4;  // of entries near 1: beyond it the factor helps nothing
constexpr double shift_growth = 1e3;    // a breakdown is rare; few retries matter more than the least shift
constexpr int most_refinements = 6;
constexpr double worthwhile = 0.3;  // a refinement that gains less is the last

}  // namespace

CondensedSystem::CondensedSystem(const ConvexModel& model, FactorKind kind, double shift)
    : model_(model), first_shift_(shift), shift_(shift) {
    find_pattern();
    std::vector<int> signs(static_cast<std::size_t>(lower_.rows()), 1);
    std::fill(signs.begin() + model.variables(), signs.end(), -1);
    factor_ = make_symmetric_factor(kind, lower_, signs);
    const Index n = model.variables(), m = model.constraints();
    weight_ = VectorXd::Zero(m);
    right_side_.resize(lower_.rows());
    rest_p_.resize(n);
    rest_q_.setZero(m);
    gathered_.resize(n);
    step_ = {VectorXd::Zero(n), VectorXd::Zero(m), VectorXd::Zero(m)};
    shifts_.resize(lower_.rows());
}

/// The entries of one column after the other, and what they are made of.
void CondensedSystem::find_pattern() {
    const auto n = static_cast<int>(model_.variables());
    const RowMajor rows = model_.rows;
    rows_ = CompressedRows(rows);
    columns_ = CompressedRows(RowMajor(model_.rows.transpose()));
    const int size = n + number_equalities();
    const std::vector<std::vector<int>> curved = hessian_by_column();
    std::vector<int> entries, owner(static_cast<std::size_t>(size), -1), slot(owner), inner, outer{0};
    const auto claim = [&](int row, int column) {
        if (owner[static_cast<std::size_t>(row)] == column) return;
        owner[static_cast<std::size_t>(row)] = column;
        entries.push_back(row);
    };
    diagonal_.resize(static_cast<std::size_t>(size));
    hessian_slot_.resize(model_.hessian.rows.size());
    for (int j = 0; j < size; ++j) {
        entries.clear();
        claim(j, j);
        const auto each_entry = [&](auto&& of_equality, auto&& of_pair) {
            if (j >= n) return;
            for (ConvexModel::Matrix::InnerIterator own(model_.rows, j); own; ++own) {
                const int equality = equality_[static_cast<std::size_t>(own.row())];
                if (equality >= 0) {
                    of_equality(equality, own.value());
                    continue;
                }
                for (RowMajor::InnerIterator other(rows, own.row()); other; ++other)
                    if (other.col() >= j)
                        of_pair(static_cast<int>(other.col()), static_cast<int>(own.row()),
                                own.value() * other.value());
            }
        };
        each_entry([&](int row, double) { claim(row, j); }, [&](int row, int, double) { claim(row, j); });
        for (const int e : curved[static_cast<std::size_t>(j)])
            claim(model_.hessian.rows[static_cast<std::size_t>(e)], j);
        std::ranges::sort(entries);
        for (const int row : entries) {
            slot[static_cast<std::size_t>(row)] = static_cast<int>(inner.size());
            inner.push_back(row);
        }
        constant_.resize(inner.size(), 0.0);
        diagonal_[static_cast<std::size_t>(j)] = slot[static_cast<std::size_t>(j)];
        each_entry(
            [&](int row, double value) {
                constant_[static_cast<std::size_t>(slot[static_cast<std::size_t>(row)])] = value;
            },
            [&](int row, int source, double product) {
                terms_.push_back({slot[static_cast<std::size_t>(row)], source, product});
            });
        for (const int e : curved[static_cast<std::size_t>(j)])
            hessian_slot_[static_cast<std::size_t>(e)] =
                slot[static_cast<std::size_t>(model_.hessian.rows[static_cast<std::size_t>(e)])];
        outer.push_back(static_cast<int>(inner.size()));
    }
    lower_ = Eigen::Map<const SymmetricFactor::Matrix>(size, size, static_cast<Index>(inner.size()),
                                                       outer.data(), inner.data(), constant_.data());
}

/// Gives every equality its row in the matrix; how many there are.
int CondensedSystem::number_equalities() {
    equality_.assign(static_cast<std::size_t>(model_.constraints()), -1);
    for (Index i = 0; i < model_.constraints(); ++i) {
        if (!model_.is_equality(i)) continue;
        equality_[static_cast<std::size_t>(i)] =
            static_cast<int>(model_.variables()) + static_cast<int>(equality_rows_.size());
        equality_rows_.push_back(static_cast<int>(i));
    }
    return static_cast<int>(equality_rows_.size());
}

/// Entries of ∇²f whose column is j, for every row of the matrix.
std::vector<std::vector<int>> CondensedSystem::hessian_by_column() const {
    std::vector<std::vector<int>> curved(static_cast<std::size_t>(model_.variables()) +
                                         equality_rows_.size());
    for (std::size_t e = 0; e < model_.hessian.columns.size(); ++e)
        curved[static_cast<std::size_t>(model_.hessian.columns[e])].push_back(static_cast<int>(e));
    return curved;
}

bool CondensedSystem::factorize(const std::vector<double>& hessian, const VectorXd& sigma,
                                const VectorXd& d) {
    hessian_ = &hessian;
    sigma_ = &sigma;
    d_ = &d;
    const Index n = model_.variables();
    for (Index i = 0; i < d.size(); ++i)
        weight_[i] = equality_[static_cast<std::size_t>(i)] < 0 ? 1.0 / d[i] : 0.0;
    double* values = lower_.valuePtr();
    std::ranges::copy(constant_, values);
    for (Index j = 0; j < n; ++j) values[diagonal_[static_cast<std::size_t>(j)]] = sigma[j];
    for (std::size_t e = 0; e < hessian.size(); ++e) values[hessian_slot_[e]] += hessian[e];
    for (const Term& term : terms_) values[term.slot] += term.product * weight_[term.row];
    for (shift_ = first_shift_; shift_ <= largest_shift; shift_ *= shift_growth) {
        shifts_.setConstant(shift_);
        const FactorOutcome outcome = factor_->factorize(lower_, shifts_);
        // A wrong sign is rounding, the matrix being quasi-definite: the residual of the solve decides.
        if (outcome == FactorOutcome::ok || outcome == FactorOutcome::wrong_sign) return true;
    }
    return false;
}

/// One solve with the factor. The inequalities are kept to the last digit, by the choice of λ.
void CondensedSystem::apply_factor(const VectorXd& p, const VectorXd& q, NewtonUnknowns& out) {
    const Index n = model_.variables();
    weighted_ = q.cwiseProduct(weight_);
    gathered_ = p;
    columns_.add_product(1.0, weighted_, gathered_);
    right_side_.head(n) = gathered_;
    for (const int i : equality_rows_) right_side_[equality_[static_cast<std::size_t>(i)]] = q[i];
    factor_->solve_in_place(right_side_);
    out.x = right_side_.head(n);
    rows_.multiply(out.x, out.image);
    out.lambda = (out.image - q).cwiseProduct(weight_);
    for (const int i : equality_rows_) out.lambda[i] = right_side_[equality_[static_cast<std::size_t>(i)]];
}

/// rest = right side − matrix · (x, λ), 0 for inequalities; its largest entry.
double CondensedSystem::residual(const VectorXd& p, const VectorXd& q, const NewtonUnknowns& at) {
    rest_p_ = p - sigma_->cwiseProduct(at.x);
    columns_.add_product(-1.0, at.lambda, rest_p_);
    const SparsityPattern& pattern = model_.hessian;
    for (std::size_t e = 0; e < hessian_->size(); ++e) {
        const int row = pattern.rows[e], column = pattern.columns[e];
        rest_p_[row] -= (*hessian_)[e] * at.x[column];
        if (row != column) rest_p_[column] -= (*hessian_)[e] * at.x[row];
    }
    double largest = 0.0;
    for (Index j = 0; j < rest_p_.size(); ++j) largest = std::max(largest, std::abs(rest_p_[j]));
    for (const int i : equality_rows_) {
        rest_q_[i] = q[i] - at.image[i];
        largest = std::max(largest, std::abs(rest_q_[i]));
    }
    return rest_p_.allFinite() && std::isfinite(largest) ? largest : infinity;
}

CondensedSystem::Accuracy CondensedSystem::solve(const VectorXd& p, const VectorXd& q, double goal,
                                                 NewtonUnknowns& out) {
    apply_factor(p, q, out);
    if (!std::isfinite(goal)) return {0.0, true};
    double rest = residual(p, q, out);
    for (int k = 0; k < most_refinements && rest > goal && std::isfinite(rest); ++k) {
        apply_factor(rest_p_, rest_q_, step_);
        step_.x += out.x;
        step_.lambda += out.lambda;
        step_.image += out.image;
        const double now = residual(p, q, step_);
        if (!(now < rest)) break;
        std::swap(out, step_);
        const bool last = now > worthwhile * rest;
        rest = now;
        if (last) break;
    }
    return {rest, rest <= goal};
}

}  // namespace camopt::structured
