// SPDX-License-Identifier: MIT
#include "solvers/structured/newton/newton_step.hpp"

#include "solvers/structured/linearized_problem.hpp"

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
// A direction is accepted if its residual is this part of what is wrong at the point, which a step then still
// reduces, or of the tolerance; unless steps must be exact, also of its right-hand side.
constexpr double good_part = 0.1;
constexpr double good_part_of_tolerance = 1e-3;
constexpr double good_residual = 1e-8;
// The full system pivots on free variables too, unlike the condensed one.
constexpr double careful_shift = 1e-9;
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
    return structured::finite(dual) && structured::finite(equality) && std::isfinite(bound_total) &&
           std::isfinite(mu);
}

void Iterate::resize(Index variables, const RangeRows& ranges) {
    x.setZero(variables);
    lambda.setZero(ranges.equal_to.size());
    gap.setOnes(ranges.sides());
    dual = ranges.present;
}

void Direction::resize(Index variables, const RangeRows& ranges) {
    x.setZero(variables);
    lambda.setZero(ranges.equal_to.size());
    gap.setZero(ranges.sides());
    dual.setZero(ranges.sides());
}

NewtonStep::NewtonStep(const ConvexModel& model, const RangeRows& ranges, const InteriorPointLimits& limits)
    : model_(model),
      ranges_(ranges),
      tolerance_(limits.tolerance),
      shift_(limits.shift),
      exact_(limits.exact_steps),
      system_(model, ranges, limits.factor, limits.shift),
      hessian_(static_cast<std::size_t>(model.hessian.size())),
      inverse_gap_(ranges.sides()),
      inverse_dual_(ranges.sides()),
      curvature_(ranges.sides()),
      image_(ranges.matrix.rows()),
      change_(VectorXd::Zero(ranges.sides())),
      right_side_{VectorXd(model.variables() + ranges.equal_to.size()), VectorXd(ranges.sides())},
      solution_{VectorXd(model.variables() + ranges.equal_to.size()), VectorXd(ranges.matrix.rows()),
                VectorXd(ranges.sides())} {}

void NewtonStep::residuals(Iterate& point, Residuals& out) {
    SideResiduals pass;
    pass.gap = point.gap.data();
    pass.dual = point.dual.data();
    pass.gap_change = pass.dual_change = point.gap.data();  // no step
    evaluate(point, pass, out);
}

void NewtonStep::advance(const Iterate& point, const Direction& direction, const Steps& steps, Iterate& to,
                         Residuals& out) {
    to.x = point.x + steps.primal * direction.x;
    to.lambda = point.lambda + steps.dual * direction.lambda;
    SideResiduals pass;
    pass.gap = point.gap.data();
    pass.dual = point.dual.data();
    pass.gap_change = direction.gap.data();
    pass.dual_change = direction.dual.data();
    pass.primal_step = steps.primal;
    pass.dual_step = steps.dual;
    evaluate(to, pass, out);
}

void NewtonStep::evaluate(Iterate& at, SideResiduals pass, Residuals& out) {
    model_.cost->gradient(at.x, out.gradient);
    system_.multiply(at.x.data(), image_);
    out.equality = image_.tail(ranges_.equal_to.size()) - ranges_.equal_to;
    out.bound.resize(ranges_.sides());
    pass.x = at.x.data();
    pass.image = image_.data();
    pass.new_gap = at.gap.data();
    pass.new_dual = at.dual.data();
    pass.bound = out.bound.data();
    pass.out = system_.products();
    system_.passes().residuals(system_.layout(), pass);
    out.dual.resize(out.gradient.size());
    system_.add_transposed(1.0, at.lambda.data(), out.gradient.data(), out.dual.data());
    out.mu = pass.products / static_cast<double>(std::max<Index>(1, ranges_.sides_present));
    out.largest_bound = pass.largest;
    out.bound_total = pass.bound_total;
    out.dual_limit = pass.dual_limit;
}

bool NewtonStep::prepare(const Iterate& point, bool& finite) {
    model_.cost->hessian(point.x, hessian_);
    finite = std::all_of(hessian_.begin(), hessian_.end(), [](double v) { return std::isfinite(v); });
    if (!finite) return false;
    SidePoint pass;
    pass.gap = point.gap.data();
    pass.dual = point.dual.data();
    pass.inverse_gap = inverse_gap_.data();
    pass.inverse_dual = inverse_dual_.data();
    pass.curvature = curvature_.data();
    careful_is_current_ = false;
    return system_.factorize(hessian_, pass) || prepare_careful(point);
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
    double good = std::max(good_part * wrong_, good_part_of_tolerance * tolerance_);
    if (!exact_) good = std::max(good, good_residual * size_of_right_side(point));
    if (accuracy.residual <= good) return;
    if (!careful_is_current_ && !prepare_careful(point)) return;
    solve_carefully(accuracy.residual);
}

/// Its largest entry, forces as the equivalent slides.
double NewtonStep::size_of_right_side(const Iterate& point) const {
    double size = largest(right_side_.all);
    for (Index b = 0; b < ranges_.sides(); ++b)
        size = std::max(
            size, ranges_.present[b] * std::abs(right_side_.force[b] * point.gap[b] * inverse_dual_[b]));
    return size;
}

void NewtonStep::solve_carefully(double known_residual) {
    VectorXd p = right_side_.all.head(model_.variables()), force = VectorXd::Zero(model_.constraints());
    for (Index b = 0; b < ranges_.sides(); ++b) {
        const RangeRows::Source& from = ranges_.source[static_cast<std::size_t>(b)];
        if (from.row >= 0)
            force[from.row] += from.sign * right_side_.force[b];
        else if (from.variable >= 0)
            p[from.variable] += from.sign * right_side_.force[b];
    }
    VectorXd q = row_flatness_.cwiseProduct(force);
    const auto equalities = right_side_.all.tail(ranges_.equal_to.size());
    for (std::size_t k = 0; k < ranges_.equalities.size(); ++k)
        q[ranges_.equalities[k]] = equalities[static_cast<Index>(k)];
    const double size = std::max(largest(p), largest(q));
    const KktSystem::Step careful = careful_->solve(p, q);
    if (!careful.finite || careful.residual * size >= known_residual) return;
    solved_ = true;
    solution_.all.head(model_.variables()) = careful.x;
    for (std::size_t k = 0; k < ranges_.equalities.size(); ++k)
        solution_.all[model_.variables() + static_cast<Index>(k)] = careful.lambda[ranges_.equalities[k]];
    system_.multiply(careful.x.data(), solution_.image);
    VectorXd slides(ranges_.sides());
    ranges_.slides(careful.x, solution_.image, slides);
    solution_.nu = curvature_.cwiseProduct(slides) - right_side_.force;
    // Of a row with one bound the multiplier is more accurate than its slide.
    for (Index b = 0; b < ranges_.sides(); ++b) {
        const RangeRows::Source& from = ranges_.source[static_cast<std::size_t>(b)];
        if (from.row < 0 || row_flatness_[from.row] >= 1.0) continue;
        const double slide =
            from.sign * row_flatness_[from.row] * (careful.lambda[from.row] + force[from.row]);
        solution_.nu[b] = curvature_[b] * slide - right_side_.force[b];
    }
}

void NewtonStep::direction(const Iterate& point, const DirectionRequest& request, Direction& out) {
    SideForces forces = request.change;
    SideDirection pass;
    pass.gap = forces.gap = point.gap.data();
    pass.dual = forces.dual = point.dual.data();
    pass.inverse_gap = forces.inverse_gap = inverse_gap_.data();
    pass.inverse_dual = inverse_dual_.data();
    pass.change = forces.change = change_.data();
    forces.force = right_side_.force.data();
    forces.out = system_.products();
    const Index n = model_.variables(), equalities = ranges_.equal_to.size();
    if (request.residuals != nullptr) {
        const Residuals& residuals = *request.residuals;
        pass.bound = forces.bound = residuals.bound.data();
        right_side_.all.head(n) = -residuals.dual;
        right_side_.all.tail(equalities) = -residuals.equality;
        wrong_ = std::max(largest(right_side_.all), residuals.mu);
        goal_ = std::max(inexactness(tolerance_) * wrong_, finest(tolerance_));
    } else {
        right_side_.all.setZero();
    }
    system_.passes().forces(system_.layout(), forces);
    // A correction must be as accurate as the direction: its residual remains.
    solve(point, goal_);
    out.x = solution_.all.head(n);
    out.lambda = solution_.all.tail(equalities);
    if (request.base != nullptr) {
        out.x += request.base->x;
        out.lambda += request.base->lambda;
        pass.base_gap = request.base->gap.data();
        pass.base_dual = request.base->dual.data();
    }
    pass.x = solution_.all.data();
    pass.image = solution_.image.data();
    pass.nu = solution_.nu.data();
    pass.gap_change = out.gap.data();
    pass.dual_change = out.dual.data();
    system_.passes().direction(system_.layout(), pass);
    out.steepest_gap = pass.steepest_gap;
    out.steepest_dual = pass.steepest_dual;
    out.gap_dual = pass.gap_dual;
    out.dual_gap = pass.dual_gap;
    out.change_change = pass.change_change;
    out.finite = solved_ && std::isfinite(pass.total) && finite(out.x) && finite(out.lambda) &&
                 (request.base == nullptr || request.base->finite);
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
