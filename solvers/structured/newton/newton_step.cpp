// SPDX-License-Identifier: MIT
#include "solvers/structured/newton/newton_step.hpp"

#include "solvers/structured/linearized_problem.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace camopt::structured {

namespace {

// Relative residual allowed in a direction, which need not be more accurate than round-off allows; where the
// tolerance requires the last digits, it must be more accurate.
double inexactness(double tolerance) {
    return std::min(1e-3, 1e7 * tolerance);
}
double finest(double tolerance) {
    return std::min(1e-16, 1e-3 * tolerance);
}
// A direction is accepted if its residual is this part of its right-hand side, or of the tolerance.
constexpr double good_residual = 1e-8;
constexpr double good_part_of_tolerance = 1e-3;
// The full system pivots on free variables too, unlike the condensed one.
constexpr double careful_shift = 1e-9;
// Replaces 0 where nothing changes.
constexpr double tiniest = 1e-300;

constexpr double largest_kkt_shift =
    1e-2;  // of entries near 1: a larger shift makes a useless preconditioner
constexpr double kkt_shift_growth =
    100.0;                           // a breakdown is rare; few retries matter more than the smallest shift
constexpr double good_solve = 1e-8;  // relative; above it other shifts are tried and the best is kept
constexpr RefinementLimits refinement{1e-14, 20};

Eigen::Index position_of(const SymmetricFactor::Matrix& matrix, int row, int column) {
    const int* begin = matrix.innerIndexPtr() + matrix.outerIndexPtr()[column];
    const int* end = matrix.innerIndexPtr() + matrix.outerIndexPtr()[column + 1];
    return std::lower_bound(begin, end, row) - matrix.innerIndexPtr();
}

}  // namespace

using Eigen::Index;
using Eigen::VectorXd;

bool Residuals::finite() const {
    return structured::finite(dual) && structured::finite(equality) && structured::finite(bound) &&
           std::isfinite(mu);
}

void Direction::resize(Index variables, const RangeRows& ranges) {
    x.setZero(variables);
    lambda.setZero(ranges.equal_to.size());
    gap.setZero(ranges.sides());
    dual.setZero(ranges.sides());
}

Direction& Direction::operator+=(const Direction& other) {
    x += other.x;
    lambda += other.lambda;
    gap += other.gap;
    dual += other.dual;
    finite = finite && other.finite;
    return *this;
}

NewtonStep::NewtonStep(const ConvexModel& model, const RangeRows& ranges, const InteriorPointLimits& limits)
    : model_(model),
      ranges_(ranges),
      tolerance_(limits.tolerance),
      shift_(limits.shift),
      system_(model, ranges, limits.factor, limits.shift),
      hessian_(static_cast<std::size_t>(model.hessian.size())),
      inverse_gap_(ranges.sides()),
      inverse_dual_(ranges.sides()),
      curvature_(ranges.sides()),
      image_(ranges.matrix.rows()),
      slide_(ranges.sides()),
      right_side_{VectorXd(model.variables()), VectorXd(ranges.equal_to.size()), VectorXd(ranges.sides())},
      solution_{VectorXd(model.variables()), VectorXd(ranges.equal_to.size()), VectorXd(ranges.sides()),
                VectorXd(ranges.sides())} {}

void NewtonStep::residuals(const Iterate& point, Residuals& out) {
    model_.cost->gradient(point.x, out.gradient);
    out.dual = out.gradient;
    slide_ = -point.dual;
    system_.add_transposed(1.0, point.lambda, slide_, out.dual);
    system_.multiply(point.x, image_);
    out.equality = image_.tail(ranges_.equal_to.size()) - ranges_.equal_to;
    ranges_.slides(point.x, image_, slide_);
    out.bound = (slide_ - ranges_.limit - point.gap).cwiseProduct(ranges_.present);
    out.mu = point.gap.dot(point.dual) / static_cast<double>(std::max<Index>(1, ranges_.sides_present));
}

bool NewtonStep::prepare(const Iterate& point, bool& finite) {
    model_.cost->hessian(point.x, hessian_);
    finite = std::all_of(hessian_.begin(), hessian_.end(), [](double v) { return std::isfinite(v); });
    if (!finite) return false;
    inverse_gap_ = point.gap.cwiseInverse();
    inverse_dual_ = point.dual.cwiseMax(tiniest).cwiseInverse();
    curvature_ = point.dual.cwiseProduct(inverse_gap_);
    careful_is_current_ = false;
    return system_.factorize(hessian_, curvature_) || prepare_careful(point);
}

/// The full system has the model's own rows.
bool NewtonStep::prepare_careful(const Iterate& point) {
    if (!careful_) careful_ = std::make_unique<KktSystem>(model_, std::max(shift_, careful_shift));
    variable_curvature_.setZero(model_.variables());
    row_flatness_.setZero(model_.constraints());
    for (Index b = 0; b < ranges_.sides(); ++b) {
        const RangeRows::Source& from = ranges_.source[static_cast<std::size_t>(b)];
        if (from.row >= 0)
            row_flatness_[from.row] += curvature_[b];
        else if (from.variable >= 0)
            variable_curvature_[from.variable] += point.dual[b] * inverse_gap_[b];
    }
    for (Index i = 0; i < row_flatness_.size(); ++i)
        if (row_flatness_[i] > 0.0) row_flatness_[i] = 1.0 / row_flatness_[i];
    careful_is_current_ = careful_->factorize(hessian_, variable_curvature_, row_flatness_);
    return careful_is_current_;
}

/// solution_ from right_side_.
void NewtonStep::solve(const Iterate& point, double goal) {
    CondensedSystem::Accuracy accuracy{infinity, false};
    if (!careful_is_current_) accuracy = system_.solve(right_side_, goal, solution_);
    solved_ = std::isfinite(accuracy.residual);
    if (accuracy.reached) return;
    // Forces as the equivalent slides.
    slide_ =
        right_side_.force.cwiseProduct(point.gap).cwiseProduct(inverse_dual_).cwiseProduct(ranges_.present);
    const double size = std::max({largest(right_side_.p), largest(right_side_.q), largest(slide_)});
    if (accuracy.residual <= std::max(good_residual * size, good_part_of_tolerance * tolerance_)) return;
    if (!careful_is_current_ && !prepare_careful(point)) return;
    solve_carefully(accuracy.residual);
}

void NewtonStep::solve_carefully(double known_residual) {
    VectorXd p = right_side_.p, force = VectorXd::Zero(model_.constraints());
    for (Index b = 0; b < ranges_.sides(); ++b) {
        const RangeRows::Source& from = ranges_.source[static_cast<std::size_t>(b)];
        if (from.row >= 0)
            force[from.row] += from.sign * right_side_.force[b];
        else if (from.variable >= 0)
            p[from.variable] += from.sign * right_side_.force[b];
    }
    VectorXd q = row_flatness_.cwiseProduct(force);
    for (std::size_t k = 0; k < ranges_.equalities.size(); ++k)
        q[ranges_.equalities[k]] = right_side_.q[static_cast<Index>(k)];
    const double size = std::max(largest(p), largest(q));
    const KktSystem::Step careful = careful_->solve(p, q);
    if (!careful.finite || careful.residual * size >= known_residual) return;
    solved_ = true;
    solution_.x = careful.x;
    for (std::size_t k = 0; k < ranges_.equalities.size(); ++k)
        solution_.lambda[static_cast<Index>(k)] = careful.lambda[ranges_.equalities[k]];
    system_.multiply(solution_.x, image_);
    ranges_.slides(solution_.x, image_, solution_.slide);
    solution_.nu = curvature_.cwiseProduct(solution_.slide) - right_side_.force;
    // Of a row with one bound the multiplier is more accurate than its slide.
    for (Index b = 0; b < ranges_.sides(); ++b) {
        const RangeRows::Source& from = ranges_.source[static_cast<std::size_t>(b)];
        if (from.row < 0 || row_flatness_[from.row] >= 1.0) continue;
        const double slide =
            from.sign * row_flatness_[from.row] * (careful.lambda[from.row] + force[from.row]);
        solution_.nu[b] = curvature_[b] * slide - right_side_.force[b];
    }
}

void NewtonStep::direction(const Iterate& point, const Residuals* residuals, const VectorXd& change,
                           Direction& out) {
    VectorXd& force = right_side_.force;
    if (residuals != nullptr) {
        force = (change - point.dual.cwiseProduct(residuals->bound)).cwiseProduct(inverse_gap_);
        right_side_.p = -residuals->dual;
        right_side_.q = -residuals->equality;
        const double wrong =
            std::max({largest(residuals->dual), largest(residuals->equality), residuals->mu});
        goal_ = std::max(inexactness(tolerance_) * wrong, finest(tolerance_));
    } else {
        force = change.cwiseProduct(inverse_gap_);
        right_side_.p.setZero();
        right_side_.q.setZero();
    }
    // A correction must be as accurate as the direction: its residual remains.
    solve(point, goal_);
    out.x = solution_.x;
    out.lambda = solution_.lambda;
    out.dual = -solution_.nu;
    out.gap = solution_.slide.cwiseProduct(ranges_.present);
    if (residuals != nullptr) out.gap += residuals->bound;
    keep_products(point, change, out);
    out.finite = solved_ && finite(out.dual) && finite(out.x) && finite(out.lambda);
}

/// Each side from the more accurate of its two unknowns: the multiplier where the gap is smaller, the gap
/// elsewhere; the other follows from the product g z. The opposite choice would amplify round-off.
void NewtonStep::keep_products(const Iterate& point, const VectorXd& change, Direction& out) const {
    const double* const gap = point.gap.data();
    const double* const dual = point.dual.data();
    const double* const inverse_gap = inverse_gap_.data();
    const double* const inverse_dual = inverse_dual_.data();
    const double* const wanted = change.data();
    double* const of_dual = out.dual.data();
    double* const of_gap = out.gap.data();
    for (Index b = 0; b < out.gap.size(); ++b) {
        const double gap_from_product = (wanted[b] - gap[b] * of_dual[b]) * inverse_dual[b];
        const double dual_from_product = (wanted[b] - dual[b] * of_gap[b]) * inverse_gap[b];
        const bool tight = dual[b] > gap[b];
        of_gap[b] = tight ? gap_from_product : of_gap[b];
        of_dual[b] = tight ? of_dual[b] : dual_from_product;
    }
}

double step_to_boundary(const VectorXd& inverse, const VectorXd& change, double fraction) {
    if (inverse.size() == 0) return 1.0;
    const double steepest = -change.cwiseProduct(inverse).minCoeff();
    return steepest > fraction ? fraction / steepest : 1.0;
}

void advance(Iterate& point, const Direction& direction, double primal_step, double dual_step) {
    point.x += primal_step * direction.x;
    point.gap += primal_step * direction.gap;
    point.lambda += dual_step * direction.lambda;
    point.dual += dual_step * direction.dual;
}

KktSystem::KktSystem(const ConvexModel& model, double shift)
    : variables_(model.variables()),
      constraints_(model.constraints()),
      first_shift_(shift),
      shift_(shift),
      factor_(make_simplicial_factor()) {
    const auto size = static_cast<int>(variables_ + constraints_);
    std::vector<Eigen::Triplet<double>> entries;
    entries.reserve(static_cast<std::size_t>(size) + static_cast<std::size_t>(model.hessian.size()));
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
    // A wrong sign is round-off, since the matrix is quasi-definite. As a preconditioner such a factor is
    // often still excellent, and better than one with a larger shift: the residual of the solve decides.
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
