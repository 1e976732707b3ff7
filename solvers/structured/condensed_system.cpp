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

/// Places in the lower triangle that are not 0 for ever, found column by column without sorting triplets.
class PatternBuilder {
 public:
    explicit PatternBuilder(int size) : rows_(static_cast<std::size_t>(size)) {}
    void add(int row, int column) {
        rows_[static_cast<std::size_t>(std::min(row, column))].push_back(std::max(row, column));
    }
    SymmetricFactor::Matrix matrix() {
        const auto size = static_cast<Index>(rows_.size());
        SymmetricFactor::Matrix result(size, size);
        Index entries = 0;
        for (std::vector<int>& column : rows_) {
            std::sort(column.begin(), column.end());
            column.erase(std::unique(column.begin(), column.end()), column.end());
            entries += static_cast<Index>(column.size());
        }
        result.resizeNonZeros(entries);
        Index next = 0;
        for (Index j = 0; j < size; ++j) {
            result.outerIndexPtr()[j] = static_cast<int>(next);
            for (const int row : rows_[static_cast<std::size_t>(j)]) {
                result.innerIndexPtr()[next] = row;
                result.valuePtr()[next++] = 0.0;
            }
        }
        result.outerIndexPtr()[size] = static_cast<int>(next);
        return result;
    }

 private:
    std::vector<std::vector<int>> rows_;
};

int slot_of(const SymmetricFactor::Matrix& lower, int row, int column) {
    const int low = std::max(row, column), high = std::min(row, column);
    const int* begin = lower.innerIndexPtr() + lower.outerIndexPtr()[high];
    const int* end = lower.innerIndexPtr() + lower.outerIndexPtr()[high + 1];
    return static_cast<int>(std::lower_bound(begin, end, low) - lower.innerIndexPtr());
}

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

void CondensedSystem::find_pattern() {
    const auto n = static_cast<int>(model_.variables());
    equality_.assign(static_cast<std::size_t>(model_.constraints()), -1);
    int size = n;
    for (Index i = 0; i < model_.constraints(); ++i)
        if (model_.is_equality(i)) {
            equality_[static_cast<std::size_t>(i)] = size++;
            equality_rows_.push_back(static_cast<int>(i));
        }
    const RowMajor rows = model_.rows;
    rows_ = CompressedRows(rows);
    columns_ = CompressedRows(RowMajor(model_.rows.transpose()));
    PatternBuilder pattern(size);
    for (int i = 0; i < size; ++i) pattern.add(i, i);
    const SparsityPattern& hessian = model_.hessian;
    for (std::size_t e = 0; e < hessian.rows.size(); ++e) pattern.add(hessian.rows[e], hessian.columns[e]);
    std::size_t terms = 0;
    for (Index i = 0; i < rows.rows(); ++i) {
        const int equality = equality_[static_cast<std::size_t>(i)];
        for (RowMajor::InnerIterator a(rows, i); a; ++a) {
            if (equality >= 0) {
                pattern.add(equality, static_cast<int>(a.col()));
                continue;
            }
            for (RowMajor::InnerIterator b(rows, i); b && b.col() <= a.col(); ++b, ++terms)
                pattern.add(static_cast<int>(a.col()), static_cast<int>(b.col()));
        }
    }
    lower_ = pattern.matrix();
    terms_.reserve(terms);
    for (Index i = 0; i < rows.rows(); ++i) {
        const int equality = equality_[static_cast<std::size_t>(i)];
        for (RowMajor::InnerIterator a(rows, i); a; ++a) {
            const auto column = static_cast<int>(a.col());
            if (equality >= 0) {
                lower_.valuePtr()[slot_of(lower_, equality, column)] = a.value();
                continue;
            }
            for (RowMajor::InnerIterator b(rows, i); b && b.col() <= a.col(); ++b)
                terms_.push_back({slot_of(lower_, column, static_cast<int>(b.col())), static_cast<int>(i),
                                  a.value() * b.value()});
        }
    }
    constant_.assign(lower_.valuePtr(), lower_.valuePtr() + lower_.nonZeros());
    for (int i = 0; i < size; ++i) diagonal_.push_back(slot_of(lower_, i, i));
    for (std::size_t e = 0; e < hessian.rows.size(); ++e)
        hessian_slot_.push_back(slot_of(lower_, hessian.rows[e], hessian.columns[e]));
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
